"""Gyro biases and noise of every IMU while the hand is at rest; a moving hand is rejected."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.base.notices import Notice, warning
from tracker.messages import Array, ImuSample

DEGREE = np.pi / 180
MOVING = {"still.imu_moves", "still.imu_biased"}


@dataclass(frozen=True)
class StillParams:
    """Limits that a hand on a table meets, and one held in the air does not."""

    duration: float = 2.0  # s
    gyro_sd: float = 1.0 * DEGREE  # rad/s, of one axis
    drift: float = 0.5 * DEGREE  # rad/s, between the first and the second half
    accel_sd: float = 0.25  # m/s²
    gyro_bias: float = 10.0 * DEGREE  # rad/s, twice the data sheet's
    gravity: float = 0.8  # m/s², twice the effect of an offset of ±60 mg
    answered: float = 0.8  # share of packets in which the IMU must be valid


@dataclass(frozen=True, eq=False)
class StillImu:
    """One IMU: gyro_bias (3,) rad/s with its sd, gyro_noise rad/s/√Hz, accel (3,) mean m/s² in I.

    ``problem`` is None if the figures may be used.
    """

    name: str
    gyro_bias: Array
    gyro_bias_sd: float
    gyro_noise: float
    accel: Array
    problem: Notice | None = None


@dataclass(frozen=True, eq=False)
class StillPose:
    """All IMUs in the glove's order; ``problem`` is the reason why all are rejected."""

    imus: tuple[StillImu, ...]
    problem: Notice | None = None

    @property
    def ok(self) -> bool:
        return self.problem is None


def still_pose(
    samples: Sequence[ImuSample], names: Sequence[str], params: StillParams | None = None
) -> StillPose:
    """Evaluates ``samples`` of a hand at rest for each of the IMUs ``names``."""
    p = params or StillParams()
    span = samples[-1].t - samples[0].t if samples else 0.0
    if span < 0.9 * p.duration:
        return StillPose((), warning("still.too_short", seconds=span, needed_s=p.duration))
    gyro, accel = (np.array([getattr(s, k) for s in samples]) for k in ("gyro", "accel"))
    valid = np.array([s.valid for s in samples])
    rate_hz = (len(samples) - 1) / span
    imus = tuple(
        _one(name, gyro[valid[:, i], i], accel[valid[:, i], i], valid[:, i].mean(), rate_hz, p)
        for i, name in enumerate(names)
    )
    return StillPose(imus, _verdict(imus))


def _one(
    name: str, gyro: Array, accel: Array, answered: float, rate_hz: float, p: StillParams
) -> StillImu:
    if answered < p.answered or len(gyro) < 2:
        nan = np.full(3, np.nan)
        return StillImu(name, nan, np.nan, np.nan, nan, warning("still.imu_silent"))
    sd = gyro.std(axis=0, ddof=1)
    half = len(gyro) // 2
    drift = float(np.abs(gyro[:half].mean(axis=0) - gyro[half:].mean(axis=0)).max())
    return StillImu(
        name=name,
        gyro_bias=gyro.mean(axis=0),
        # a slow drift is not averaged out: half of it remains in the mean
        gyro_bias_sd=float(np.hypot(sd.max() / np.sqrt(len(gyro)), drift / 2)),
        gyro_noise=float(np.sqrt(np.mean(sd**2) / (rate_hz / 2))),
        accel=accel.mean(axis=0),
        problem=_problem_of(gyro, accel, drift, p),
    )


def _problem_of(gyro: Array, accel: Array, drift: float, p: StillParams) -> Notice | None:
    sd, bias = float(gyro.std(axis=0).max()), float(np.abs(gyro.mean(axis=0)).max())
    if sd > p.gyro_sd or drift > p.drift or float(accel.std(axis=0).max()) > p.accel_sd:
        return warning("still.imu_moves", rate_dps=max(sd, drift) / DEGREE)
    if bias > p.gyro_bias:
        return warning("still.imu_biased", bias_dps=bias / DEGREE)
    weight = float(np.linalg.norm(accel.mean(axis=0)))
    if abs(weight - GRAVITY) > p.gravity:
        return warning("still.imu_gravity", gravity=weight)
    return None


def _verdict(imus: Sequence[StillImu]) -> Notice | None:
    broken = [i for i in imus if i.problem is not None]
    moving = [i.name for i in broken if i.problem is not None and i.problem.code in MOVING]
    if moving:
        return warning("still.moved", moving=moving)
    if not broken:
        return None
    return warning(
        "still.imus", imus=[warning("still.imu", imu=i.name, what=i.problem) for i in broken]
    )
