"""Packets that a session contains more than once: a network or a merge has duplicated them."""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Iterable, Iterator
from typing import TypeVar

import numpy as np

from tracker.engine.hands import Sided
from tracker.messages import ImuSample

REMEMBERED = 1024  # packets of a glove, 10 s at 100 Hz
T = TypeVar("T")


class Repeats:
    """Removes packets that are repeated, and counts them by the glove's side."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()
        self._seen: dict[str, OrderedDict[tuple[float, int], ImuSample]] = {}

    def without(self, messages: Iterable[T]) -> Iterator[T]:
        """``messages`` without repeated packets."""
        for message in messages:
            if isinstance(message, Sided) and self._is_repeated(message.side, message.sample):
                self.counts[message.side] += 1
            else:
                yield message

    def _is_repeated(self, side: str, sample: ImuSample) -> bool:
        """Returns whether an earlier packet had the same number, instant and readings.

        If each message of a packet is duplicated, the second packet has no readings.
        """
        seen = self._seen.setdefault(side, OrderedDict())
        key = sample.t, sample.seq
        earlier = seen.get(key)
        if earlier is None:
            seen[key] = sample
            if len(seen) > REMEMBERED:
                seen.popitem(last=False)
            return False
        new = sample.valid
        return bool(
            np.all(earlier.valid[new])
            and np.array_equal(sample.accel[new], earlier.accel[new])
            and np.array_equal(sample.gyro[new], earlier.gyro[new])
        )
