"""One message of the record: a hand's 26 joints, if any, and its three time stamps."""

from __future__ import annotations

import struct
from functools import cache
from typing import NamedTuple

import flatbuffers
import numpy as np
from flatbuffers.table import Table

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.hand.openxr import JOINTS, OpenXrHand
from tracker.messages import Validity

JOINT = np.dtype(
    {
        "names": ["position", "orientation", "is_valid", "radius"],
        "formats": [("<f4", 3), ("<f4", 4), "u1", "<f4"],
        "offsets": [0, 12, 28, 32],
        "itemsize": 36,
    }
)
"""core.HandJointPose: position in m, quaternion xyzw, validity, radius in m."""
STAMPS = np.dtype("<i8")


class Stamps(NamedTuple):
    """Times in ns: when the record was available and when the hand was sampled, both on the
    system's monotonic clock; and the sample time on the glove's clock."""

    available: int
    sample: int
    device: int


class HandRecord(NamedTuple):
    """``joints`` (26,) of type `JOINT`; None while the hand is inactive."""

    stamps: Stamps
    joints: np.ndarray | None


def joints_of(hand: OpenXrHand) -> np.ndarray | None:
    """Joints (26,) of type `JOINT`; None if the wrist is lost, since a hand requires it.

    A lost joint has a cleared flag and zero values.
    """
    valid = hand.state != Validity.LOST
    if not valid[JOINTS.index("wrist")]:
        return None
    out = np.zeros(len(JOINTS), JOINT)
    out["position"][valid] = hand.position[valid]
    out["orientation"][valid] = hand.orientation[valid]
    out["radius"][valid] = hand.radius[valid]
    out["is_valid"] = valid
    return out


class _Template(NamedTuple):
    """A message with the offsets of its parts, which are the same in all messages of a kind."""

    bytes: bytes
    joints: int
    stamps: int


def encode(record: HandRecord) -> bytes:
    """The flatbuffer of a record."""
    template = _template(record.joints is not None)
    out = bytearray(template.bytes)
    stamps = np.array(record.stamps, STAMPS).tobytes()
    out[template.stamps : template.stamps + len(stamps)] = stamps
    if record.joints is not None:
        joints = record.joints.tobytes()
        out[template.joints : template.joints + len(joints)] = joints
    return bytes(out)


@cache
def _template(active: bool) -> _Template:
    b = flatbuffers.Builder(1200)
    size, joints, data = JOINT.itemsize * len(JOINTS), 0, 0
    if active:
        b.StartObject(1)  # core.HandPose
        joints = _struct(b, size, 4)
        b.PrependStructSlot(0, joints, 0)
        data = b.EndObject()
    b.StartObject(2)  # core.HandPoseRecord
    b.PrependUOffsetTRelativeSlot(0, data, 0)
    stamps = _struct(b, 24, 8)
    b.PrependStructSlot(1, stamps, 0)
    b.Finish(b.EndObject())
    whole = bytes(b.Output())
    return _Template(whole, len(whole) - joints, len(whole) - stamps)


def _struct(b: flatbuffers.Builder, size: int, align: int) -> int:
    """Reserve space for a struct; returns its offset from the end."""
    b.Prep(align, size)
    b.Pad(size)
    return int(b.Offset())


def decode(data: bytes) -> HandRecord:
    """The record in a message. Raises FileError if it is invalid."""
    try:
        return _decode(data)
    except (ValueError, TypeError, IndexError, struct.error) as error:
        raise FileError(notice("isaac.damaged")) from error


def _decode(data: bytes) -> HandRecord:
    root = Table(data, int.from_bytes(data[:4], "little"))
    at = root.Offset(6)
    stamps = Stamps(0, 0, 0)
    if at:
        stamps = Stamps(*np.frombuffer(data, STAMPS, 3, root.Pos + at).tolist())
    to_data = root.Offset(4)
    if not to_data:
        return HandRecord(stamps, None)
    hand = Table(data, root.Indirect(root.Pos + to_data))
    to_joints = hand.Offset(4)
    if not to_joints:
        return HandRecord(stamps, None)
    return HandRecord(stamps, np.frombuffer(data, JOINT, len(JOINTS), hand.Pos + to_joints))
