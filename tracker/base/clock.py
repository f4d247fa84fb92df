"""Time as whole nanoseconds at the borders and float seconds inside.

A session stores wall-clock nanoseconds; the engine works in seconds of a monotonic clock. Every
``t`` is made by `seconds` from an integer, so that a value read back from a file is the same float.
"""

from __future__ import annotations

import time
from dataclasses import dataclass

NS = 1_000_000_000
EXACT_BELOW_NS = 4 * 10**15
"""46 days: up to here neighbouring floats of seconds are less than a nanosecond apart."""
COARSE_NS = 1000
"""Beyond it, on computers that run for longer, instants are whole microseconds: `seconds` and
`nanoseconds` stay each other's inverse for 34 years."""


def on_grid(ns: int) -> int:
    """The nearest instant that a float can hold."""
    if -EXACT_BELOW_NS < ns < EXACT_BELOW_NS:
        return ns
    return (ns + COARSE_NS // 2) // COARSE_NS * COARSE_NS


def next_instant(ns: int) -> int:
    """The first instant after ``ns`` that a float can hold."""
    at = on_grid(ns)
    return at + (1 if -EXACT_BELOW_NS < at < EXACT_BELOW_NS else COARSE_NS)


def seconds(ns: int) -> float:
    """The float time ``t`` of an integer number of nanoseconds; see `COARSE_NS`."""
    return on_grid(ns) / NS


def nanoseconds(t: float) -> int:
    """The integer of nanoseconds of ``t``; the inverse of `seconds`."""
    return on_grid(round(t * NS))


def monotonic() -> float:
    """Seconds of the host's monotonic clock now, a whole number of nanoseconds."""
    return seconds(time.monotonic_ns())


@dataclass(frozen=True)
class ClockAnchor:
    """One instant on both clocks: what turns monotonic time into the stamps of a file.

    The difference is fixed for a session's life, so stamps never jump when the wall clock is set.
    """

    wall_ns: int
    monotonic_ns: int

    def wall(self, t: float) -> int:
        """Nanoseconds since 1970 for the monotonic time ``t`` (s)."""
        return nanoseconds(t) + self.wall_ns - self.monotonic_ns

    def monotonic(self, wall_ns: int) -> float:
        """The monotonic time (s) of a stamp in nanoseconds since 1970."""
        return seconds(wall_ns - self.wall_ns + self.monotonic_ns)

    def at(self, t: float) -> ClockAnchor:
        """Returns the same two clocks, anchored at the monotonic time ``t`` (s); stamps do not
        change."""
        return ClockAnchor(self.wall(t), nanoseconds(t))
