"""The movement of an alignment, from a recorded session."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from extensions.room.alignment import Moved
from tracker.base.errors import FileError
from tracker.base.notices import failure
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraImuSample, CameraPose, ImuSample, WristPose
from tracker.online.camera_tilt import CameraTilt
from tracker.session.reader import SessionReader


def recorded_movement(
    path: Path, side: str = "", start: float = 0.0, end: float = np.inf
) -> tuple[str, Moved]:
    """The side of the hand, and what glove and tracker sensed from ``start`` to ``end`` (s since
    the recording's start).

    Raises FileError for a session without poses that have rotations.
    """
    with SessionReader(path, side=side) as reader:
        info = reader.info
        if side and info.side != side:
            raise FileError(failure("room.no_poses", file=path.name, side=side))
        begin = reader.anchor.monotonic(reader.span_ns[0])
        messages = list(reader.messages((ImuSample, WristPose)))
    inside = [m for m in messages if start <= m.t - begin <= end]
    poses = sorted((m for m in inside if isinstance(m, WristPose)), key=lambda m: m.t)
    poses = [p for k, p in enumerate(poses) if k == 0 or p.t > poses[k - 1].t]
    if not poses:
        raise FileError(failure("room.no_poses", file=path.name, side=info.side))
    turned = [p for p in poses if np.isfinite(p.q_GT).all()]
    if not turned:
        raise FileError(failure("room.no_rotations", file=path.name, side=info.side))
    inside_B = [m for m in inside if isinstance(m, ImuSample)]
    track = PoseTrack(
        np.array([p.t for p in turned]),
        np.array([p.p_GT for p in turned]),
        np.array([p.q_GT for p in turned]),
    )
    return info.side, moved_by(inside_B, track, info.hand, info.glove)


class PoseTrack(NamedTuple):
    """Poses of a tracker: t (M,) s, which increase, p_WT (M, 3) m and q_WT (M, 4) xyzw."""

    t: Array
    p_WT: Array
    q_WT: Array


def moved_by(
    samples: Sequence[ImuSample], track: PoseTrack, hand: HandModel, glove: GloveModel
) -> Moved:
    """The movement that a glove's packets and a tracker's poses measured.

    Raises FileError for a glove without an IMU on the root segment.
    """
    t_B, R_GB, speed = root_movement(samples, hand, glove)
    return Moved(
        t_B=t_B,
        R_GB=R_GB,
        speed=speed,
        t_T=track.t,
        R_WT=so3.matrix_from_quat(track.q_WT),
        p_WT=track.p_WT,
        w_B=hand.keypoint_offset[0].copy(),  # of the wrist, the hand's first keypoint
    )


def root_movement(
    samples: Sequence[ImuSample], hand: HandModel, glove: GloveModel
) -> tuple[Array, Array, Array]:
    """t (N,) s, R_GB (N, 3, 3) and angular speed (N,) rad/s of the root segment, by its IMU alone
    mounted as in the glove file: the filter's own mounting would drift meanwhile.

    Raises FileError for a glove without an IMU there.
    """
    on, root = [imu.segment for imu in glove.imus], hand.segments[0].name
    if root not in on:
        raise FileError(failure("room.no_root_imu", segment=root))
    j = on.index(root)
    R_BI, tilt = glove.imus[j].R_BI, CameraTilt(CameraPose(np.eye(3), np.zeros(3)))
    t: list[float] = []
    R: list[Array] = []
    speed: list[float] = []
    for m in samples:
        if not m.valid[j] or (t and m.t <= t[-1]):
            continue
        tilt.feed(CameraImuSample(m.t, m.t_arrival, R_BI @ m.gyro[j], R_BI @ m.accel[j]))
        pose = tilt.pose(m.t)
        if pose is not None:
            t.append(m.t)
            R.append(pose.R_GC)
            speed.append(float(np.linalg.norm(m.gyro[j])))
    return np.array(t), np.array(R).reshape(-1, 3, 3), np.array(speed)
