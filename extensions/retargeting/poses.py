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

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from glovetrack.conventions import MEDIAPIPE, operator_frame
from tracker.base.notices import Notice, notice
from tracker.geometry import so3
from tracker.geometry.kernels import quats
from tracker.hand.openxr import (
    JOINTS,
    KEYPOINT_OF,
    R_BX,
    WRIST,
    OpenXrHand,
    keypoint_rows,
)
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import encoded, openxr_of
from tracker.streaming.publisher import STATE_WORDS, Names, Publisher, StreamError
from tracker.streaming.registry import StreamKind
from tracker.streaming.text import HOLE, Column, TextForm, holes

SCHEMA = 1
FORMS = 256  # of messages whose text is stored
_JOINT_OF = {keypoint: joint for joint, keypoint in KEYPOINT_OF.items()}
TIPS = ("wrist", *(j for j in JOINTS if j.endswith("_tip")))
LANDMARKS = tuple(_JOINT_OF[k] for k in MEDIAPIPE)
SETS = {"tips": TIPS, "openxr": JOINTS, "landmarks": LANDMARKS}
FRAMES = ("world", "openxr", "wrist", "operator")
_ROWS = {name: [JOINTS.index(j) for j in joints] for name, joints in SETS.items()}
_LANDMARK_ROWS = _ROWS["landmarks"]


@dataclass(frozen=True)
class KeyedPoseOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(9003, "destination port")
    joints: str = option(
        "tips",
        "tips: wrist and fingertips; openxr: 26 joints; landmarks: 21, in MediaPipe's order",
        ("tips", "openxr", "landmarks"),
    )
    frame: str = option(
        "world",
        "world: z up; openxr: y up; wrist: relative to the wrist; operator: dex-retargeting's",
        ("world", "openxr", "wrist", "operator"),
    )
    matrix: bool = option(False, "whether each pose also has a 4×4 matrix")


@dataclass(frozen=True)
class PoseView:
    """Which poses, in which frame, and whether as matrices, too: values of `KeyedPoseOptions`."""

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
    """Poses in one of the frames of `KeyedPoseOptions`; ``names`` have OpenXR's radii."""
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


def pose_text(e: Estimate, names: Names, view: PoseView) -> str:
    """The message as JSON."""
    poses, rows = poses_of(e, names, view.frame), _ROWS[view.joints]
    R, p = poses.R[rows], poses.p[rows]
    columns = [p, quats(R) + 0.0, poses.sd[rows]]
    if view.matrix:
        columns.append(np.concatenate([R, p[:, :, None]], axis=2).reshape(len(rows), 12))
    flat = np.column_stack(columns).ravel() + 0.0  # no -0
    seq = None if e.seq < 0 else e.seq
    head = [encoded(x) for x in (seq, e.t, names.wall_ns(e.t))]
    states = tuple(poses.state[rows].tolist())
    known = np.isfinite(poses.sd[rows])
    form = _form(names.side, e.tracking.name.lower(), view, states, tuple(known.tolist()))
    return form.fill(flat, head)


@lru_cache(maxsize=FORMS)
def _form(
    side: str, tracking: str, view: PoseView, states: tuple[int, ...], known: tuple[bool, ...]
) -> TextForm:
    """``states`` of the poses, and whether their sd is ``known``."""
    size = 20 if view.matrix else 8
    (rows,) = holes([(len(states), size)], None)
    names = [JOINTS[i] for i in _ROWS[view.joints]]
    poses = {
        name: _pose(Validity(state), row if state != Validity.LOST else None, k, view.matrix)
        for name, state, row, k in zip(names, states, rows, known, strict=True)
    }
    return TextForm(
        {
            "schema": SCHEMA,
            "side": side,
            "seq": HOLE,
            "t": HOLE,
            "t_unix_ns": HOLE,
            "tracking": tracking,
            "frame": view.frame,
            "poses": poses,
        }
    )


def _pose(state: Validity, row: Column | None, known: bool, matrix: bool) -> dict[str, Any]:
    """``row``: position, quaternion, sd and perhaps three rows of a matrix; None where lost."""
    out: dict[str, Any] = {"state": STATE_WORDS[state]}
    if row is None:
        out |= {"position": None, "orientation_xyzw": None, "sd": None}
        return {**out, "matrix": None} if matrix else out
    out |= {"position": row[:3], "orientation_xyzw": row[3:7], "sd": row[7] if known else None}
    if matrix:
        out["matrix"] = [row[8:12], row[12:16], row[16:20], [0.0, 0.0, 0.0, 1.0]]
    return out


class PosePublisher:
    """One datagram of JSON for each estimate of a hand, whose names have OpenXR's radii."""

    def __init__(self, names: Names, view: PoseView, host: str, port: int) -> None:
        self._names, self._view = names, view
        self.name = notice("poses.to", host=host, port=port)
        self._socket = DatagramSocket("poses", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(pose_text(estimate, self._names, self._view).encode())

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()


def _publishers(options: KeyedPoseOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    view = PoseView(options.joints, options.frame, options.matrix)
    for names in hands:
        yield PosePublisher(names.with_openxr(), view, options.host, options.port)


POSES = StreamKind(
    name="poses",
    title="Keyed poses (Isaac, retargeting)",
    options=KeyedPoseOptions,
    make=_publishers,
    order=26,
)
