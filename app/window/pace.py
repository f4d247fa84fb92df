"""How often the window is drawn: as often as it can, but never at the cost of what is tracked.

Tracking and window share a computer and Python's lock. Where images are left out for want of time,
people see no more than a slower picture, and a tracker misses what never comes again.
"""

from __future__ import annotations

HURRIED = 0.6
"""Share of a processor that the window takes, painting included, where a motor or a robot waits
for the hand. What tracks it shares Python's lock: a window that paints all the time holds up every
packet. Where only people look it may take all there is."""
LEAST, LESS, MORE = 0.3, 0.8, 0.01
"""While images are left out the share shrinks by `LESS` at each look, down to `LEAST`; else it
grows by `MORE`: back within twenty seconds, so that it does not swing."""
SLOWEST = 1 / 20  # s between two drawings that hold it to no share: it must not look stuck


class Pace:
    """Whether it is time to draw again; times in s, ``spent`` is the processor time of the thread
    that draws."""

    def __init__(self) -> None:
        self.share = 1.0
        self._last = (0.0, 0.0)  # when it was drawn last, and what was spent by then

    def look(self, strained: bool) -> None:
        """Told a few times a second whether images are left out, or anything else."""
        if strained:
            self.share = max(LEAST, LESS * self.share)
        else:
            self.share = min(1.0, self.share + MORE)

    def is_due(self, now: float, spent: float, hurried: bool) -> bool:
        """Whether to draw ``now``; then what follows is counted from here. ``hurried``: something
        follows the hand that cannot wait."""
        since, used = now - self._last[0], spent - self._last[1]
        held = self.share < 1.0 and used > self.share * since and since < SLOWEST
        if held or (hurried and used > HURRIED * since):
            return False
        self._last = now, spent
        return True
