"""Detects unusable images: black, torn, repeated or missing ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import Notice, notice, warning

Image = NDArray[np.uint8]
STEP = 16
"""Every 16th row and column is evaluated: 3600 pixels of a 720p image."""
TORN_ROWS = 8
"""Rows at the bottom that a torn image fills with one colour; sensor noise never does."""
SATURATED = 250


@dataclass(frozen=True)
class WatchParams:
    """Limits at which an image counts as black (its brightest evaluated pixel) or the camera as
    frozen."""

    black_level: int = 24
    frozen_after: float = 0.5  # s of identical images


class ImageWatch:
    """Checks the images of one camera. A live sensor's noise makes all images differ."""

    def __init__(self, params: WatchParams | None = None) -> None:
        self._params = params or WatchParams()
        self._last: Image | None = None
        self._last_change = 0.0
        self.black = False
        self.repeated = False
        self.frozen = False
        self.torn = False
        """The end of the image was lost, and the decoder has filled it."""

    def look(self, image: Image, t: float) -> None:
        """Updates the verdicts with the image (h, w, 3) that arrived at ``t`` (s)."""
        sample = image[::STEP, ::STEP].copy()
        self.black = int(sample.max()) < self._params.black_level
        self.repeated = self._last is not None and np.array_equal(sample, self._last)
        if not self.repeated:
            self._last, self._last_change = sample, t
        self.frozen = t - self._last_change > self._params.frozen_after
        self.torn = not self.black and _filled(image[-TORN_ROWS:])


def _filled(rows: Image) -> bool:
    """Whether all pixels have one colour that overexposure does not explain."""
    colour = rows[0, 0]
    return int(colour.max()) < SATURATED and bool((rows == colour).all())


class StallWatch:
    """Reports once that no image arrived for ``after`` s, and once that images arrive again."""

    def __init__(self, after: float = 0.5) -> None:
        self._after = after
        self._last: float | None = None
        self._stalled = False

    def received(self, t: float) -> Notice | None:
        """An image arrived at ``t`` (s)."""
        self._last = t
        if not self._stalled:
            return None
        self._stalled = False
        return notice("camera.images_back")

    def look(self, t: float) -> Notice | None:
        """No image arrived until ``t`` (s)."""
        if self._stalled or self._last is None or t - self._last <= self._after:
            return None
        self._stalled = True
        return warning("camera.no_images", silent_s=self._after)
