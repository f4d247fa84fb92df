"""Learns a class for each colour: histograms of each hue's cloth, the glove and the background.

Colours are counted by chroma, which shade hardly changes, and by value. A colour belongs to a hue
if it is more likely in that hue's cloth than in the background, the glove or another hue: class
frequencies are ignored, since markers are few and the background is large.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.calibration.colours_fit import Image, fit_samples, parted
from tracker.messages import Array, IntArray
from tracker.vision.colours import (
    HUES,
    LEARNED_BITS,
    ROOM,
    UNKNOWN,
    WORN,
    ColourProfile,
    HueRange,
    LearnedColours,
)

CHROMA_BINS, VALUE_BINS = 48, 20
CHROMA_SPREAD, VALUE_SPREAD = 1.2, 1.6  # sd in bins: covers other light, other shade, noise
DARK = 12.0  # added to the value that chroma is relative to: dark pixels have no chroma
LEAST_DENSITY = 2e-6  # per bin, below which a colour counts as not observed
LEAST_PIXELS, LEAST_PATCHES = 60, 2  # of a hue, required to learn it
WIDE_HUE, WIDE_SATURATION, WIDE_VALUE = 4, 60, 35  # a hue's margin and minimums of wide colours
LIGHTS = ((1.0, 1.0), (0.75, 1.2), (0.55, 1.4), (1.25, 0.85), (1.5, 0.7))  # gains of blue and red
TYPICAL = (200.0, 170.0)  # saturation and value of a marker
TAUGHT = 1  # cells of learned colours to each side of a selected one
CLOTH_SHARE = 0.05  # of the surroundings of a marker; half at a finger's edge, less between two
SMOOTHING_PX = 5  # of noisy images
CONTRAST = 0.15  # minimum, where background colours are known: shade and noise reduce it


@dataclass
class ColourSamples:
    """BGR pixels (n, 3): of each hue's markers, of the glove around them, and of the background;
    whether each image was noisy, and therefore smoothed first."""

    hues: dict[str, list[Image]]
    cloth: list[Image] = field(default_factory=list)
    room: list[Image] = field(default_factory=list)
    patches: dict[str, int] = field(default_factory=dict)
    noisy: list[bool] = field(default_factory=list)

    @staticmethod
    def of(names: Sequence[str]) -> ColourSamples:
        return ColourSamples({name: [] for name in names}, patches=dict.fromkeys(names, 0))

    def is_enough(self, name: str) -> bool:
        """Whether there are enough samples to learn a hue."""
        return len(self.pixels(name)) >= LEAST_PIXELS and self.patches[name] >= LEAST_PATCHES

    def pixels(self, name: str) -> Image:
        """(n, 3) of one hue."""
        return np.concatenate([np.zeros((0, 3), np.uint8), *self.hues[name]])

    def add(self, other: ColourSamples) -> None:
        """Add the samples of another image."""
        for name, pixels in other.hues.items():
            self.hues[name] += pixels
            self.patches[name] += other.patches[name]
        self.cloth += other.cloth
        self.room += other.room
        self.noisy += other.noisy


def learn(profile: ColourProfile, samples: ColourSamples, cloth: bool = True) -> ColourProfile:
    """``profile`` with intervals and classes learned from ``samples``; hues with too few pixels
    keep their intervals."""
    enough = [h.name for h in profile.hues if samples.is_enough(h.name)]
    hues = []
    for old in profile.hues:
        if old.name not in enough:
            hues.append(old)
            continue
        hsv = _hsv(samples.pixels(old.name))
        hues.append(fit_samples(old.name, hsv))
    classes = _classes(profile, samples, enough)
    smoothing = SMOOTHING_PX if 2 * sum(samples.noisy) > len(samples.noisy) else 0
    learned = LearnedColours.of(classes, CLOTH_SHARE if cloth else 0.0, smoothing)
    shape = replace(profile.shape, contrast=min(profile.shape.contrast, CONTRAST))
    return replace(profile, hues=parted(tuple(hues)), shape=shape, learned=learned)


def _classes(
    profile: ColourProfile, samples: ColourSamples, enough: Sequence[str]
) -> NDArray[np.uint8]:
    """(LEARNED_CELLS,) as in `LearnedColours`."""
    cells = _cell_bins()
    worn = _density(samples.cloth).ravel()[cells]
    room = _density(samples.room).ravel()[cells]
    own = np.array(
        [
            _density(samples.hues[h.name]).ravel()[cells]
            if h.name in enough
            else np.zeros(len(cells))
            for h in profile.hues
        ]
    )
    best = np.argmax(own, axis=0)
    likely = own[best, np.arange(len(cells))]
    out = np.where(worn > room, WORN, ROOM).astype(np.uint8)
    is_hue = likely > np.maximum(room, worn)
    out[is_hue] = (best[is_hue] + 1).astype(np.uint8)
    met = np.maximum(likely, np.maximum(room, worn)) >= LEAST_DENSITY
    out[~met] = UNKNOWN
    hsv = _hsv(_cell_colours())
    for h in profile.hues:
        if h.name not in enough:  # its markers are among the samples of background and glove
            out[h.contains(hsv) & ~is_hue] = UNKNOWN
    return out


def _density(parts: Sequence[Image]) -> Array:
    """(CHROMA_BINS, CHROMA_BINS, VALUE_BINS) share of the pixels, smoothed."""
    from scipy.ndimage import gaussian_filter  # deferred: slow to load

    counts = np.zeros(CHROMA_BINS * CHROMA_BINS * VALUE_BINS)
    total = 0
    for pixels in parts:
        counts += np.bincount(bins(pixels), minlength=len(counts))
        total += len(pixels)
    shape = CHROMA_BINS, CHROMA_BINS, VALUE_BINS
    spread = (CHROMA_SPREAD, CHROMA_SPREAD, VALUE_SPREAD)
    out = gaussian_filter(counts.reshape(shape) / max(total, 1), spread, mode="nearest")
    return np.asarray(out, float)


def bins(pixels: Image) -> IntArray:
    """(n,) number of the bin of each BGR pixel (n, 3)."""
    bgr = pixels.astype(np.float32)
    value = bgr.max(axis=1)
    scale = 0.5 * CHROMA_BINS / (value + DARK)
    blue = (bgr[:, 0] - bgr[:, 1]) * scale + 0.5 * CHROMA_BINS
    red = (bgr[:, 2] - bgr[:, 1]) * scale + 0.5 * CHROMA_BINS
    bright = np.sqrt(value / 256.0) * VALUE_BINS
    return (
        blue.astype(np.int64) * CHROMA_BINS + red.astype(np.int64)
    ) * VALUE_BINS + bright.astype(np.int64)


@lru_cache(maxsize=1)
def _cell_bins() -> IntArray:
    """(LEARNED_CELLS,) bin of each cell of learned colours."""
    return bins(_cell_colours())


def _cell_colours() -> Image:
    """(LEARNED_CELLS, 3) BGR of the middle of each cell."""
    side = 1 << LEARNED_BITS
    middle = (np.arange(side) * (256 // side) + 128 // side).astype(np.uint8)
    b, g, r = np.meshgrid(middle, middle, middle, indexing="ij")
    return np.stack([b, g, r], axis=-1).reshape(-1, 3)


def _hsv(pixels: Image) -> Image:
    """BGR pixels (n, 3) in HSV."""
    return np.asarray(cv2.cvtColor(pixels[None], cv2.COLOR_BGR2HSV), np.uint8)[0]


def with_colour(profile: ColourProfile, bgr: Image, hue: int) -> ColourProfile:
    """``profile`` in which colours next to a BGR pixel (3,) belong to the hue in this row, or to
    the background where it is -1: the eyedropper overrides learned classes."""
    if profile.learned is None:
        return profile
    side = 1 << LEARNED_BITS
    classes = profile.learned.classes().reshape(side, side, side).copy()
    b, g, r = (int(x) >> (8 - LEARNED_BITS) for x in bgr)
    around = tuple(slice(max(x - TAUGHT, 0), x + TAUGHT + 1) for x in (b, g, r))
    classes[around] = hue + 1 if hue >= 0 else ROOM
    old = profile.learned
    learned = LearnedColours.of(classes.ravel(), old.cloth, old.smoothing_px)
    return replace(profile, learned=learned)


def wide_profiles(profile: ColourProfile) -> Iterator[ColourProfile]:
    """Wider profiles, for neutral, warmer and cooler light."""
    for blue, red in LIGHTS:
        hues = tuple(_lit(h, blue, red) for h in profile.hues)
        yield replace(profile, hues=hues, learned=None)


def _lit(hue: HueRange, blue: float, red: float) -> HueRange:
    """A hue's wide interval in light with these gains."""
    saturation, value = TYPICAL
    hsv = np.array([[[hue.centre, saturation, value]]], np.uint8)
    bgr = cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR).astype(float) * [blue, 1.0, red]
    lit = np.clip(bgr * value / bgr.max(), 0, 255).astype(np.uint8)
    centre = int(cv2.cvtColor(lit, cv2.COLOR_BGR2HSV)[0, 0, 0])
    half = hue.width // 2 + WIDE_HUE
    return HueRange(
        hue.name,
        ((centre - half) % HUES, (centre + half) % HUES),
        (min(hue.saturation[0], WIDE_SATURATION), 255),
        (min(hue.value[0], WIDE_VALUE), 255),
    )
