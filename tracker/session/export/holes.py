"""Where a series says nothing: instants that are missing, and numbers that are lost."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array

LONGEST_FILLED = 0.1
"""s between two known values, beyond which nothing is put between them."""


def runs(t: Array, known: NDArray[np.bool_]) -> list[slice]:
    """Stretches of the rising times ``t`` (s) whose known rows lie close to one another.

    Each begins and ends with a known row. Rows inside that are not known are bridged: from the
    known one before to the one behind is no longer than `LONGEST_FILLED`.
    """
    rows = np.flatnonzero(known)
    if len(rows) == 0:
        return []
    breaks = np.flatnonzero(np.diff(t[rows]) > LONGEST_FILLED + 1e-9)
    first = np.r_[0, breaks + 1]
    last = np.r_[breaks, len(rows) - 1]
    return [slice(int(rows[a]), int(rows[b]) + 1) for a, b in zip(first, last, strict=True)]


def gaps(t: Array, known: NDArray[np.bool_]) -> list[tuple[float, float]]:
    """(from, to) in s of `t` where nothing is known for longer than `LONGEST_FILLED`.

    From the last known instant to the next; from the first or to the last instant at the ends.
    """
    found = runs(t, known)
    if not found:
        return [(float(t[0]), float(t[-1]))]
    ends = [float(t[0]), *(float(t[r.stop - 1]) for r in found)]
    starts = [*(float(t[r.start]) for r in found), float(t[-1])]
    pairs = list(zip(ends, starts, strict=True))
    return [(a, b) for a, b in pairs if b - a > LONGEST_FILLED + 1e-9]
