"""The error of interpolation in the middle of a gap, measured on the session's own motion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.messages import Array
from tracker.session.gaps.interpolate import (
    SPEED_OVER,
    Mask,
    RecordedMotion,
    SessionSkeleton,
    fill_motion,
)
from tracker.session.holes import LONGEST_FILLED

TRIALS = 24  # trial gaps for each length
_HALVINGS = 6  # of a length for which the session has no complete stretch
_GROWTH = 2**1.5  # of the error with twice the length, for extrapolation: between 2 and 2²
_PER_OCTAVE = 2  # trial lengths


class Spread:
    """Errors of one method on a hand's ``motion``; ``known`` (N, K) are values that were not
    interpolated.

    Trial gaps of the same length are cut where the hand is known, evenly over the session, filled,
    and compared with the removed motion. The motion around a real gap may be faster.
    """

    def __init__(
        self,
        motion: RecordedMotion,
        known: Mask,
        skeleton: SessionSkeleton,
        method: str,
        shape: RecordedMotion | None = None,
    ) -> None:
        """``shape``: as for `fill_motion`, with the rows of ``motion``."""
        self._m, self._known, self._of, self._method = motion, known, skeleton, method
        self._shape = shape
        self._measured: dict[tuple[object, ...], Array] = {}

    def middle(self, columns: Sequence[int], angles: Sequence[int], length: float) -> Array:
        """(n,) m standard deviation of each keypoint of ``columns`` along an axis, in the middle of
        a gap of ``length`` s in which also ``angles`` are missing; NaN if no stretch is long
        enough."""
        octave = round(_PER_OCTAVE * np.log2(length))
        key = (tuple(columns), tuple(angles), octave)
        if key not in self._measured:
            self._measured[key] = self._measure(columns, angles, 2.0 ** (octave / _PER_OCTAVE))
        return self._measured[key]

    def _measure(self, columns: Sequence[int], angles: Sequence[int], length: float) -> Array:
        for halved in range(_HALVINGS + 1):
            part = length / 2**halved
            trials = [self._error(rows, columns, angles) for rows in self._stretches(columns, part)]
            errors = [error for error in trials if np.isfinite(error).all()]
            if errors:
                mean = np.mean(np.square(errors), axis=0)
                return np.asarray(np.sqrt(mean / 3) * _GROWTH**halved)
        return np.full(len(columns), np.nan)

    def _stretches(self, columns: Sequence[int], length: float) -> list[tuple[int, int]]:
        """Rows before and after each trial gap."""
        t = self._m.t
        if len(t) < 3 or t[-1] - t[0] < length:
            return []
        centres = t[0] + (t[-1] - t[0]) * (np.arange(TRIALS) + 0.5) / TRIALS
        before = np.searchsorted(t, centres - length / 2)
        after = np.searchsorted(t, centres + length / 2)
        pairs = zip(before.tolist(), after.tolist(), strict=True)
        return [(a, b) for a, b in dict.fromkeys(pairs) if self._is_whole(a, b, columns, length)]

    def _is_whole(self, a: int, b: int, columns: Sequence[int], length: float) -> bool:
        t = self._m.t
        if b >= len(t) or b - a < 2 or t[b] - t[a] < 0.9 * length:
            return False
        near = bool((np.diff(t[a : b + 1]) <= LONGEST_FILLED).all())
        return near and bool(self._known[a : b + 1, columns].all())

    def _error(self, rows: tuple[int, int], columns: Sequence[int], angles: Sequence[int]) -> Array:
        """(n,) m of each keypoint at the row nearest to the middle."""
        t = self._m.t
        low = int(np.searchsorted(t, t[rows[0]] - SPEED_OVER))
        high = int(np.searchsorted(t, t[rows[1]] + SPEED_OVER, side="right"))
        part = self._m.part(slice(low, high))
        a, b = rows[0] - low, rows[1] - low
        free = np.zeros(part.angles.shape, bool)
        free[a + 1 : b, angles] = True
        middle = a + int(np.argmin(np.abs(part.t[a:b] - (part.t[a] + part.t[b]) / 2)))
        truth = part.keypoints[middle, columns].copy()
        _forget(part, (a, b), columns, free)
        shape = None if self._shape is None else self._shape.part(slice(low, high))
        missing = {k: [(a, b)] for k in columns}
        fill_motion(part, self._of, missing, free, self._method, shape)
        return np.asarray(np.linalg.norm(part.keypoints[middle, columns] - truth, axis=1))


def _forget(
    part: RecordedMotion, rows: tuple[int, int], columns: Sequence[int], free: Mask
) -> None:
    inside = slice(rows[0] + 1, rows[1])
    part.keypoints[inside, columns] = np.nan
    part.q[inside, columns] = np.nan
    part.angles[free] = np.nan


def grown(share: Array, first: Array, last: Array, middle: Array) -> Array:
    """(n, K) m standard deviations at the shares (n,) of gaps, from those at both ends (K,) and
    what interpolation adds in the middle (K,): the variance of a Brownian bridge."""
    u = share[:, None]
    ends = (1 - u) * np.nan_to_num(first) ** 2 + u * np.nan_to_num(last) ** 2
    return np.asarray(np.sqrt(ends + 4 * u * (1 - u) * middle**2))
