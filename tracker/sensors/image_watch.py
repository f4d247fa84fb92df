"""Notices images that show nothing: black, torn, the last one again, or none at all."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import Notice, notice, warning

Image = NDArray[np.uint8]
STEP = 16
"""Every 16th row and column is looked at: 3600 pixels of a 720p image."""
TORN_ROWS = 8
"""Rows at the bottom that a torn image fills with one colour; sensor noise never does."""
SATURATED = 250


@dataclass(frozen=True)
class WatchParams:
    """When an image counts as black (its brightest looked-at pixel) or the camera as frozen."""

    black_level: int = 24
    frozen_after: float = 0.5  # s of one and the same image


class ImageWatch:
    """Judges the images of one camera. A live sensor's noise makes no two images equal."""

    def __init__(self, params: WatchParams | None = None) -> None:
        self._params = params or WatchParams()
        self._last: Image | None = None
        self._last_change = 0.0
        self.black = False
        self.repeated = False
        self.frozen = False
        self.torn = False
        """The end of the image did not arrive: the decoder has filled it up."""

    def look(self, image: Image, t: float) -> None:
        """Take the image (h, w, 3) that came at ``t`` (s) and update the verdicts."""
        sample = image[::STEP, ::STEP].copy()
        self.black = int(sample.max()) < self._params.black_level
        self.repeated = self._last is not None and np.array_equal(sample, self._last)
        if not self.repeated:
            self._last, self._last_change = sample, t
        self.frozen = t - self._last_change > self._params.frozen_after
        self.torn = not self.black and _filled(image[-TORN_ROWS:])


def _filled(rows: Image) -> bool:
    """Whether all is one colour that no light too bright for the sensor explains."""
    colour = rows[0, 0]
    return int(colour.max()) < SATURATED and bool((rows == colour).all())


class SilenceWatch:
    """Reports once that no image arrived for ``after`` s, and once that images arrive again."""

    def __init__(self, after: float = 0.5) -> None:
        self._after = after
        self._last: float | None = None
        self._silent = False

    def received(self, t: float) -> Notice | None:
        """An image arrived at ``t`` (s)."""
        self._last = t
        if not self._silent:
            return None
        self._silent = False
        return notice("camera.images_back")

    def look(self, t: float) -> Notice | None:
        """No image arrived until ``t`` (s)."""
        if self._silent or self._last is None or t - self._last <= self._after:
            return None
        self._silent = True
        return warning("camera.no_images", silent_s=self._after)
