"""Holes in a series of estimates: missing instants and lost values.

The one definition of a hole: more than `LONGEST_FILLED` between two known values. Nothing is
interpolated, drawn, measured or counted as tracked across it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array

LONGEST_FILLED = 0.1
"""s between two known values, beyond which the gap is not interpolated."""
_ROUNDING = 1e-9  # s


def runs(t: Array, known: NDArray[np.bool_]) -> list[slice]:
    """Returns runs of the increasing times ``t`` (s) without a hole.

    Each begins and ends with a known row and may contain unknown ones: successive known rows are at
    most `LONGEST_FILLED` apart.
    """
    rows = np.flatnonzero(known)
    if len(rows) == 0:
        return []
    breaks = np.flatnonzero(np.diff(t[rows]) > LONGEST_FILLED + _ROUNDING)
    first = np.r_[0, breaks + 1]
    last = np.r_[breaks, len(rows) - 1]
    return [slice(int(rows[a]), int(rows[b]) + 1) for a, b in zip(first, last, strict=True)]


def gaps(t: Array, known: NDArray[np.bool_]) -> list[tuple[float, float]]:
    """(from, to) in s of `t` where nothing is known for longer than `LONGEST_FILLED`: from the last
    known instant to the next, at the ends from the first or to the last instant.
    """
    found = runs(t, known)
    if not found:
        return [(float(t[0]), float(t[-1]))]
    ends = [float(t[0]), *(float(t[r.stop - 1]) for r in found)]
    starts = [*(float(t[r.start]) for r in found), float(t[-1])]
    pairs = list(zip(ends, starts, strict=True))
    return [(a, b) for a, b in pairs if b - a > LONGEST_FILLED + _ROUNDING]


def is_hole(before: float, after: float) -> bool:
    """Whether there is a hole between the instants (s) of two consecutive known values."""
    return after - before > LONGEST_FILLED + _ROUNDING


def with_breaks(t: Array, values: Array, longest: float = LONGEST_FILLED) -> tuple[Array, Array]:
    """``t`` (N,) s and ``values`` (N, ...) with a row of NaN in the middle of each hole, so that a
    line drawn through them is interrupted there. ``longest`` (s) replaces `LONGEST_FILLED` for
    series with a lower rate than the estimates."""
    after = np.flatnonzero(np.diff(t) > longest + _ROUNDING) + 1
    if len(after) == 0:
        return t, np.asarray(values, float)
    middle = (t[after] + t[after - 1]) / 2
    return np.insert(t, after, middle), np.insert(np.asarray(values, float), after, np.nan, axis=0)


def durations(t: Array) -> Array:
    """Returns the duration (N,) s that each value at increasing times ``t`` (N,) s represents: half
    the distance to both neighbours, at an end of a run the same on both sides. Holes are not
    represented."""
    half = np.diff(t) / 2
    half[half * 2 > LONGEST_FILLED + _ROUNDING] = np.nan
    before, after = np.r_[np.nan, half][: len(t)], np.r_[half, np.nan][: len(t)]
    outwards = np.where(np.isnan(before), after, before), np.where(np.isnan(after), before, after)
    return np.asarray(np.nan_to_num(outwards[0]) + np.nan_to_num(outwards[1]))


def time_shares(t: Array) -> Array:
    """Returns the share (N,) of the time that each value at ``t`` (N,) s represents; they add up to
    1 without holes."""
    each = durations(t)
    if len(t) == 0 or not each.any():
        return np.full(len(t), 1.0 / max(len(t), 1))
    outside = (each[0] - _inside(t[:2])) + (each[-1] - _inside(t[-2:]))
    return np.asarray(each / (t[-1] - t[0] + outside))


def _inside(pair: Array) -> float:
    """Returns the time (s) between two neighbours that one of them represents."""
    step = float(pair[-1] - pair[0])
    return 0.0 if step > LONGEST_FILLED + _ROUNDING else step / 2
