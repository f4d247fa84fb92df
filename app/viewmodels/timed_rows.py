"""Figures of the last seconds, instant by instant, as arrays that need not be built again."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array

FIRST_CAPACITY = 256


class TimedRows:
    """Rows (k,) at growing instants, none more than ``span`` s before the last one."""

    def __init__(self, span: float) -> None:
        self._span = span
        self.clear()

    def clear(self) -> None:
        """Forget all."""
        self._t = np.empty(0)
        self._rows = np.empty((0, 0))
        self._begin = self._end = 0

    def __len__(self) -> int:
        return self._end - self._begin

    @property
    def t(self) -> Array:
        """(n,) s; valid until the next row is added."""
        return self._t[self._begin : self._end]

    @property
    def rows(self) -> Array:
        """(n, k); valid until the next row is added."""
        return self._rows[self._begin : self._end]

    def add(self, t: float, row: Array) -> None:
        """One more, later than the last."""
        self.extend(np.array([t]), row[None])

    def extend(self, t: Array, rows: Array) -> None:
        """More at once: t (m,) growing and later than the last, rows (m, k)."""
        count = len(t)
        if count == 0:
            return
        if self._end + count > len(self._t):
            self._make_room(count, rows.shape[1])
        end = self._end + count
        self._t[self._end : end], self._rows[self._end : end] = t, rows
        self._end = end
        self._begin += int(np.searchsorted(self.t, t[-1] - self._span))

    def _make_room(self, count: int, width: int) -> None:
        """Move what is left to the front; where it fills half, into twice the room."""
        kept = len(self)
        t = np.empty(max(2 * (kept + count), FIRST_CAPACITY))
        rows = np.empty((len(t), width))
        if kept:
            t[:kept], rows[:kept] = self.t, self.rows
        self._t, self._rows = t, rows
        self._begin, self._end = 0, kept
