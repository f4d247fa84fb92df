"""Display of a colour profile: colours of the hues, numbers of blobs, overlapping ranges."""

from __future__ import annotations

import colorsys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from app.engines.snapshot import Snapshot
from app.viewmodels.names import display_name
from app.viewmodels.states import GOOD, IDLE, WARN, StateLook
from app.words import local, tr
from tracker.calibration.colours_fit import clashes
from tracker.messages import Array, Blobs, Tracking
from tracker.vision.colours import HUES, ColourProfile


def hue_hex(hue: float) -> str:
    """A saturated colour of this OpenCV hue, visible on a dark image."""
    rgb = colorsys.hsv_to_rgb(hue / HUES, 0.85, 1.0)
    return "#" + "".join(f"{round(255 * x):02X}" for x in rgb)


def hue_colours(profile: ColourProfile) -> dict[str, str]:
    """The display colour of each hue, by name."""
    return {h.name: hue_hex(h.centre) for h in profile.hues}


def nearest_hue(profile: ColourProfile, hsv: Array) -> tuple[str, bool]:
    """The hue nearest to an HSV pixel (3,), and whether the pixel is in its range; hues whose range
    contains the pixel take precedence."""
    inside = [h.name for h in profile.hues if h.contains(hsv)]
    apart = {h.name: abs((hsv[0] - h.centre + HUES / 2) % HUES - HUES / 2) for h in profile.hues}
    return min(inside or apart, key=apart.__getitem__), bool(inside)


@dataclass(frozen=True)
class HueRow:
    """One hue: the number of blobs, the expected number, and problems."""

    name: str
    colour: str
    count: str
    tip: str
    look: StateLook
    clash: str


def hue_rows(
    profile: ColourProfile,
    found: Mapping[str, float] | None = None,
    expected: Mapping[str, float] | None = None,
    room: Mapping[str, float] | None = None,
) -> list[HueRow]:
    """One row per hue. ``found`` and ``expected`` are numbers of blobs in one image, by hue;
    ``room`` is the share of the background that has the hue."""
    colours, overlaps = hue_colours(profile), _overlaps(profile)
    rows = []
    for h in profile.hues:
        count, tip, look = _count(h.name, found, expected)
        clash = "; ".join(filter(None, (overlaps.get(h.name, ""), _room(h.name, room or {}))))
        rows.append(HueRow(h.name, colours[h.name], count, tip, WARN if clash else look, clash))
    return rows


def seen_rows(
    view: Snapshot, profile: ColourProfile, room: Mapping[str, float] | None = None
) -> list[HueRow]:
    """The rows of a live image."""
    found = {}
    if view.blobs is not None:
        sides = (view.blobs.left, view.blobs.right)
        found = blob_counts(sides, view.blobs.hue_names, profile)
    return hue_rows(profile, found, expected_counts(view), room)


def blob_counts(
    sides: Sequence[Blobs | None], names: Sequence[str], profile: ColourProfile
) -> dict[str, float]:
    """Number of blobs in one image by hue name: the mean over the sides. Empty without an image."""
    there = [b for b in sides if b is not None]
    if not there:
        return {}
    return {
        h.name: sum(int((b.hue == names.index(h.name)).sum()) for b in there) / len(there)
        for h in profile.hues
        if h.name in names
    }


def expected_counts(view: Snapshot) -> dict[str, float]:
    """Number of visible markers expected in one image by hue name; empty while searching, and if
    there are no predictions, as in a session."""
    if view.result is None or view.result.tracking != Tracking.TRACKING:
        return {}
    out: dict[str, float] = {}
    for marker in view.setup.glove.markers:
        seen = float(np.nan_to_num(view.result.visible[marker.id]))
        out[marker.hue] = out.get(marker.hue, 0.0) + seen
    return out if any(out.values()) else {}


def _count(
    name: str, found: Mapping[str, float] | None, expected: Mapping[str, float] | None
) -> tuple[str, str, StateLook]:
    """Short text, long text and state."""
    if not found or name not in found:
        return "–", tr("no image"), IDLE
    n = found[name]
    if not expected or name not in expected:
        return f"{n:.0f}", tr("{:.0f} found in an image").format(n), IDLE
    m = expected[name]
    if round(m) == 0:
        words = tr("{:.0f} found in an image, none expected").format(n)
        return f"{n:.0f}", words, WARN if n > 2 else GOOD
    wrong = n < 0.5 * m or n > 2 * m + 2
    words = tr("{:.0f} found in an image, about {:.0f} expected").format(n, m)
    return tr("{:.0f} of about {:.0f}").format(n, m), words, WARN if wrong else GOOD


def _overlaps(profile: ColourProfile) -> dict[str, str]:
    """For each hue name, the hues whose ranges overlap with it."""
    out: dict[str, list[str]] = {}
    for clash in clashes(profile):
        for mine, other in ((clash.hue, clash.other), (clash.other, clash.hue)):
            out.setdefault(mine, []).append(f"{display_name(other)} ({100 * clash.share:.0f} %)")
    return {name: tr("overlaps {}").format(", ".join(others)) for name, others in out.items()}


def _room(name: str, room: Mapping[str, float]) -> str:
    share = room.get(name)
    return (
        ""
        if share is None
        else tr("the background has this colour, too ({:.2g} % of the image)").format(
            local(100 * share)
        )
    )
