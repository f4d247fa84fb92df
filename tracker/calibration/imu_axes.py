"""Scale and cross-axis errors of a glove's IMUs from rests in several positions, without equipment.

The method is that of Tedaldi, Pretto and Menegatti (2014), doi:10.1109/ICRA.2014.6907297, with the
data sheet's tolerances as a prior. At rest an accelerometer measures gravity, whose magnitude is
known; between two rests the gyroscope, integrated, must turn one direction of gravity into the
other. Both corrections refer to the accelerometer's axes: x is its x axis, and y is in the plane of
its x and y axes. The small rotation that remains is part of the mounting.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.glove.model import ImuAxes
from tracker.messages import Array, ImuSample

BLOCK_S, LEAST_BLOCKS = 0.25, 4
"""s of packets that are judged together, and how many of them are a rest."""
STILL = np.deg2rad(1.0)
"""rad/s: largest standard deviation of a gyroscope's axis at rest; noise alone is 0.1 °/s."""
LONGEST_GAP = 0.1
"""s without a packet, after which a rotation is not known."""
APART = np.deg2rad(25.0)
"""Least angle between two positions that count as different."""
POSITIONS = 12
"""Different positions that the procedure asks for. Six are the least for a result."""
FEWEST = 6
SD_NORM, SD_TURN = 0.01, 0.004
"""m/s² of the magnitude of gravity at rest; rad of its direction after a rotation: g-sensitivity
and noise of the gyroscope in 3 s."""
SD_SCALE, SD_CROSS, SD_BIAS = 0.01, 0.01, 0.25
"""Prior: a third of the data sheet's ±3 %, half of ±2 % for two axes, and 25 mg."""


@dataclass(eq=False)
class Rest:
    """accel and gyro (n, 3): means of each IMU, NaN where it did not answer."""

    accel: Array
    gyro: Array


class Turn(NamedTuple):
    """Between two rests: steps (m,) s and gyro (m, n, 3) rad/s, NaN where an IMU was missing."""

    steps: Array
    gyro: Array


@dataclass(eq=False)
class RestFinder:
    """Finds the rests in packets, which come in order of time."""

    rests: list[Rest] = field(default_factory=list)
    turns: list[Turn] = field(default_factory=list)
    """``turns[k]`` is between ``rests[k]`` and the next one."""
    is_still: bool = False
    """Whether the last block was a rest."""
    _block: list[ImuSample] = field(default_factory=list)
    _still: list[list[ImuSample]] = field(default_factory=list)
    _moving: list[ImuSample] = field(default_factory=list)

    def add(self, sample: ImuSample) -> None:
        """Takes a packet."""
        self._block.append(sample)
        if sample.t - self._block[0].t >= BLOCK_S:
            self._judge(self._block)
            self._block = []

    def _judge(self, block: list[ImuSample]) -> None:
        gyro = np.array([s.gyro for s in block])
        answers = np.isfinite(gyro).all(axis=(0, 2))
        self.is_still = bool(answers.any() and gyro[:, answers].std(axis=0).max() < STILL)
        if not self.is_still:
            if len(self._still) < LEAST_BLOCKS:
                self._moving += [s for still in self._still for s in still]
            self._still = []
            self._moving += block
            return
        self._still.append(block)
        if len(self._still) == LEAST_BLOCKS:
            self._begin()
        elif len(self._still) > LEAST_BLOCKS:
            self.rests[-1] = _rest(self._still)

    def _begin(self) -> None:
        if self.rests:
            self.turns.append(_turn(self._moving, self._still[0][0]))
        self.rests.append(_rest(self._still))
        self._moving = []

    def positions(self) -> int:
        """Number of rests that differ from all before by `APART` in the direction of gravity, in
        the IMU that shows the fewest."""
        if not self.rests:
            return 0
        ups = np.array([r.accel for r in self.rests])
        ups /= np.linalg.norm(ups, axis=2, keepdims=True)
        answers = np.isfinite(ups).all(axis=(0, 2))
        return min((_different(ups[:, j]) for j in np.flatnonzero(answers)), default=0)


def _different(ups: Array) -> int:
    found: list[Array] = []
    for up in ups:
        if all(float(up @ other) < np.cos(APART) for other in found):
            found.append(up)
    return len(found)


def _rest(blocks: Sequence[Sequence[ImuSample]]) -> Rest:
    samples = [s for block in blocks for s in block]
    accel, gyro = (np.array([getattr(s, name) for s in samples]) for name in ("accel", "gyro"))
    return Rest(accel.mean(axis=0), gyro.mean(axis=0))


def _turn(moving: Sequence[ImuSample], end: ImuSample) -> Turn:
    t = np.array([s.t for s in (*moving, end)])
    steps = np.diff(t)
    n = len(end.gyro)
    gyro = np.array([s.gyro for s in moving]).reshape(-1, n, 3)
    gyro[steps > LONGEST_GAP] = np.nan
    return Turn(steps, gyro)


class AxesResult(NamedTuple):
    """One IMU: the correction, the standard deviations of its elements (each (3, 3), 0 for those
    that are fixed), and the root mean square of its residuals in standard deviations."""

    axes: ImuAxes
    gyro_sd: Array
    accel_sd: Array
    misfit: float


def fit_axes(found: RestFinder, imu: int) -> AxesResult | None:
    """The correction of one IMU by least squares; None if it has fewer than `FEWEST` rests."""
    accel = np.array([r.accel[imu] for r in found.rests]).reshape(-1, 3)
    if np.isfinite(accel).all(axis=1).sum() < FEWEST:
        return None
    problem = _Problem(accel, [_steps(found, k, imu) for k in range(len(found.turns))])
    solution = least_squares(problem.residuals, np.zeros(18), x_scale=0.01)
    covariance = np.linalg.inv(solution.jac.T @ solution.jac)
    sd = np.sqrt(np.diag(covariance))
    measured = problem.measured(solution.x)
    misfit = float(np.sqrt(np.mean(measured**2))) if len(measured) else 0.0
    accel_sd = np.zeros((3, 3))
    accel_sd[UPPER] = sd[:6]
    axes = ImuAxes(_gyro(solution.x), _accel(solution.x))
    return AxesResult(axes, sd[9:].reshape(3, 3), accel_sd, misfit)


UPPER = np.triu_indices(3)
_PRIOR = np.concatenate(
    [np.where(UPPER[0] == UPPER[1], SD_SCALE, SD_CROSS), np.full(3, SD_BIAS), np.full(9, SD_CROSS)]
)


def _accel(x: Array) -> Array:
    """(3, 3) of the parameters (18,): six of it, three biases, nine of the gyroscope."""
    matrix: Array = np.eye(3)
    matrix[UPPER] += x[:6]
    return matrix


def _gyro(x: Array) -> Array:
    return np.eye(3) + np.reshape(x[9:], (3, 3))


def _steps(found: RestFinder, k: int, imu: int) -> Array | None:
    """(m, 3) rad: rotations of a turn without the bias, as measured; None if a part is missing."""
    turn, before, after = found.turns[k], found.rests[k], found.rests[k + 1]
    gyro = turn.gyro[:, imu]
    share = np.linspace(0, 1, len(gyro))[:, None] if len(gyro) else np.zeros((0, 1))
    bias = (1 - share) * before.gyro[imu] + share * after.gyro[imu]
    steps = (gyro - bias) * turn.steps[: len(gyro), None]
    return steps if np.isfinite(steps).all() else None


class _Problem:
    """Residuals in standard deviations for the rests' accel (K, 3) and the turns between them."""

    def __init__(self, accel: Array, turns: list[Array | None]) -> None:
        self._accel, self._turns = accel, turns

    def residuals(self, x: Array) -> Array:
        return np.concatenate([self.measured(x), x / _PRIOR])

    def measured(self, x: Array) -> Array:
        up = (self._accel - x[6:9]) @ _accel(x).T
        size = np.linalg.norm(up, axis=1)
        known = np.isfinite(size)
        parts = [(size[known] - GRAVITY) / SD_NORM]
        for k, steps in enumerate(self._turns):
            if steps is None or not known[k] or not known[k + 1]:
                continue
            R = _product(so3.exp(steps @ _gyro(x).T))
            parts.append((up[k + 1] / size[k + 1] - R.T @ (up[k] / size[k])) / SD_TURN)
        return np.concatenate(parts)


def _product(R: Array) -> Array:
    """R[0] R[1] … of (m, 3, 3), in pairs."""
    if len(R) == 0:
        return np.eye(3)
    while len(R) > 1:
        last = R[-1:] if len(R) % 2 else R[:0]
        R = np.concatenate([R[: len(R) - len(last) : 2] @ R[1::2], last])
    out: Array = R[0]
    return out
