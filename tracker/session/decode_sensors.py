"""Sensor messages assembled from their topics: packets of IMUs, pairs of images and of blobs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Generic, TypeVar

import numpy as np

from tracker.base.clock import NS, seconds
from tracker.base.damage import LeftOut
from tracker.messages import (
    EYES,
    Array,
    BlobFrame,
    Blobs,
    CameraImuSample,
    CameraPose,
    Cloth,
    ImuSample,
    WristPose,
)
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame, check_image
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.rigs import exact_pose, is_camera, pose_of
from tracker.session.ros import motion, sensors, topics
from tracker.session.ros.cdr import CdrError, CdrReader

T = TypeVar("T")


@dataclass
class Group(Generic[T]):
    """Parts by name. ``stamp`` is that of the first part, ``log_time`` the latest of all (ns)."""

    stamp: int
    log_time: int
    sequence: int
    parts: dict[str, T] = field(default_factory=dict)


class Grouper(Generic[T]):
    """Collects parts whose stamps agree within ``tolerance`` ns.

    A group is released when it is complete, when `close` is called, or when log time has advanced
    by more than ``delay`` ns; groups are released in the order of their stamps, at log times
    that never decrease.
    """

    def __init__(self, names: frozenset[str], tolerance: int, delay: int) -> None:
        self._names, self._tolerance, self._delay = names, tolerance, delay
        self._open: list[Group[T]] = []
        self._released_until = -1

    def add(self, name: str, stamp: int, log_time: int, sequence: int, part: T) -> None:
        """Take a part. One that is older than the last released group is dropped."""
        if stamp <= self._released_until:
            return
        group = self._find(name, stamp)
        if group is None:
            group = Group(stamp, log_time, sequence)
            self._open.append(group)
            self._open.sort(key=lambda g: g.stamp)
        group.parts[name] = part
        group.log_time = max(group.log_time, log_time)

    def _find(self, name: str, stamp: int) -> Group[T] | None:
        near = [
            g for g in self._open if abs(g.stamp - stamp) <= self._tolerance and name not in g.parts
        ]
        return min(near, key=lambda g: abs(g.stamp - stamp), default=None)

    def close(self, stamp: int, log_time: int, sequence: int) -> Group[T]:
        """Removes and returns the group at exactly ``stamp``; an empty one if there is none."""
        for group in self._open:
            if group.stamp == stamp:
                self._open.remove(group)
                return group
        return Group(stamp, log_time, sequence)

    def ready(self, now: int | None) -> list[Group[T]]:
        """Groups that are released at log time ``now``; all of them if it is None."""
        out: list[Group[T]] = []
        while self._open and (now is None or self._done(self._open[0], now)):
            group = self._open.pop(0)
            self._released_until = max(self._released_until, group.stamp)
            out.append(group)
        return out

    def _done(self, group: Group[T], now: int) -> bool:
        return group.parts.keys() >= self._names or now - group.log_time > self._delay


_KEPT = 64
_FOREIGN_DELAY = NS // 10  # images in a foreign file may be this late against their IMUs


@dataclass(frozen=True)
class Timing:
    """Largest time differences (ns) of parts of one instant; zero for Glovetrack's own files."""

    imu_tolerance: int = 0
    frame_tolerance: int = 0
    delay: int = 0


def foreign_timing(source: McapInput, info: SessionInfo) -> Timing:
    """The tolerances for another program's file: half of each period. Raises FileError on
    damage."""
    imus = [topics.imu(info.side, n) for n in info.glove.imu_names]
    frames = [f(c) for c in EYES for f in (topics.image, topics.blobs)]
    return Timing(
        _half_period(source, imus, NS // 100),
        _half_period(source, frames, NS // 30),
        _FOREIGN_DELAY,
    )


def _half_period(source: McapInput, candidates: list[str], default: int) -> int:
    """Half the median step (ns) of the first stamps of the first topic that the file has."""
    there = {c.topic for c in source.contents.channels.values()}
    topic = next((t for t in candidates if t in there), None)
    if topic is None:
        return default // 2
    stamps: list[int] = []
    for raw in ordered(source, frozenset([topic])):
        with source.left_out.reading(topic, raw.log_time):
            stamps.append(CdrReader(raw.data).time())
        if len(stamps) == 50:
            break
    steps = np.diff(np.sort(stamps))
    return int(np.median(steps)) // 2 if len(steps) else default // 2


Sensed = ImuSample | CameraImuSample | WristPose | BlobFrame | PackedFrame


class SensorDecoder:
    """Takes raw messages in order; `release` returns complete ones."""

    def __init__(
        self, info: SessionInfo, packets: bool, timing: Timing, left_out: LeftOut | None = None
    ) -> None:
        """``packets``: the file marks the end of each glove packet. ``left_out`` counts images that
        turn out to be damaged when they are unpacked."""
        self._info, self._packets, self._left_out = info, packets, left_out
        self._t = info.anchor.monotonic
        self._imus = Grouper[sensors.ImuMessage](
            frozenset(info.glove.imu_names), timing.imu_tolerance, timing.delay
        )
        both = frozenset(EYES)
        self._images = Grouper[sensors.ImageMessage](both, timing.frame_tolerance, timing.delay)
        self._blobs = Grouper[sensors.Detections](both, timing.frame_tolerance, timing.delay)
        self._celsius: Array | None = None  # from the next packet on
        self._poses: dict[int, CameraPose] = {}
        self._cloth: dict[tuple[str, int], Cloth] = {}  # of the next blobs, by their stamp
        self._pose_tolerance = timing.frame_tolerance

    def handlers(self) -> dict[str, Callable[[RawMessage], list[Sensed]]]:
        """The function for messages of each topic; it returns messages that are complete."""
        side = self._info.side
        table: dict[str, Callable[[RawMessage], list[Sensed]]] = {
            topics.packets(side): self._packet,
            topics.temperatures(side): self._temperatures,
            topics.CAMERA_IMU: self._camera_imu,
            topics.wrist_exact(side): self._wrist,
            topics.CAMERA_POSE: self._exact_pose,
        }
        table |= {topics.imu(side, name): self._imu for name in self._info.glove.imu_names}
        table |= {topics.image(camera): self._image for camera in EYES}
        table |= {topics.cloth(camera): self._keep_cloth for camera in EYES}
        table |= {topics.blobs(camera): self._detections for camera in EYES}
        return table

    def set_camera(self, transforms: list[motion.Transform]) -> None:
        """Store the camera's pose, unless the exact one is known."""
        for t in transforms:
            if is_camera(t) and t.stamp not in self._poses:
                self._keep_pose(t.stamp, pose_of(t))

    def release(self, now: int | None) -> list[Sensed]:
        """Returns messages that need not wait at log time ``now`` (ns); all of them if it is None.

        At -1 no time has passed: only complete ones.
        """
        out: list[Sensed] = []
        if not self._packets:
            out += [self._sample(g) for g in self._imus.ready(now)]
        out += [self._frame(g) for g in self._images.ready(now)]
        out += [self._blob_frame(g) for g in self._blobs.ready(now)]
        return out

    def _imu(self, raw: RawMessage) -> list[Sensed]:
        name = raw.topic.rsplit("/", 1)[1]
        part = sensors.unpack_imu(raw.data)
        self._imus.add(name, part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _camera_imu(self, raw: RawMessage) -> list[Sensed]:
        part = sensors.unpack_imu(raw.data)
        t, arrival = self._t(part.stamp), self._t(raw.log_time)
        return [CameraImuSample(t, arrival, part.gyro.copy(), part.accel.copy())]

    def _wrist(self, raw: RawMessage) -> list[Sensed]:
        values = motion.unpack_numbers(raw.data)
        if len(values) != 16:
            raise CdrError("the pose of a tracker has 16 numbers")
        p_GT, q_GT, p_BT, q_BT, variances = np.split(values.copy(), [3, 7, 10, 14])
        t, arrival, side = self._t(raw.publish_time), self._t(raw.log_time), self._info.side
        variance = float(variances[0]), float(variances[1])
        return [WristPose(t, arrival, side, p_GT, q_GT, p_BT, q_BT, *variance)]

    def _temperatures(self, raw: RawMessage) -> list[Sensed]:
        values = motion.unpack_numbers(raw.data)
        if len(values) != len(self._info.glove.imus):
            raise CdrError("temperatures are not those of the glove's IMUs")
        self._celsius = values.copy()
        return []

    def _packet(self, raw: RawMessage) -> list[Sensed]:
        times = sensors.unpack_time_reference(raw.data)
        group = self._imus.close(times.stamp, raw.log_time, raw.sequence)
        group.sequence = raw.sequence
        device = seconds(times.reference) if times.source else np.nan
        return [self._sample(group, device)]

    def _sample(self, group: Group[sensors.ImuMessage], device: float = np.nan) -> ImuSample:
        names = self._info.glove.imu_names
        accel = np.full((len(names), 3), np.nan)
        gyro = np.full((len(names), 3), np.nan)
        valid = np.zeros(len(names), bool)
        for i, name in enumerate(names):
            part = group.parts.get(name)
            if part is not None:
                accel[i], gyro[i] = part.accel, part.gyro
                valid[i] = bool(np.isfinite(accel[i]).all() and np.isfinite(gyro[i]).all())
        t, arrival = self._t(group.stamp), self._t(group.log_time)
        celsius, self._celsius = self._celsius, None
        return ImuSample(t, arrival, device, group.sequence - 1, accel, gyro, valid, celsius)

    def _image(self, raw: RawMessage) -> list[Sensed]:
        part = sensors.unpack_image(raw.data)
        check_image(part.data, part.frame)
        self._images.add(_camera(raw.topic), part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _detections(self, raw: RawMessage) -> list[Sensed]:
        part = sensors.unpack_detections(raw.data)
        self._blobs.add(_camera(raw.topic), part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _keep_cloth(self, raw: RawMessage) -> list[Sensed]:
        self._cloth[_camera(raw.topic), raw.publish_time] = sensors.unpack_cloth(raw.data)
        while len(self._cloth) > _KEPT:
            del self._cloth[next(iter(self._cloth))]
        return []

    def _frame(self, group: Group[sensors.ImageMessage]) -> PackedFrame:
        return PackedFrame(
            self._t(group.stamp),
            self._t(group.log_time),
            group.parts,
            self._pose(group.stamp),
            group.sequence - 1,
            self._left_out,
        )

    def _blob_frame(self, group: Group[sensors.Detections]) -> BlobFrame:
        found = [n for p in group.parts.values() for n in p.names]
        names = tuple(dict.fromkeys([*self._info.hue_names, *found]))
        sides = {
            c: replace(_with_hues(p, names), cloth=self._cloth.pop((c, p.stamp), None))
            for c, p in group.parts.items()
        }
        return BlobFrame(
            self._t(group.stamp),
            self._t(group.log_time),
            names,
            sides.get("left"),
            sides.get("right"),
            self._pose(group.stamp),
            index=group.sequence - 1,
        )

    def _pose(self, stamp: int) -> CameraPose | None:
        """Pose of a moving camera at an exposure; the nearest one in a foreign file."""
        if not self._info.moving_camera or not self._poses:
            return None
        nearest = min(self._poses, key=lambda s: abs(s - stamp))
        if nearest != stamp and not self._pose_tolerance:
            return None
        return self._poses[nearest]

    def _exact_pose(self, raw: RawMessage) -> list[Sensed]:
        self._keep_pose(raw.publish_time, exact_pose(raw.data))
        return []

    def _keep_pose(self, stamp: int, pose: CameraPose) -> None:
        self._poses[stamp] = pose
        while len(self._poses) > _KEPT:
            del self._poses[next(iter(self._poses))]


def _camera(topic: str) -> str:
    return topic.split("/")[2]


def _with_hues(found: sensors.Detections, names: tuple[str, ...]) -> Blobs:
    """Blobs whose hues index ``names``."""
    b = found.blobs
    index = np.array([names.index(n) for n in found.names], np.int64)
    return Blobs(b.uv, b.size, index[b.hue] if len(b) else b.hue, b.score)
