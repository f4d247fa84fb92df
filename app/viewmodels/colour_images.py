"""Image processing for tuning colours: masks, histograms, the background."""

from __future__ import annotations

from collections.abc import Mapping

import cv2
import numpy as np
from numpy.typing import NDArray

from app.engines.snapshot import Snapshot
from app.viewmodels.camera_overlay import project
from tracker.messages import Array, Tracking
from tracker.vision.colours import HUES, LEARNED_BITS, UNKNOWN, ColourProfile, HueRange

Image = NDArray[np.uint8]
DIMMED = 0.35
DIMMED_COLOUR = 0.55  # the same while a pixel is to be selected
ROOM_STEP = 4
ROOM_EVERY = 8  # refreshes
HAND_MARGIN_PX = 60
ROOM_SHARE = 2e-4
"""For an image: a patch of 12 mm at 0.6 m covers 0.02 %."""


def to_hsv(image: Image) -> Image:
    """A BGR image in OpenCV's HSV."""
    return np.asarray(cv2.cvtColor(np.ascontiguousarray(image), cv2.COLOR_BGR2HSV), np.uint8)


def in_range(hsv: Image, hue: HueRange) -> Image:
    """(h, w) 255 where a pixel belongs to the hue, as `HueRange.contains`, ten times faster."""
    (s0, s1), (v0, v1) = hue.saturation, hue.value
    first, last = hue.hue
    parts = [(first, last)] if first <= last else [(first, HUES - 1), (0, last)]
    masks = [cv2.inRange(hsv, (a, s0, v0), (b, s1, v1)) for a, b in parts]
    return np.asarray(masks[0] if len(masks) == 1 else cv2.bitwise_or(masks[0], masks[1]), np.uint8)


def hue_histogram(image: Image, step: int = 4) -> Array:
    """(180,) share of each hue among the saturated, bright pixels, the largest being 1."""
    hsv = to_hsv(image[::step, ::step])
    vivid = (hsv[..., 1] >= 80) & (hsv[..., 2] >= 40)
    counts = np.bincount(hsv[..., 0][vivid], minlength=HUES).astype(float)
    return counts / max(1.0, counts.max())


def mask_image(image: Image, hue: HueRange, step: int = 2, coloured: bool = False) -> Image:
    """The image with everything outside the range dimmed to grey, ``step`` times smaller; with
    ``coloured`` it is only dimmed, so that further colours can be recognized and clicked."""
    small = np.ascontiguousarray(image[::step, ::step])
    if coloured:
        out = cv2.convertScaleAbs(small, alpha=DIMMED_COLOUR)
        cv2.copyTo(small, in_range(to_hsv(small), hue), out)
        return np.asarray(out, np.uint8)
    return _over_grey(small, small, in_range(to_hsv(small), hue))


def masks_image(image: Image, hues: Mapping[HueRange, str]) -> Image:
    """Each hue's pixels in its colour (``#RRGGBB``), the rest of the image dimmed to grey.

    A pixel of two hues shows the first, as the detector counts it.
    """
    hsv, number = to_hsv(image), np.zeros(image.shape[:2], np.uint8)
    palette = np.zeros((256, 1, 3), np.uint8)
    for k, (hue, colour) in reversed(list(enumerate(hues.items(), start=1))):
        palette[k, 0] = [int(colour[i : i + 2], 16) for i in (5, 3, 1)]
        cv2.copyTo(np.full_like(number, k), in_range(hsv, hue), number)
    painted = np.asarray(cv2.applyColorMap(number, palette), np.uint8)
    return _over_grey(image, painted, number)


def _over_grey(image: Image, shown: Image, mask: Image) -> Image:
    """``shown`` where ``mask``, else ``image`` in dim grey."""
    grey = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    out = cv2.cvtColor(cv2.convertScaleAbs(grey, alpha=DIMMED), cv2.COLOR_GRAY2BGR)
    cv2.copyTo(shown, mask, out)
    return np.asarray(out, np.uint8)


def pixel_bgr(image: Image, u: float, v: float) -> Image:
    """(3,) the median colour of the 3 by 3 pixels around (u, v)."""
    row, column = round(v), round(u)
    patch = image[max(0, row - 1) : row + 2, max(0, column - 1) : column + 2]
    return np.asarray(np.median(patch.reshape(-1, 3), axis=0).astype(np.uint8))


def pixel_hsv(image: Image, u: float, v: float) -> tuple[int, int, int]:
    """The same in HSV."""
    h, s, value = to_hsv(pixel_bgr(image, u, v).reshape(1, 1, 3))[0, 0]
    return int(h), int(s), int(value)


def room_shares(image: Image, profile: ColourProfile) -> dict[str, float]:
    """Hue name to its share of a BGR image of the background, if it is significant; without colours
    that were learned to be those of the background, the glove or another hue."""
    small = image[::ROOM_STEP, ::ROOM_STEP]
    hsv, known = to_hsv(small), _learned_classes(small, profile)
    shares = {}
    for k, h in enumerate(profile.hues):
        own = (known == UNKNOWN) | (known == k + 1)
        shares[h.name] = float(((in_range(hsv, h) > 0) & own).mean())
    return {name: share for name, share in shares.items() if share >= ROOM_SHARE}


def _learned_classes(image: Image, profile: ColourProfile) -> Image:
    """(h, w) class of each pixel according to `LearnedColours`."""
    if profile.learned is None:
        return np.full(image.shape[:2], UNKNOWN, np.uint8)
    b, g, r = np.moveaxis(image.astype(np.int64) >> (8 - LEARNED_BITS), 2, 0)
    cells = (b << LEARNED_BITS | g) << LEARNED_BITS | r
    return np.asarray(profile.learned.classes()[cells], np.uint8)


def room_image(view: Snapshot) -> Image | None:
    """The left image with the tracked hand blackened; None if the position of the hand is
    unknown."""
    frame, estimate = view.frame, view.estimate_at_frame
    if frame is None or frame.left is None or estimate is None:
        return None
    if estimate.tracking != Tracking.TRACKING or not np.isfinite(estimate.keypoints).all():
        return None
    uv = project(view, estimate.keypoints, right=False)
    if not np.isfinite(uv).all():
        return None
    image = frame.left.copy()
    (u0, v0), (u1, v1) = (
        np.maximum(uv.min(axis=0) - HAND_MARGIN_PX, 0).astype(int),
        np.maximum(uv.max(axis=0) + HAND_MARGIN_PX, 0).astype(int),
    )
    image[v0:v1, u0:u1] = 0
    return image


class RoomColours:
    """Hues that occur in the background, by name, with their share of the image."""

    def __init__(self) -> None:
        self.shares: dict[str, float] = {}
        self._age = 0  # refreshes since the last measurement

    def measure(self, image: Image, profile: ColourProfile) -> None:
        """Measure an image of the background without the glove; `watch` then pauses for a while."""
        self.shares, self._age = room_shares(image, profile), -10 * ROOM_EVERY

    def watch(self, view: Snapshot | None, profile: ColourProfile) -> None:
        """Measure the image around the tracked hand, on every `ROOM_EVERY`-th call."""
        self._age += 1
        if self._age < ROOM_EVERY:
            return
        self._age = 0
        image = room_image(view) if view is not None else None
        if image is not None:
            self.shares = room_shares(image, profile)
