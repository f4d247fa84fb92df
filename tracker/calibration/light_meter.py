"""A light meter for markers: finds lighting problems that cost markers, and recommends changes.

Each image is analysed separately: patches of any colour are detected and distinguished from the
background by the dark cloth around them. Their pixels and those of the cloth determine the light,
independently of the fitted colours; the fitted colours determine the hue of each patch and which
ones are missed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import Notice, notice, warning
from tracker.messages import Array, Blobs, IntArray
from tracker.vision.colours import HUES, ColourProfile, HueRange
from tracker.vision.detector import Detector, smoothed

Image = NDArray[np.uint8]
QUARTERS = 4
NOISY = 2.9  # levels, standard deviation where an image is smooth, above which it is noisy
LIGHT = ("clipped", "dark", "noisy", "warm", "cold")
"""Kinds of advice that are about lamp and exposure; the others are about colours and the room."""


@dataclass(frozen=True)
class MeterParams:
    """Bounds beyond which the light costs markers. Levels are 0..255 as stored."""

    clipped_level: int = 249
    clipped_share: float = 0.2  # of the patches
    clipped_image: float = 0.03  # of the image
    dark_level: float = 108.0  # of the patches' brightest channel, median
    noise: float = NOISY
    warm: float = 1.3  # linear red / blue of the glove's grey cloth
    cold: float = 0.40
    near_hues: float = 9.0  # between the medians of two hues, OpenCV units
    room_blobs: int = 8  # of a hue, outside the hand
    least_patches: int = 5  # required to evaluate patches at all
    contrast: float = 1.5  # of a patch to the cloth around it, minimum
    cloth_level: float = 125.0  # maximum of dark cloth
    cloth_chroma: float = 48.0  # levels between its channels
    found_px: float = 4.0
    hand: float = 11.0  # half extent of a hand in diameters of a patch


class Advice(NamedTuple):
    """A problem, by a short code (`LIGHT`, or near, room, missed), and what to do about it."""

    kind: str
    notice: Notice


@dataclass(frozen=True, eq=False)
class LightReading:
    """The result for one image: patches (n, 2) px with hue (n,) of the profile and whether found
    (n,); level, noise in levels; warmth the linear red / blue of cloth, NaN where no patch is
    visible; room: number of blobs of each hue that are not patches."""

    uv: Array
    hue: IntArray
    found: NDArray[np.bool_]
    level: float
    noise: float
    warmth: float
    clipped: float
    room: dict[str, int]
    advice: tuple[Advice, ...]

    @property
    def good(self) -> bool:
        """Whether lamp and exposure need no change."""
        return not any(a.kind in LIGHT for a in self.advice)

    @property
    def missed(self) -> Array:
        """(k, 2) px of patches that the profile misses."""
        return self.uv[~self.found]


class LightMeter:
    """Evaluates images for one profile. Constructing one takes 0.1 s, an evaluation 0.01 s.

    ``fx`` (px) is the camera's focal length, as for `Detector`.
    """

    def __init__(
        self, profile: ColourProfile, fx: float = 640.0, params: MeterParams | None = None
    ) -> None:
        self.profile, self.params = profile, params or MeterParams()
        self._narrow = Detector(profile, fx=fx)
        # a patch whose hues span two quarters of one search is whole in the other
        shift = HUES // QUARTERS // 2
        self._any = tuple(Detector(any_colours(at), fx=fx) for at in (0, shift))

    def read(self, image: Image) -> LightReading:
        """The light in a BGR image (h, w, 3) uint8 of the gloved hand."""
        p = self.params
        blobs, noise = self._narrow.detect(image)[0], noise_of(image)
        # the noise of dark cloth contains every sufficiently wide colour
        smooth = smoothed(image) if noise > p.noise else image
        both = [_patches(smooth, wide.detect(smooth)[0], p) for wide in self._any]
        seen = _of_one_hand(_named(_whole(*both), self.profile), p)
        others = _neighbours(blobs, seen)
        names = enumerate(self.profile.hue_names)
        reading = LightReading(
            uv=seen.uv,
            hue=seen.hue,
            found=_near(seen.uv, seen.hue, blobs, p.found_px),
            level=float(np.median(seen.pixel.max(axis=1))) if len(seen.uv) else float("nan"),
            noise=noise,
            warmth=_warmth(seen, p),
            clipped=float(np.mean(image[::4, ::4].min(axis=2) >= p.clipped_level)),
            room={name: int(np.sum(others == k)) for k, name in names},
            advice=(),
        )
        return replace(reading, advice=tuple(_advice(reading, seen, self.profile, p)))


def any_colours(first: int) -> ColourProfile:
    """All hues at any brightness, in quarters of the circle from ``first`` on."""
    arc = HUES // QUARTERS
    starts = [(first + k * arc) % HUES for k in range(QUARTERS)]
    hues = (HueRange(str(at), (at, (at + arc - 1) % HUES), (80, 255), (30, 255)) for at in starts)
    return ColourProfile("any", tuple(hues))


def noise_of(image: Image, block: int = 16) -> float:
    """Standard deviation (levels) of green in smooth areas: the 10th percentile of blocks that are
    neither black nor white."""
    h, w = (n // (2 * block) * 2 * block for n in image.shape[:2])
    rows = image[:h, :w, 1].reshape(h // block, block, w // block, block)[::2, :, ::2]
    blocks = np.ascontiguousarray(rows.swapaxes(1, 2)).reshape(-1, block * block)
    sums = np.sum(blocks, axis=1, dtype=np.int64)
    squares = np.einsum("bi,bi->b", blocks, blocks, dtype=np.int64)
    mean = sums / block**2
    sd = np.sqrt(np.maximum(squares / block**2 - mean**2, 0.0))
    lit = (mean > 15) & (mean < 235)
    return float(np.quantile(sd[lit], 0.1)) if lit.any() else 0.0


class _Patches(NamedTuple):
    """uv (n, 2), hue (n,), radius (n,) px, pixel (n, 3) BGR of their centres, cloth (n, 3) BGR
    around them."""

    uv: Array
    hue: IntArray
    radius: Array
    pixel: Array
    cloth: Array


def _patches(image: Image, blobs: Blobs, p: MeterParams) -> _Patches:
    """Blobs with dark grey cloth around them."""
    soft = cv2.blur(image, (3, 3))
    radius = 0.5 * blobs.size.mean(axis=1) if len(blobs) else np.zeros(0)
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    spots = blobs.uv[:, None] + (1.35 * radius + 2.5)[:, None, None] * ring
    pixel, around = _at(soft, blobs.uv), _at(soft, spots)
    # another patch or a finger's edge may be on one side: the darker half of the ring is cloth
    order = np.argsort(around.max(axis=2), axis=1)[:, : len(turn) // 2]
    cloth = np.median(np.take_along_axis(around, order[..., None], axis=1), axis=1)
    dark = cloth.max(axis=1) < p.cloth_level
    grey = np.ptp(cloth, axis=1) < np.minimum(p.cloth_chroma, 12 + 0.5 * cloth.max(axis=1))
    most = np.sort(around.max(axis=2), axis=1)[:, 3 * len(turn) // 4]
    inside = (cloth.max(axis=1) * p.contrast < pixel.max(axis=1)) & (
        most < pixel.max(axis=1) * 1.05
    )
    keep = dark & grey & inside
    return _Patches(blobs.uv[keep], blobs.hue[keep], radius[keep], pixel[keep], cloth[keep])


def _whole(one: _Patches, other: _Patches) -> _Patches:
    """The union of two searches: the larger patch where both have found it."""
    gap = np.linalg.norm(one.uv[:, None] - other.uv[None], axis=2)
    same = gap < np.maximum(one.radius[:, None], other.radius[None])
    smaller = same & (one.radius[:, None] < other.radius[None])
    first, second = ~smaller.any(axis=1), ~(same & ~smaller).any(axis=0)
    pairs = zip(one, other, strict=True)
    return _Patches(*(np.concatenate([a[first], b[second]]) for a, b in pairs))


def _named(seen: _Patches, profile: ColourProfile) -> _Patches:
    """With the profile's nearest hue for each."""
    if len(seen.uv) == 0:
        return seen
    hsv = cv2.cvtColor(np.round(seen.pixel).astype(np.uint8)[None], cv2.COLOR_BGR2HSV)[0]
    apart = hsv[:, :1].astype(float) - np.array([h.centre for h in profile.hues])
    return seen._replace(hue=np.argmin(np.abs((apart + HUES / 2) % HUES - HUES / 2), axis=1))


def _of_one_hand(seen: _Patches, p: MeterParams) -> _Patches:
    """Those around the densest position: objects on a desk are patches too, but farther apart."""
    if len(seen.uv) == 0:
        return seen
    unit = 2 * float(np.median(seen.radius))
    gap = np.linalg.norm(seen.uv[:, None] - seen.uv[None], axis=2) / unit
    middle = int(np.argmax(np.sum(gap < p.hand / 2, axis=1)))
    keep = gap[middle] < p.hand
    return _Patches(*(field[keep] for field in seen))


def _at(image: Image, uv: Array) -> Array:
    """(…, 3) pixels nearest to uv (…, 2), clamped to the image."""
    h, w = image.shape[:2]
    column, row = np.round(uv[..., 0]).astype(int), np.round(uv[..., 1]).astype(int)
    return image[np.clip(row, 0, h - 1), np.clip(column, 0, w - 1)].astype(float)


def _near(uv: Array, hue: IntArray, blobs: Blobs, reach: float) -> NDArray[np.bool_]:
    """(n,) whether a blob of the same hue is there."""
    gap = np.linalg.norm(uv[:, None] - blobs.uv[None], axis=2)
    return np.any((gap < reach) & (hue[:, None] == blobs.hue[None]), axis=1)


def _neighbours(blobs: Blobs, seen: _Patches) -> IntArray:
    """Hues (k,) of the blobs that are not patches."""
    gap = np.linalg.norm(blobs.uv[:, None] - seen.uv[None], axis=2)
    return blobs.hue[~np.any(gap < seen.radius[None] + 2, axis=1)]


def _warmth(seen: _Patches, p: MeterParams) -> float:
    """Linear red / blue of the cloth, NaN where too few patches are visible."""
    if len(seen.uv) < p.least_patches:
        return float("nan")
    # lit patches have more weight than shaded ones, where the light differs
    blue, _, red = np.mean((seen.cloth / 255) ** 2.2, axis=0)
    return float(red / max(blue, 1e-6))


def _advice(
    r: LightReading, seen: _Patches, profile: ColourProfile, p: MeterParams
) -> list[Advice]:
    names = np.array(profile.hue_names)
    out = []
    few = len(seen.uv) < p.least_patches
    dim = r.level < p.dark_level and r.noise > p.noise  # cloth is noise then, and has no colour
    clipped = seen.pixel.max(axis=1) >= p.clipped_level
    if not few and clipped.mean() > p.clipped_share:
        hues = names[np.unique(seen.hue[clipped])]
        out.append(Advice("clipped", warning("light.too_bright", hues=hues.tolist())))
    elif r.clipped > p.clipped_image:
        out.append(Advice("clipped", warning("light.clipped", share_percent=100 * r.clipped)))
    if not few and r.level < p.dark_level:
        out.append(Advice("dark", warning("light.dark")))
    if r.noise > p.noise:
        out.append(Advice("noisy", warning("light.noisy")))
    if r.warmth > p.warm and not dim:
        out.append(Advice("warm", warning("light.warm")))
    if r.warmth < p.cold and not dim:
        out.append(Advice("cold", warning("light.cold")))
    return out + _colour_advice(r, seen, profile, p)


def _colour_advice(
    r: LightReading, seen: _Patches, profile: ColourProfile, p: MeterParams
) -> list[Advice]:
    """Hues that are similar or occur in the background, and missed markers."""
    out = []
    for a, b in near_hues(seen.pixel, seen.hue, p.near_hues):
        pair = (profile.hue_names[a], profile.hue_names[b])
        out.append(Advice("near", warning("light.hues_alike", hues=pair)))
    crowded = [name for name, count in r.room.items() if count > p.room_blobs]
    if crowded:
        spots = sum(r.room.values())
        out.append(Advice("room", warning("light.room_has_hues", hues=crowded, spots=spots)))
    missed = len(r.missed)
    if missed:
        few_found = warning("light.markers_missed", missed=missed, expected=len(r.uv))
        out.append(Advice("missed", few_found))
    if len(r.uv) < p.least_patches:
        out.append(Advice("hand", notice("light.show_hand")))
    return out


def near_hues(pixel: Array, hue: IntArray, least: float) -> list[tuple[int, int]]:
    """Pairs of hues whose patches (n, 3) BGR differ by less than ``least`` in the median."""
    if len(pixel) == 0:
        return []
    hsv = cv2.cvtColor(np.round(pixel).astype(np.uint8)[None], cv2.COLOR_BGR2HSV)[0]
    turn = np.exp(2j * np.pi * hsv[:, 0].astype(float) / HUES)
    middle = {int(k): float(np.angle(turn[hue == k].mean())) for k in np.unique(hue)}
    out = []
    for a, b in combinations(middle, 2):
        gap = abs((middle[a] - middle[b] + np.pi) % (2 * np.pi) - np.pi) * HUES / (2 * np.pi)
        if gap < least and min(np.sum(hue == a), np.sum(hue == b)) >= 2:
            out.append((a, b))
    return out
