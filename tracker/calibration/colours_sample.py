"""Labels pixels of an image by its known markers: their cloth, the glove and the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.calibration.colours_fit import Image, hue_interval
from tracker.calibration.colours_learn import SMOOTHING_PX, ColourSamples
from tracker.calibration.light_meter import NOISY, noise_of
from tracker.glove.model import GloveModel
from tracker.messages import Array, BlobFrame, FrameResult, StereoFrame
from tracker.vision.colours import HUES
from tracker.vision.detector import smoothed

CORE = 0.36  # of a marker's smaller extent: radius of the disc that is certainly cloth
LEAST_SHARE = 0.5  # of a disc's median saturation and value, for a pixel of its cloth
MOST_TURN = 20  # of hue, from the median of the disc
AWAY = 0.75  # likewise, of the disc that may be cloth
RING = (0.85, 1.25)  # likewise, of the ring of the glove's cloth around it
HAND = 6.0  # likewise, around each marker, excluded from the background
DARKEST = 8.0  # added to channels before their logarithm: below it, noise dominates
ROOM_STEP = 7  # stride of background samples


@dataclass(frozen=True, eq=False)
class KnownMarkers:
    """Markers in one image: uv (n, 2) px, ``size`` (n, 2) px along and across, the hue's name of
    each; ``hand`` (k, 2) px further positions that are not background."""

    uv: Array
    size: Array
    hue: tuple[str, ...]
    hand: Array

    @property
    def extent(self) -> Array:
        """(n,) px, the larger one."""
        return np.asarray(self.size.max(axis=1))


def samples_of(image: Image, known: KnownMarkers, names: tuple[str, ...]) -> ColourSamples:
    """BGR pixels of an image by class; a noisy image is smoothed first."""
    out = ColourSamples.of(names)
    smooth = denoised(image)
    out.noisy.append(smooth is not image)
    image = smooth
    shape = image.shape[:2]
    taken = np.zeros(shape, np.uint8)
    for uv, extent in zip(known.uv, known.extent, strict=True):
        _disc(taken, uv, AWAY * extent)
    for uv, size, name in zip(known.uv, known.size, known.hue, strict=True):
        extent = float(size.max())
        core = _cloth(_pixels(image, uv, 0.0, CORE * float(size.min())))
        if len(core):
            out.hues[name].append(core)
            out.patches[name] += 1
        beside = _pixels(image, uv, RING[0] * extent, RING[1] * extent, taken)
        if len(beside):
            out.cloth.append(beside)
    away = np.zeros(shape, np.uint8)
    reach = HAND * float(np.median(known.extent)) if len(known.extent) else 0.0
    for uv in np.concatenate([known.uv, known.hand]):
        _disc(away, uv, reach)
    room = np.flatnonzero(away.ravel() == 0)[::ROOM_STEP]
    out.room.append(image.reshape(-1, 3)[room])
    return out


def denoised(image: Image) -> Image:
    """The image, smoothed if it is noisy."""
    return smoothed(image, SMOOTHING_PX) if noise_of(image) > NOISY else image


def core_colours(sides: Sequence[tuple[Image, KnownMarkers]]) -> dict[str, Array]:
    """ln BGR (3,) of each hue's visible markers: the median over the means of their cores."""
    means: dict[str, list[Array]] = {}
    for image, known in sides:
        for uv, size, name in zip(known.uv, known.size, known.hue, strict=True):
            core = _pixels(image, uv, 0.0, CORE * float(size.min()))
            if len(core):
                means.setdefault(name, []).append(np.log(core.mean(axis=0) + DARKEST))
    return {name: np.asarray(np.median(seen, axis=0)) for name, seen in means.items()}


def core_pixels(image: Image, uv: Array, radius: float) -> Image:
    """BGR pixels (n, 3) within ``radius`` px of uv (2,) that are of one cloth."""
    return _cloth(_pixels(image, uv, 0.0, radius))


def _cloth(pixels: Image) -> Image:
    """The BGR pixels (n, 3) of a disc that are similar to the majority: a slanted or partly
    occluded patch includes its surroundings."""
    if len(pixels) == 0:
        return pixels
    hsv = np.asarray(cv2.cvtColor(pixels[None], cv2.COLOR_BGR2HSV), np.uint8)[0].astype(np.int64)
    like = np.all(hsv[:, 1:] >= LEAST_SHARE * np.median(hsv[:, 1:], axis=0), axis=1)
    first, last = hue_interval(hsv[like, 0], 0.25)
    middle = first + ((last - first) % HUES) / 2
    like &= np.abs((hsv[:, 0] - middle + HUES / 2) % HUES - HUES / 2) <= MOST_TURN
    return pixels[like]


def _disc(mask: NDArray[np.uint8], uv: Array, radius: float) -> None:
    cv2.circle(mask, (round(float(uv[0])), round(float(uv[1]))), max(round(radius), 1), 1, -1)


def _pixels(
    image: Image, uv: Array, least: float, most: float, but: NDArray[np.uint8] | None = None
) -> Image:
    """BGR pixels (n, 3) between two distances (px) from ``uv`` (2,), except those in ``but``."""
    height, width = image.shape[:2]
    reach = int(np.ceil(most)) + 1
    column, row = (round(float(x)) for x in uv)
    top, first = max(row - reach, 0), max(column - reach, 0)
    bottom, last = min(row + reach + 1, height), min(column + reach + 1, width)
    if bottom <= top or last <= first:
        return np.zeros((0, 3), np.uint8)
    y, x = np.arange(top, bottom)[:, None], np.arange(first, last)
    apart = np.hypot(x - float(uv[0]), y - float(uv[1]))
    inside = (apart >= least) & (apart <= max(most, 0.75))
    if but is not None:
        inside &= but[top:bottom, first:last] == 0
    return image[top:bottom, first:last][inside]


def known_sides(
    frame: StereoFrame, blobs: BlobFrame, result: FrameResult, glove: GloveModel
) -> list[tuple[Image, KnownMarkers]]:
    """Both images with their known markers."""
    sides = (
        (frame.left, blobs.left, result.match_left, result.predicted_left),
        (frame.right, blobs.right, result.match_right, result.predicted_right),
    )
    out = []
    for image, found, match, expected in sides:
        if image is None or found is None or not (match >= 0).any():
            continue
        rows = np.flatnonzero(match >= 0)
        hand = expected[np.isfinite(expected[:, 0])]
        hue = tuple(glove.markers[int(m)].hue for m in rows)
        out.append((image, KnownMarkers(found.uv[match[rows]], found.size[match[rows]], hue, hand)))
    return out
