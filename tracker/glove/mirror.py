"""The hand and glove of the other side: the mirror image in y of each segment's frame B."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel, Joint, Synergy
from tracker.messages import Array

MIRROR = np.diag([1.0, -1.0, 1.0])
TURNED = ("abduction", "twist")
"""Axes about which a mirrored hand rotates in reverse; +flexion bends a finger on both sides."""
OTHER = {"left": "right", "right": "left"}


def mirrored_hand(hand: HandModel) -> HandModel:
    """A hand of the other side with the same bones, ranges and synergies."""
    segments = tuple(
        replace(s, origin=s.origin * [1, -1, 1], R_rest=_rotation(s.R_rest)) for s in hand.segments
    )
    return replace(
        hand,
        side=OTHER[hand.side],
        segments=segments,
        joints=tuple(map(_joint, hand.joints)),
        synergies=tuple(map(_synergy, hand.synergies)),
    )


def mirrored_glove(glove: GloveModel) -> GloveModel:
    """A glove of the other side with mirrored IMUs and patches."""
    imus = tuple(
        replace(i, position=i.position * [1, -1, 1], R_BI=_rotation(i.R_BI), drift=None, axes=None)
        for i in glove.imus
    )
    markers = tuple(
        replace(m, position=m.position * [1, -1, 1], normal=m.normal * [1, -1, 1])
        for m in glove.markers
    )
    keypoints = tuple(replace(k, position=k.position * [1, -1, 1]) for k in glove.keypoints)
    side = OTHER[glove.side]
    return replace(glove, side=side, imus=imus, markers=markers, keypoints=keypoints)


def _rotation(R: Array) -> Array:
    return np.asarray(MIRROR @ R @ MIRROR)


def _sign(angle: str) -> float:
    return -1.0 if angle.endswith(TURNED) else 1.0


def _synergy(synergy: Synergy) -> Synergy:
    ratio = _sign(synergy.angle) * _sign(synergy.of) * synergy.ratio
    return replace(synergy, ratio=ratio, offset=_sign(synergy.angle) * synergy.offset)


def _joint(joint: Joint) -> Joint:
    limits = {
        axis: (-high, -low) if axis in TURNED else (low, high)
        for axis, (low, high) in joint.limits.items()
    }
    return replace(joint, limits=limits)
