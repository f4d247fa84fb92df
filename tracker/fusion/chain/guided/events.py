"""Guided poses as events of a session tell them (docs/sessions.md)."""

from __future__ import annotations

from typing import NamedTuple

from tracker.hand.poses import POSES
from tracker.messages import Event

KIND = "guided"


class GuidedSaid(NamedTuple):
    """A pose begins, or ends and was ``held`` or not."""

    pose: str
    begins: bool
    held: bool


def guided_of(event: Event) -> GuidedSaid | str | None:
    """What an event says of a guided pose; a sentence where it is of none that there is, None where
    it is about something else."""
    if event.kind != KIND:
        return None
    pose, phase = event.data.get("pose"), event.data.get("phase")
    if not isinstance(pose, str) or pose not in POSES:
        return f"There is no guided pose {str(pose)[:40]!r}: it is passed over."
    if phase not in ("begin", "end"):
        return f"The guided pose {pose} neither begins nor ends: it is passed over."
    return GuidedSaid(pose, phase == "begin", event.data.get("held") is True)


def began(pose: str, t: float) -> Event:
    """The wearer is to hold ``pose`` from ``t`` (s) on."""
    return Event(t, KIND, POSES[pose].words, {"pose": pose, "phase": "begin"})


def ended(pose: str, t: float, held: bool) -> Event:
    """The pose is over at ``t`` (s); ``held``: not skipped."""
    return Event(t, KIND, "", {"pose": pose, "phase": "end", "held": held})
