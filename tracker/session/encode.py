"""Encodes messages of the engine as topics of a session."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np

from tracker.base.clock import nanoseconds
from tracker.base.notices import to_json
from tracker.geometry import so3
from tracker.glove.model import ImuNoise
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    CameraImuSample,
    CameraPose,
    EngineState,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Message,
    RobotMemory,
    RobotModel,
    RobotState,
    Status,
    StereoFrame,
    Tracking,
    Validity,
    WristPose,
)
from tracker.session.description import MAIN, SessionInfo
from tracker.session.encode_robot import RobotEncoder
from tracker.session.images import PackedFrame, encode_image
from tracker.session.ros import motion, sensors, topics
from tracker.vision.rig import StereoRig


class Out(NamedTuple):
    """One message for the file. Times in ns since 1970."""

    topic: str
    type: str
    log_time: int
    stamp: int
    data: bytes
    sequence: int = 0


@dataclass(frozen=True)
class ImageCoding:
    """``kind``: jpeg, png (lossless) or none (only blobs); ``quality``: 1 to 100, of a JPEG."""

    kind: str = "jpeg"
    quality: int = 90


class Arrivals:
    """The latest arrival (ns since 1970) of a message fed to the engine.

    An estimate is logged at the arrival of the message that caused it, not at its own instant:
    images may arrive long after their exposure. So the messages of a file are in the order of the
    run that wrote it.
    """

    def __init__(self) -> None:
        self.last = 0

    def add(self, log_time: int) -> None:
        self.last = max(self.last, log_time)


def status_name(info: SessionInfo, side: str) -> str:
    """Returns the name of a Status; that of the second hand in a session of both has its side."""
    return f"tracker_{side}" if info.others and side != MAIN else "tracker"


class Encoder:
    """Encodes messages; stores the last value of those whose changes only are written."""

    def __init__(
        self,
        info: SessionInfo,
        images: ImageCoding,
        status: str = "tracker",
        arrivals: Arrivals | None = None,
    ) -> None:
        """``status``: the name under which a Status is written, see `status_name`; ``arrivals``:
        those of all hands of the session."""
        self._coding, self._tracker = images, status
        self._arrivals = arrivals or Arrivals()
        self._info, self._side, self._wall = info, info.side, info.anchor.wall
        self._imu_variances = [imu_variances(imu.noise) for imu in info.glove.imus]
        self._segments = [f"{info.side}_{s}" for s in info.hand.segment_names]
        self._robots = RobotEncoder(self._wall)
        self._states: object = None
        self._pose_stamp = -1

    def encoded(self, message: Message) -> Iterator[Out]:
        """Encodes any message. A FrameResult follows from the others and an EngineState is an
        attachment, so neither is encoded."""
        match message:
            case ImuSample():
                return self.imu(message)
            case CameraImuSample():
                return self.camera_imu(message)
            case WristPose():
                return self.wrist(message)
            case StereoFrame():
                return self.images(message)
            case BlobFrame():
                return self.blobs(message)
            case Estimate():
                return self.estimate(message)
            case Calibration():
                return self.calibration(message)
            case Status():
                return self.status(message)
            case Event():
                return iter((event_message(message, self._wall(message.t)),))
            case RobotModel() | RobotState() | RobotMemory():
                return self.robot(message)
            case FrameResult() | EngineState():
                return iter(())

    def imu(self, m: ImuSample) -> Iterator[Out]:
        """One message for each IMU that responded, then the packet's times on both clocks."""
        stamp, log = self._wall(m.t), self._wall(m.t_arrival)
        self._arrivals.add(log)
        sequence = (m.seq + 1) % 2**32
        if m.temperature is not None:
            data = motion.pack_numbers(m.temperature)
            yield Out(topics.temperatures(self._side), motion.NUMBERS, log, stamp, data)
        for i, name in enumerate(self._info.glove.imu_names):
            if m.valid[i]:
                measured = m.gyro[i], m.accel[i], *self._imu_variances[i]
                data = sensors.pack_imu(sensors.ImuMessage(stamp, name, *measured))
                yield Out(topics.imu(self._side, name), sensors.IMU, log, stamp, data, sequence)
        known = math.isfinite(m.t_device)
        reference = nanoseconds(m.t_device) if known else 0
        data = sensors.pack_time_reference(
            sensors.TimeReference(stamp, reference, "glove" if known else "")
        )
        yield Out(topics.packets(self._side), sensors.TIME_REFERENCE, log, stamp, data, sequence)

    def camera_imu(self, m: CameraImuSample) -> Iterator[Out]:
        """A sample of the camera's own IMU, in its frame."""
        stamp, frame = self._wall(m.t), topics.camera_frame("left")
        data = sensors.pack_imu(sensors.ImuMessage(stamp, frame, m.gyro, m.accel))
        yield Out(topics.CAMERA_IMU, sensors.IMU, self._wall(m.t_arrival), stamp, data)

    def wrist(self, m: WristPose) -> Iterator[Out]:
        """The pose of a tracker on the hand: as ROS pose for other programs, and exact."""
        stamp, log = self._wall(m.t), self._wall(m.t_arrival)
        covariance = np.diag(np.repeat([m.position_variance, m.rotation_variance], 3))
        if not np.isfinite(m.q_GT).all():
            covariance[3, 3] = -1.0
        pose = motion.PoseWithCovariance(stamp, topics.WORLD, m.p_GT, m.q_GT, covariance)
        data = motion.pack_pose_with_covariance(pose)
        yield Out(topics.wrist_pose(m.side), motion.POSE_COVARIANCE, log, stamp, data)
        exact = motion.pack_numbers(wrist_numbers(m))
        yield Out(topics.wrist_exact(m.side), motion.NUMBERS, log, stamp, exact)

    def camera_pose(
        self, t: float, t_arrival: float, pose: CameraPose | None, exact: bool = True
    ) -> Iterator[Out]:
        """Pose of a moving camera, once per exposure; ``exact``: also without rounding."""
        stamp = self._wall(t)
        if pose is not None and stamp != self._pose_stamp:
            self._pose_stamp = stamp
            messages = pose_messages(topics.TF, pose, self._wall(t_arrival), stamp)
            yield from (m for m in messages if exact or m.topic == topics.TF)

    def robot(self, m: RobotModel | RobotState | RobotMemory) -> Iterator[Out]:
        """The state of a robot that follows the hand; its log time is when its command was sent."""
        stamp = log = self._wall(m.t)
        if isinstance(m, RobotState) and math.isfinite(m.t_sent):
            log = self._wall(m.t_sent)
        for topic, kind, data in self._robots.parts(m):
            yield Out(topic, kind, log, stamp, data)

    def images(self, m: StereoFrame) -> Iterator[Out]:
        """Both images, compressed, after the pose of a camera that moves."""
        yield from self.camera_pose(m.t, m.t_arrival, m.pose)
        kind, quality = self._coding.kind, self._coding.quality
        if kind == "none":
            return
        for camera, image in (("left", m.left), ("right", m.right)):
            if image is not None:
                yield self._image(camera, m, kind, encode_image(image, kind, quality))

    def packed_images(self, m: PackedFrame) -> Iterator[Out]:
        """Images of another session, byte for byte."""
        yield from self.camera_pose(m.t, m.t_arrival, m.pose)
        for camera, part in m.parts.items():
            yield self._image(camera, m, part.format, part.data)

    def _image(self, camera: str, m: StereoFrame | PackedFrame, kind: str, image: bytes) -> Out:
        stamp, log = self._wall(m.t), self._wall(m.t_arrival)
        frame = topics.camera_frame(camera)
        data = sensors.pack_image(sensors.ImageMessage(stamp, frame, kind, image))
        return Out(topics.image(camera), sensors.IMAGE, log, stamp, data, (m.index + 1) % 2**32)

    def blobs(self, m: BlobFrame) -> Iterator[Out]:
        stamp, log = self._wall(m.t), self._wall(m.t_arrival)
        self._arrivals.add(log)
        yield from self.camera_pose(m.t, m.t_arrival, m.pose)
        for camera, found in (("left", m.left), ("right", m.right)):
            if found is None:
                continue
            frame = topics.camera_frame(camera)
            data = sensors.pack_detections(sensors.Detections(stamp, frame, found, m.hue_names))
            sequence = (m.index + 1) % 2**32
            if found.cloth is not None:
                cloth = sensors.pack_cloth(found.cloth)
                yield Out(topics.cloth(camera), sensors.CLOTH, log, stamp, cloth)
            yield Out(topics.blobs(camera), sensors.DETECTIONS, log, stamp, data, sequence)

    def estimate(self, m: Estimate) -> Iterator[Out]:
        """States if they changed, angles, segments, sd, and last the keypoints."""
        stamp = self._wall(m.t)
        log = max(stamp, self._arrivals.last)
        yield from self._state_changes(m, stamp, log)
        yield self._joints(topics.hand(self._side, "joint_states"), m, stamp, log)
        yield self._segment_poses(m, stamp, log)
        sd = motion.pack_numbers(m.keypoint_sd)
        yield Out(topics.hand(self._side, "keypoint_sd"), motion.NUMBERS, log, stamp, sd)
        yield self._keypoints(topics.hand(self._side, "keypoints"), m, stamp, log)

    def truth(self, m: Estimate) -> Iterator[Out]:
        """The true pose of a simulated hand."""
        stamp = self._wall(m.t)
        yield self._joints(topics.truth(self._side, "joint_states"), m, stamp, stamp)
        yield self._keypoints(topics.truth(self._side, "keypoints"), m, stamp, stamp)

    def _joints(self, topic: str, m: Estimate, stamp: int, log: int) -> Out:
        names = self._info.hand.joint_names
        known = np.flatnonzero(np.isfinite(m.angles) & (m.angle_state != Validity.LOST))
        data = motion.pack_joints(
            motion.JointState(stamp, [names[i] for i in known], m.angles[known])
        )
        return Out(topic, motion.JOINTS, log, stamp, data)

    def _keypoints(self, topic: str, m: Estimate, stamp: int, log: int) -> Out:
        lost = (m.keypoint_state == Validity.LOST)[:, None]
        position = np.where(lost, np.nan, m.keypoints)
        orientation = np.where(lost, np.nan, m.keypoint_q)
        data = motion.pack_poses(motion.PoseArray(stamp, topics.WORLD, position, orientation))
        return Out(topic, motion.POSES, log, stamp, data)

    def _segment_poses(self, m: Estimate, stamp: int, log: int) -> Out:
        known = np.flatnonzero(np.isfinite(m.segment_p).all(axis=1)).tolist()
        q = so3.quat_from_matrix(m.segment_R[known]) if known else np.zeros((0, 4))
        data = motion.pack_transforms(
            [
                motion.Transform(stamp, topics.WORLD, self._segments[i], m.segment_p[i], q[k])
                for k, i in enumerate(known)
            ]
        )
        return Out(topics.TF, motion.TF, log, stamp, data)

    def _state_changes(self, m: Estimate, stamp: int, log: int) -> Iterator[Out]:
        now = (m.tracking, m.keypoint_state.tobytes(), m.angle_state.tobytes())
        if now == self._states:
            return
        self._states = now
        groups = (
            ("keypoints", self._info.keypoint_names, m.keypoint_state),
            ("joints", self._info.hand.joint_names, m.angle_state),
        )
        tracking = Tracking(m.tracking).name.lower()
        level = 0 if m.tracking == Tracking.TRACKING else 1
        out = [motion.Diagnostic(level, "tracking", tracking, {})]
        for name, rows, states in groups:
            names = {r: Validity(s).name.lower() for r, s in zip(rows, states, strict=True)}
            out.append(motion.Diagnostic(int("lost" in names.values()), name, "", names))
        data = motion.pack_diagnostics(stamp, out)
        yield Out(topics.hand(self._side, "states"), motion.DIAGNOSTICS, log, stamp, data)

    def calibration(self, m: Calibration) -> Iterator[Out]:
        stamp = self._wall(m.t)
        out = [
            motion.Diagnostic(
                0,
                "hand",
                "",
                {"length": repr(m.hand_length), "length_sd": repr(m.hand_length_sd)},
            )
        ]
        for i, segment in enumerate(m.segments):
            values = {
                f"{name}_{axis}": repr(float(getattr(m, name)[i, k]))
                for name in CALIBRATION_ROWS
                for k, axis in enumerate("xyz")
            }
            out.append(motion.Diagnostic(0, segment, "", values))
        data = motion.pack_diagnostics(stamp, out)
        topic = topics.hand(self._side, "calibration")
        yield Out(topic, motion.DIAGNOSTICS, max(stamp, self._arrivals.last), stamp, data)

    def status(self, m: Status) -> Iterator[Out]:
        stamp = self._wall(m.t)
        values = {name: repr(float(value)) for name, value in m.values.items()}
        tracking = Tracking(m.tracking).name.lower()
        data = motion.pack_diagnostics(
            stamp, [motion.Diagnostic(0, self._tracker, tracking, values)]
        )
        yield Out(topics.STATUS, motion.DIAGNOSTICS, stamp, stamp, data)

    def rig(self, rig: StereoRig, t: float) -> Iterator[Out]:
        """Writes the calibrations of the cameras; their poses too, unless frames contain them."""
        now = self._wall(t)
        for camera in rig.sides:
            intrinsics = rig.left if camera == "left" else rig.right
            data = sensors.pack_camera_info(now, topics.camera_frame(camera), intrinsics)
            yield Out(topics.camera_info(camera), sensors.CAMERA_INFO, now, now, data)
        right = motion.Transform(
            now,
            topics.camera_frame("left"),
            topics.camera_frame("right"),
            np.array([rig.baseline, 0, 0]),
            np.array([0.0, 0, 0, 1]),
        )
        second = [] if rig.one_camera else [right]
        moving = self._info.moving_camera
        yield from pose_messages(topics.TF_STATIC, None if moving else rig.pose, now, now, second)


NOMINAL = ImuNoise(np.deg2rad(0.01), 300e-6 * 9.80665, 0.0, 0.0)
"""For the MPU-9250 (product specification 1.1), for IMUs whose noise was not measured."""
PACKETS_HZ = 100.0


def imu_variances(noise: ImuNoise | None) -> tuple[float, float]:
    """rad²/s² and m²/s⁴ of each axis: white noise in the half of `PACKETS_HZ`. A message has no
    field for biases, so these are not included."""
    noise = noise or NOMINAL
    return noise.gyro**2 * PACKETS_HZ / 2, noise.accel**2 * PACKETS_HZ / 2


def event_message(m: Event, stamp: int) -> Out:
    """An event as JSON, with the code and values of its notice."""
    record = {"stamp_ns": stamp, "kind": m.kind, "text": m.text, "data": m.data}
    if m.notice is not None:
        record |= to_json(m.notice)
    text = json.dumps(record, ensure_ascii=False, default=str)
    return Out(topics.EVENTS, motion.STRING, stamp, stamp, motion.pack_string(text))


def wrist_numbers(m: WristPose) -> Array:
    """(16,) p_GT, q_GT, p_BT, q_BT and both variances."""
    variances = [m.position_variance, m.rotation_variance]
    return np.concatenate([m.p_GT, m.q_GT, m.p_BT, m.q_BT, variances])


CALIBRATION_ROWS = tuple(
    f.name
    for f in fields(Calibration)
    if f.name not in ("t", "segments", "hand_length", "hand_length_sd")
)


def pose_messages(
    topic: str,
    pose: CameraPose | None,
    log: int,
    stamp: int,
    more: list[motion.Transform] | None = None,
) -> Iterator[Out]:
    """world → camera_left as a transform and, exactly, as numbers."""
    transforms = list(more or [])
    if pose is not None:
        exact = motion.pack_numbers(np.r_[pose.R_GC.ravel(), pose.p_GC])
        yield Out(topics.CAMERA_POSE, motion.NUMBERS, log, stamp, exact)
        q = so3.quat_from_matrix(pose.R_GC)
        transforms.insert(
            0, motion.Transform(stamp, topics.WORLD, topics.camera_frame("left"), pose.p_GC, q)
        )
    yield Out(topic, motion.TF, log, stamp, motion.pack_transforms(transforms))
