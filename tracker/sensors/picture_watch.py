"""Notices pictures that show nothing: black ones, and ones that are the last picture again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]
STEP = 16
"""Every 16th row and column is looked at: 3600 pixels of a 720p picture."""


@dataclass(frozen=True)
class WatchParams:
    """When a picture counts as black (its brightest looked-at pixel) or the camera as frozen."""

    black_level: int = 24
    frozen_after: float = 0.5  # s of one and the same picture


class PictureWatch:
    """Judges the pictures of one lens. A live sensor's noise makes no two pictures equal."""

    def __init__(self, params: WatchParams | None = None) -> None:
        self._params = params or WatchParams()
        self._last: Image | None = None
        self._last_change = 0.0
        self.black = False
        self.repeated = False
        self.frozen = False

    def look(self, image: Image, t: float) -> None:
        """Take the picture (h, w, 3) that came at ``t`` (s) and update the verdicts."""
        sample = image[::STEP, ::STEP].copy()
        self.black = int(sample.max()) < self._params.black_level
        self.repeated = self._last is not None and np.array_equal(sample, self._last)
        if not self.repeated:
            self._last, self._last_change = sample, t
        self.frozen = t - self._last_change > self._params.frozen_after
