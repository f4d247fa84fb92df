"""Detection of blobs in the image that colours are tuned on, if no engine searches it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.colour_images import Image
from app.widgets.image_shapes import Ring
from tracker.messages import Array, Blobs
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector

MASK_STEP = 2


@dataclass(frozen=True, eq=False)
class ShownImage:
    """The image of one side with the live exposure it belongs to (None for a stored image). A
    ``frozen`` image does not change while the live one does."""

    image: Image | None
    view: Snapshot | None
    right: bool
    frozen: bool = False


@dataclass(frozen=True, eq=False)
class MaskShown:
    """The image, dimmed outside the selected range and `MASK_STEP` times smaller, with the blobs
    found; the shares (180,) of its hues; the interval of each hue (from, to, colour)."""

    image: Image
    rings: list[Ring]
    histogram: Array
    intervals: list[tuple[int, int, str]]


class ImageSearch:
    """Searches stored and frozen images and those of a replay; the engine searches live ones."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self.blobs: Blobs | None = None
        self._searched: Image | None = None  # the image that ``blobs`` belong to

    def work(self, shown: ShownImage, profile: ColourProfile | None) -> Callable[[], Blobs] | None:
        """A search of the image for another thread; None if the engine searches it, or without a
        ``profile``, while that changes continuously."""
        image = shown.image if self.is_own(shown) and profile is not None else None
        if image is None or (image is not self._searched and (shown.view is None or shown.frozen)):
            self.blobs = None
        self._searched = image
        if image is None or profile is None:
            return None
        size, fx = float(self._setup.glove.marker_size.mean()), self._setup.camera.rig.fx
        return lambda: Detector(profile, size, fx).detect(image)[0]

    def is_own(self, shown: ShownImage) -> bool:
        """Whether the engine does not search this image with the current colours."""
        return shown.view is None or shown.frozen or self._setup.player is not None

    def is_new(self, shown: ShownImage) -> bool:
        """Whether the image has to be searched here and has not been."""
        return self.is_own(shown) and shown.image is not self._searched

    def found(self, blobs: Blobs) -> None:
        """Store the result of the last `work`."""
        self.blobs = blobs

    def rings(self, shown: ShownImage, hue: int, colour: str) -> list[Ring]:
        """Around the blobs of a hue, in pixels of the mask."""
        blobs, view = self.blobs, shown.view
        if view is not None and view.blobs is not None and not self.is_own(shown):
            blobs = view.blobs.right if shown.right else view.blobs.left
        rings: list[Ring] = []
        if blobs is not None:
            for i in np.flatnonzero(blobs.hue == hue):
                u, v = blobs.uv[i] / MASK_STEP
                radius = float(max(blobs.size[i])) / 2 / MASK_STEP + 2
                rings.append(Ring(float(u), float(v), radius, colour))
        return rings
