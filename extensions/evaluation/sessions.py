"""Sessions that are not usual: other people, a hand out of view, names of hues exchanged."""

from __future__ import annotations

from dataclasses import replace

from tracker.messages import BlobFrame, Blobs
from tracker.simulation.wearer import WearerParams

SEEN, AWAY = 10.0, 5.0  # s in turn, beginning in view
EXCHANGED = {"red": "blue", "blue": "red"}

_USUAL = WearerParams()
UNUSUAL = replace(
    _USUAL,
    common_size=2 * _USUAL.common_size,
    length=2 * _USUAL.length,
    breadth=2 * _USUAL.breadth,
    girth=2 * _USUAL.girth,
    joint_offset=2 * _USUAL.joint_offset,
    axis_deg=2 * _USUAL.axis_deg,
    thumb_axis_deg=2 * _USUAL.thumb_axis_deg,
    mounting_deg=2 * _USUAL.mounting_deg,
    marker_place=2 * _USUAL.marker_place,
    slip=2 * _USUAL.slip,
)


def people_of(session: str) -> WearerParams:
    """How people vary in a session of this name."""
    return UNUSUAL if session == "unusual" else _USUAL


def blobs_of(session: str, frame: BlobFrame) -> BlobFrame:
    """What the camera sees in a session of this name."""
    if session == "exchanged":
        return replace(frame, hue_names=tuple(EXCHANGED.get(n, n) for n in frame.hue_names))
    if session == "away" and frame.t % (SEEN + AWAY) >= SEEN:
        right = None if frame.right is None else Blobs.empty()
        return replace(frame, left=Blobs.empty(), right=right)
    return frame
