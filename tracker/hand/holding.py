"""How well a guided pose is held according to the tracker, as feedback for the wearer.

A pure function of one estimate. It evaluates measured joints; inferred ones would only reflect the
tracker's assumptions.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import GuidedPose, HeldFlexion
from tracker.messages import Array, Estimate, Tracking, Validity

ALLOWED = 2.5  # sds of a pose by which a joint may deviate, in addition to the tracker's own error
OWN_ERROR = np.deg2rad(8.0)  # rad, of a displayed angle
NOTHING_ARRIVES = "nothing"
"""In place of a joint: the displayed hand is a guess, since no sensor measures it any more."""
NEAR = (
    0.038  # m between the ends of two fingertips' axes: radii, where pads meet, the tracker's error
)
UNPLACED = 0.010  # m added if the mounting of the IMUs was not estimated with a camera


class Holding(NamedTuple):
    """``is_held``, and if not the largest deviation: ``joint`` (or the finger to be touched),
    ``off`` rad or m, ``word`` a short instruction for the user. A pose assumed to be held because
    nothing measures it has the ``joint``, too."""

    is_held: bool
    joint: str = ""
    off: float = 0.0
    word: str = ""


def how_held(pose: GuidedPose, estimate: Estimate, hand: HandModel) -> Holding:
    """Evaluates ``pose`` in ``estimate``."""
    if estimate.tracking == Tracking.SEARCHING:
        return Holding(False, word="Show the hand to the camera")
    if not (estimate.angle_state == int(Validity.MEASURED)).any():
        return Holding(False, NOTHING_ARRIVES, word="Nothing arrives from the glove")
    amiss = [_joint(f, estimate, hand) for f in pose.flexions]
    if pose.touches:
        amiss.append(_touch(pose.touches, estimate, hand))
    worst = max((a for a in amiss if a is not None), key=lambda a: a[0], default=None)
    if worst is None:
        return Holding(True, joint=pose.touches or pose.flexions[0].joint)
    if worst[0] <= 1.0:
        return Holding(True)
    return worst[1]


def _joint(held: HeldFlexion, estimate: Estimate, hand: HandModel) -> tuple[float, Holding] | None:
    """The deviation of a joint relative to its limit; None where nothing measures it."""
    column = hand.angle_index.get(f"{held.joint}_flexion", -1)
    if column < 0 or estimate.angle_state[column] != int(Validity.MEASURED):
        return None
    off = float(estimate.angles[column] - held.value)
    finger = held.joint.split("_")[0]
    name = finger if finger == "thumb" else f"{finger} finger"
    word = f"Straighten the {name} more" if off > 0 else f"Bend the {name} more"
    return abs(off) / (ALLOWED * held.sd + OWN_ERROR), Holding(False, held.joint, off, word)


def _touch(finger: str, estimate: Estimate, hand: HandModel) -> tuple[float, Holding] | None:
    """Likewise for the distance of two fingertips; no other may be closer to the thumb's."""
    known = [f for f in FINGERS if _is_measured(f, estimate, hand)]
    thumb = _tip("thumb", estimate, hand)
    if thumb is None or finger not in known:
        return None
    tips = {f: tip for f in known if (tip := _tip(f, estimate, hand)) is not None}
    if finger not in tips:
        return None
    apart = {f: float(np.linalg.norm(thumb - tip)) for f, tip in tips.items()}
    allowed = NEAR + UNPLACED * (estimate.tracking == Tracking.LOST)
    word = f"Bring thumb and {finger} fingertip together"
    share = max(apart[finger] / allowed, apart[finger] / max(min(apart.values()), 1e-9))
    return share, Holding(False, finger, apart[finger], word)


def _tip(digit: str, estimate: Estimate, hand: HandModel) -> Array | None:
    """(3,) m, the end of a digit's axis; None where the hand has none."""
    row = hand.index.get(CHAINS[digit][-1], -1)
    if row < 0:
        return None
    end = np.array([hand.segments[row].length, 0.0, 0.0])
    return np.asarray(estimate.segment_p[row] + estimate.segment_R[row] @ end)


def _is_measured(finger: str, estimate: Estimate, hand: HandModel) -> bool:
    """Whether a sensor measures the finger's middle joint."""
    column = hand.angle_index.get(f"{finger}_pip_flexion", -1)
    return column >= 0 and estimate.angle_state[column] == int(Validity.MEASURED)
