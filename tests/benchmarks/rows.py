"""Rows of the benchmark, and the timing that fills them: interleaved rounds, medians, ratios."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from tracker.messages import Array

Call = Callable[[], object]


@dataclass(frozen=True)
class BenchRow:
    """One line of the table. ``ratio`` is value / peer_value; None where there is no peer."""

    name: str
    value: float
    unit: str
    peer: str
    peer_value: float | None
    ratio: float | None
    goal: str


def row(
    name: str, value: float, unit: str, peer: str, peer_value: float | None, goal: str
) -> BenchRow:
    """A row with its ratio worked out."""
    ratio = float(value / peer_value) if peer_value else None
    theirs = None if peer_value is None else float(peer_value)
    return BenchRow(name, float(value), unit, peer, theirs, ratio, goal)


def interleaved(calls: Sequence[Call], rounds: int, inner: int | Sequence[int] = 1) -> Array:
    """Median seconds of each call; every round runs each of them ``inner`` times in a row.

    With ``inner`` for each call, one of microseconds can be run until it fills milliseconds, so
    that its first run in a row, with the other's data in the caches, does not decide.

    A first call of each, which may compile, is not counted. Seconds are the processor's: on a busy
    machine the wall's would count waiting, and against the longer call.
    """
    for call in calls:
        call()
    runs = [inner] * len(calls) if isinstance(inner, int) else list(inner)
    times = np.empty((rounds, len(calls)))
    for r in range(rounds):
        for k, (call, count) in enumerate(zip(calls, runs, strict=True)):
            start = time.process_time()
            for _ in range(count):
                call()
            times[r, k] = (time.process_time() - start) / count
    return np.median(times, axis=0)
