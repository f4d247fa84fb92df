"""The hand as a robot for Foxglove: model (URDF), joint states and frames as in recordings.

Sources: docs.foxglove.dev/docs/sdk/schemas/frame-transforms; sensor_msgs/JointState and
std_msgs/String of ROS 2. Frames have the names of the model's links.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from extensions.foxglove.scene import FRAME, INTEGER, NUMBER, STRING, array_of, object_of, xyz
from tracker.base.clock import ClockAnchor
from tracker.geometry import so3
from tracker.messages import Estimate, Validity
from tracker.session.description import SessionInfo
from tracker.session.export.urdf import robot_description
from tracker.session.ros import motion
from tracker.streaming.payload import DECIMALS
from tracker.streaming.publisher import Names

Json = dict[str, Any]


def joint_states(names: Names, e: Estimate, stamp_ns: int) -> bytes:
    """A sensor_msgs/JointState (CDR) of the angles that are known, in rad."""
    known = np.flatnonzero(np.isfinite(e.angles) & (e.angle_state != Validity.LOST))
    rows = [names.angles[i] for i in known]
    return motion.pack_joints(motion.JointState(stamp_ns, rows, e.angles[known]))


def frame_transforms(names: Names, e: Estimate, stamp_ns: int) -> Json:
    """A foxglove.FrameTransforms of the segments that are known, in ``world``."""
    known = np.flatnonzero(np.isfinite(e.segment_p).all(axis=1))
    rotations = so3.quat_from_matrix(e.segment_R[known]) if len(known) else np.zeros((0, 4))
    stamp = {"sec": stamp_ns // 10**9, "nsec": stamp_ns % 10**9}
    segments = names.model.segment_names
    return {
        "transforms": [
            {
                "timestamp": stamp,
                "parent_frame_id": FRAME,
                "child_frame_id": f"{names.side}_{segments[i]}",
                "translation": xyz(e.segment_p[i]),
                "rotation": {a: round(v, DECIMALS) for a, v in zip("xyzw", q, strict=True)},
            }
            for i, q in zip(known, rotations.tolist(), strict=True)
        ]
    }


def transforms_schema() -> Json:
    """JSON schema of foxglove.FrameTransforms."""
    stamp = object_of("time", sec=INTEGER, nsec=INTEGER)
    transform = object_of(
        "foxglove.FrameTransform",
        timestamp=stamp,
        parent_frame_id=STRING,
        child_frame_id=STRING,
        translation=object_of("foxglove.Vector3", **dict.fromkeys("xyz", NUMBER)),
        rotation=object_of("foxglove.Quaternion", **dict.fromkeys("xyzw", NUMBER)),
    )
    return object_of("foxglove.FrameTransforms", transforms=array_of(transform))


def description(names: Names) -> bytes:
    """A std_msgs/String (CDR) with the hand's URDF. Raises ValueError for names without a hand."""
    if names.glove is None:
        raise ValueError("these names have no glove")
    session = SessionInfo(names.model, names.glove, "", "", names.anchor or ClockAnchor(0, 0))
    return motion.pack_string(robot_description(session))
