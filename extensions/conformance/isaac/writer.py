"""Writes MCAP files without compression, with one topic per hand, and one per tracked fingertip.

Wrist and fingertips are SE(3) trackers of NVIDIA's Isaac Teleop, by name. Each is a tracker of its
own, `core.Se3TrackerPoseRecord`, whose collection is named ``glovetrack_SIDE_JOINT``
(``glovetrack_right_index_tip``); the frame is OpenXR's world, the axes are those of its joints.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import BinaryIO, NamedTuple

import flatbuffers
import numpy as np
from mcap.writer import CompressionType, Writer

from extensions.conformance.isaac.record import STAMPS, HandRecord, Stamps, encode
from extensions.conformance.isaac.schema import NAME, SE3, binary_schema
from tracker import __version__
from tracker.hand.names import SIDES
from tracker.hand.openxr import JOINTS, OpenXrHand
from tracker.messages import Validity

ENCODING = "flatbuffer"
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


def topic(side: str) -> str:
    return f"hands/{side}_hand"


class IsaacWriter:
    """Writes records of both hands to an open file, which the caller closes.

    Both topics exist even with only one hand. Records of a hand must be in the order of their
    available times.
    """

    def __init__(self, file: BinaryIO) -> None:
        self._writer = Writer(file, compression=CompressionType.NONE)
        self._writer.start("", f"glovetrack {__version__}")
        schema = self._writer.register_schema(NAME, ENCODING, binary_schema())
        self._channels = {
            side: self._writer.register_channel(topic(side), ENCODING, schema) for side in SIDES
        }
        self._tips: dict[tuple[str, str], list[int]] = {}
        self._se3 = 0
        self._sequence = 0

    def write(self, side: str, record: HandRecord) -> None:
        """Add one record at its available time."""
        stamp = record.stamps.available
        self._writer.add_message(self._channels[side], stamp, encode(record), stamp, self._sequence)
        self._sequence += 1

    def write_tips(self, side: str, stamps: Stamps, hand: OpenXrHand) -> None:
        """Add the poses of wrist and fingertips as SE(3) trackers, at their available time."""
        for name, data in tip_records(hand, stamps).items():
            for channel in self._tip_channels(side, name):
                self._writer.add_message(
                    channel, stamps.available, data, stamps.available, self._sequence
                )
        self._sequence += 1

    def _tip_channels(self, side: str, name: str) -> list[int]:
        if (side, name) not in self._tips:
            if not self._tips:
                self._se3 = self._writer.register_schema(SE3, ENCODING, binary_schema(SE3))
            topics = [f"{collection(side, name)}/{channel}" for channel in CHANNELS]
            register = self._writer.register_channel
            self._tips[side, name] = [register(t, ENCODING, self._se3) for t in topics]
        return self._tips[side, name]

    def finish(self) -> None:
        """Write the index, without which most readers treat the file as truncated."""
        self._writer.finish()


def write_records(path: Path, hands: Mapping[str, Sequence[HandRecord]]) -> None:
    """Write a file with the records of each side in the order of their available times."""
    items = [(r.stamps.available, side, r) for side, records in hands.items() for r in records]
    with path.open("wb") as file:
        writer = IsaacWriter(file)
        for _, side, record in sorted(items, key=lambda item: item[:2]):
            writer.write(side, record)
        writer.finish()
