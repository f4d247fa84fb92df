"""A simulated IMU follows mechanics, and its errors have the parameters' values."""

from dataclasses import replace

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.imu import ImuParams, ImuSimulator, true_imu
from tracker.simulation.motion import Poses, Still
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.wearer import Wearer

PERFECT = ImuParams(
    gyro_noise_deg=0, accel_noise_ug=0, gyro_bias_deg=0, accel_bias_mg=0, gyro_walk_deg=0,
    accel_walk_mg=0, gyro_scale=0, accel_scale=0, skew_ppm=0,
)  # fmt: skip


class Spin:
    """The flat hand rotating about G's z through the wrist at a constant rate."""

    follows_synergies = True
    duration = 10.0

    def __init__(self, hand: HandModel, rate: float) -> None:
        self._count, self._rate = len(hand.joint_names), rate

    def poses(self, t: np.ndarray) -> Poses:
        turn = np.column_stack([0 * t, 0 * t, self._rate * t])
        return Poses(np.zeros((len(t), self._count)), so3.exp(turn), np.zeros((len(t), 3)))


def test_rotation_gives_centripetal_force_and_rate(hand: HandModel, glove: GloveModel) -> None:
    rate = 5.0
    force, omega = true_imu(Wearer.exact(hand, glove), Spin(hand, rate), np.array([1.0, 2.0]))
    lever = glove.imus[0].position
    expected = np.array([-(rate**2) * lever[0], -(rate**2) * lever[1], GRAVITY])
    np.testing.assert_allclose(force[:, 0], np.tile(expected, (2, 1)), atol=1e-4)
    np.testing.assert_allclose(omega[:, 0], [[0, 0, rate]] * 2, atol=1e-5)


def test_integrated_samples_reproduce_the_motion(hand: HandModel, glove: GloveModel) -> None:
    """Strapdown integration of exact samples for 4 s, independent of the simulator."""
    wearer, motion = Wearer(hand, glove, 5), RandomPostures(hand, 5, duration=5)
    t = np.arange(0, 4.0, 0.001)
    force, omega = true_imu(wearer, motion, t)
    R_GI, p_GI = wearer.imus(motion, t)
    v0 = np.diff(wearer.imus(motion, np.array([-1e-4, 1e-4]))[1], axis=0)[0] / 2e-4
    R, p, v = R_GI[0].copy(), p_GI[0].copy(), v0
    for k in range(len(t) - 1):
        turn = so3.exp((omega[k] + omega[k + 1]) / 2 * 0.001)
        a0 = np.einsum("nij,nj->ni", R, force[k])
        R = R @ turn
        a1 = np.einsum("nij,nj->ni", R, force[k + 1])
        a = (a0 + a1) / 2 - [0, 0, GRAVITY]
        p, v = p + v * 0.001 + a * 0.5e-6, v + a * 0.001
    np.testing.assert_allclose(R, R_GI[-1], atol=1e-3)
    np.testing.assert_allclose(p, p_GI[-1], atol=5e-3)


def _still(hand: HandModel, duration: float = 60.0) -> Still:
    return Still(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3), duration)


def test_noise_has_the_data_sheets_density(hand: HandModel, glove: GloveModel) -> None:
    params = replace(PERFECT, gyro_noise_deg=0.01, accel_noise_ug=300.0)
    still = Still(np.zeros(len(hand.joint_names)), so3.rx(1.0), np.zeros(3), 60.0)
    imu = ImuSimulator(Wearer.exact(hand, glove), still, 1, params)
    samples = list(imu.samples(0, 50))
    accel = np.array([s.accel for s in samples])
    gyro = np.array([s.gyro for s in samples])
    bandwidth = 50.0  # half of 100 Hz
    lsb = np.deg2rad(2000) / 32768  # coarser than the noise of 0.07 °/s
    expected = np.hypot(np.deg2rad(0.01) * np.sqrt(bandwidth), lsb / np.sqrt(12))
    assert gyro.std(axis=0).mean() == pytest.approx(expected, rel=0.1)
    expected = np.hypot(300e-6 * GRAVITY * np.sqrt(bandwidth), 16 * GRAVITY / 32768 / np.sqrt(12))
    assert accel.std(axis=0).mean() == pytest.approx(expected, rel=0.05)


def test_biases_are_within_the_data_sheets_limits(hand: HandModel, glove: GloveModel) -> None:
    wild = replace(PERFECT, gyro_bias_deg=50.0, accel_bias_mg=500.0)
    imu = ImuSimulator(Wearer.exact(hand, glove), _still(hand), 2, wild)
    assert np.abs(imu.gyro_bias).max() == pytest.approx(np.deg2rad(5))
    assert np.abs(imu.accel_bias).max() == pytest.approx(0.060 * GRAVITY)
    mean = np.mean([s.gyro for s in imu.samples(0, 1)], axis=0)
    np.testing.assert_allclose(mean, imu.gyro_bias, atol=np.deg2rad(2000) / 32768)


def test_values_are_integer_lsb_and_saturate(hand: HandModel, glove: GloveModel) -> None:
    imu = ImuSimulator(Wearer.exact(hand, glove), Spin(hand, np.deg2rad(3000)), 0, PERFECT)
    for s in imu.samples(0, 0.2):
        counts = s.gyro / (np.deg2rad(2000) / 32768)
        np.testing.assert_allclose(counts, np.round(counts), atol=1e-6)
        assert counts[0, 2] == pytest.approx(32767)


def test_clock_skew_and_arrival(hand: HandModel, glove: GloveModel) -> None:
    imu = ImuSimulator(
        Wearer.exact(hand, glove), _still(hand), 3, replace(PERFECT, skew_ppm=200.0, bunching=0.016)
    )
    samples = list(imu.samples(0, 50))
    t = np.array([s.t for s in samples])
    device = np.array([s.t_device for s in samples])
    slope = np.polyfit(device, t, 1)[0]
    assert slope == pytest.approx(imu.period * 100, abs=1e-9) and slope != 1.0
    arrival = np.array([s.t_arrival for s in samples])
    assert np.all(arrival >= t + 0.003) and np.all(np.diff(arrival) >= 0)
    np.testing.assert_allclose(arrival / 0.016, np.round(arrival / 0.016), atol=1e-5)
    assert [s.seq for s in samples] == list(range(samples[0].seq, samples[0].seq + len(t)))


def test_any_window_gives_the_same_packets(hand: HandModel, glove: GloveModel) -> None:
    imu = ImuSimulator(Wearer(hand, glove, 1), RandomPostures(hand, 1), 1)
    whole = {s.seq: s for s in imu.samples(0, 5)}
    for s in imu.samples(2.345, 3.1):
        np.testing.assert_array_equal(s.accel, whole[s.seq].accel)
        assert s.t == whole[s.seq].t
