"""Reports colours that do not match: many patches for a while, but no hand."""

from __future__ import annotations

from tracker.base.notices import Outbox, notice, warning
from tracker.messages import BlobFrame, Tracking

DELAY = 2.0  # s
MANY = 2.0  # patches in one image for each of the glove's markers
GAP = 1.0  # s without images, after which it starts over


class ColourWatch:
    """For one glove with this number of ``markers``; times in s of the images' stamps."""

    def __init__(self, markers: int) -> None:
        self._markers = markers
        self._since = self._last = float("-inf")
        self._most = 0
        self.notices = Outbox()
        self.unfit = False

    def look(self, blobs: BlobFrame, tracking: Tracking) -> None:
        """Adds an image and its result."""
        count = max((len(b) for b in (blobs.left, blobs.right) if b is not None), default=0)
        lost = tracking in (Tracking.SEARCHING, Tracking.LOST)
        if not lost or not self._is_strange(count) or blobs.t - self._last > GAP:
            self._begin(blobs.t)
        self._last = blobs.t
        if not (lost and self._is_strange(count)):
            return
        self._most = max(self._most, count)
        if not self.unfit and blobs.t - self._since >= DELAY:
            self.unfit = True
            self.notices.post(warning("colours.unfit", patches=self._most))

    def _is_strange(self, count: int) -> bool:
        """Whether there are more patches than a glove and a room should show."""
        return count > MANY * self._markers

    def _begin(self, t: float) -> None:
        if self.unfit:
            self.notices.post(notice("colours.fit_again"))
        self._since, self._most, self.unfit = t, 0, False

    def figures(self) -> dict[str, float]:
        """Whether the colours are the likely cause now."""
        return {"colours_unfit": float(self.unfit)}
