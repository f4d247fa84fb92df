"""When the next packet of a glove is expected, so that no image is begun just before it.

An image takes the engine's thread a few milliseconds, and a packet that arrives meanwhile waits.
Packets are regular: an image that is begun right after one is finished before the next.
"""

from __future__ import annotations

import math
from itertools import pairwise

LATE = 0.0015  # s after which an expected packet is no longer waited for
LONGEST = 0.012  # s that an image is held in all
SPARE = 0.0025  # s of a gap that its first packet, and an early next one, may use
NEW = 0.1  # weight of a new value in a mean
ENOUGH = 1.3  # times the mean duration of an image; the longest are three times as long
MISSED = 3.0  # periods; a longer interval says nothing about the period
MOST_PERIOD = 0.05  # s; rarer packets are not waited for


class PacketRhythm:
    """All times in s of one clock; for one thread at a time."""

    def __init__(self) -> None:
        self._last: dict[str, float] = {}  # arrival, by the side of the hand
        self._period: dict[str, float] = {}
        self._takes = 0.0  # mean of recent images
        self._until = math.inf  # when the held image is begun at the latest

    def packet(self, side: str, now: float) -> None:
        """A packet has arrived."""
        last, self._last[side] = self._last.get(side), now
        if last is None:
            return
        period = self._period.setdefault(side, now - last)
        self._period[side] += NEW * (min(now - last, MISSED * period) - period)

    def expected(self, side: str) -> float:
        """When the next packet of this hand is expected; infinite without packets."""
        return self._last[side] + self._period[side] if side in self._period else math.inf

    def image(self, took: float) -> None:
        """An image was processed within ``took``."""
        self._takes += NEW * (took - self._takes)

    def begun(self) -> None:
        """The image is no longer held."""
        self._until = math.inf

    def hold(self, now: float) -> float:
        """How long to wait for a packet at most before the next image is begun; 0: begin it."""
        expected = sorted(
            self._last[side] + period
            for side, period in self._period.items()
            if period <= MOST_PERIOD and now < self._last[side] + period + LATE
        )
        if not expected or now >= self._until:
            return 0.0
        ends = [*expected, expected[0] + min(self._period.values())]
        longest = max(b - a for a, b in pairwise(ends))
        ahead = expected[0] - now
        if ahead >= min(ENOUGH * self._takes, longest - SPARE):
            return 0.0
        self._until = min(self._until, now + LONGEST)
        return min(max(ahead, 0.0) + LATE, self._until - now)
