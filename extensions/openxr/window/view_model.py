"""What the panel *OpenXR* shows, from the registration and the shared memory."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.viewmodels.states import BAD, GOOD, IDLE, WARN, StateLook
from app.words import mark, tr
from extensions.openxr.readers import Link, Reader
from extensions.openxr.registration import Registered
from tracker.geometry import so3
from tracker.hand.openxr import R_BX
from tracker.messages import Array

LAYER_TEXTS = {
    Registered.NO: mark("The layer is not registered. Applications do not find the hand."),
    Registered.YES: mark("The layer is registered. Applications find the hand when they start."),
    Registered.OLD: mark("The layer of another version is registered. Register it again."),
    Registered.BROKEN: mark("The registered layer is damaged. Register it again."),
}
LAYER_LOOKS = {
    Registered.NO: IDLE,
    Registered.YES: GOOD,
    Registered.OLD: WARN,
    Registered.BROKEN: BAD,
}


IN_FRONT = {"local": np.array([0.0, -0.3, -0.4]), "stage": np.array([0.0, 1.1, -0.4])}
"""m, where a wrist is in front of the wearer, by the reference space."""


@dataclass(frozen=True)
class StateText:
    """A sign with its colour, and a sentence."""

    look: StateLook
    text: str


def origin_for(wrist_G: Array, space: str, yaw_deg: float) -> tuple[float, float, float]:
    """Position (m) of Glovetrack's origin with which a wrist (3,) m is `IN_FRONT`."""
    wrist = so3.ry(np.deg2rad(yaw_deg)) @ (wrist_G @ R_BX)
    x, y, z = (IN_FRONT.get(space, IN_FRONT["local"]) - wrist).tolist()
    return x, y, z


def layer_text(found: Registered) -> StateText:
    return StateText(LAYER_LOOKS[found], tr(LAYER_TEXTS[found]))


def stream_text(on: bool, link: Link | None) -> StateText:
    """Whether the hand is sent, and which applications read it now."""
    if not on:
        return StateText(IDLE, tr("The hand is not sent."))
    if link is None or not link.running:
        return StateText(IDLE, tr("The hand is sent as soon as tracking runs."))
    names = [r.name or tr("unnamed") for r in link.readers if r.is_reading(link.now_ns)]
    if not names:
        return StateText(WARN, tr("The hand is sent. No application reads it now."))
    return StateText(GOOD, tr("The hand is sent and read by {}.").format(", ".join(names)))


def test_result(
    found: Registered, on: bool, before: Link | None, after: Link | None, seconds: float
) -> StateText:
    """Whether an application read the hand between two states of the memory, ``seconds`` apart."""
    if found != Registered.YES:
        return layer_text(found)
    if not on or after is None or not after.running:
        return StateText(BAD, tr("Nothing is sent: tick the stream and start tracking, then test."))
    counts = {r.process: r for r in before.readers} if before is not None else {}
    reading = [r for r in after.readers if r.is_reading(after.now_ns)]
    if reading:
        lines = [_rate(r, counts.get(r.process), seconds) for r in reading]
        return StateText(GOOD, "\n".join(lines))
    if after.readers:
        last = max(after.readers, key=lambda r: r.last_ns)
        ago = (after.now_ns - last.last_ns) / 1e9
        text = tr("No application reads the hand now. The last one was {}, {:.0f} s ago.")
        return StateText(WARN, text.format(last.name, ago))
    return StateText(
        WARN,
        tr(
            "No application has read the hand. Start an application with hand tracking; one that "
            "was running before the layer was registered must be started again."
        ),
    )


def _rate(now: Reader, before: Reader | None, seconds: float) -> str:
    readings = now.readings - (before.readings if before is not None else 0)
    active = now.active - (before.active if before is not None else 0)
    text = (
        tr("{} reads the hand {:.0f} times per second.")
        if active
        else tr("{} asks for the hand {:.0f} times per second, but the hand is lost.")
    )
    return text.format(now.name or tr("unnamed"), readings / seconds)
