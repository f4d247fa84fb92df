"""Times of images from the driver's time stamps, which the computer's load does not delay.

Video for Linux stamps each buffer on the monotonic clock, a network stream on one of its own. An
image cannot arrive before it was stamped, so the smallest delay of the last seconds is the one
without queuing: that delay and the stamp give an arrival time without jitter, on any clock.
"""

from __future__ import annotations

import math
from collections import deque
from typing import Protocol, runtime_checkable

MEMORY = 5.0  # s: two clocks drift by 0.5 ms in it at 100 ppm
APART = 0.25  # s by which steps of stamps and of arrivals may differ
LEAST_STEP = 1e-4  # s between two images


@runtime_checkable
class HasStamps(Protocol):
    """An image input whose driver timestamps its images."""

    def stamp(self) -> float:
        """Time stamp (s) of the image that was read last, on any clock; NaN without one."""


class SteadyArrivals:
    """Call `arrival` for each image, and `restart` after a disconnection."""

    def __init__(self) -> None:
        self.restart()

    def restart(self) -> None:
        """Clears the history."""
        self._delays: deque[tuple[float, float]] = deque()  # (arrival, arrival - stamp)
        self._last_stamp = self._last_arrival = math.nan
        self._last = -math.inf

    @property
    def is_stamped(self) -> bool:
        """Whether the driver's stamps are in use."""
        return len(self._delays) > 1

    def arrival(self, arrival: float, stamp: float) -> float:
        """Arrival time (s) without queuing; ``arrival`` if the stamps are not usable."""
        if not self._is_usable(arrival, stamp):
            self._delays.clear()
        self._last_stamp, self._last_arrival = stamp, arrival
        if not math.isfinite(stamp) or stamp <= 0.0:
            self._last = arrival
            return arrival
        self._delays.append((arrival, arrival - stamp))
        while self._delays[0][0] < arrival - MEMORY:
            self._delays.popleft()
        steady = stamp + min(delay for _, delay in self._delays)
        self._last = min(max(steady, self._last + LEAST_STEP), arrival)
        return self._last

    def _is_usable(self, arrival: float, stamp: float) -> bool:
        """Whether the stamp has advanced by about as much as the arrival time."""
        step = stamp - self._last_stamp
        return step > 0.0 and abs((arrival - self._last_arrival) - step) < APART
