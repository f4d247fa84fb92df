"""Fitting a colour profile to the markers that are being tracked: no picture has to be labelled.

The tracker knows which marker stands where, so every patch labels its own pixels. Where the profile
misses the patches of a hue (the light has changed) the places where its markers are expected serve.
"""

from __future__ import annotations

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
    """Which discs of a picture are taken for cloth, and how ranges are drawn around them."""

    core: float = 0.35  # of a blob's extent: radius of the disc that is surely cloth
    least_visible: float = 0.7  # for a marker that no blob was matched with
    sure: float = 0.5  # of the disc: largest 2σ of an expected marker's place
    least_saturation: int = 60  # of a disc's median, to be cloth at all
    least_share: float = 0.6  # of a disc's median saturation and value, for a pixel of the cloth
    hue_spread: int = 16  # of the middle 80 % of those; more is not one cloth
    rim: int = 3  # of hue, beyond that middle
    least_patches: int = 2  # for a hue to be fitted at all


@dataclass(frozen=True, eq=False)
class SeenSide:
    """One picture: BGR image, blobs found, the blob of each marker (-1), where each is expected.

    ``cov`` (M, 2, 2) px² of the expected place; NaN where it is not known for this side.
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
    """The sides of an exposure of which there are a picture and blobs."""
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


def fit_markers(
    sides: Sequence[SeenSide],
    visible: Array,
    glove: GloveModel,
    profile: ColourProfile,
    params: MarkerFitParams | None = None,
) -> tuple[ColourProfile, tuple[FoundHue, ...]]:
    """A profile fitted to tracked markers; hues of which too few are seen are kept.

    ``visible`` (M,) probability that a marker is seen.
    """
    params = params or MarkerFitParams()
    discs: dict[str, list[Image]] = {h.name: [] for h in profile.hues}
    for side in sides:
        _take_side(discs, side, visible, glove, params)
    hues, found = [], []
    for old in profile.hues:
        mine = discs[old.name]
        if len(mine) < params.least_patches:
            hues.append(old)
            continue
        pixels = np.concatenate(mine)
        hues.append(fit_samples(old.name, pixels))
        found.append(FoundHue(hues[-1], len(mine), len(pixels)))
    return replace(profile, hues=parted(tuple(hues))), tuple(found)


def _take_side(
    discs: dict[str, list[Image]],
    side: SeenSide,
    visible: Array,
    glove: GloveModel,
    params: MarkerFitParams,
) -> None:
    """Add the discs of one picture to those of their hues."""
    matched = np.flatnonzero(side.match >= 0)
    if len(matched) == 0:
        return
    extent = side.blobs.size[side.match[matched]].max(axis=1)
    radius = params.core * float(np.median(extent))
    places = {int(m): side.blobs.uv[side.match[m]] for m in matched}
    missed = np.flatnonzero((side.match < 0) & (visible >= params.least_visible))
    for m in missed[np.isfinite(side.expected[missed, 0])]:
        if _is_sure(side.cov[m], params.sure * radius):
            places[int(m)] = side.expected[m]
    for marker, uv in places.items():
        hue = glove.markers[marker].hue
        pixels = disc_pixels(side.image, uv, radius)
        cloth = _cloth(pixels, params)
        if hue in discs and len(cloth) > 0:
            discs[hue].append(cloth)


def _is_sure(cov: Array, limit: float) -> bool:
    """Whether the longer half axis of the 2σ ellipse stays under ``limit`` px."""
    return bool(np.isfinite(cov).all() and 2 * np.sqrt(np.linalg.eigvalsh(cov)[-1]) <= limit)


def disc_pixels(image: Image, uv: Array, radius: float) -> NDArray[np.uint8]:
    """HSV pixels (n, 3) of a BGR picture within ``radius`` px of ``uv`` (2,); none outside it."""
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
    """The pixels (n, 3) of a disc that are its cloth: none where the glove beside the patch, or
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
