"""The IMUs as curves and states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.viewmodels.states import BAD, GOOD, IDLE, WARN, Look
from tracker.messages import Array, ImuSample

STALE = 0.5
"""s without a sample after which an IMU counts as silent."""


@dataclass(frozen=True, eq=False)
class Curves:
    """t (n,) s before now (negative), values (n, 3)."""

    t: Array
    values: Array


@dataclass(frozen=True)
class ImuState:
    name: str
    look: Look
    text: str


def curves(samples: Sequence[ImuSample], imu: int, kind: str, span: float) -> Curves:
    """The last ``span`` s of one IMU: kind "gyro" in °/s or "accel" in g."""
    if not samples:
        return Curves(np.zeros(0), np.zeros((0, 3)))
    now = samples[-1].t
    recent = [s for s in samples if s.t >= now - span]
    t = np.array([s.t - now for s in recent])
    rows = np.array([(s.gyro if kind == "gyro" else s.accel)[imu] for s in recent])
    return Curves(t, np.rad2deg(rows) if kind == "gyro" else rows / 9.80665)


def imu_states(
    names: tuple[str, ...], samples: Sequence[ImuSample], running: bool
) -> list[ImuState]:
    """Per IMU: answers, answers with gaps, or silent; judged over the last second."""
    if not samples or not running:
        return [ImuState(n, IDLE, "no samples") for n in names]
    now = samples[-1].t
    recent = [s for s in samples if s.t >= now - 1.0]
    valid = np.array([s.valid for s in recent]).mean(axis=0)
    return [_state(name, float(share)) for name, share in zip(names, valid, strict=True)]


def _state(name: str, share: float) -> ImuState:
    if share > 0.99:
        return ImuState(name, GOOD, "answers")
    if share > 0:
        return ImuState(name, WARN, f"{100 * (1 - share):.0f} % missing")
    return ImuState(name, BAD, "silent")


def jitter_ms(samples: Sequence[ImuSample]) -> float:
    """Standard deviation of the arrival intervals, ms; NaN below three samples."""
    if len(samples) < 3:
        return float("nan")
    arrivals = np.array([s.t_arrival for s in list(samples)[-100:]])
    return float(1000 * np.diff(arrivals).std())
