"""Change of the IMUs' biases with their temperature, learned from rests in recordings.

The bias of an axis is b + o_s + r_k + s (T - 25 °C): b of the glove, o_s of a session, r_k of a
rest (g-sensitivity, since rests have different orientations, and slow drift), s the slope. A slope
that was learned before is the prior, so that a glove file improves with each session.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker import GRAVITY
from tracker.glove.correction import ROOM_C
from tracker.glove.model import ImuDrift
from tracker.messages import Array, IntArray

WINDOW_S, LEAST_WINDOWS = 1.0, 3
"""s of packets that are judged together, and how many of them are a rest."""
STILL = np.deg2rad(1.0)
"""rad/s: largest standard deviation of a gyroscope's axis in a window at rest."""
SLOWEST = np.deg2rad(10.0)
"""rad/s: a larger mean is a rotation; biases are within ±5 °/s."""
STEADY = np.deg2rad(0.15)
"""rad: largest change of the direction of gravity from a window to the next one at rest. A worn
hand sways by a degree, which is not a change of the bias."""


class _Sizes(NamedTuple):
    """Standard deviations: of the slope (°C⁻¹), of b, o_s and r_k, and of a window's mean."""

    slope: float
    bias: float
    session: float
    rest: float
    window: float


_DEGREE, _MG = np.pi / 180, 1e-3 * GRAVITY
GYRO = _Sizes(0.08 * _DEGREE, 2.0 * _DEGREE, 0.1 * _DEGREE, 0.06 * _DEGREE, 0.1 * _DEGREE)
"""Slope: a third of the limit of an MPU-9250, ±30 °/s from -40 to 85 °C."""
ACCEL = _Sizes(0.5 * _MG, 20.0, 1.0, 20.0, 0.05)
"""Slope: a third of the data sheet's ±1.5 mg/°C. A rest has any orientation: only the change within
one counts."""


@dataclass(frozen=True, eq=False)
class Rests:
    """Windows (m,) at rest of one IMU in one session: rest (m,) the number of the rest, celsius
    (m,), gyro (m, 3) rad/s and accel (m, 3) m/s²."""

    rest: IntArray
    celsius: Array
    gyro: Array
    accel: Array


def rests_of(t: Array, celsius: Array, gyro: Array, accel: Array) -> Rests:
    """From packets of one IMU at t (N,) s, with its temperature (N,); NaN where it is unknown."""
    size = max(2, round(WINDOW_S * (len(t) - 1) / max(float(t[-1] - t[0]), 1e-9)))
    count = len(t) // size
    windows = [x[: count * size].reshape(count, size, *x.shape[1:]) for x in (celsius, gyro, accel)]
    means = [w.mean(axis=1) for w in windows]
    return at_rest(windows[1].std(axis=1).max(axis=1), *means)


def at_rest(spread: Array, celsius: Array, gyro: Array, accel: Array) -> Rests:
    """Those of one IMU's windows that are at rest: ``spread`` (m,) is the largest standard
    deviation of an axis of the gyroscope, the others are means (m,) and (m, 3); windows are a
    second each, in order. A rest has at least `LEAST_WINDOWS`."""
    still = (spread < STILL) & np.isfinite(celsius)
    still &= (np.abs(gyro).max(axis=1) < SLOWEST) & np.isfinite(accel).all(axis=1)
    steady = _turned(accel) < STEADY
    moved = still[:-1] & still[1:] & ~steady
    still &= ~(np.append(moved, False) | np.append(False, moved))
    begins = still & ~np.append(False, still[:-1])
    rest = np.cumsum(begins) - 1
    still &= np.bincount(rest[still], minlength=len(rest) + 1)[rest] >= LEAST_WINDOWS
    numbers = np.unique(rest[still], return_inverse=True)[1]
    return Rests(numbers, celsius[still], gyro[still], accel[still])


def _turned(accel: Array) -> Array:
    """(m - 1,) rad between the directions of successive accel (m, 3)."""
    size = np.linalg.norm(accel, axis=1)
    cross = np.linalg.norm(np.cross(accel[:-1], accel[1:]), axis=1)
    turned: Array = cross / np.maximum(size[:-1] * size[1:], 1e-9)
    return turned


def fit_drift(sessions: Sequence[Rests], before: ImuDrift | None = None) -> ImuDrift | None:
    """The slopes of one IMU from its rests in several sessions; ``before`` is the prior, by default
    the data sheet. None if there are no rests and no prior."""
    sessions = [s for s in sessions if len(s.rest)]
    if not sessions:
        return before
    gyro, gyro_sd = _fit(sessions, "gyro", GYRO, before)
    accel, accel_sd = _fit(sessions, "accel", ACCEL, before)
    return ImuDrift(gyro, gyro_sd, accel, accel_sd)


def _fit(
    sessions: Sequence[Rests], kind: str, sizes: _Sizes, before: ImuDrift | None
) -> tuple[Array, Array]:
    """Slope (3,) and its standard deviation: the mean of a Gaussian posterior."""
    prior = np.zeros(3) if before is None else getattr(before, kind)
    sd = np.full(3, sizes.slope) if before is None else getattr(before, f"{kind}_sd")
    A, variances = _design(sessions, sizes)
    y = np.concatenate([getattr(s, kind) for s in sessions])
    AtA, Aty = A.T @ A / sizes.window**2, A.T @ y / sizes.window**2
    slope, slope_sd = np.empty(3), np.empty(3)
    for axis in range(3):
        information = 1 / np.concatenate([[max(sd[axis], 1e-12) ** 2], variances])
        covariance = np.linalg.inv(AtA + np.diag(information))
        weighted = Aty[:, axis].copy()
        weighted[0] += prior[axis] * information[0]
        slope[axis] = (covariance @ weighted)[0]
        slope_sd[axis] = np.sqrt(covariance[0, 0])
    return slope, slope_sd


def _design(sessions: Sequence[Rests], sizes: _Sizes) -> tuple[Array, Array]:
    """Rows of windows, columns: slope, b, sessions, rests; and variances of all but the slope."""
    rests = [int(s.rest.max()) + 1 for s in sessions]
    rows = sum(len(s.rest) for s in sessions)
    A = np.zeros((rows, 2 + len(sessions) + sum(rests)))
    row, column = 0, 2 + len(sessions)
    for k, s in enumerate(sessions):
        here = np.arange(row, row + len(s.rest))
        A[here, 0], A[here, 1], A[here, 2 + k] = s.celsius - ROOM_C, 1.0, 1.0
        A[here, column + s.rest] = 1.0
        row, column = row + len(s.rest), column + rests[k]
    parts = [[sizes.bias], [sizes.session] * len(sessions), [sizes.rest] * sum(rests)]
    return A, np.concatenate(parts) ** 2
