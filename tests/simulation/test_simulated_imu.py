"""A simulated IMU follows mechanics, and its errors have the parameters' values."""

from dataclasses import replace

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.imu import ImuSimulator, true_imu
from tracker.simulation.imu_errors import DrawnImuErrors, ImuParams
from tracker.simulation.motion import Poses, Still
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.wearer import Wearer

PERFECT = ImuParams(
    gyro_noise_deg=0, accel_noise_ug=0, gyro_bias_deg=0, accel_bias_mg=0, gyro_walk_deg=0,
    accel_walk_mg=0, gyro_scale=0, accel_scale=0, skew_ppm=0, cross_axis=0, g_sensitivity_deg=0,
    gyro_slope_deg=0, accel_slope_mg=0, read_skew=0,
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
    assert np.abs(imu.errors.gyro_bias).max() == pytest.approx(np.deg2rad(5))
    assert np.abs(imu.errors.accel_bias).max() == pytest.approx(0.060 * GRAVITY)
    mean = np.mean([s.gyro for s in imu.samples(0, 1)], axis=0)
    np.testing.assert_allclose(mean, imu.errors.gyro_bias, atol=np.deg2rad(2000) / 32768)


def test_values_are_integer_lsb_and_saturate(hand: HandModel, glove: GloveModel) -> None:
    imu = ImuSimulator(Wearer.exact(hand, glove), Spin(hand, np.deg2rad(3000)), 0, PERFECT)
    for s in imu.samples(0, 0.2):
        counts = s.gyro / (np.deg2rad(2000) / 32768)
        np.testing.assert_allclose(counts, np.round(counts), atol=1e-6)
        assert counts[0, 2] == pytest.approx(32767)
        assert not s.valid.any()


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


def test_scale_and_cross_axis_errors_are_within_the_data_sheet() -> None:
    errors = DrawnImuErrors(500, 1, ImuParams())
    for matrix in (errors.gyro_matrix, errors.accel_matrix):
        scale = np.diagonal(matrix, axis1=1, axis2=2) - 1
        cross = matrix[:, ~np.eye(3, dtype=bool)]
        assert np.abs(scale).max() == pytest.approx(0.03)
        assert np.abs(cross).max() == pytest.approx(0.02)
        assert scale.std() == pytest.approx(0.01, rel=0.1)
        assert cross.std() == pytest.approx(0.007, rel=0.1)


def test_a_glove_has_the_same_errors_in_each_session(hand: HandModel, glove: GloveModel) -> None:
    wearer, still = Wearer.exact(hand, glove), _still(hand)
    one, two = (ImuSimulator(wearer, still, seed, device=7) for seed in (1, 2))
    np.testing.assert_array_equal(one.errors.gyro_slope, two.errors.gyro_slope)
    np.testing.assert_array_equal(one.errors.accel_matrix, two.errors.accel_matrix)
    assert one.temperature(np.zeros(1))[0, 0] != two.temperature(np.zeros(1))[0, 0]


def test_biases_follow_the_temperature(hand: HandModel, glove: GloveModel) -> None:
    params = replace(PERFECT, gyro_slope_deg=0.2)
    imu = ImuSimulator(Wearer.exact(hand, glove), _still(hand, 1e4), 4, params)
    t = np.array([0.0, 300.0, 3000.0])
    warm = imu.temperature(t) - imu.temperature(np.zeros(1))
    np.testing.assert_allclose(warm[:, 2], [0.0, 6 * (1 - np.exp(-1)), 6.0], atol=1e-3)
    gyro = imu.measure(t, np.random.default_rng(0))[1]
    expected = imu.errors.gyro_slope * warm[-1, :, None]
    np.testing.assert_allclose(gyro[2] - gyro[0], expected, atol=np.deg2rad(2000) / 32768)


def test_gravity_turns_the_gyroscopes(hand: HandModel, glove: GloveModel) -> None:
    params = replace(PERFECT, g_sensitivity_deg=1.0)
    imu = ImuSimulator(Wearer.exact(hand, glove), _still(hand), 5, params)
    accel, gyro = imu.measure(np.zeros(1), np.random.default_rng(0))
    expected = np.einsum("nij,nj->ni", imu.errors.g_sensitivity, accel[0])
    np.testing.assert_allclose(gyro[0], expected, atol=np.deg2rad(2000) / 32768)


def test_the_last_imu_is_read_later(hand: HandModel, glove: GloveModel) -> None:
    """With a skew of 0.55 ms, IMU j measures what one without skew measures j/6 of it later."""
    wearer, motion = Wearer(hand, glove, 5), RandomPostures(hand, 5, duration=5)
    t = np.linspace(1.0, 4.0, 50)
    late = np.linspace(0.0, 0.55e-3, 7)
    force, rate = true_imu(wearer, motion, t, late)
    force_now, rate_now = true_imu(wearer, motion, t)
    for j in (0, 3, 6):
        force_j, rate_j = true_imu(wearer, motion, t + late[j])
        # linear interpolation of a tremor of 10 Hz between instants 1 ms apart: 5e-4 of it
        np.testing.assert_allclose(force[:, j], force_j[:, j], atol=5e-3)
        np.testing.assert_allclose(rate[:, j], rate_j[:, j], atol=3e-4)
    assert np.abs(rate[:, 6] - rate_now[:, 6]).max() > 1e-3
    assert np.abs(force[:, 6] - force_now[:, 6]).max() > 1e-2
