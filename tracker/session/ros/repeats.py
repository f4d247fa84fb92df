"""Messages that differ from an earlier one only in their times and numbers.

A recording contains the names of all segments and joints in each of its messages. What was read of
one is remembered: of the next message of the same bytes, apart from times and float64 numbers, only
these are read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tracker.base.clock import NS
from tracker.messages import Array

MOST = 64  # layouts that are remembered per kind of message


class Values(NamedTuple):
    """``stamps``: ns since 1970; ``numbers``: (n,) float64, writable."""

    stamps: list[int]
    numbers: Array


class FieldLayout:
    """Where a message of these bytes has its times and its numbers, by the offsets of their first
    bytes; ``texts`` are the names in it."""

    def __init__(
        self, data: bytes, times: Sequence[int], numbers: Sequence[int], texts: tuple[str, ...]
    ) -> None:
        self.texts = texts
        self._times = np.add.outer(np.array(times, np.intp), np.arange(8))
        self._numbers = np.add.outer(np.array(numbers, np.intp), np.arange(8)).ravel()
        same = np.ones(len(data), bool)
        same[self._times], same[self._numbers] = False, False
        self._same = np.flatnonzero(same)
        self._known = np.frombuffer(data, np.uint8)[self._same].tobytes()
        order = "<" if data[1] else ">"
        self._time = np.dtype([("s", f"{order}i4"), ("ns", f"{order}u4")])
        self._float = np.dtype(f"{order}f8")

    def values(self, data: bytes) -> Values | None:
        """None if anything else differs: names, the number of values, the byte order."""
        raw = np.frombuffer(data, np.uint8)
        if raw[self._same].tobytes() != self._known:
            return None
        times = raw[self._times].view(self._time).ravel()
        stamps = times["s"].astype(np.int64) * NS + times["ns"]
        numbers = raw[self._numbers].view(self._float).astype(np.float64)
        return Values(stamps.tolist(), numbers)


class Layouts:
    """The layouts of one kind of message, by their length in bytes."""

    def __init__(self) -> None:
        self._known: dict[int, FieldLayout] = {}

    def find(self, data: bytes) -> tuple[Values, tuple[str, ...]] | None:
        """Values and names of a message like one that is known."""
        layout = self._known.get(len(data))
        values = None if layout is None else layout.values(data)
        return None if layout is None or values is None else (values, layout.texts)

    def remember(self, data: bytes, layout: FieldLayout) -> None:
        if len(self._known) >= MOST:
            self._known = {}
        self._known[len(data)] = layout
