"""Topics of a session as messages of the engine; the inverse of `encode`."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import Any

import numpy as np

from tracker.clock import seconds
from tracker.geometry import so3
from tracker.messages import (
    BlobFrame,
    Blobs,
    Calibration,
    CameraImuSample,
    CameraPose,
    Estimate,
    Event,
    ImuSample,
    Message,
    Status,
    StereoFrame,
)
from tracker.session.decode_estimate import EstimateDecoder, tracking_of
from tracker.session.description import SessionInfo
from tracker.session.encode import CALIBRATION_ROWS
from tracker.session.grouping import Group, Grouper
from tracker.session.images import PackedFrame
from tracker.session.mcap.input import RawMessage
from tracker.session.ros import motion, sensors, topics
from tracker.session.ros.cdr import in_words

MESSAGE_KINDS: tuple[type, ...] = (
    ImuSample,
    CameraImuSample,
    StereoFrame,
    BlobFrame,
    Estimate,
    Calibration,
    Status,
    Event,
)
_POSES_KEPT = 64


@dataclass(frozen=True)
class Timing:
    """How parts of one instant are known to belong together, ns; zero for our own files."""

    imu_tolerance: int = 0
    frame_tolerance: int = 0
    patience: int = 0


Decoded = Message | PackedFrame
"""What a `Decoder` gives: a StereoFrame comes as a PackedFrame."""


class Decoder:
    """Feeds on raw messages in order and gives the engine's messages, images still packed."""

    def __init__(self, info: SessionInfo, packets: bool, timing: Timing) -> None:
        """``packets``: the file tells where each glove packet ends."""
        self._info, self._packets = info, packets
        self._t = info.anchor.monotonic
        self._imus = Grouper[sensors.Imu](
            frozenset(info.glove.imu_names), timing.imu_tolerance, timing.patience
        )
        both = frozenset(topics.SIDES)
        self._images = Grouper[sensors.Image](both, timing.frame_tolerance, timing.patience)
        self._blobs = Grouper[sensors.Detections](both, timing.frame_tolerance, timing.patience)
        self._poses: dict[int, CameraPose] = {}
        self._pose_tolerance = timing.frame_tolerance
        self._estimates = EstimateDecoder(info, "hand")
        self._handlers = self._handler_table()

    def _handler_table(self) -> dict[str, Callable[[RawMessage], list[Decoded]]]:
        side = self._info.side
        table: dict[str, Callable[[RawMessage], list[Decoded]]] = {
            topics.packets(side): self._packet,
            topics.CAMERA_IMU: self._camera_imu,
            topics.TF: self._transforms,
            topics.CAMERA_POSE: self._exact_pose,
            topics.hand(side, "calibration"): self._calibration,
            topics.STATUS: self._status,
            topics.EVENTS: self._event,
        }
        for name in self._info.glove.imu_names:
            table[topics.imu(side, name)] = self._imu
        for camera in topics.SIDES:
            table[topics.image(camera)] = self._image
            table[topics.blobs(camera)] = self._detections
        for topic in self._estimates.topics:
            table[topic] = self._estimate
        return table

    def topics_of(self, kinds: Collection[type]) -> frozenset[str]:
        """Topics that messages of these kinds are made of."""
        side, hand = self._info.side, self._estimates.topics
        imus = [topics.imu(side, n) for n in self._info.glove.imu_names]
        camera = [topics.TF, topics.CAMERA_POSE]
        table: dict[type, list[str]] = {
            ImuSample: [*imus, topics.packets(side)],
            CameraImuSample: [topics.CAMERA_IMU],
            StereoFrame: [*(topics.image(c) for c in topics.SIDES), *camera],
            BlobFrame: [*(topics.blobs(c) for c in topics.SIDES), *camera],
            Estimate: [*hand, topics.TF],
            Calibration: [topics.hand(side, "calibration")],
            Status: [topics.STATUS],
            Event: [topics.EVENTS],
        }
        return frozenset(t for kind in kinds for t in table.get(kind, ()))

    def rank(self, topic: str) -> int:
        """Order of topics at one log time: IMU before what was seen, the camera's own between."""
        if topic.startswith("/glove/"):
            return 0
        return 1 if topic in (topics.TF, topics.CAMERA_POSE, topics.CAMERA_IMU) else 2

    def remember(self, raw: RawMessage) -> None:
        """Take a message from before the first, for what still holds of it."""
        self._handle(raw)

    def feed(self, raw: RawMessage) -> list[Decoded]:
        """What is complete by the time of ``raw``. Raises FileError where it is not readable."""
        out = self._release(raw.log_time)
        out += self._handle(raw)
        return out + self._complete()

    def _handle(self, raw: RawMessage) -> list[Decoded]:
        handler = self._handlers.get(raw.topic)
        if handler is None:
            return []
        with in_words(raw.topic):
            return handler(raw)

    def finish(self) -> list[Decoded]:
        """What was still waiting for company."""
        return self._release(None)

    def _release(self, now: int | None) -> list[Decoded]:
        out: list[Decoded] = []
        if not self._packets:
            out += [self._sample(g) for g in self._imus.ready(now)]
        out += [self._frame(g) for g in self._images.ready(now)]
        out += [self._blob_frame(g) for g in self._blobs.ready(now)]
        return out

    def _complete(self) -> list[Decoded]:
        return self._release(-1)  # no time passes: only groups that are whole

    def _imu(self, raw: RawMessage) -> list[Decoded]:
        name = raw.topic.rsplit("/", 1)[1]
        part = sensors.unpack_imu(raw.data)
        self._imus.add(name, part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _camera_imu(self, raw: RawMessage) -> list[Decoded]:
        part = sensors.unpack_imu(raw.data)
        t, arrival = self._t(part.stamp), self._t(raw.log_time)
        return [CameraImuSample(t, arrival, part.gyro.copy(), part.accel.copy())]

    def _packet(self, raw: RawMessage) -> list[Decoded]:
        times = sensors.unpack_time_reference(raw.data)
        group = self._imus.close(times.stamp, raw.log_time, raw.sequence)
        group.sequence = raw.sequence
        device = seconds(times.reference) if times.source else np.nan
        return [self._sample(group, device)]

    def _sample(self, group: Group[sensors.Imu], device: float = np.nan) -> ImuSample:
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
        return ImuSample(t, arrival, device, group.sequence - 1, accel, gyro, valid)

    def _image(self, raw: RawMessage) -> list[Decoded]:
        part = sensors.unpack_image(raw.data)
        self._images.add(_camera(raw.topic), part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _detections(self, raw: RawMessage) -> list[Decoded]:
        part = sensors.unpack_detections(raw.data)
        self._blobs.add(_camera(raw.topic), part.stamp, raw.log_time, raw.sequence, part)
        return []

    def _frame(self, group: Group[sensors.Image]) -> PackedFrame:
        return PackedFrame(
            self._t(group.stamp),
            self._t(group.log_time),
            group.parts,
            self._pose(group.stamp),
            group.sequence - 1,
        )

    def _blob_frame(self, group: Group[sensors.Detections]) -> BlobFrame:
        found = [n for p in group.parts.values() for n in p.names]
        names = tuple(dict.fromkeys([*self._info.hue_names, *found]))
        sides = {c: _with_hues(p, names) for c, p in group.parts.items()}
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
        """Pose of a moving camera at an exposure; the nearest one in a file of others."""
        if not self._info.moving_camera or not self._poses:
            return None
        nearest = min(self._poses, key=lambda s: abs(s - stamp))
        if nearest != stamp and not self._pose_tolerance:
            return None
        return self._poses[nearest]

    def _exact_pose(self, raw: RawMessage) -> list[Decoded]:
        self._keep_pose(raw.publish_time, exact_pose(raw.data))
        return []

    def _transforms(self, raw: RawMessage) -> list[Decoded]:
        transforms = motion.unpack_transforms(raw.data)
        self._estimates.take_segments(transforms)
        for t in transforms:
            if is_camera(t) and t.stamp not in self._poses:
                self._keep_pose(t.stamp, pose_of(t))
        return []

    def _keep_pose(self, stamp: int, pose: CameraPose) -> None:
        self._poses[stamp] = pose
        while len(self._poses) > _POSES_KEPT:
            del self._poses[next(iter(self._poses))]

    def _estimate(self, raw: RawMessage) -> list[Decoded]:
        estimate = self._estimates.feed(raw)
        return [] if estimate is None else [estimate]

    def _calibration(self, raw: RawMessage) -> list[Decoded]:
        stamp, statuses = motion.unpack_diagnostics(raw.data)
        hand = {s.name: s.values for s in statuses}.get("hand", {})
        rows = [s for s in statuses if s.name != "hand"]
        fields = {
            name: np.array([[_number(s.values, f"{name}_{a}") for a in "xyz"] for s in rows])
            for name in CALIBRATION_ROWS
        }
        segments = tuple(s.name for s in rows)
        length, sd = _number(hand, "length"), _number(hand, "length_sd")
        return [
            Calibration(self._t(stamp), segments, **fields, hand_length=length, hand_length_sd=sd)
        ]

    def _status(self, raw: RawMessage) -> list[Decoded]:
        stamp, statuses = motion.unpack_diagnostics(raw.data)
        return [
            Status(
                self._t(stamp), tracking_of(s.message), {k: float(v) for k, v in s.values.items()}
            )
            for s in statuses
            if s.name == "tracker"
        ]

    def _event(self, raw: RawMessage) -> list[Decoded]:
        text = motion.unpack_string(raw.data)
        try:
            said = json.loads(text)
        except json.JSONDecodeError:
            said = {"text": text}
        if not isinstance(said, dict):
            said = {"text": text}
        return [_event_of(said, self._t(int(said.get("stamp_ns", raw.log_time))))]


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


def _camera(topic: str) -> str:
    return topic.split("/")[2]


def _with_hues(found: sensors.Detections, names: tuple[str, ...]) -> Blobs:
    """Blobs whose hues index ``names``."""
    b = found.blobs
    index = np.array([names.index(n) for n in found.names], np.int64)
    return Blobs(b.uv, b.size, index[b.hue] if len(b) else b.hue, b.score)


def _number(values: dict[str, str], key: str) -> float:
    return float(values.get(key, "nan"))


def _event_of(said: dict[str, Any], t: float) -> Event:
    data = said.get("data")
    return Event(
        t,
        str(said.get("kind", "note")),
        str(said.get("text", "")),
        data if isinstance(data, dict) else {},
    )
