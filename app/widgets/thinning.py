"""Curves thinned to what a screen can show."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array

WORTH = 4
"""Points a column from which on a curve is thinned; the columns keep two each."""


def thinned(t: Array, values: Array, begin: float, end: float, columns: int) -> tuple[Array, Array]:
    """The part of t (n,), growing, and values (n,) between ``begin`` and ``end``, with a neighbour
    on either side; of many points the least and the greatest for each of ``columns``.

    Columns are at multiples of their width, so that a curve that scrolls keeps its form. One with
    a NaN is NaN: interruptions stay.
    """
    first = max(0, int(np.searchsorted(t, begin)) - 1)
    last = int(np.searchsorted(t, end, side="right")) + 1
    t, values = t[first:last], values[first:last]
    if len(t) <= WORTH * columns or end <= begin:
        return t, values
    width = (end - begin) / columns
    edges = np.arange(np.floor(t[0] / width) + 1, np.floor(t[-1] / width) + 1) * width
    starts = np.concatenate([[0], np.searchsorted(t, edges)])
    starts = starts[np.diff(starts, append=len(t)) > 0]  # columns with a point
    out = np.empty((len(starts), 2))
    out[:, 0] = np.minimum.reduceat(values, starts)
    out[:, 1] = np.maximum.reduceat(values, starts)
    return np.repeat(t[starts], 2), out.ravel()
