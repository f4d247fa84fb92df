"""The parts of a file by the log times of their messages."""

from __future__ import annotations

from array import array
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

RUN = 2**20
"""Loose messages are gathered in runs of this many bytes."""


class Span(NamedTuple):
    """A part of the file with messages from an interval of log times: a chunk, or loose
    messages."""

    start: int
    end: int
    offset: int
    length: int
    channels: frozenset[int] | None  # None where unknown


class Spans:
    """Many spans in little memory (an hour of images has 400,000)."""

    def __init__(self) -> None:
        self._numbers = array("Q")
        self._sets: list[frozenset[int] | None] = []
        self._known: dict[frozenset[int], frozenset[int]] = {}
        self._order: tuple[NDArray[np.int64], NDArray[np.uint64], NDArray[np.uint64]] | None = None

    def add(self, span: Span) -> None:
        self._numbers.extend(span[:4])
        channels = span.channels
        self._sets.append(None if channels is None else self._known.setdefault(channels, channels))

    def __len__(self) -> int:
        return len(self._sets)

    def __getitem__(self, i: int) -> Span:
        if i < 0:
            raise IndexError(i)
        a, b, c, d = self._numbers[4 * i : 4 * i + 4]
        return Span(a, b, c, d, self._sets[i])

    @property
    def channels(self) -> frozenset[int]:
        """Ids of all channels with messages in known spans."""
        return frozenset().union(*self._known)

    def bounds(self) -> tuple[int, int]:
        """Returns the first and last log time; (0, 0) without messages."""
        _, starts, latest = self._sorted()
        return (int(starts[0]), int(latest[-1])) if len(self) else (0, 0)

    def between(self, start: int, end: int) -> NDArray[np.int64]:
        """Returns indices of spans that touch [start, end), by start and then by offset."""
        order, starts, latest = self._sorted()
        first = np.searchsorted(latest, np.uint64(max(start, 0)))
        last = np.searchsorted(starts, np.uint64(max(end, 0)))
        return order[first:last]

    def _sorted(self) -> tuple[NDArray[np.int64], NDArray[np.uint64], NDArray[np.uint64]]:
        """The spans' order by start, the starts in that order, and the latest end up to each."""
        if self._order is None or len(self._order[0]) != len(self):
            rows = np.array(self._numbers, np.uint64).reshape(-1, 4)
            order = np.lexsort((rows[:, 2], rows[:, 0]))
            rows = rows[order]
            self._order = order, rows[:, 0].copy(), np.maximum.accumulate(rows[:, 1])
        return self._order


class LooseMessages:
    """Messages outside of chunks; adjacent ones form one span."""

    def __init__(self, spans: Spans) -> None:
        self._spans = spans
        self._offset = self._length = self._start = self._end = 0

    def add(self, offset: int, length: int, log_time: int) -> None:
        if self._length and self._length + length > RUN:
            self.flush()
        if not self._length:
            self._offset, self._start, self._end = offset, log_time, log_time
        self._length += length
        self._start, self._end = min(self._start, log_time), max(self._end, log_time)

    def flush(self) -> None:
        if self._length:
            self._spans.add(Span(self._start, self._end, self._offset, self._length, None))
        self._length = 0
