"""The colour profile on screen: what hues look like, how many blobs, which intervals clash."""

from __future__ import annotations

import colorsys
import dataclasses
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.viewmodels.snapshot import Snapshot
from app.viewmodels.states import GOOD, IDLE, WARN, Look
from tracker.messages import Array, Tracking
from tracker.vision.colours import HUES, ColourProfile, HueRange


def hue_hex(hue: float) -> str:
    """A clear colour of this OpenCV hue, readable on a dark picture."""
    rgb = colorsys.hsv_to_rgb(hue / HUES, 0.85, 1.0)
    return "#" + "".join(f"{round(255 * x):02X}" for x in rgb)


def hue_colours(profile: ColourProfile) -> dict[str, str]:
    """Hue name to the colour it is drawn in."""
    return {h.name: hue_hex(h.centre) for h in profile.hues}


class ProfileHistory:
    """The profile being tuned, with undo and redo."""

    def __init__(self, profile: ColourProfile, depth: int = 100) -> None:
        self._past: list[ColourProfile] = []
        self._future: list[ColourProfile] = []
        self._depth = depth
        self.profile = profile

    def change(self, profile: ColourProfile, merge: bool = False) -> None:
        """Take a new profile; with ``merge`` (a slider still moving) no step of its own."""
        if profile == self.profile:
            return
        if not (merge and self._past):
            self._past = [*self._past, self.profile][-self._depth :]
        self._future.clear()
        self.profile = profile

    def undo(self) -> bool:
        """Whether there was a step to take back."""
        if not self._past:
            return False
        self._future.append(self.profile)
        self.profile = self._past.pop()
        return True

    def redo(self) -> bool:
        if not self._future:
            return False
        self._past.append(self.profile)
        self.profile = self._future.pop()
        return True


def with_range(profile: ColourProfile, changed: HueRange) -> ColourProfile:
    """``profile`` with the hue of the same name replaced."""
    hues = tuple(changed if h.name == changed.name else h for h in profile.hues)
    return dataclasses.replace(profile, hues=hues)


def with_channel(hue_range: HueRange, channel: str, interval: tuple[int, int]) -> HueRange:
    """``hue_range`` with its "hue", "saturation" or "value" interval replaced."""
    if channel == "hue":
        return dataclasses.replace(hue_range, hue=interval)
    if channel == "saturation":
        return dataclasses.replace(hue_range, saturation=interval)
    return dataclasses.replace(hue_range, value=interval)


def stretched(hue_range: HueRange, hsv: tuple[int, int, int], margin: int = 2) -> HueRange:
    """The smallest growth of a range that takes in the pixel, and ``margin`` beyond it.

    The hue interval grows at whichever end is nearer round the circle.
    """
    h, s, v = hsv
    first, last = hue_range.hue
    if (h - first) % HUES > hue_range.width:
        before, after = (first - h) % HUES, (h - last) % HUES
        if before <= after:
            first = (h - margin) % HUES
        else:
            last = (h + margin) % HUES
    return dataclasses.replace(
        hue_range,
        hue=(first, last),
        saturation=_grown(hue_range.saturation, s, margin),
        value=_grown(hue_range.value, v, margin),
    )


def _grown(interval: tuple[int, int], x: int, margin: int) -> tuple[int, int]:
    low, high = interval
    low = max(0, x - margin) if x < low else low
    high = min(255, x + margin) if x > high else high
    return low, high


def without_pixel(hue_range: HueRange, hsv: tuple[int, int, int]) -> HueRange:
    """The range that just leaves the pixel out, cut where the cut costs the smallest share."""
    if not bool(hue_range.contains(np.array(hsv))):
        return hue_range
    cuts = [*_hue_cuts(hue_range, hsv[0]), *_level_cuts(hue_range, hsv[1], hsv[2])]
    return min(cuts, key=lambda c: c[0])[1] if cuts else hue_range


def _hue_cuts(r: HueRange, h: int) -> list[tuple[float, HueRange]]:
    """(share lost, range) of moving either end of the hue interval past ``h``."""
    below = (h - r.hue[0]) % HUES + 1
    above = (r.hue[1] - h) % HUES + 1
    total = r.width + 1
    cuts = []
    if below < total:
        cuts.append((below / total, dataclasses.replace(r, hue=((h + 1) % HUES, r.hue[1]))))
    if above < total:
        cuts.append((above / total, dataclasses.replace(r, hue=(r.hue[0], (h - 1) % HUES))))
    return cuts


def _level_cuts(r: HueRange, s: int, v: int) -> list[tuple[float, HueRange]]:
    """The same for the lower ends of saturation and value."""
    cuts = []
    for key, x in (("saturation", s), ("value", v)):
        low, high = getattr(r, key)
        if x < high:
            share = (x - low + 1) / (high - low + 1)
            cuts.append((share, with_channel(r, key, (x + 1, high))))
    return cuts


@dataclass(frozen=True)
class HueRow:
    """One hue on screen."""

    name: str
    colour: str
    count: str
    look: Look
    clash: str


def hue_rows(view: Snapshot | None, profile: ColourProfile) -> list[HueRow]:
    """Blobs found (left + right) against markers expected, and clashes, per hue."""
    colours = hue_colours(profile)
    return [
        HueRow(h.name, colours[h.name], *_count(view, h.name), _clash(h, profile))
        for h in profile.hues
    ]


def _count(view: Snapshot | None, name: str) -> tuple[str, Look]:
    if view is None or view.blobs is None or name not in view.blobs.hue_names:
        return "–", IDLE
    index = view.blobs.hue_names.index(name)
    sides = [b for b in (view.blobs.left, view.blobs.right) if b is not None]
    found = sum(int((b.hue == index).sum()) for b in sides) / max(1, len(sides))
    expected = _expected(view, name)
    if expected is None:
        return f"{found:g} found", IDLE
    few = found < 0.5 * expected
    many = found > 2 * expected + 2
    return f"{found:g} found, {expected:.0f} expected", WARN if few or many else GOOD


def _expected(view: Snapshot, name: str) -> float | None:
    """Markers of the hue that should be seen in one picture; None while searching."""
    if view.result is None or view.result.tracking != Tracking.TRACKING:
        return None
    mine = [m.id for m in view.setup.glove.markers if m.hue == name]
    return float(np.nansum(view.result.visible[mine]))


def _clash(hue: HueRange, profile: ColourProfile) -> str:
    others = [o.name for o in profile.hues if o.name != hue.name and hue.overlaps(o)]
    return f"overlaps {', '.join(others)}" if others else ""


def hue_histogram(picture: NDArray[np.uint8], step: int = 4) -> Array:
    """(180,) share of each hue among the saturated, bright pixels, the largest being 1."""
    hsv = cv2.cvtColor(np.ascontiguousarray(picture[::step, ::step]), cv2.COLOR_BGR2HSV)
    vivid = (hsv[..., 1] >= 80) & (hsv[..., 2] >= 40)
    counts = np.bincount(hsv[..., 0][vivid], minlength=HUES).astype(float)
    return counts / max(1.0, counts.max())


def mask_picture(picture: NDArray[np.uint8], hue: HueRange, step: int = 2) -> NDArray[np.uint8]:
    """The picture with everything outside the range dimmed to grey, ``step`` times smaller."""
    small = np.ascontiguousarray(picture[::step, ::step])
    inside = hue.contains(cv2.cvtColor(small, cv2.COLOR_BGR2HSV))
    grey = small.mean(axis=2, keepdims=True) * 0.35
    return np.where(inside[..., None], small, grey).astype(np.uint8)


def pixel_hsv(picture: NDArray[np.uint8], u: float, v: float) -> tuple[int, int, int]:
    """HSV of the median colour of the 3 by 3 pixels around (u, v)."""
    row, column = round(v), round(u)
    patch = picture[max(0, row - 1) : row + 2, max(0, column - 1) : column + 2]
    middle = np.median(patch.reshape(-1, 3), axis=0).astype(np.uint8)
    h, s, value = cv2.cvtColor(middle.reshape(1, 1, 3), cv2.COLOR_BGR2HSV)[0, 0]
    return int(h), int(s), int(value)
