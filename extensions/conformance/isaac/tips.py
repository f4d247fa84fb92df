"""Poses of the wrist and each fingertip as SE(3) trackers of NVIDIA's Isaac Teleop, by name.

Each is a tracker of its own, `core.Se3TrackerPoseRecord`, whose collection is named
``glovetrack_SIDE_JOINT`` (``glovetrack_right_index_tip``); the frame is OpenXR's world, the axes
are those of OpenXR's joints.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import flatbuffers
import numpy as np

from extensions.conformance.isaac.record import STAMPS, Stamps
from tracker.hand.openxr import JOINTS, OpenXrHand
from tracker.messages import Validity

TIPS = ("wrist", *(j for j in JOINTS if j.endswith("_tip")))
CHANNELS = ("se3_tracker", "se3_tracker_tracked")
"""Each sample, and the latest sample of each frame of a recorder, which here is the same."""
_POSE = np.dtype("<f4")


def collection(side: str, joint: str) -> str:
    """Name of a tracker."""
    return f"glovetrack_{side}_{joint}"


def tip_records(hand: OpenXrHand, stamps: Stamps) -> dict[str, bytes]:
    """The flatbuffer of each of `TIPS`; a lost one is not valid and has the identity."""
    out = {}
    for name in TIPS:
        i = JOINTS.index(name)
        valid = hand.state[i] != Validity.LOST
        pose = [*hand.position[i], *hand.orientation[i]] if valid else [0.0] * 6 + [1.0]
        out[name] = _encoded(np.array(pose, _POSE), bool(valid), stamps)
    return out


class _TipTemplate(NamedTuple):
    bytes: bytes
    pose: int
    stamps: int


def _encoded(pose: np.ndarray, valid: bool, stamps: Stamps) -> bytes:
    template = _template(valid)
    out = bytearray(template.bytes)
    out[template.pose : template.pose + 28] = pose.tobytes()
    out[template.stamps : template.stamps + 24] = np.array(stamps, STAMPS).tobytes()
    return bytes(out)


@cache
def _template(valid: bool) -> _TipTemplate:
    b = flatbuffers.Builder(128)
    b.StartObject(2)  # core.Se3TrackerPose
    b.PrependBoolSlot(1, valid, False)
    b.Prep(4, 28)
    b.Pad(28)
    pose = int(b.Offset())
    b.PrependStructSlot(0, pose, 0)
    data = b.EndObject()
    b.StartObject(2)  # core.Se3TrackerPoseRecord
    b.PrependUOffsetTRelativeSlot(0, data, 0)
    b.Prep(8, 24)
    b.Pad(24)
    stamps = int(b.Offset())
    b.PrependStructSlot(1, stamps, 0)
    b.Finish(b.EndObject())
    whole = bytes(b.Output())
    return _TipTemplate(whole, len(whole) - pose, len(whole) - stamps)
