"""Fits a colour profile to tracked markers, without labelled images.

The tracker knows the position of each marker, so every patch labels its own pixels. Where the
profile misses the patches of a hue (the light has changed), the pixels at the predicted positions
of its markers are used.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.calibration.colours_fit import (
    FoundHue,
    Image,
    fit_samples,
    hue_interval,
    parted,
)
from tracker.glove.model import GloveModel
from tracker.messages import Array, Blobs, FrameResult, IntArray
from tracker.vision.colours import HUES, ColourProfile


@dataclass(frozen=True)
class MarkerFitParams:
    """Criteria for discs of an image that are cloth, and parameters for ranges around them."""

    core: float = 0.35  # of a blob's extent: radius of the disc that is certainly cloth
    least_visible: float = 0.6  # for an unmatched marker
    sure: float = 1.5  # radii of the disc: maximum 2σ of a predicted marker's position
    least_saturation: int = 60  # of a disc's median, for cloth
    least_share: float = 0.6  # of a disc's median saturation and value, for a pixel of the cloth
    hue_spread: int = 16  # of the middle 80 % of those; a larger spread is not one cloth
    rim: int = 3  # of hue, beyond those 80 %
    most_exposures: int = 64  # 8 s at the panel's rate
    least_patches: int = 2  # required to fit a hue


@dataclass(frozen=True, eq=False)
class SeenSide:
    """One image: BGR image, detected blobs, the blob of each marker (-1), predicted positions.

    ``cov`` (M, 2, 2) px² of the predicted position; NaN where it is not known for this side.
    """

    image: Image
    blobs: Blobs
    match: IntArray
    expected: Array
    cov: Array


def seen_sides(
    left: Image | None,
    right: Image | None,
    blobs: tuple[Blobs | None, Blobs | None],
    result: FrameResult,
) -> tuple[SeenSide, ...]:
    """The sides of an exposure that have an image and blobs."""
    unknown = np.full_like(result.predicted_cov, np.nan)
    sides = (
        (left, blobs[0], result.match_left, result.predicted_left, result.predicted_cov),
        (right, blobs[1], result.match_right, result.predicted_right, unknown),
    )
    return tuple(
        SeenSide(image, found, match, expected, cov)
        for image, found, match, expected, cov in sides
        if image is not None and found is not None
    )


class MarkerSamples:
    """Pixels of tracked markers over the last exposures: a moving hand shows all its patches, in
    all the light that falls on them."""

    def __init__(
        self, glove: GloveModel, hue_names: Sequence[str], params: MarkerFitParams | None = None
    ) -> None:
        self._glove, self._params = glove, params or MarkerFitParams()
        self._exposures: deque[dict[str, list[Image]]] = deque(maxlen=self._params.most_exposures)
        self._names = tuple(hue_names)

    def __len__(self) -> int:
        """Number of stored exposures."""
        return len(self._exposures)

    def copy(self) -> MarkerSamples:
        """A copy of the present samples, for a fit in another thread."""
        out = MarkerSamples(self._glove, self._names, self._params)
        out._exposures.extend(self._exposures)
        return out

    def take(self, sides: Sequence[SeenSide], visible: Array) -> None:
        """Adds an exposure. ``visible`` (M,) is the probability that a marker is visible."""
        discs: dict[str, list[Image]] = {name: [] for name in self._names}
        for side in sides:
            _take_side(discs, side, visible, self._glove, self._params)
        self._exposures.append(discs)

    def fit(self, profile: ColourProfile) -> tuple[ColourProfile, tuple[FoundHue, ...]]:
        """A profile fitted to the samples; hues with too few patches are unchanged."""
        hues, found = [], []
        for old in profile.hues:
            mine = _alike([d for e in self._exposures for d in e[old.name]], self._params)
            if len(mine) < self._params.least_patches:
                hues.append(old)
                continue
            pixels = np.concatenate(mine)
            hues.append(fit_samples(old.name, pixels))
            found.append(FoundHue(hues[-1], len(mine), len(pixels)))
        return replace(profile, hues=parted(tuple(hues))), tuple(found)


def _alike(discs: list[Image], params: MarkerFitParams) -> list[Image]:
    """Removes discs whose colour differs from the majority: wrong predictions."""
    if not discs:
        return discs
    middles = np.array([_middle_hue(d) for d in discs], np.int64)
    first, last = hue_interval(middles, 0.25)
    centre = first + ((last - first) % HUES) / 2
    away = np.abs((middles - centre + HUES / 2) % HUES - HUES / 2)
    return [d for d, gap in zip(discs, away, strict=True) if gap <= params.hue_spread]


def _middle_hue(pixels: Image) -> int:
    first, last = hue_interval(pixels[:, 0].astype(np.int64), 0.25)
    return round(first + ((last - first) % HUES) / 2) % HUES


def _take_side(
    discs: dict[str, list[Image]],
    side: SeenSide,
    visible: Array,
    glove: GloveModel,
    params: MarkerFitParams,
) -> None:
    """Add the discs of one image to those of their hues."""
    matched = np.flatnonzero(side.match >= 0)
    if len(matched) == 0:
        return
    extent = side.blobs.size[side.match[matched]].max(axis=1)
    radius = params.core * float(np.median(extent))
    centres = {int(m): side.blobs.uv[side.match[m]] for m in matched}
    missed = np.flatnonzero((side.match < 0) & (visible >= params.least_visible))
    for m in missed[np.isfinite(side.expected[missed, 0])]:
        if _is_sure(side.cov[m], params.sure * radius):
            centres[int(m)] = side.expected[m]
    for marker, uv in centres.items():
        hue = glove.markers[marker].hue
        cloth = _cloth(disc_pixels(side.image, uv, radius), params)
        if hue in discs and len(cloth) > 0:
            discs[hue].append(cloth)


def _is_sure(cov: Array, limit: float) -> bool:
    """Whether the longer half axis of the 2σ ellipse is below ``limit`` px."""
    return bool(np.isfinite(cov).all() and 2 * np.sqrt(np.linalg.eigvalsh(cov)[-1]) <= limit)


def disc_pixels(image: Image, uv: Array, radius: float) -> NDArray[np.uint8]:
    """HSV pixels (n, 3) of a BGR image within ``radius`` px of ``uv`` (2,); none outside it."""
    height, width = image.shape[:2]
    reach = int(np.ceil(radius))
    column, row = (round(float(x)) for x in uv)
    top, first = max(row - reach, 0), max(column - reach, 0)
    box = image[top : max(row + reach + 1, 0), first : max(column + reach + 1, 0)]
    if box.size == 0 or not (0 <= column < width and 0 <= row < height):
        return np.zeros((0, 3), np.uint8)
    hsv = np.asarray(cv2.cvtColor(np.ascontiguousarray(box), cv2.COLOR_BGR2HSV), np.uint8)
    y, x = np.mgrid[top : top + box.shape[0], first : first + box.shape[1]]
    return hsv[np.hypot(x - float(uv[0]), y - float(uv[1])) <= max(radius, 0.75)]


def _cloth(pixels: Image, params: MarkerFitParams) -> Image:
    """The pixels (n, 3) of a disc that are its cloth: none where the glove next to the patch, or
    another patch, fills it; without the rim where a slanted patch is narrower than the disc."""
    if len(pixels) == 0:
        return pixels
    middle = np.median(pixels[:, 1:], axis=0)
    if middle[0] < params.least_saturation:
        return pixels[:0]
    pixels = pixels[np.all(pixels[:, 1:] >= params.least_share * middle, axis=1)]
    hue = pixels[:, 0].astype(np.int64)
    first, last = hue_interval(hue, 0.1)
    width = (last - first) % HUES
    if width > params.hue_spread:
        return pixels[:0]
    return pixels[(hue - first + params.rim) % HUES <= width + 2 * params.rim]
