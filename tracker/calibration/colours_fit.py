"""Fitting a colour profile to the light in a room: from one image, from samples, by eyedropper.

All in OpenCV's HSV: hue 0..179 on a circle, saturation and value 0..255.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.errors import GlovetrackError
from tracker.vision.colours import HUES, ColourProfile, HueRange

Image = NDArray[np.uint8]


@dataclass(frozen=True)
class FitParams:
    """How ranges are drawn around samples."""

    least_saturation: int = 90  # for a pixel to count as cloth at all, where nothing is labelled
    least_value: int = 45
    tail: float = 0.01  # share of samples left out at either end
    hue_margin: int = 6  # around the samples, for other light
    level_margin: int = 45  # below the least saturation and value
    dimmest: float = 0.45  # of the least value: how dark the same cloth is when it turns away
    half_width: int = 11  # of a fitted hue, at most
    least_area_px: float = 20.0
    largest_share: float = 0.02  # of the image, for a patch
    roundness: float = 0.5  # 4 pi area / perimeter²
    nearest_hue: int = 14  # how far a cluster may be from the hue it replaces
    least_patches: int = 1


def fit_samples(name: str, hsv: NDArray[Any], params: FitParams | None = None) -> HueRange:
    """The range of a hue from labelled pixels (n, 3) in HSV.

    Raises GlovetrackError where there are no pixels.
    """
    params = params or FitParams()
    pixels = np.asarray(hsv).reshape(-1, 3).astype(np.int64)
    if len(pixels) == 0:
        raise GlovetrackError(f"No pixels were marked for the hue {name!r}.")
    low, high = hue_interval(pixels[:, 0], params.tail)
    width = (high - low) % HUES + 2 * params.hue_margin
    if width >= HUES:
        raise GlovetrackError(
            f"The pixels marked for {name!r} have every hue: mark one cloth only."
        )
    hue = ((low - params.hue_margin) % HUES, (high + params.hue_margin) % HUES)
    least = np.quantile(pixels[:, 1:], params.tail, axis=0)
    floor = np.minimum(least - params.level_margin, least * [1.0, params.dimmest])
    s, v = (int(x) for x in np.clip(np.floor(floor), 0, 255))
    return HueRange(name, hue, (s, 255), (v, 255))


def hue_interval(hue: NDArray[np.int64], tail: float = 0.0) -> tuple[int, int]:
    """First and last hue of the shortest arc that holds all but a share of 2 ``tail`` of them."""
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
    """The eyedropper: the range grown just enough to take an HSV pixel with its neighbours."""
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
    """The eyedropper's other end: the range cut so that it leaves an HSV pixel out.

    Of the six cuts that do so the one that takes the least share of its interval is made. A range
    that would be empty is left as it is; so is one that does not hold the pixel.
    """
    if not bool(hue.contains(np.asarray(pixel))):
        return hue
    cuts = _cuts(hue, *(int(x) for x in np.asarray(pixel)))
    return min(cuts, key=lambda c: c[0])[1] if cuts else hue


def _cuts(hue: HueRange, h: int, s: int, v: int) -> list[tuple[float, HueRange]]:
    """Ranges without the pixel, each with the share of its interval that was lost."""
    out = []
    above, width = (h - hue.hue[0]) % HUES, hue.width
    if above < width:
        cut = replace(hue, hue=((h + 1) % HUES, hue.hue[1]))
        out.append(((above + 1) / (width + 1), cut))
    if above > 0:
        cut = replace(hue, hue=(hue.hue[0], (h - 1) % HUES))
        out.append(((width - above + 1) / (width + 1), cut))
    for share, kept in _level_cuts(hue.saturation, s):
        out.append((share, replace(hue, saturation=kept)))
    for share, kept in _level_cuts(hue.value, v):
        out.append((share, replace(hue, value=kept)))
    return out


def _level_cuts(interval: tuple[int, int], x: int) -> list[tuple[float, tuple[int, int]]]:
    low, high = interval
    cuts = [((x - low + 1), (x + 1, high)), ((high - x + 1), (low, x - 1))]
    return [(lost / (high - low + 1), kept) for lost, kept in cuts if kept[0] <= kept[1]]


@dataclass(frozen=True)
class FoundHue:
    """A cluster of patches: the range fitted to it, its patches and its pixels."""

    range: HueRange
    patches: int
    pixels: int


def fit_image(
    image: Image, profile: ColourProfile, params: FitParams | None = None
) -> tuple[ColourProfile, tuple[FoundHue, ...]]:
    """A profile fitted to a BGR image of the glove; hues that it does not show are kept.

    Patches are looked for among all saturated pixels, whatever their hue, and given to the hue of
    the profile that is nearest. The ranges never overlap in hue: neighbours share the gap.
    """
    params = params or FitParams()
    hsv = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2HSV), np.uint8)
    patches = _patches(hsv, params)
    hues, found = [], []
    for k, old in enumerate(profile.hues):
        mine = [p for p in patches if _nearest(profile, p, params) == k]
        if len(mine) < params.least_patches:
            hues.append(old)
            continue
        pixels = np.concatenate(mine)
        new = _at_most(fit_samples(old.name, pixels, params), params.half_width)
        hues.append(new)
        found.append(FoundHue(new, len(mine), len(pixels)))
    return replace(profile, hues=parted(tuple(hues))), tuple(found)


def _patches(hsv: Image, params: FitParams) -> list[Image]:
    """HSV pixels (n, 3) of each blob-like region of like hue.

    Regions are cut where hue changes, so that two cloths side by side stay two.
    """
    floor = (0, params.least_saturation, params.least_value)
    mask = np.asarray(cv2.inRange(hsv, floor, (HUES - 1, 255, 255)))
    out: list[Image] = []
    largest = params.largest_share * mask.size
    for band in _bands(hsv[..., 0][mask > 0]):
        part = HueRange("band", band, (0, 255), (0, 255)).contains(hsv) & (mask > 0)
        count, labels, stats, _ = cv2.connectedComponentsWithStats(part.astype(np.uint8))
        for k in range(1, count):
            area = stats[k, cv2.CC_STAT_AREA]
            if params.least_area_px <= area <= largest and _is_round(labels, stats[k], k, params):
                out.append(_inner(hsv, labels, stats[k], k))
    return out


def _bands(hue: NDArray[np.uint8]) -> list[tuple[int, int]]:
    """Arcs of hue between the valleys of the histogram; each holds one peak."""
    counts = np.bincount(hue, minlength=HUES).astype(float)
    if counts.sum() == 0:
        return []
    kernel = np.array([1, 3, 6, 7, 6, 3, 1]) / 27
    wrapped = np.concatenate([counts[-3:], counts, counts[:3]])
    smooth = np.convolve(wrapped, kernel, "valid")
    low = smooth < 0.04 * smooth.max()
    if low.all() or not low.any():
        return [(0, HUES - 1)]
    start = int(np.flatnonzero(low)[0])
    order = (start + np.arange(HUES)) % HUES
    edges = np.diff(np.concatenate([[1], low[order].astype(int), [1]]))
    first, last = np.flatnonzero(edges == -1), np.flatnonzero(edges == 1) - 1
    return [(int(order[a]), int(order[b])) for a, b in zip(first, last, strict=True)]


def _box(stats: NDArray[np.int32]) -> tuple[slice, slice]:
    x, y, w, h = (int(s) for s in stats[:4])
    return slice(y, y + h), slice(x, x + w)


def _is_round(
    labels: NDArray[np.int32], stats: NDArray[np.int32], k: int, params: FitParams
) -> bool:
    mask = np.pad((labels[_box(stats)] == k).astype(np.uint8), 1)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    perimeter = max(cv2.arcLength(contours[0], True), 1.0)
    return bool(4 * np.pi * cv2.contourArea(contours[0]) >= params.roundness * perimeter**2)


def _inner(hsv: Image, labels: NDArray[np.int32], stats: NDArray[np.int32], k: int) -> Image:
    """A region's pixels without its rim, which mixes with what is beside it."""
    box = _box(stats)
    mask = np.pad((labels[box] == k).astype(np.uint8), 1)
    core = cv2.erode(mask, np.ones((3, 3), np.uint8))[1:-1, 1:-1] > 0
    if not core.any():
        core = mask[1:-1, 1:-1] > 0
    return hsv[box][core]


def _nearest(profile: ColourProfile, pixels: Image, params: FitParams) -> int:
    """Row of the hue whose centre is nearest to a patch's middle, -1 if none is near."""
    first, last = hue_interval(pixels[:, 0].astype(np.int64), 0.1)
    middle = first + ((last - first) % HUES) / 2
    gaps = [abs(_turn(middle - h.centre)) for h in profile.hues]
    best = int(np.argmin(gaps))
    return best if gaps[best] <= params.nearest_hue else -1


def _turn(difference: float) -> float:
    """A difference of hues brought to -90..90."""
    return (difference + HUES / 2) % HUES - HUES / 2


def _at_most(hue: HueRange, half_width: int) -> HueRange:
    """Narrowed about its centre to ±half_width."""
    if hue.width <= 2 * half_width:
        return hue
    middle = round(hue.centre)
    return replace(hue, hue=((middle - half_width) % HUES, (middle + half_width) % HUES))


def parted(hues: tuple[HueRange, ...]) -> tuple[HueRange, ...]:
    """The same ranges, neighbours that overlap in hue cut half-way between their centres."""
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
    """``hue`` shares colours with ``other`` (another hue's name, or "room"); share in 0..1.

    Of two hues: the share of the narrower interval. Of the room: the share of the image's pixels.
    """

    hue: str
    other: str
    share: float


def clashes(profile: ColourProfile) -> tuple[Clash, ...]:
    """Pairs of hues that take the same pixels."""
    out = []
    for i, a in enumerate(profile.hues):
        for b in profile.hues[i + 1 :]:
            if a.overlaps(b):
                mine = (np.arange(HUES) - a.hue[0]) % HUES <= a.width
                theirs = (np.arange(HUES) - b.hue[0]) % HUES <= b.width
                share = np.sum(mine & theirs) / min(mine.sum(), theirs.sum())
                out.append(Clash(a.name, b.name, float(share)))
    return tuple(out)


def room_clashes(
    empty_room: Image, profile: ColourProfile, least_share: float = 1e-4
) -> tuple[Clash, ...]:
    """Hues that a BGR image without the glove already shows, worst first."""
    hsv = np.asarray(cv2.cvtColor(empty_room, cv2.COLOR_BGR2HSV), np.uint8)
    shares = [Clash(h.name, "room", float(h.contains(hsv).mean())) for h in profile.hues]
    worst = sorted(shares, key=lambda c: -c.share)
    return tuple(c for c in worst if c.share >= least_share)
