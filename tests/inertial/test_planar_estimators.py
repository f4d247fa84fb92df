"""The estimators of the 2020 paper and ours on known motions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from extensions.evaluation.inertial.errors import MPU9250, draw
from extensions.evaluation.inertial.motion import (
    HORIZONTAL,
    MOVING,
    VERTICAL,
    MotionCondition,
    grasp,
)
from tracker import GRAVITY
from tracker.inertial.finger import Finger
from tracker.inertial.gravity import Gravity
from tracker.inertial.integration import Integration
from tracker.inertial.learned import Learned, LearnedParams
from tracker.inertial.madgwick import ADAPTIVE, Madgwick, MadgwickParams
from tracker.inertial.planar import PlanarReadings
from tracker.inertial.switching import Switching, SwitchingParams
from tracker.messages import Array

FINGER, DT = Finger(), 0.01
MAKERS: dict[str, Callable[[], Any]] = {
    "gravity": Gravity,
    "integration": lambda: Integration(DT),
    "switching": lambda: Switching(DT, FINGER.levers),
    "switching_offset": lambda: Switching(
        DT, FINGER.levers, SwitchingParams.with_offset(MPU9250.accel_offset)
    ),
    "madgwick": lambda: Madgwick(DT, FINGER.levers),
    "madgwick_adaptive": lambda: Madgwick(DT, FINGER.levers, ADAPTIVE),
    "learned": lambda: Learned(DT, FINGER.levers),
}


def _readings(
    t_m: float,
    series: str,
    condition: MotionCondition = VERTICAL,
    seed: int = 0,
    rate: float = 100.0,
) -> tuple[PlanarReadings, Array]:
    motion = grasp(FINGER, t_m, rate, condition)
    drawn = draw(len(motion.t), series, rate, (seed,))
    return drawn.planar(motion.ideal), motion.theta[:, :2]


def _rms_deg(estimator: Any, readings: PlanarReadings, truth: Array) -> float:
    return float(np.rad2deg(np.sqrt(np.mean((estimator.run(readings) - truth) ** 2))))


@pytest.mark.parametrize("name", MAKERS)
def test_run_equals_updates_and_a_restored_state_continues_identically(name: str) -> None:
    readings, _ = _readings(1.0, "both")
    whole = MAKERS[name]().run(readings)
    first, second = MAKERS[name](), MAKERS[name]()
    half = len(readings.root) // 2
    for i in range(half):
        np.testing.assert_array_equal(first.update(*_sample(readings, i)), whole[i])
    saved = first.state
    first.update(*_sample(readings, half))  # must not modify the saved state
    second.state = saved
    rest = PlanarReadings(*(a[half:] for a in readings))
    np.testing.assert_array_equal(second.run(rest), whole[half:])


def _sample(readings: PlanarReadings, i: int) -> tuple[Array, Any, complex]:
    return readings.gyro[i], readings.accel[i], complex(readings.root[i])


def test_gravity_is_exact_at_rest_and_disturbed_by_acceleration() -> None:
    readings, truth = _readings(1.0, "none")
    error = Gravity().run(readings) - truth
    static = slice(0, 20)
    np.testing.assert_allclose(error[static], 0.0, atol=1e-12)
    motion = grasp(FINGER, 1.0, 100.0)
    mu_0 = readings.accel[:, 0] * np.exp(1j * motion.theta[:, 0]) - readings.root
    expected = -np.angle(1 + mu_0 / readings.root)
    np.testing.assert_allclose(error[:, 0], expected, atol=1e-9)


@pytest.mark.parametrize("t_m", [0.5, 2.0])
def test_integration_error_is_the_gyroscopes_offset_times_time(t_m: float) -> None:
    readings, truth = _readings(t_m, "none")
    shifted = readings._replace(gyro=readings.gyro + np.array([0.05, -0.02]))
    error = Integration(DT).run(shifted) - truth
    t = np.arange(len(truth)) * DT
    np.testing.assert_allclose(
        error, np.outer(t, [0.05, -0.02]), atol=5e-4
    )  # the discontinuity at the start costs 2e-4


def test_integration_converges_with_the_third_power_of_the_sampling_time() -> None:
    error = []
    for rate in (100.0, 200.0):
        readings, truth = _readings(0.6, "none", rate=rate)
        error.append(np.abs(Integration(1 / rate).run(readings) - truth).max())
    assert error[0] / error[1] > 6.0


def test_switching_selects_the_estimate_with_the_smaller_bound() -> None:
    """At rest the paper's rule selects gravity at once; with the offset it waits until the drift
    exceeds it.

    60 mg over 1 g against 5 °/s: 3.44° / 5 °/s = 0.69 s.
    """
    n = 120
    still = PlanarReadings(
        np.zeros((n, 2)), np.full((n, 2), -1j * GRAVITY), np.full(n, -1j * GRAVITY)
    )
    for params, expected in (
        (SwitchingParams(), 0.01),
        (SwitchingParams.with_offset(MPU9250.accel_offset), np.rad2deg(0.06) / 5),
    ):
        estimator = Switching(DT, FINGER.levers, params)
        slow_from = None
        for i in range(n):
            estimator.update(*_sample(still, i))
            if slow_from is None and not estimator.state.fast.any():
                slow_from = i * DT
        assert slow_from == pytest.approx(expected, abs=1.01 * DT)


def test_switching_never_uses_gravity_in_a_horizontal_plane() -> None:
    readings, truth = _readings(3.0, "both", HORIZONTAL)
    plain, switched = Integration(DT).run(readings), MAKERS["switching"]().run(readings)
    np.testing.assert_array_equal(plain, switched)
    assert np.abs(Gravity().run(readings) - truth).max() > 1.0


@pytest.mark.parametrize("t_m", [0.1, 0.6, 1.45, 3.5, 20.0])
def test_switching_with_the_offset_follows_the_better_estimate(t_m: float) -> None:
    squares = dict.fromkeys(("gravity", "integration", "switching_offset"), 0.0)
    for seed in range(8):
        readings, truth = _readings(t_m, "both", seed=seed)
        for name in squares:
            squares[name] += _rms_deg(MAKERS[name](), readings, truth) ** 2
    rms = {name: value**0.5 for name, value in squares.items()}
    assert rms["switching_offset"] <= 1.05 * min(rms["gravity"], rms["integration"])


def test_madgwick_moves_by_twice_beta_and_converges_to_gravity() -> None:
    n, beta = 200, 0.2
    still = PlanarReadings(
        np.zeros((n, 2)), np.full((n, 2), -1j * GRAVITY), np.full(n, -1j * GRAVITY)
    )
    theta = Madgwick(DT, FINGER.levers, MadgwickParams(beta), (0.3, -0.2)).run(still)
    np.testing.assert_allclose(theta[52, 0] - theta[2, 0], -2 * beta * 0.5, rtol=1e-9)
    assert np.abs(theta[-1]).max() <= 2 * beta * DT


def test_compensated_madgwick_at_1_khz_is_far_better_than_plain_on_fast_motion() -> None:
    readings, truth = _readings(1.0, "white", rate=1000.0)
    error = {
        plain: _rms_deg(
            Madgwick(1e-3, FINGER.levers, MadgwickParams(0.33, compensate=not plain)),
            readings,
            truth,
        )
        for plain in (True, False)
    }
    assert error[False] < 0.2 * error[True]


def test_small_beta_diverges_on_long_motions_and_large_beta_errs_on_fast_ones() -> None:
    rms = {}
    for t_m in (0.1, 100.0):
        readings, truth = _readings(t_m, "both")
        for beta in (0.033, 0.33):
            estimator = Madgwick(DT, FINGER.levers, MadgwickParams(beta))
            rms[t_m, beta] = _rms_deg(estimator, readings, truth)
    assert rms[0.1, 0.033] < 0.7 * rms[0.1, 0.33]
    assert rms[100.0, 0.033] > 5 * rms[100.0, 0.33]


def test_adaptive_beta_is_less_disturbed_by_fast_motion_and_tracks_a_swaying_hand() -> None:
    white, truth = _readings(0.6, "white")
    adaptive, constant = MAKERS["madgwick_adaptive"], MAKERS["madgwick"]
    assert _rms_deg(adaptive(), white, truth) < _rms_deg(constant(), white, truth)
    swaying, truth = _readings(60.0, "both", MOVING)
    assert _rms_deg(adaptive(), swaying, truth) < 6.0  # 5 °/s alone would give 170°


@pytest.mark.parametrize("condition", [VERTICAL, MOVING])
@pytest.mark.parametrize("t_m", [0.33, 1.08, 11.6, 100.0])
def test_learned_is_ten_times_as_accurate_as_the_papers_estimators(
    t_m: float, condition: MotionCondition
) -> None:
    readings, truth = _readings(t_m, "both", condition, seed=3)
    ours = _rms_deg(MAKERS["learned"](), readings, truth)
    others = [_rms_deg(make(), readings, truth) for n, make in MAKERS.items() if n != "learned"]
    assert ours < 0.1 * min(others)


def test_learned_estimates_the_added_offsets() -> None:
    readings, _ = _readings(5.0, "none")
    gyro, accel = np.array([0.08, -0.06]), np.array([0.3 - 0.5j, -0.4 + 0.2j])
    estimator = MAKERS["learned"]()
    estimator.run(PlanarReadings(readings.gyro + gyro, readings.accel + accel, readings.root))
    np.testing.assert_allclose(estimator.gyro_offset, gyro, atol=2e-4)
    np.testing.assert_allclose(estimator.accel_offset, accel, atol=0.02)


def test_the_covariance_of_learned_is_consistent() -> None:
    """Normalised squared errors at the end of many runs average to about one."""
    squares = []
    for seed in range(40):
        readings, truth = _readings(2.0, "both", seed=seed)
        estimator = MAKERS["learned"]()
        error = estimator.run(readings)[-1] - truth[-1]
        squares.append((error / estimator.angle_sd) ** 2)
    assert 0.1 < np.mean(squares) < 2.0


def test_learned_uses_angles_measured_by_vision() -> None:
    """Wrong start, no static phase: corrections converge to the true angle and offset."""
    unsure = LearnedParams(static_start=0.0, start_sd=0.5)
    estimator = Learned(DT, FINGER.levers, unsure, (0.0, 0.0))
    offset = np.array([0.08, -0.05])
    n = 400
    accel = np.full(2, -1j * GRAVITY * np.exp(-0.5j)) + (0.3 + 0.4j)
    for i in range(n):
        estimator.update(offset, accel, -1j * GRAVITY)
        if i % 10 == 0:
            theta = estimator.correct(np.array([0.5, np.nan]), 0.02)
    assert theta[0] == pytest.approx(0.5, abs=0.01)
    assert estimator.gyro_offset[0] == pytest.approx(0.08, abs=0.01)
    assert estimator.accel_offset[0] == pytest.approx(0.3 + 0.4j, abs=0.15)


@pytest.mark.parametrize("name", ["switching", "learned"])
def test_rotating_the_planes_axes_changes_only_the_axes(name: str) -> None:
    readings, _ = _readings(1.0, "both", seed=2)
    fixed, turning = MAKERS[name](), MAKERS[name]()
    angle = 0.0
    for i in range(60):
        gyro, accel, root = _sample(readings, i)
        step = 0.002 * i
        angle += step
        turning.turn(step)
        expected = fixed.update(gyro, accel, root)
        got = turning.update(gyro, accel, root * np.exp(-1j * angle))
        if abs(angle) < 1.0:  # beyond it, gravity has another branch for `switching`
            np.testing.assert_allclose(got + angle, expected, atol=1e-9)
