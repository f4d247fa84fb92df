"""Which exposures become views: still ones, and each different from the others."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from tracker.calibration.stereo.coverage import novelty
from tracker.calibration.stereo.views import BoardLook, StereoView


@dataclass(frozen=True)
class CollectParams:
    """``still_px``: median motion of corners since the last look, above which cameras that do not
    expose at the same instant would disagree."""

    still_px: float = 2.0
    novelty: float = 1.0
    most: int = 60


class Answer(Enum):
    """What became of an exposure."""

    TAKEN = "taken"
    ABSENT = "absent"
    MOVING = "moving"
    KNOWN = "known"
    FULL = "full"


class Collector:
    """Views taken so far. Not for more than one thread at a time."""

    def __init__(self, width: int, params: CollectParams | None = None) -> None:
        self._width, self.params = width, params or CollectParams()
        self.views: list[StereoView] = []
        self._last: StereoView | None = None

    def offer(self, look: BoardLook, live: bool = True) -> Answer:
        """Take the exposure if it is worth it; a still image (not ``live``) cannot be moving."""
        view, before = look.view, self._last
        self._last = view
        if view is None:
            return Answer.ABSENT
        if len(self.views) >= self.params.most:
            return Answer.FULL
        if live and (before is None or _motion(view, before) > self.params.still_px):
            return Answer.MOVING
        if any(novelty(view, v, self._width) < self.params.novelty for v in self.views):
            return Answer.KNOWN
        self.views.append(view)
        return Answer.TAKEN

    def remove(self, index: int) -> None:
        """Forget a view."""
        del self.views[index]


def _motion(view: StereoView, before: StereoView) -> float:
    """Median motion of the corners, px, the largest of all images."""
    _, i, j = np.intersect1d(view.ids, before.ids, return_indices=True)
    if len(i) == 0:
        return float("inf")
    if len(view.sides) != len(before.sides):
        return float("inf")
    moved = [now[i] - then[j] for now, then in zip(view.sides, before.sides, strict=True)]
    return max(float(np.median(np.linalg.norm(m, axis=1))) for m in moved)
