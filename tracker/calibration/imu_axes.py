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
SD_NORM, SD_TURN = 0.01, 0.002
"""m/s² of the magnitude of gravity at rest; rad of its direction after a rotation."""
SD_SCALE, SD_CROSS, SD_BIAS = 0.01, 0.01, 0.25
"""Prior: a third of the data sheet's ±3 %, half of ±2 % for two axes, and 25 mg."""
SD_GYRO_BIAS, SD_SENSITIVITY = np.deg2rad(0.5), np.deg2rad(0.1) / GRAVITY
"""Prior: rad/s about the mean of all rests; rad/s per m/s² of each axis to each acceleration."""


@dataclass(eq=False)
class Rest:
    """Blocks of packets at rest.

    A worn hand sways by 2 °/s at rest. Gravity is therefore compared between the first half second
    and the last one, and the gyroscope is integrated from the middle of the one to that of the
    other.
    """

    blocks: list[list[ImuSample]]

    @property
    def accel(self) -> Array:
        """(n, 3): mean of each IMU, NaN where it did not answer."""
        return _mean(self.blocks, "accel")

    @property
    def gyro(self) -> Array:
        """(n, 3), likewise."""
        return _mean(self.blocks, "gyro")

    @property
    def first(self) -> Array:
        """accel (n, 3) about the beginning of the second block."""
        return _mean(self.blocks[:2], "accel")

    @property
    def last(self) -> Array:
        """accel (n, 3) about the beginning of the last block."""
        return _mean(self.blocks[-2:], "accel")

    @property
    def inside(self) -> Turn:
        """Between the instants of `first` and `last`."""
        middle = [s for block in self.blocks[1:-1] for s in block]
        return _turn(middle, self.blocks[-1][0])


class Turn(NamedTuple):
    """Packets: steps (m,) s to the next one, gyro (m, n, 3) rad/s and accel (m, n, 3) m/s², NaN
    where an IMU was missing."""

    steps: Array
    gyro: Array
    accel: Array


@dataclass(eq=False)
class RestFinder:
    """Finds the rests in packets, which come in order of time."""

    rests: list[Rest] = field(default_factory=list)
    is_still: bool = False
    """Whether the last block was a rest."""
    _block: list[ImuSample] = field(default_factory=list)
    _still: list[list[ImuSample]] = field(default_factory=list)
    _moving: list[ImuSample] = field(default_factory=list)
    _between: list[list[ImuSample]] = field(default_factory=list)
    """Packets between each rest and the next one."""

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

    def _begin(self) -> None:
        if self.rests:
            self._between.append(self._moving)
        self.rests.append(Rest(self._still))  # the list continues to grow
        self._moving = []

    def turns(self) -> list[Turn]:
        """From the end of each rest to the beginning of the next one."""
        return [
            _turn([*before.blocks[-1], *moving, *after.blocks[0]], after.blocks[1][0])
            for before, moving, after in zip(
                self.rests, self._between, self.rests[1:], strict=False
            )
        ]

    @property
    def rest_s(self) -> float:
        """s of the present rest; 0 while the glove moves or has just stopped."""
        return BLOCK_S * len(self._still) if len(self._still) >= LEAST_BLOCKS else 0.0

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


def _mean(blocks: Sequence[Sequence[ImuSample]], name: str) -> Array:
    mean: Array = np.mean([getattr(s, name) for block in blocks for s in block], axis=0)
    return mean


def _turn(samples: Sequence[ImuSample], end: ImuSample) -> Turn:
    steps = np.diff([s.t for s in (*samples, end)])
    n = len(end.gyro)
    gyro = np.array([s.gyro for s in samples]).reshape(-1, n, 3)
    gyro[steps > LONGEST_GAP] = np.nan
    return Turn(steps, gyro, np.array([s.accel for s in samples]).reshape(-1, n, 3))


class AxesResult(NamedTuple):
    """One IMU: the correction, the standard deviations of its elements (each (3, 3), 0 for those
    that are fixed), and the root mean square of its residuals in standard deviations."""

    axes: ImuAxes
    gyro_sd: Array
    accel_sd: Array
    misfit: float


def fit_axes(found: RestFinder, imu: int) -> AxesResult | None:
    """The correction of one IMU by least squares; None if it has fewer than `FEWEST` rests."""
    from scipy.optimize import least_squares  # deferred: slow to load

    rests = found.rests
    accel = np.array([r.accel[imu] for r in rests]).reshape(-1, 3)
    if np.isfinite(accel).all(axis=1).sum() < FEWEST:
        return None
    bias = np.nanmean([r.gyro[imu] for r in rests], axis=0)
    inside = [_path(r.inside, imu, bias, r.first, r.last) for r in rests]
    between = [
        _path(turn, imu, bias, before.last, after.first)
        for turn, before, after in zip(found.turns(), rests, rests[1:], strict=False)
    ]
    paths = [p for p in (*inside, *between) if p is not None]
    problem = _Problem(accel[np.isfinite(accel).all(axis=1)], paths)
    solution = least_squares(problem.residuals, np.zeros(len(_PRIOR)), x_scale=_PRIOR)
    covariance = np.linalg.inv(solution.jac.T @ solution.jac)
    sd = np.sqrt(np.diag(covariance))
    measured = problem.measured(solution.x)
    misfit = float(np.sqrt(np.mean(measured**2))) if len(measured) else 0.0
    accel_sd = np.zeros((3, 3))
    accel_sd[UPPER] = sd[:6]
    axes = ImuAxes(_gyro(solution.x), _accel(solution.x))
    return AxesResult(axes, sd[9:18].reshape(3, 3), accel_sd, misfit)


UPPER = np.triu_indices(3)
_PRIOR = np.concatenate(
    [
        np.where(UPPER[0] == UPPER[1], SD_SCALE, SD_CROSS),
        np.full(3, SD_BIAS),
        np.full(9, SD_CROSS),
        np.full(3, SD_GYRO_BIAS),
        np.full(9, SD_SENSITIVITY),
    ]
)


def _accel(x: Array) -> Array:
    """(3, 3) of the parameters (30,): six of it, three biases; nine of the gyroscope, three biases
    and nine of its sensitivity to acceleration."""
    matrix: Array = np.eye(3)
    matrix[UPPER] += x[:6]
    return matrix


def _gyro(x: Array) -> Array:
    return np.eye(3) + np.reshape(x[9:18], (3, 3))


class _Path(NamedTuple):
    """A rotation as measured: steps (m, 1) s, gyro (m, 3) without the mean bias, accel (m, 3); and
    gravity before and after it, (3,) each."""

    steps: Array
    gyro: Array
    accel: Array
    before: Array
    after: Array


def _path(turn: Turn, imu: int, bias: Array, before: Array, after: Array) -> _Path | None:
    """None if a part is missing."""
    steps = turn.steps[:, None]
    path = _Path(steps, turn.gyro[:, imu] - bias, turn.accel[:, imu], before[imu], after[imu])
    return path if all(np.isfinite(x).all() for x in path) else None


class _Problem:
    """Residuals in standard deviations for the rests' accel (K, 3) and the rotations in and between
    them."""

    def __init__(self, accel: Array, paths: list[_Path]) -> None:
        self._accel, self._paths = accel, paths

    def residuals(self, x: Array) -> Array:
        return np.concatenate([self.measured(x), x / _PRIOR])

    def measured(self, x: Array) -> Array:
        accel, gyro, sensitivity = _accel(x), _gyro(x), np.reshape(x[21:], (3, 3))
        size = np.linalg.norm((self._accel - x[6:9]) @ accel.T, axis=1)
        parts = [(size - GRAVITY) / SD_NORM]
        for path in self._paths:
            rate = path.gyro - x[18:21] - path.accel @ sensitivity.T
            R = _product(so3.exp((rate * path.steps) @ gyro.T))
            up, then = (accel @ (f - x[6:9]) for f in (path.before, path.after))
            error = then / np.linalg.norm(then) - R.T @ (up / np.linalg.norm(up))
            parts.append(error / SD_TURN)
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
