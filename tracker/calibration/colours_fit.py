"""Fits a colour profile to the light in a room, from samples or by eyedropper; finds clashes.

All in OpenCV's HSV: hue 0..179 on a circle, saturation and value 0..255.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.vision.colours import HUES, ColourProfile, HueRange

Image = NDArray[np.uint8]


@dataclass(frozen=True)
class FitParams:
    """Parameters for ranges around samples."""

    tail: float = 0.01  # share of samples ignored at either end
    hue_margin: int = 6  # around the samples, for other light
    level_margin: int = 45  # below the minimum saturation and value
    dimmest: float = 0.45  # of the minimum value: cloth that faces away from the light is darker


def fit_samples(name: str, hsv: NDArray[Any], params: FitParams | None = None) -> HueRange:
    """The range of a hue from labelled pixels (n, 3) in HSV.

    Raises GlovetrackError if there are no pixels.
    """
    params = params or FitParams()
    pixels = np.asarray(hsv).reshape(-1, 3).astype(np.int64)
    if len(pixels) == 0:
        raise GlovetrackError(notice("colours.no_pixels", hue=name))
    low, high = hue_interval(pixels[:, 0], params.tail)
    width = (high - low) % HUES + 2 * params.hue_margin
    if width >= HUES:
        raise GlovetrackError(notice("colours.every_hue", hue=name))
    hue = ((low - params.hue_margin) % HUES, (high + params.hue_margin) % HUES)
    least = np.quantile(pixels[:, 1:], params.tail, axis=0)
    floor = np.minimum(least - params.level_margin, least * [1.0, params.dimmest])
    s, v = (int(x) for x in np.clip(np.floor(floor), 0, 255))
    return HueRange(name, hue, (s, 255), (v, 255))


def hue_interval(hue: NDArray[np.int64], tail: float = 0.0) -> tuple[int, int]:
    """First and last hue of the shortest arc that contains all but a share of 2 ``tail``."""
    counts = np.bincount(np.asarray(hue) % HUES, minlength=HUES)
    need = max(int(np.ceil(counts.sum() * (1 - 2 * tail))), 1)
    twice = np.concatenate([[0], np.cumsum(np.tile(counts, 2))])
    best, arc = HUES, (0, HUES - 1)
    for first in np.flatnonzero(counts).tolist():
        last = int(np.searchsorted(twice, twice[first] + need)) - 1
        if last - first < best:
            best, arc = last - first, (first, last % HUES)
    return arc


def add_pixel(hue: HueRange, pixel: NDArray[Any], params: FitParams | None = None) -> HueRange:
    """The eyedropper: extends the range just enough to include an HSV pixel and its neighbours."""
    params = params or FitParams()
    h, s, v = (int(x) for x in np.asarray(pixel))
    margin = min(2, params.hue_margin)
    first, last = hue.hue
    if (h - first) % HUES > hue.width:
        before, after = (first - h) % HUES, (h - last) % HUES
        if before < after:
            first = (h - margin) % HUES
        else:
            last = (h + margin) % HUES
    return replace(
        hue,
        hue=(first, last),
        saturation=_with(hue.saturation, s, 10),
        value=_with(hue.value, v, 10),
    )


def _with(interval: tuple[int, int], x: int, margin: int) -> tuple[int, int]:
    low, high = interval
    return (low if x >= low else max(x - margin, 0)), (high if x <= high else min(x + margin, 255))


def remove_pixel(hue: HueRange, pixel: NDArray[Any]) -> HueRange:
    """The eyedropper in reverse: reduces the range so that it excludes an HSV pixel.

    Of the six possible cuts, the one that removes the smallest share of its interval is used. A
    range that would become empty is unchanged; so is one that does not contain the pixel.
    """
    if not bool(hue.contains(np.asarray(pixel))):
        return hue
    cuts = _cuts(hue, *(int(x) for x in np.asarray(pixel)))
    return min(cuts, key=lambda c: c[0])[1] if cuts else hue


def _cuts(hue: HueRange, h: int, s: int, v: int) -> list[tuple[float, HueRange]]:
    """Ranges without the pixel, each with the share of its interval that was removed."""
    out = []
    above, width = (h - hue.hue[0]) % HUES, hue.width
    if above < width:
        cut = replace(hue, hue=((h + 1) % HUES, hue.hue[1]))
        out.append(((above + 1) / (width + 1), cut))
    if above > 0:
        cut = replace(hue, hue=(hue.hue[0], (h - 1) % HUES))
        out.append(((width - above + 1) / (width + 1), cut))
    for share, rest in _level_cuts(hue.saturation, s):
        out.append((share, replace(hue, saturation=rest)))
    for share, rest in _level_cuts(hue.value, v):
        out.append((share, replace(hue, value=rest)))
    return out


def _level_cuts(interval: tuple[int, int], x: int) -> list[tuple[float, tuple[int, int]]]:
    low, high = interval
    cuts = [((x - low + 1), (x + 1, high)), ((high - x + 1), (low, x - 1))]
    return [(lost / (high - low + 1), cut) for lost, cut in cuts if cut[0] <= cut[1]]


@dataclass(frozen=True)
class FoundHue:
    """A cluster of patches: the range fitted to it, its patches and its pixels."""

    range: HueRange
    patches: int
    pixels: int


def parted(hues: tuple[HueRange, ...]) -> tuple[HueRange, ...]:
    """The same ranges, with neighbours that overlap in hue split half-way between their centres."""
    out = list(hues)
    order = sorted(range(len(out)), key=lambda k: out[k].centre)
    for a, b in zip(order, order[1:] + order[:1], strict=True):
        if a == b or (out[b].hue[0] - out[a].hue[0]) % HUES > out[a].width:
            continue
        gap = (out[b].centre - out[a].centre) % HUES
        middle = int(np.floor(out[a].centre + gap / 2)) % HUES
        out[a] = replace(out[a], hue=(out[a].hue[0], middle))
        out[b] = replace(out[b], hue=((middle + 1) % HUES, out[b].hue[1]))
    return tuple(out)


@dataclass(frozen=True)
class Clash:
    """``hue`` shares colours with ``other`` (another hue's name): ``share`` (0..1) of the narrower
    interval."""

    hue: str
    other: str
    share: float


def clashes(profile: ColourProfile) -> tuple[Clash, ...]:
    """Pairs of hues that include the same pixels."""
    out = []
    for i, a in enumerate(profile.hues):
        for b in profile.hues[i + 1 :]:
            if a.overlaps(b):
                mine = (np.arange(HUES) - a.hue[0]) % HUES <= a.width
                theirs = (np.arange(HUES) - b.hue[0]) % HUES <= b.width
                share = np.sum(mine & theirs) / min(mine.sum(), theirs.sum())
                out.append(Clash(a.name, b.name, float(share)))
    return tuple(out)
