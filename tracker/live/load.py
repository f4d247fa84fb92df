"""Load shedding while the computer is overloaded, in the order of least loss.

First the display is reduced, then the images that tracking uses, never the packets of the glove: a
skipped image costs accuracy for a moment, a lost packet is lost motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from tracker.base.notices import Notice, Outbox, notice, warning
from tracker.messages import Shed

BEGINS: dict[Shed, Notice] = {
    Shed.VIEW_RATE: warning("load.view_slower"),
    Shed.OVERLAYS: warning("load.no_overlays"),
    Shed.WHOLE_SEARCHES: warning("load.narrow_search"),
    Shed.IMAGES: warning("load.fewer_images"),
}
ENDS: dict[Shed, Notice] = {
    Shed.VIEW_RATE: notice("load.recovered"),
    Shed.OVERLAYS: notice("load.overlays_back"),
    Shed.WHOLE_SEARCHES: notice("load.full_search"),
    Shed.IMAGES: notice("load.all_images"),
}
IMAGE_INTERVALS = (0.03, 0.045, 0.09)
"""s at least between images that are searched at `Shed.IMAGES`. While the load remains too high,
the next one applies: every second, third and sixth of 60 images a second."""


@dataclass(frozen=True)
class LoadParams:
    """Times in s. ``memory`` is that of the means that are judged."""

    packet_lag: float = 0.06  # from a packet's instant to its estimate
    image_lag: float = 0.12  # from an image's arrival to the filter
    missed: float = 0.5  # share of images that the vision thread did not search
    memory: float = 0.4
    begin: float = 0.5  # of too much, before more is shed
    end: float = 3.0  # of little, before the last is taken up again
    thicken: float = 0.5  # of little, before images are searched more often again
    little: float = 0.5  # share of the limits above
    other_clock: float = 60.0  # a lag beyond it is between two clocks, not in this computer


class _Mean:
    """For the last moments, weighed by age."""

    def __init__(self, memory: float) -> None:
        self._memory = memory
        self._weight = self._sum = 0.0
        self._last = -math.inf

    def take(self, now: float, value: float) -> None:
        keep = math.exp(-max(now - self._last, 0.0) / self._memory)
        self._weight, self._sum = keep * self._weight + 1.0, keep * self._sum + value
        self._last = now

    def value(self, now: float) -> float:
        """0 after a long time without values: that is a fault of a device, not load."""
        if not self._weight or now - self._last > 5 * self._memory:
            return 0.0
        return self._sum / self._weight


class LoadWatch:
    """Judges by lags alone; all times (s) are given. For one thread; ``level`` for any."""

    def __init__(self, params: LoadParams | None = None) -> None:
        self._params = params = params or LoadParams()
        self._packets, self._images, self._missed = (_Mean(params.memory) for _ in range(3))
        self._idle_since = self._overloaded_since = math.inf
        self._judged = -math.inf
        self._thinned = 0  # of `IMAGE_INTERVALS`
        self.level = Shed.NOTHING
        self.notices = Outbox()

    def packet(self, now: float, lag: float) -> None:
        """A packet has become an estimate, ``lag`` after its instant."""
        if lag < self._params.other_clock:
            self._packets.take(now, lag)
        self._judge(now)

    def image(self, now: float, lag: float, missed: int) -> None:
        """Takes the ``lag`` (s) of an image to the filter; ``missed`` images before it were
        skipped."""
        if lag < self._params.other_clock:
            self._images.take(now, lag)
            self._missed.take(now, missed / (1 + missed))
        self._judge(now)

    def strain(self, now: float) -> float:
        """The largest of the means over its limit: above 1 is too much."""
        p = self._params
        return max(
            self._packets.value(now) / p.packet_lag,
            self._images.value(now) / p.image_lag,
            self._missed.value(now) / p.missed,
        )

    @property
    def image_interval(self) -> float:
        """s at least between two images that are searched; any thread may ask."""
        return IMAGE_INTERVALS[self._thinned] if self.level >= Shed.IMAGES else 0.0

    def figures(self) -> dict[str, float]:
        """Returns the level, a number of `Shed`, and the share of images missed recently."""
        missed = self._missed.value(self._judged)
        return {"load_shed": float(self.level), "images_missed": missed}

    def _judge(self, now: float) -> None:
        """One step at a time, up soon and down late, so that nothing flickers."""
        self._judged = now
        p, strain = self._params, self.strain(now)
        self._overloaded_since = min(self._overloaded_since, now) if strain > 1 else math.inf
        self._idle_since = min(self._idle_since, now) if strain < p.little else math.inf
        if now - self._overloaded_since >= p.begin:
            self._overloaded_since = now
            self._leave_out_more()
        elif now - self._idle_since >= (p.thicken if self._thinned else p.end):
            self._idle_since = now
            self._leave_out_less()

    def _leave_out_more(self) -> None:
        if self.level < Shed.IMAGES:
            self.level = Shed(self.level + 1)
            self.notices.post(BEGINS[self.level])
        else:
            self._thinned = min(self._thinned + 1, len(IMAGE_INTERVALS) - 1)

    def _leave_out_less(self) -> None:
        if self._thinned:
            self._thinned -= 1
        elif self.level > Shed.NOTHING:
            self.notices.post(ENDS[self.level])
            self.level = Shed(self.level - 1)
