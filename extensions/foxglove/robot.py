"""The hand as a robot for Foxglove: model (URDF), joint states and frames as in recordings.

Sources: docs.foxglove.dev/docs/sdk/schemas/frame-transforms; sensor_msgs/JointState and
std_msgs/String of ROS 2. Frames have the names of the model's links.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from extensions.foxglove.scene import FRAME, INTEGER, NUMBER, STRING, array_of, object_of, xyz
from tracker.base.clock import ClockAnchor
from tracker.geometry.kernels import quats
from tracker.messages import Estimate, Validity
from tracker.session.description import SessionInfo
from tracker.session.export.urdf import robot_description
from tracker.session.ros import motion
from tracker.streaming.publisher import Names
from tracker.streaming.text import HOLE, TextForm, holes

Json = dict[str, Any]


def joint_states(names: Names, e: Estimate, stamp_ns: int) -> bytes:
    """A sensor_msgs/JointState (CDR) of the angles that are known, in rad."""
    known = np.flatnonzero(np.isfinite(e.angles) & (e.angle_state != Validity.LOST))
    rows = [names.angles[i] for i in known]
    return motion.pack_joints(motion.JointState(stamp_ns, rows, e.angles[known]))


class FrameTransforms:
    """Texts of foxglove.FrameTransforms of a hand's segments in ``world``."""

    def __init__(self, names: Names) -> None:
        self._frames = [f"{names.side}_{segment}" for segment in names.model.segment_names]
        self._forms: dict[bytes, TextForm] = {}  # by the segments that are known

    def text(self, e: Estimate, stamp_ns: int) -> str:
        known = np.isfinite(e.segment_p).all(axis=1)
        rows, key = np.flatnonzero(known), known.tobytes()
        if key not in self._forms:
            self._forms[key] = TextForm(self._message(rows.tolist()))
        sec, nsec = divmod(stamp_ns, 10**9)
        flat = np.column_stack([e.segment_p[rows], quats(e.segment_R[rows])]).ravel()
        return self._forms[key].fill(flat, [str(sec), str(nsec)] * len(rows))

    def _message(self, rows: Sequence[int]) -> Json:
        (poses,) = holes([(len(rows), 7)], None)
        return {
            "transforms": [
                {
                    "timestamp": {"sec": HOLE, "nsec": HOLE},
                    "parent_frame_id": FRAME,
                    "child_frame_id": self._frames[i],
                    "translation": xyz(pose[:3]),
                    "rotation": dict(zip("xyzw", pose[3:], strict=True)),
                }
                for i, pose in zip(rows, poses, strict=True)
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
