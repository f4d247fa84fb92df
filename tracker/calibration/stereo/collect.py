"""Selects exposures as views: still ones, each different from the others."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from tracker.calibration.stereo.coverage import novelty
from tracker.calibration.stereo.views import BoardLook, StereoView


@dataclass(frozen=True)
class CollectParams:
    """``still_px``: maximum median motion of corners since the last exposure; with faster motion,
    cameras that are not synchronised would disagree."""

    still_px: float = 2.0
    novelty: float = 1.0
    most: int = 60


class ExposureResult(Enum):
    """The result for an exposure."""

    TAKEN = "taken"
    ABSENT = "absent"
    MOVING = "moving"
    KNOWN = "known"
    FULL = "full"


class Collector:
    """The views collected so far. Not thread-safe."""

    def __init__(self, width: int, params: CollectParams | None = None) -> None:
        self._width, self.params = width, params or CollectParams()
        self.views: list[StereoView] = []
        self._last: StereoView | None = None

    def offer(self, look: BoardLook, live: bool = True) -> ExposureResult:
        """Add the exposure if it is useful; a single image (not ``live``) is always still."""
        view, before = look.view, self._last
        self._last = view
        if view is None:
            return ExposureResult.ABSENT
        if len(self.views) >= self.params.most:
            return ExposureResult.FULL
        if live and (before is None or _motion(view, before) > self.params.still_px):
            return ExposureResult.MOVING
        if any(novelty(view, v, self._width) < self.params.novelty for v in self.views):
            return ExposureResult.KNOWN
        self.views.append(view)
        return ExposureResult.TAKEN

    def remove(self, index: int) -> None:
        """Remove a view."""
        del self.views[index]


def _motion(view: StereoView, before: StereoView) -> float:
    """Median motion of the corners, px, maximum over all images."""
    _, i, j = np.intersect1d(view.ids, before.ids, return_indices=True)
    if len(i) == 0:
        return float("inf")
    if len(view.sides) != len(before.sides):
        return float("inf")
    moved = [now[i] - then[j] for now, then in zip(view.sides, before.sides, strict=True)]
    return max(float(np.median(np.linalg.norm(m, axis=1))) for m in moved)
