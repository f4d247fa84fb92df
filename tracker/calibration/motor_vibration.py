"""Vibration of a glove's motors in its IMUs, from packets before and during a run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tracker.messages import Array, ImuSample

SMOOTH_S = 0.2
"""s of the moving mean that is subtracted: movements of the hand are slower than a motor."""
FEWEST = 20
"""Packets in each of the two parts."""


class Vibration(NamedTuple):
    """Of one motor in each IMU: gyro (n,) rad/s and accel (n,) m/s², standard deviations of
    the axis that vibrates most; ``period`` s between two packets."""

    gyro: Array
    accel: Array
    period: float

    @property
    def densities(self) -> tuple[Array, Array]:
        """(n,) rad/s/√Hz and m/s²/√Hz of white noise of the same size."""
        root = np.sqrt(self.period)
        return self.gyro * root, self.accel * root


def vibration_of(before: Sequence[ImuSample], during: Sequence[ImuSample]) -> Vibration | None:
    """The noise that is added during a run; None for too few packets. NaN becomes 0."""
    if len(before) < FEWEST or len(during) < FEWEST:
        return None
    period = float(np.median(np.diff([s.t for s in during])))
    size = max(3, round(SMOOTH_S / max(period, 1e-4)))
    added = []
    for name in ("gyro", "accel"):
        still, shaken = (_variance(part, name, size) for part in (before, during))
        added.append(np.sqrt(np.nan_to_num(np.maximum(shaken - still, 0.0))).max(axis=1))
    return Vibration(added[0], added[1], period)


def _variance(samples: Sequence[ImuSample], name: str, size: int) -> Array:
    """(n, 3) about the moving mean of ``size`` packets."""
    values = np.array([getattr(s, name) for s in samples])
    size = min(size, len(values) // 2)
    sums = np.cumsum(np.concatenate([np.zeros((1, *values.shape[1:])), values]), axis=0)
    mean = (sums[size:] - sums[:-size]) / size
    start = size // 2
    variance: Array = np.var(values[start : start + len(mean)] - mean, axis=0)
    return variance * size / (size - 1)
