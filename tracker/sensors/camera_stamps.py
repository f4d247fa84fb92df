"""Times of images from the driver's time stamps, which the computer's load does not delay.

Video for Linux stamps each buffer on the monotonic clock, a network stream on one of its own. An
image cannot arrive before it was stamped, so the smallest delay of the last seconds is the one
without queuing: that delay and the stamp give an arrival time without jitter, on any clock.

A stream of JPEG images, such as that of many network cameras, has no time stamps. FFmpeg then
counts images, at 25 per second, so the stamps tell nothing of a camera with another rate or of lost
images. Such stamps have equal steps and leave the clock, and are not used.
"""

from __future__ import annotations

import math
from collections import deque
from typing import Protocol, runtime_checkable

MEMORY = 5.0  # s: two clocks drift by 0.5 ms in it at 100 ppm
APART = 0.25  # s by which steps of stamps and of arrivals may differ
LEAST_STEP = 1e-4  # s between two images
EQUAL = 2e-6  # s by which counted stamps' steps differ: rounding
LEFT = 0.02  # s by which counted stamps leave the clock within the memory before they are rejected
PROOF = 2.0  # s after which stamps with equal steps are used if they have not left the clock
FEWEST = 10  # images


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
        self._steps = math.inf, -math.inf  # the least and the largest of the stamps
        self._is_counted = self._in_use = False
        self._last_stamp = self._last_arrival = math.nan
        self._last = -math.inf

    @property
    def is_stamped(self) -> bool:
        """Whether the driver's stamps are in use."""
        return self._in_use

    def arrival(self, arrival: float, stamp: float) -> float:
        """Arrival time (s) without queuing; ``arrival`` if the stamps are not usable."""
        if not self._is_usable(arrival, stamp):
            self._delays.clear()
            self._steps = math.inf, -math.inf
        else:
            step = stamp - self._last_stamp
            self._steps = min(self._steps[0], step), max(self._steps[1], step)
        self._last_stamp, self._last_arrival = stamp, arrival
        if not math.isfinite(stamp) or stamp <= 0.0 or self._is_counted:
            self._last = arrival
            return arrival
        self._delays.append((arrival, arrival - stamp))
        while self._delays[0][0] < arrival - MEMORY:
            self._delays.popleft()
        if self._are_counted():
            self._is_counted = True
            self._delays.clear()
        if self._is_counted or self._may_be_counted(arrival):
            self._in_use, self._last = False, arrival
            return arrival
        self._in_use = True
        steady = stamp + min(delay for _, delay in self._delays)
        self._last = min(max(steady, self._last + LEAST_STEP), arrival)
        return self._last

    def _are_counted(self) -> bool:
        """Whether the stamps are multiples of a step and leave the clock of the arrivals: the least
        delays of the older and the newer images, which queuing does not affect, differ."""
        if len(self._delays) < FEWEST or self._steps[1] - self._steps[0] > EQUAL:
            return False
        delays = [delay for _, delay in self._delays]
        half = len(delays) // 2
        return abs(min(delays[:half]) - min(delays[half:])) > LEFT

    def _may_be_counted(self, arrival: float) -> bool:
        equal = self._steps[1] - self._steps[0] <= EQUAL
        return equal and arrival - self._delays[0][0] < PROOF

    def _is_usable(self, arrival: float, stamp: float) -> bool:
        """Whether the stamp has advanced by about as much as the arrival time."""
        step = stamp - self._last_stamp
        return step > 0.0 and abs((arrival - self._last_arrival) - step) < APART
