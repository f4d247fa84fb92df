"""Scale and cross-axis errors from rests, compared with the errors of the simulated IMUs."""

from __future__ import annotations

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.calibration.imu_axes import FEWEST, RestFinder, fit_axes
from tracker.geometry import so3
from tracker.messages import Array, ImuSample
from tracker.simulation.imu_errors import DrawnImuErrors, ImuParams
from tracker.simulation.smooth import minimum_jerk

N = 3
RATE_HZ = 100.0
REST_S, TURN_S = 2.0, 1.5


def orientations(count: int) -> list[Array]:
    """Six sides of a box, then its edges."""
    sides = [so3.exp(np.array(v) * np.pi / 2) for v in
             ([0, 0, 0], [1, 0, 0], [2, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0])]  # fmt: skip
    edges = [so3.exp(np.array(v) * np.pi / 4) for v in
             ([1, 0, 0], [0, 1, 0], [-1, 0, 1], [0, -1, 1], [3, 0, 0], [0, 3, 1])]  # fmt: skip
    return (sides + edges)[:count]


def turned(positions: list[Array], rate_hz: float = RATE_HZ) -> tuple[Array, Array]:
    """R_GI (n, 3, 3) and rate (n, 3) rad/s of a box that rests in each position in turn."""
    R, rate, dt = [], [], 1 / rate_hz
    still, moves = round(REST_S * rate_hz), round(TURN_S * rate_hz)
    for k, here in enumerate(positions):
        R += [here] * still
        rate += [np.zeros(3)] * still
        if k + 1 < len(positions):
            whole = so3.log(here.T @ positions[k + 1])
            shares = minimum_jerk(np.arange(moves + 1) / moves)
            R += [here @ so3.exp(whole * s) for s in shares[:-1]]
            rate += [whole * step / dt for step in np.diff(shares)]
    return np.array(R), np.array(rate)


def found_in(positions: list[Array], seed: int = 3) -> tuple[RestFinder, DrawnImuErrors]:
    params, rng = ImuParams(), np.random.default_rng(seed)
    errors = DrawnImuErrors(N, seed, params)
    R, rate = turned(positions)
    force = np.swapaxes(R, 1, 2) @ np.array([0, 0, GRAVITY])
    shape = (len(R), N, 3)
    force, rate = (np.broadcast_to(x[:, None], shape) for x in (force, rate))
    gyro = errors.measured_rate(rate, force) + rng.normal(0, np.deg2rad(0.07), shape)
    accel = errors.measured_force(force) + rng.normal(0, 0.02, shape)
    found = RestFinder()
    for k in range(len(R)):
        t = k / RATE_HZ
        found.add(ImuSample(t, t, t, k, accel[k], gyro[k], np.ones(N, bool)))
    return found, errors


@pytest.fixture(scope="module")
def found() -> tuple[RestFinder, DrawnImuErrors]:
    return found_in(orientations(12))


def test_each_rest_and_position_is_found(found: tuple[RestFinder, DrawnImuErrors]) -> None:
    assert len(found[0].rests) == 12 and len(found[0].turns()) == 11
    assert found[0].positions() == 12 and found[0].is_still


@pytest.mark.long
@pytest.mark.parametrize("imu", range(N))
def test_the_errors_are_those_of_the_simulated_imus(
    found: tuple[RestFinder, DrawnImuErrors], imu: int
) -> None:
    """C M is a rotation, the same for both sensors: that of the axes to which both refer."""
    result = fit_axes(found[0], imu)
    assert result is not None and result.misfit < 2.0
    left = result.axes.accel @ found[1].accel_matrix[imu]
    shape_before = found[1].accel_matrix[imu].T @ found[1].accel_matrix[imu] - np.eye(3)
    assert np.abs(left.T @ left - np.eye(3)).max() < 0.003 < np.abs(shape_before).max()
    gyro = result.axes.gyro @ found[1].gyro_matrix[imu]
    sd = np.maximum(result.gyro_sd, 5e-4)
    assert np.all(np.abs(gyro - left) < 4 * np.hypot(sd, 1e-3))
    assert np.abs(gyro - left).max() < 0.008
    assert result.gyro_sd.max() < 0.005 and result.accel_sd.max() < 0.005


def test_too_few_rests_give_no_result() -> None:
    assert fit_axes(found_in(orientations(FEWEST - 1))[0], 0) is None
