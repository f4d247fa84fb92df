"""Times of images by the driver's time stamps, which do not wait for a busy computer.

Video for Linux stamps each buffer on the monotonic clock, a network stream on one of its own. An
image cannot arrive before it was stamped, so the smallest delay of the last seconds is the one
without waiting: that delay and the stamp give an arrival without jitter, whatever the clock.
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
        """s, of the image that was read last, on any clock; NaN without one."""


class SteadyArrivals:
    """Call `arrival` for each image; `restart` after a device was away."""

    def __init__(self) -> None:
        self.restart()

    def restart(self) -> None:
        """Forget all images."""
        self._delays: deque[tuple[float, float]] = deque()  # (arrival, arrival - stamp)
        self._last_stamp = self._last_arrival = math.nan
        self._last = -math.inf

    @property
    def is_stamped(self) -> bool:
        """Whether the driver's stamps are in use."""
        return len(self._delays) > 1

    def arrival(self, arrival: float, stamp: float) -> float:
        """s: when the image would have arrived at once; ``arrival`` without usable stamps."""
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
        """Whether the stamp has advanced about as much as the arrival has."""
        step = stamp - self._last_stamp
        return step > 0.0 and abs((arrival - self._last_arrival) - step) < APART
