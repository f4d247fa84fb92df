"""Guided poses: a wearer holds them on request, to determine what free motion does not.

Their values are those people achieve (docs/sessions.md, "Guided poses"), with standard deviations,
not exact ones.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.hand.names import FINGERS

HELD = 2.0  # s for which each pose is held
BETWEEN = 1.5  # s between two poses
LATE = 0.5  # s after the start by which a wearer has reached the pose
EARLY = 0.2  # s before the end at which a wearer may release it


class HeldFlexion(NamedTuple):
    """Flexion of a joint (``index_pip``) while a pose is held: value and sd, rad.

    ``by_will``: the joint is held actively, so the value contains little information on its
    synergy.
    """

    joint: str
    value: float
    sd: float
    by_will: bool = False


@dataclass(frozen=True)
class GuidedPose:
    """``words`` is the instruction to the wearer; ``touches`` is the finger whose pad the thumb's
    pad touches, ``on_table``: fingertips and palm lie in one plane."""

    name: str
    words: str
    flexions: tuple[HeldFlexion, ...] = ()
    touches: str = ""
    on_table: bool = False


def _each(
    mcp: tuple[float, float], pip: tuple[float, float], dip: tuple[float, float]
) -> tuple[HeldFlexion, ...]:
    """For all four fingers: value and sd in degrees. A table, or the other fingers, hold the end
    joints in place, independent of their synergies."""
    return tuple(
        HeldFlexion(
            f"{finger}_{joint}", float(np.deg2rad(value)), float(np.deg2rad(sd)), joint == "dip"
        )
        for finger in FINGERS
        for joint, (value, sd) in (("mcp", mcp), ("pip", pip), ("dip", dip))
    )


def _thumb(value: float, sd: float) -> tuple[HeldFlexion, ...]:
    held = float(np.deg2rad(value)), float(np.deg2rad(sd))
    return HeldFlexion("thumb_mcp", *held), HeldFlexion("thumb_ip", *held, by_will=True)


_STRAIGHT = _each((0, 5), (0, 5), (0, 5))
_CLENCHED = _each((80, 7), (95, 7), (60, 11))

POSES: dict[str, GuidedPose] = {
    p.name: p
    for p in (
        GuidedPose(
            "flat",
            "Lay the hand flat on the table, fingers together, the thumb beside them",
            _STRAIGHT,
            on_table=True,
        ),
        GuidedPose(
            "spread", "Flat on the table, fingers and thumb spread", _STRAIGHT, on_table=True
        ),
        GuidedPose("fist", "Make a firm fist, the thumb over the fingers", _CLENCHED),
        GuidedPose("thumb_up", "A fist with the thumb straight up", _CLENCHED + _thumb(0, 10)),
        *(
            GuidedPose(
                f"pinch_{finger}",
                f"Touch the pad of the {finger} finger with the pad of the thumb",
                touches=finger,
            )
            for finger in FINGERS
        ),
    )
}
"""By name, in the order in which a wearer performs them."""
