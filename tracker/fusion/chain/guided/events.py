"""Guided poses as events in a session (docs/sessions.md)."""

from __future__ import annotations

from typing import NamedTuple

from tracker.base.notices import Notice, notice, warning
from tracker.hand.poses import POSES
from tracker.messages import Event

KIND = "guided"


class GuidedPoseEvent(NamedTuple):
    """A pose begins, or ends; ``held``: whether it was held."""

    pose: str
    begins: bool
    held: bool


def guided_of(event: Event) -> GuidedPoseEvent | Notice | None:
    """The guided pose in an event; a notice for an unknown pose, None for any other event."""
    if event.kind != KIND:
        return None
    pose, phase = event.data.get("pose"), event.data.get("phase")
    if not isinstance(pose, str) or pose not in POSES:
        return warning("guided.unknown", pose=str(pose)[:40])
    if phase not in ("begin", "end"):
        return warning("guided.no_phase", pose=pose)
    return GuidedPoseEvent(pose, phase == "begin", event.data.get("held") is True)


def began(pose: str, t: float) -> Event:
    """The wearer is asked to hold ``pose`` from ``t`` (s) on."""
    asked = notice("guided.pose", instruction=POSES[pose].words)
    return Event.of(t, KIND, asked, {"pose": pose, "phase": "begin"})


def ended(pose: str, t: float, held: bool) -> Event:
    """The pose ends at ``t`` (s); ``held``: it was not skipped."""
    return Event(t, KIND, "", {"pose": pose, "phase": "end", "held": held})
