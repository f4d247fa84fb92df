"""The size of a hand that one camera sees, by its accelerometer."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.calibration.size import (
    distance_sd,
    size_index,
    size_index_gain,
    size_sd,
    with_min_distance_sd,
)
from tracker.fusion.chain.calibration.size_by_motion import (
    COLUMNS,
    TILT,
    MotionWindow,
    information,
    sized,
)
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import profile_of
from tracker.fusion.chain.reports import length_gain
from tracker.fusion.chain.state import initial_state
from tracker.fusion.time.imu_buffer import Intervals
from tracker.geometry import so3
from tracker.messages import BlobFrame, CameraPose, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

SIZE = 1.12
ACCEL_BIAS = np.array([0.2, -0.1, 0.15])
GYRO_BIAS = np.array([0.02, -0.03, 0.01])
GYRO_MATRIX = np.eye(3) + 0.01 * np.array([[1.0, 0.5, 0], [-0.5, -1.0, 0.3], [0, 0.6, 0.8]])


def place(t: float) -> np.ndarray:
    """(3,) m of a hand that moves to and fro by about 0.1 m."""
    return np.array([0.1 * np.sin(5 * t), 0.08 * np.sin(6.1 * t + 1), 0.4 + 0.06 * np.sin(4.3 * t)])


def rotation(t: float) -> np.ndarray:
    """(3, 3) of its IMU."""
    return so3.exp(np.array([0.7 * np.sin(3.1 * t), 0.5 * np.sin(3.7 * t), 0.6 * np.cos(2.9 * t)]))


def readings(t: float) -> tuple[np.ndarray, np.ndarray]:
    """accel and gyro (3,) by central differences, with their errors."""
    h = 1e-4
    a = (place(t + h) - 2 * place(t) + place(t - h)) / h**2
    force = rotation(t).T @ (a + [0, 0, GRAVITY])
    rate = so3.log(rotation(t - h).T @ rotation(t + h)) / (2 * h)
    return force + ACCEL_BIAS, GYRO_MATRIX @ rate + GYRO_BIAS


def head(t: float) -> np.ndarray:
    """(3,) m: a camera that sways."""
    return 0.03 * np.array([np.sin(2.9 * t), np.sin(3.7 * t + 1.0), np.sin(2.3 * t + 2.0)])


def window(start: float, tilt: np.ndarray, bg: np.ndarray, moves: bool = False) -> MotionWindow:
    """Two seconds with 30 images per second of a hand whose filter has a wrong orientation."""
    zero = np.zeros((3, COLUMNS))
    out = MotionWindow(
        start=start, t=start, camera=CameraPose(np.eye(3), moves * head(start)), bg=bg,
        R_GI=so3.exp(tilt) @ rotation(start), velocity=zero, place=zero, turn=zero,
    )  # fmt: skip
    for k in range(60):
        if k > 0:
            edges = out.t + np.arange(5) / 120
            each = [readings((a + b) / 2) for a, b in pairwise(edges)]
            accel, gyro = (np.array(column)[:, None] for column in zip(*each, strict=True))
            way = Intervals(edges[:-1], edges[1:], accel, gyro, np.ones((4, 1), bool))
            assert out.integrate(way, 0)
        camera = moves * head(out.t)
        out.add((place(out.t) - camera) / SIZE, CameraPose(np.eye(3), camera))
    return out


@pytest.mark.parametrize("moves", [False, True])
def test_windows_of_motion_measure_the_size_despite_the_errors_of_an_imu(moves: bool) -> None:
    """The files' size is 12 % wrong. The orientation is 3° off, differently in each window. The
    sway of a camera on a head is known from its poses."""
    rng = np.random.default_rng(1)
    N, g = np.diag(np.r_[1e-6, np.full(TILT - 1, 1e-2)]), np.zeros(TILT)
    for k in range(8):
        found = information(window(2.3 * k, rng.normal(0, 0.03, 3), 0.5 * GYRO_BIAS, moves), 1.0)
        assert found[2] < 0.5
        N, g = N + found[0], g + found[1]
    x = np.linalg.solve(N, g)
    # errors of second order: 0.03 rad of orientation squared, and of its product with the axes' 1 %
    assert 1 / x[0] == pytest.approx(SIZE, rel=0.01)
    assert -x[1:4] * SIZE == pytest.approx(ACCEL_BIAS, abs=0.03)
    assert np.sqrt(np.linalg.inv(N)[0, 0]) < 0.03


def test_missing_packets_end_a_window() -> None:
    whole = window(0.0, np.zeros(3), np.zeros(3))
    way = Intervals(
        np.array([2.0]), np.array([2.01]), np.zeros((1, 1, 3)), np.zeros((1, 1, 3)),
        np.zeros((1, 1), bool),
    )  # fmt: skip
    assert not whole.integrate(way, 0)


def test_a_profile_gets_the_measured_size(hand, glove) -> None:
    layout = ChainLayout(hand, glove)
    state = initial_state(layout)
    state.P = initial_covariance(layout, PriorParams())
    people = profile_of(state, layout)
    found = sized(people, layout, 1.1, 0.02)
    assert size_index(found.scale, layout) == pytest.approx(1.1, rel=1e-9)
    assert distance_sd(found, layout) == pytest.approx(0.02, rel=1e-6)
    # long hands may be slender: the length is not known as well
    assert 0.03 < size_sd(found, layout) < 0.06
    less = with_min_distance_sd(found, layout, 0.05)
    gain = size_index_gain(layout)
    assert np.sqrt(gain @ less.P @ gain) / 1.1 == pytest.approx(0.05, rel=0.1)
    assert size_sd(less, layout) == pytest.approx(size_sd(found, layout), rel=1e-9)


def test_with_a_ruler_the_girth_is_measured(hand, glove) -> None:
    """A ruler knows the length to 2 mm, so that a larger hand than expected is a broader one."""
    layout = ChainLayout(hand, glove)
    ruler = measured_profile(layout, 0.19)
    assert distance_sd(ruler, layout) > 0.02 > 0.012 > size_sd(ruler, layout)
    index = 1.05 * size_index(ruler.scale, layout)
    found = sized(ruler, layout, index, 0.018)
    ratio = found.scale / ruler.scale
    gain = length_gain(layout)
    assert gain @ found.scale[:, 0] == pytest.approx(0.19, abs=0.002)
    assert ratio[:, 1].mean() > 1.08


@pytest.mark.long
def test_a_stranger_is_measured_with_one_camera(hand, glove) -> None:
    """A hand 12 % smaller than its file; a copy of the engine in the middle of a window continues
    identically."""
    sim = Simulation(hand, glove, RandomPostures(hand, 21, duration=11.0), 21, fps=15)
    pipeline, copy = Pipeline(hand, glove, sim.rig), Pipeline(hand, glove, sim.rig)
    assert sim.wearer.hand_length < 0.9 * length_gain(ChainLayout(hand, glove)).sum()
    engine = pipeline.engine
    assert isinstance(engine, ChainEngine)
    running, shown, again = [pipeline], [], []
    for message in sim.feed():
        if len(running) == 1 and message.t > 8.0:
            copy.set_state(pipeline.get_state())
            running.append(copy)
        for one in running:
            if isinstance(message, BlobFrame):
                one.feed_frame(replace(message, right=None))
            elif isinstance(message, ImuSample):
                e = one.feed_imu(message)
                (shown if one is pipeline else again).append(e.keypoints)
    assert len(again) > 250
    assert np.array_equal(np.array(shown[-len(again) :]), np.array(again), equal_nan=True)
    sd = engine.wearer.calibration.distance_sd
    assert sd < 0.04  # 6.5 % before
    truth = sim.truth(engine.newest or 0.0)
    far = np.linalg.norm(np.array(again[-1]) - sim.rig.pose.p_GC, axis=1).mean()
    true = np.linalg.norm(truth.keypoints - sim.rig.pose.p_GC, axis=1).mean()
    assert abs(far / true - 1) < min(3 * sd, 0.08)  # 0.12 before
    kept = engine.profile()
    assert distance_sd(kept, engine.layout) >= 0.99 * sd
    assert size_sd(kept, engine.layout) < 0.065
