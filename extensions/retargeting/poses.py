"""Keyed poses, SE(3), of a hand as JSON: what teleoperation and retargeting programs read.

    {"schema": 1, "side": "right", "seq": 7, "t": 12.34, "t_unix_ns": 1732538096123456789,
     "tracking": "tracking", "frame": "world",
     "poses": {"index_tip": {"state": "measured", "position": [x, y, z],
                             "orientation_xyzw": [x, y, z, w], "sd": 0.002}, ...}}

Keys are the joint names of OpenXR and Isaac Lab. Axes of a joint are OpenXR's in every frame: -z to
the tip, y out of the back of the hand. Position and ``sd`` (of the position, per axis) in m; with
``matrix``, also ``"matrix"``, 4 rows of 4. A lost pose has nulls.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from glovetrack.conventions import MEDIAPIPE, operator_frame
from tracker.base.notices import Notice, notice
from tracker.geometry import so3
from tracker.hand.openxr import (
    JOINTS,
    KEYPOINT_OF,
    R_BX,
    WRIST,
    OpenXrHand,
    keypoint_rows,
)
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import DECIMALS, encoded, openxr_of
from tracker.streaming.publisher import STATE_WORDS, Names, StreamError

SCHEMA = 1
_JOINT_OF = {keypoint: joint for joint, keypoint in KEYPOINT_OF.items()}
TIPS = ("wrist", *(j for j in JOINTS if j.endswith("_tip")))
LANDMARKS = tuple(_JOINT_OF[k] for k in MEDIAPIPE)
SETS = {"tips": TIPS, "openxr": JOINTS, "landmarks": LANDMARKS}
FRAMES = ("world", "openxr", "wrist", "operator")
_ROWS = {name: [JOINTS.index(j) for j in joints] for name, joints in SETS.items()}
_LANDMARK_ROWS = _ROWS["landmarks"]


@dataclass(frozen=True)
class PoseView:
    """Which poses, in which frame, and whether as matrices, too: values of `PoseOptions`."""

    joints: str = "tips"
    frame: str = "world"
    matrix: bool = False

    def __post_init__(self) -> None:
        for value, known in ((self.joints, tuple(SETS)), (self.frame, FRAMES)):
            if value not in known:
                raise StreamError(notice("option.choice", option="poses", known=known, value=value))


@dataclass(frozen=True, eq=False)
class KeyedPoses:
    """For `JOINTS`: R (26, 3, 3), p (26, 3) m, sd (26,) m and state (26,); NaN where lost."""

    R: Array
    p: Array
    sd: Array
    state: IntArray


def poses_of(e: Estimate, names: Names, frame: str) -> KeyedPoses:
    """Poses in one of the frames of `PoseOptions`; ``names`` have OpenXR's radii."""
    hand = openxr_of(e, names)
    state = np.array(hand.state)
    R = np.full((len(JOINTS), 3, 3), np.nan)
    there = state != Validity.LOST
    R[there] = so3.matrix_from_quat(hand.orientation[there])
    R_FX, origin = _frame(hand, R, frame)
    R, p = R_FX @ R, (hand.position - origin) @ R_FX.T
    lost = ~np.isfinite(p).all(axis=1)
    state[lost] = int(Validity.LOST)
    rows = np.array(keypoint_rows(names.keypoints))
    sd = np.where((rows >= 0) & ~lost, e.keypoint_sd[np.maximum(rows, 0)], np.nan)
    return KeyedPoses(R, p, sd, state)


def _frame(hand: OpenXrHand, R: Array, frame: str) -> tuple[Array, Array]:
    """R_FX (3, 3) from OpenXR's world, and the frame's origin (3,) m there."""
    if frame == "world":
        return R_BX, np.zeros(3)
    if frame == "openxr":
        return np.eye(3), np.zeros(3)
    origin = hand.position[WRIST]
    if frame == "wrist":
        return R[WRIST].T, origin
    return operator_frame(hand.position[_LANDMARK_ROWS] - origin, R[WRIST] @ R_BX.T).T, origin


def pose_message(e: Estimate, names: Names, view: PoseView) -> dict[str, Any]:
    """The message as JSON-ready objects."""
    poses = poses_of(e, names, view.frame)
    return {
        "schema": SCHEMA,
        "side": names.side,
        "seq": None if e.seq < 0 else e.seq,
        "t": e.t,
        "t_unix_ns": names.wall_ns(e.t),
        "tracking": e.tracking.name.lower(),
        "frame": view.frame,
        "poses": {JOINTS[i]: _pose(poses, i, view.matrix) for i in _ROWS[view.joints]},
    }


def _pose(poses: KeyedPoses, i: int, matrix: bool) -> dict[str, Any]:
    state = Validity(int(poses.state[i]))
    out: dict[str, Any] = {"state": STATE_WORDS[state]}
    if state == Validity.LOST:
        out |= {"position": None, "orientation_xyzw": None, "sd": None}
        return {**out, "matrix": None} if matrix else out
    R, p, sd = poses.R[i], poses.p[i], float(poses.sd[i])
    out |= {
        "position": _numbers(p),
        "orientation_xyzw": _numbers(so3.quat_from_matrix(R)),
        "sd": round(sd, DECIMALS) if np.isfinite(sd) else None,
    }
    if matrix:
        rows = np.vstack([np.column_stack([R, p]), [0.0, 0.0, 0.0, 1.0]])
        out["matrix"] = [_numbers(row) for row in rows]
    return out


def _numbers(values: Array) -> list[float]:
    return [round(v, DECIMALS) + 0.0 for v in values.tolist()]  # no -0


class PosePublisher:
    """One datagram of JSON for each estimate of a hand, whose names have OpenXR's radii."""

    def __init__(self, names: Names, view: PoseView, host: str, port: int) -> None:
        self._names, self._view = names, view
        self.name = f"Keyed poses to {host}:{port}"
        self._socket = DatagramSocket("poses", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(encoded(pose_message(estimate, self._names, self._view)).encode())

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()
