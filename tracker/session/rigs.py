"""The stereo camera of a session: at the start, and at each change."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from tracker.base.clock import nanoseconds, seconds
from tracker.base.damage import LeftOut
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import EYES, CameraPose
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.ros import motion, sensors, topics
from tracker.vision.lenses import one_camera_rig
from tracker.vision.rig import Camera, StereoRig

_INFOS = {topics.camera_info(c): c for c in EYES}
_MOST_RIG_MESSAGES = 500  # messages of a topic
_BEFORE_CONTENT = 12  # bytes of CDR header and stamp, which differ in otherwise equal messages


CAMERA = "camera"
"""Metadata record of a camera with a rolling shutter."""
LINE_TIME, FROM = "line_time_ns", "from_ns"


def shutter_record(rig: StereoRig, since: int | None = None) -> dict[str, str]:
    """The values of the record `CAMERA`: of a calibration valid from the log time ``since`` (ns)
    on, None from the start."""
    values = {LINE_TIME: str(nanoseconds(rig.line_time))}
    return values if since is None else values | {FROM: str(since)}


class LineTimes:
    """The delay of exposure from each row of a session's images to the next."""

    def __init__(self, source: McapInput) -> None:
        """Raises FileError for a record without a plausible number."""
        self._from = [(0, 0.0)]
        for record in source.metadata():
            if record.name == CAMERA and LINE_TIME in record.metadata:
                values = record.metadata
                try:
                    since, line_time = int(values.get(FROM, "0")), int(values[LINE_TIME])
                except ValueError as error:
                    raise FileError(notice("session.line_time", path=source.path)) from error
                self._from.append((since, seconds(line_time)))
        self._from.sort(key=lambda entry: entry[0])

    def at(self, log_time: int) -> float:
        """s per row, for a calibration that is valid from this log time (ns) on; 0 if all rows are
        exposed at once."""
        return [line_time for since, line_time in self._from if since <= log_time][-1]


def is_camera(t: motion.Transform) -> bool:
    """Whether a transform is that of the left camera in the world."""
    return t.frame.lstrip("/") == topics.WORLD and t.child.lstrip("/") == "camera_left"


def pose_of(t: motion.Transform) -> CameraPose:
    return CameraPose(so3.matrix_from_quat(t.rotation), np.array(t.translation))


def exact_pose(data: bytes) -> CameraPose:
    """A pose from the twelve numbers on `topics.CAMERA_POSE`."""
    values = motion.unpack_numbers(data)
    if len(values) != 12:
        raise ValueError("a camera's pose has twelve numbers")
    return CameraPose(values[:9].reshape(3, 3).copy(), values[9:].copy())


@dataclass
class _Start:
    """The first calibration and pose of the camera."""

    cameras: dict[str, Camera] = field(default_factory=dict)
    exact: CameraPose | None = None
    fixed: CameraPose | None = None
    first: CameraPose | None = None

    def take(self, raw: RawMessage, left_out: LeftOut) -> None:
        with left_out.reading(raw.topic, raw.log_time):
            if raw.topic in _INFOS:
                self.cameras.setdefault(_INFOS[raw.topic], sensors.unpack_camera_info(raw.data))
            elif raw.topic == topics.CAMERA_POSE:
                self.exact = self.exact or exact_pose(raw.data)
            else:
                for t in filter(is_camera, motion.unpack_transforms(raw.data)):
                    if raw.topic == topics.TF_STATIC:
                        self.fixed = self.fixed or pose_of(t)
                    self.first = self.first or pose_of(t)


def camera_count(source: McapInput) -> int:
    """Returns the number of cameras of a session: one if it contains nothing of a right camera."""
    there = {channel.topic for channel in source.contents.channels.values()}
    of_right = (topics.camera_info("right"), topics.image("right"), topics.blobs("right"))
    return 2 if there.intersection(of_right) else 1


def _rig_of(cameras: dict[str, Camera], pose: CameraPose, count: int) -> StereoRig:
    """Raises ConfigError if left and right are from different calibrations."""
    if count == 1:
        return one_camera_rig(cameras["left"], pose)
    return StereoRig(cameras["left"], cameras["right"], pose)


def _take_first(source: McapInput, topic: str, start: _Start, pose: str) -> None:
    """Takes messages of a topic until the field ``pose`` of `_Start` is set.

    Each topic is read separately: a recording that began on an overloaded computer describes its
    cameras after thousands of transforms of the hand.
    """
    for n, raw in enumerate(ordered(source, frozenset([topic]))):
        start.take(raw, source.left_out)
        if getattr(start, pose) is not None or n > _MOST_RIG_MESSAGES:
            break


def first_rig(source: McapInput) -> tuple[StereoRig | None, bool]:
    """The rig at the start, None if it is incomplete, and whether its camera moves.

    Raises FileError if left and right are from different calibrations.
    """
    start, count, log_time = _Start(), camera_count(source), 0
    for n, raw in enumerate(ordered(source, frozenset([*_INFOS, topics.TF_STATIC]))):
        before = len(start.cameras), start.fixed is None
        start.take(raw, source.left_out)
        if (len(start.cameras), start.fixed is None) != before:
            log_time = raw.log_time
        if (len(start.cameras) == count and start.fixed is not None) or n > _MOST_RIG_MESSAGES:
            break
    _take_first(source, topics.CAMERA_POSE, start, "exact")
    if start.exact is None and start.fixed is None:
        _take_first(source, topics.TF, start, "first")
    pose, moving = start.exact or start.fixed or start.first, start.fixed is None
    if len(start.cameras) < count or pose is None:
        return None, moving
    try:
        rig = _rig_of(start.cameras, pose, count)
        return replace(rig, line_time=LineTimes(source).at(log_time)), moving
    except ConfigError as error:
        raise FileError(notice("session.rig_invalid", path=source.path, why=error)) from error


@dataclass
class _Current:
    """The latest calibration and pose of a device with ``count`` cameras."""

    count: int = 2
    cameras: dict[str, Camera] = field(default_factory=dict)
    pose: CameraPose | None = None
    exact_at: int = -1  # log time of an exact pose, which a transform does not replace
    latest: dict[str, bytes] = field(default_factory=dict)

    def take(self, raw: RawMessage, left_out: LeftOut) -> bool:
        """Takes a message; returns whether it contains a change. A damaged one does not."""
        content = raw.data[_BEFORE_CONTENT:]
        if self.latest.get(raw.topic) == content:
            return False
        self.latest[raw.topic] = content
        with left_out.reading(raw.topic, raw.log_time):
            return self._update(raw)
        return False

    def _update(self, raw: RawMessage) -> bool:
        if raw.topic in _INFOS:
            self.cameras[_INFOS[raw.topic]] = sensors.unpack_camera_info(raw.data)
        elif raw.topic == topics.CAMERA_POSE:
            self.pose, self.exact_at = exact_pose(raw.data), raw.log_time
        else:
            return self._take_transform(raw)
        return True

    def _take_transform(self, raw: RawMessage) -> bool:
        if self.exact_at == raw.log_time:
            return False
        for t in filter(is_camera, motion.unpack_transforms(raw.data)):
            self.pose = pose_of(t)
            return True
        return False

    def rig(self) -> StereoRig | None:
        """None if a part is missing, or left and right are from different calibrations."""
        if len(self.cameras) < self.count or self.pose is None:
            return None
        try:
            return _rig_of(self.cameras, self.pose, self.count)
        except ConfigError:
            return None


def rig_changes(source: McapInput, moving: CameraPose | None) -> Iterator[tuple[int, StereoRig]]:
    """Yields (log time ns, rig) of each calibration, including the first; it is valid until the
    next.

    ``moving`` is the initial pose of a camera whose poses are sent with the images.
    """
    pose_topics = [] if moving is not None else [topics.TF_STATIC, topics.CAMERA_POSE]
    current, changed = _Current(camera_count(source), pose=moving), -1
    line_times = LineTimes(source)
    for raw in ordered(source, frozenset([*_INFOS, *pose_topics])):
        if 0 <= changed < raw.log_time and (rig := current.rig()) is not None:
            yield changed, replace(rig, line_time=line_times.at(changed))
            changed = -1
        if current.take(raw, source.left_out):
            changed = raw.log_time
    if changed >= 0 and (rig := current.rig()) is not None:
        yield changed, replace(rig, line_time=line_times.at(changed))
