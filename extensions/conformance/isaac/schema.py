"""The binary schemas of `core.HandPoseRecord` and `core.Se3TrackerPoseRecord`, for readers.

Source: names, types and ids of NVIDIA/IsaacTeleop, src/core/schema/fbs/{hand,se3_tracker,pose,
point,quaternion,timestamp}.fbs; the form of a binary schema is google/flatbuffers,
reflection/reflection.fbs, whose field numbers are given next to each value. No flatbuffers compiler
is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import flatbuffers

NAME = "core.HandPoseRecord"
SE3_POSE, SE3 = "core.Se3TrackerPose", "core.Se3TrackerPoseRecord"
JOINTS = 26

BOOL, LONG, FLOAT, OBJECT, ARRAY = 2, 9, 11, 15, 17  # reflection.BaseType
_SIZE = {BOOL: 1, LONG: 8, FLOAT: 4}


class _Field(NamedTuple):
    """``offset``: bytes from the start of a struct, or the position in a table's vtable."""

    name: str
    kind: int
    id: int
    offset: int
    padding: int = 0
    of: str = ""  # object


class _Object(NamedTuple):
    """A struct of ``size`` bytes aligned to ``align``, or a table, whose size is 0."""

    name: str
    fields: tuple[_Field, ...]
    align: int
    size: int


_OBJECTS = (
    _Object("core.DeviceDataTimestamp", (
        _Field("available_time_local_common_clock", LONG, 0, 0),
        _Field("sample_time_local_common_clock", LONG, 1, 8),
        _Field("sample_time_raw_device_clock", LONG, 2, 16),
    ), 8, 24),
    _Object("core.HandJointPose", (
        _Field("pose", OBJECT, 0, 0, 0, "core.Pose"),
        _Field("is_valid", BOOL, 1, 28, 3),
        _Field("radius", FLOAT, 2, 32),
    ), 4, 36),
    _Object("core.HandJoints", (
        _Field("poses", ARRAY, 0, 0, 0, "core.HandJointPose"),
    ), 4, 36 * JOINTS),
    _Object("core.HandPose", (
        _Field("joints", OBJECT, 0, 4, 0, "core.HandJoints"),
    ), 1, 0),
    _Object("core.HandPoseRecord", (
        _Field("data", OBJECT, 0, 4, 0, "core.HandPose"),
        _Field("timestamp", OBJECT, 1, 6, 0, "core.DeviceDataTimestamp"),
    ), 1, 0),
    _Object("core.Point", tuple(
        _Field(axis, FLOAT, i, 4 * i) for i, axis in enumerate("xyz")
    ), 4, 12),
    _Object("core.Pose", (
        _Field("position", OBJECT, 0, 0, 0, "core.Point"),
        _Field("orientation", OBJECT, 1, 12, 0, "core.Quaternion"),
    ), 4, 28),
    _Object("core.Quaternion", tuple(
        _Field(axis, FLOAT, i, 4 * i) for i, axis in enumerate("xyzw")
    ), 4, 16),
    _Object("core.Se3TrackerPose", (
        _Field("pose", OBJECT, 0, 4, 0, "core.Pose"),
        _Field("is_valid", BOOL, 1, 6),
    ), 1, 0),
    _Object("core.Se3TrackerPoseRecord", (
        _Field("data", OBJECT, 0, 4, 0, "core.Se3TrackerPose"),
        _Field("timestamp", OBJECT, 1, 6, 0, "core.DeviceDataTimestamp"),
    ), 1, 0),
)  # fmt: skip
_SIZES = {o.name: o.size for o in _OBJECTS}
_ROOTS = {
    NAME: {o.name for o in _OBJECTS if not o.name.startswith("core.Se3")},
    SE3: {"core.DeviceDataTimestamp", "core.Point", "core.Pose", "core.Quaternion", SE3_POSE, SE3},
}
"""Objects of each schema."""


@cache
def binary_schema(root: str = NAME) -> bytes:
    """The binary schema (.bfbs) of `NAME` or `SE3`."""
    b = flatbuffers.Builder(2048)
    used = [o for o in _OBJECTS if o.name in _ROOTS[root]]  # by name: readers use binary search
    row = {o.name: i for i, o in enumerate(used)}
    objects = [_object(b, o, row) for o in used]
    rows, enums = _vector(b, objects), _vector(b, [])
    nothing = b.CreateString("")
    b.StartObject(8)  # reflection.Schema
    for slot, offset in (
        (0, rows),
        (1, enums),
        (2, nothing),
        (3, nothing),
        (4, objects[row[root]]),
    ):
        b.PrependUOffsetTRelativeSlot(slot, offset, 0)
    b.Finish(b.EndObject(), file_identifier=b"BFBS")
    return bytes(b.Output())


def _object(b: flatbuffers.Builder, o: _Object, row: Mapping[str, int]) -> int:
    fields = _vector(b, [_field(b, f, bool(o.size), row) for f in sorted(o.fields)])
    name = b.CreateString(o.name)
    b.StartObject(8)  # reflection.Object
    b.PrependUOffsetTRelativeSlot(0, name, 0)
    b.PrependUOffsetTRelativeSlot(1, fields, 0)
    b.PrependBoolSlot(2, bool(o.size), False)
    b.PrependInt32Slot(3, o.align, 0)
    b.PrependInt32Slot(4, o.size, 0)
    return int(b.EndObject())


def _field(b: flatbuffers.Builder, f: _Field, of_struct: bool, row: Mapping[str, int]) -> int:
    name, kind = b.CreateString(f.name), _type(b, f, row)
    b.StartObject(14)  # reflection.Field
    b.PrependUOffsetTRelativeSlot(0, name, 0)
    b.PrependUOffsetTRelativeSlot(1, kind, 0)
    b.PrependUint16Slot(2, f.id, 0)
    b.PrependUint16Slot(3, f.offset, 0)
    b.PrependBoolSlot(11, not of_struct, False)  # optional
    b.PrependUint16Slot(12, f.padding, 0)
    return int(b.EndObject())


def _type(b: flatbuffers.Builder, f: _Field, row: Mapping[str, int]) -> int:
    array = f.kind == ARRAY
    b.StartObject(6)  # reflection.Type
    b.PrependInt8Slot(0, f.kind, 0)
    b.PrependInt8Slot(1, OBJECT if array else 0, 0)
    b.PrependInt32Slot(2, row[f.of] if f.of else -1, -1)
    b.PrependUint16Slot(3, JOINTS if array else 0, 0)
    b.PrependUint32Slot(4, _SIZE.get(f.kind, 4), 4)
    b.PrependUint32Slot(5, _SIZES[f.of] if array else 0, 0)
    return int(b.EndObject())


def _vector(b: flatbuffers.Builder, offsets: Sequence[int]) -> int:
    b.StartVector(4, len(offsets), 4)
    put: Callable[[int], None] = b.PrependUOffsetTRelative
    for offset in reversed(offsets):
        put(offset)
    return int(b.EndVector())
