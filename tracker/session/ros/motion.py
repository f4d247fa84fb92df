"""Encodes and decodes ROS 2 motion and diagnostic messages; tested against the bytes of rosbags.

Stamps are nanoseconds since 1970; quaternions x, y, z, w.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tracker.base.clock import NS
from tracker.messages import Array
from tracker.session.ros.cdr import CdrReader, CdrWriter

# ---- messages that differ from an earlier one only in their times and numbers
#
# A recording contains the names of all segments and joints in each of its messages. What was read
# of one is remembered: of the next message of the same bytes, apart from times and float64
# numbers, only these are read.

MOST = 64  # layouts that are remembered per kind of message


class Values(NamedTuple):
    """``stamps``: ns since 1970; ``numbers``: (n,) float64, writable."""

    stamps: list[int]
    numbers: Array


class FieldLayout:
    """Where a message of these bytes has its times and its numbers, by the offsets of their first
    bytes; ``texts`` are the names in it."""

    def __init__(
        self, data: bytes, times: Sequence[int], numbers: Sequence[int], texts: tuple[str, ...]
    ) -> None:
        self.texts = texts
        self._times = np.add.outer(np.array(times, np.intp), np.arange(8))
        self._numbers = np.add.outer(np.array(numbers, np.intp), np.arange(8)).ravel()
        same = np.ones(len(data), bool)
        same[self._times], same[self._numbers] = False, False
        self._same = np.flatnonzero(same)
        self._known = np.frombuffer(data, np.uint8)[self._same].tobytes()
        order = "<" if data[1] else ">"
        self._time = np.dtype([("s", f"{order}i4"), ("ns", f"{order}u4")])
        self._float = np.dtype(f"{order}f8")

    def values(self, data: bytes) -> Values | None:
        """None if anything else differs: names, the number of values, the byte order."""
        raw = np.frombuffer(data, np.uint8)
        if raw[self._same].tobytes() != self._known:
            return None
        times = raw[self._times].view(self._time).ravel()
        stamps = times["s"].astype(np.int64) * NS + times["ns"]
        numbers = raw[self._numbers].view(self._float).astype(np.float64)
        return Values(stamps.tolist(), numbers)


class Layouts:
    """The layouts of one kind of message, by their length in bytes."""

    def __init__(self) -> None:
        self._known: dict[int, FieldLayout] = {}

    def find(self, data: bytes) -> tuple[Values, tuple[str, ...]] | None:
        """Values and names of a message like one that is known."""
        layout = self._known.get(len(data))
        values = None if layout is None else layout.values(data)
        return None if layout is None or values is None else (values, layout.texts)

    def remember(self, data: bytes, layout: FieldLayout) -> None:
        if len(self._known) >= MOST:
            self._known = {}
        self._known[len(data)] = layout


# ---- encodes and decodes ROS 2 motion and diagnostic messages; tested against the bytes of
# rosbags
#
# Stamps are nanoseconds since 1970; quaternions x, y, z, w.

TF = "tf2_msgs/msg/TFMessage"
POSES = "geometry_msgs/msg/PoseArray"
JOINTS = "sensor_msgs/msg/JointState"
DIAGNOSTICS = "diagnostic_msgs/msg/DiagnosticArray"
STRING = "std_msgs/msg/String"
NUMBERS = "std_msgs/msg/Float64MultiArray"
POSE_COVARIANCE = "geometry_msgs/msg/PoseWithCovarianceStamped"
_NO_ROTATION = np.array([0.0, 0.0, 0.0, 1.0])
_TRANSFORMS, _JOINTS = Layouts(), Layouts()


class Transform(NamedTuple):
    """Pose of ``child`` in ``frame``: translation (3,) m, rotation (4,) xyzw."""

    stamp: int
    frame: str
    child: str
    translation: Array
    rotation: Array


class PoseArray(NamedTuple):
    stamp: int
    frame: str
    position: Array  # (n, 3) m
    orientation: Array  # (n, 4)


class PoseWithCovariance(NamedTuple):
    """position (3,) m, orientation (4,) xyzw, covariance (6, 6) of the errors about the axes of
    ``frame``; its first rotational variance is -1 where no orientation is known."""

    stamp: int
    frame: str
    position: Array
    orientation: Array
    covariance: Array


class JointState(NamedTuple):
    stamp: int
    names: Sequence[str]
    position: Array  # (n,) rad


class Diagnostic(NamedTuple):
    """``level``: 0 OK, 1 warning, 2 error, 3 stale."""

    level: int
    name: str
    message: str
    values: dict[str, str]


def pack_transforms(transforms: Sequence[Transform]) -> bytes:
    out = CdrWriter()
    out.u32(len(transforms))
    for t in transforms:
        out.header(t.stamp, t.frame)
        out.text(t.child)
        out.doubles(t.translation)
        out.doubles(t.rotation)
    return out.done()


def unpack_transforms(data: bytes) -> list[Transform]:
    known = _TRANSFORMS.find(data)
    if known is None:
        return _unpack_new_transforms(data)
    (stamps, numbers), texts = known
    rows = numbers.reshape(-1, 7)
    columns = stamps, texts[::2], texts[1::2], rows[:, :3], rows[:, 3:]
    return [Transform(*values) for values in zip(*columns, strict=True)]


def _unpack_new_transforms(data: bytes) -> list[Transform]:
    source = CdrReader(data)
    out: list[Transform] = []
    times: list[int] = []
    numbers: list[int] = []
    for _ in range(source.count(56)):
        stamp = source.time()
        times.append(source.at - 8)
        frame, child = source.text(), source.text()
        values = source.doubles(7)
        numbers += range(source.at - 56, source.at, 8)
        out.append(Transform(stamp, frame, child, values[:3], values[3:]))
    texts = tuple(text for t in out for text in (t.frame, t.child))
    _TRANSFORMS.remember(data, FieldLayout(data, times, numbers, texts))
    return out


def pack_poses(m: PoseArray) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, m.frame)
    out.u32(len(m.position))
    out.doubles(np.hstack([m.position, m.orientation]).ravel())
    return out.done()


def unpack_poses(data: bytes) -> PoseArray:
    source = CdrReader(data)
    stamp, frame = source.header()
    values = source.doubles(7 * source.count(56)).reshape(-1, 7)
    return PoseArray(stamp, frame, values[:, :3].copy(), values[:, 3:].copy())


def pack_pose_with_covariance(m: PoseWithCovariance) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, m.frame)
    known = np.isfinite(m.orientation).all()
    out.doubles(np.concatenate([m.position, m.orientation if known else _NO_ROTATION]))
    out.doubles(m.covariance.ravel())
    return out.done()


def unpack_pose_with_covariance(data: bytes) -> PoseWithCovariance:
    source = CdrReader(data)
    stamp, frame = source.header()
    values = source.doubles(43)
    return PoseWithCovariance(stamp, frame, values[:3], values[3:7], values[7:].reshape(6, 6))


def pack_joints(m: JointState) -> bytes:
    out = CdrWriter()
    out.header(m.stamp, "")
    out.text_list(m.names)
    out.double_list(m.position)
    out.double_list(())  # velocity
    out.double_list(())  # effort
    return out.done()


def unpack_joints(data: bytes) -> JointState:
    known = _JOINTS.find(data)
    if known is not None:
        ([stamp], numbers), names = known
        return JointState(stamp, names, numbers)
    source = CdrReader(data)
    stamp = source.time()
    time = source.at - 8
    source.text()
    names, position = tuple(source.text_list()), source.double_list()
    numbers_at = range(source.at - 8 * len(position), source.at, 8)
    _JOINTS.remember(data, FieldLayout(data, [time], numbers_at, names))
    return JointState(stamp, names, position)


def pack_diagnostics(stamp: int, statuses: Sequence[Diagnostic]) -> bytes:
    out = CdrWriter()
    out.header(stamp, "")
    out.u32(len(statuses))
    for s in statuses:
        out.u8(s.level)
        out.text(s.name)
        out.text(s.message)
        out.text("")  # hardware id
        out.u32(len(s.values))
        for key, value in s.values.items():
            out.text(key)
            out.text(value)
    return out.done()


def unpack_diagnostics(data: bytes) -> tuple[int, list[Diagnostic]]:
    source = CdrReader(data)
    stamp, _ = source.header()
    out = []
    for _ in range(source.count(20)):
        level, name, message = source.u8(), source.text(), source.text()
        source.text()
        values = {source.text(): source.text() for _ in range(source.count(10))}
        out.append(Diagnostic(level, name, message, values))
    return stamp, out


def pack_string(text: str) -> bytes:
    out = CdrWriter()
    out.text(text)
    return out.done()


def unpack_string(data: bytes) -> str:
    return CdrReader(data).text()


def pack_numbers(values: Array) -> bytes:
    """One row of numbers, without dimensions."""
    out = CdrWriter()
    out.no_layout()
    out.double_list(values)
    return out.done()


def unpack_numbers(data: bytes) -> Array:
    source = CdrReader(data)
    source.skip_layout()
    return source.double_list()
