"""Assembles estimates from the topics that they are split into."""

from __future__ import annotations

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity
from tracker.session.description import SessionInfo
from tracker.session.mcap.input import RawMessage
from tracker.session.ros import motion, topics

_SEGMENTS_KEPT = 64  # the transforms of all estimates of one arrival are read first


class EstimateDecoder:
    """Assembles estimates from their topics; ``root``: ``hand``, ``truth`` or ``reference``."""

    def __init__(self, info: SessionInfo, root: str) -> None:
        known = {"hand": topics.hand, "truth": topics.truth, "reference": topics.reference}
        name = known[root]
        self._keypoint_names, self._hand = info.keypoint_names, info.hand
        self._t = info.anchor.monotonic
        self._rows = {f"{info.side}_{s}": i for i, s in enumerate(info.hand.segment_names)}
        self._names = {
            name(info.side, what): what
            for what in ("keypoints", "joint_states", "keypoint_sd", "states")
        }
        self.topics = tuple(self._names)
        self._tracking = Tracking.TRACKING
        self._named = {"keypoints": self._keypoint_names, "joints": self._hand.joint_names}
        self._states_of = {name: _states({}, rows) for name, rows in self._named.items()}
        self._joints: motion.JointState | None = None
        self._sd: Array | None = None
        self._segments: dict[int, list[motion.Transform]] = {}

    def set_segments(self, transforms: list[motion.Transform]) -> None:
        mine = [t for t in transforms if t.child in self._rows]
        if mine:
            self._segments[mine[0].stamp] = mine
            while len(self._segments) > _SEGMENTS_KEPT:
                del self._segments[next(iter(self._segments))]

    def feed(self, raw: RawMessage) -> Estimate | None:
        """Returns an estimate with its keypoints, which are written last."""
        what = self._names[raw.topic]
        if what == "keypoints":
            return self._build(motion.unpack_poses(raw.data))
        if what == "joint_states":
            self._joints = motion.unpack_joints(raw.data)
        elif what == "keypoint_sd":
            self._sd = motion.unpack_numbers(raw.data)
        else:
            self._read_states(raw.data)
        return None

    def _read_states(self, data: bytes) -> None:
        for s in motion.unpack_diagnostics(data)[1]:
            if s.name == "tracking":
                self._tracking = tracking_of(s.message)
            elif s.name in self._named:
                self._states_of[s.name] = _states(s.values, self._named[s.name])

    def _build(self, poses: motion.PoseArray) -> Estimate:
        n = len(self._keypoint_names)
        keypoints, q = np.full((n, 3), np.nan), np.full((n, 4), np.nan)
        rows = min(n, len(poses.position))
        keypoints[:rows], q[:rows] = poses.position[:rows], poses.orientation[:rows]
        angles = self._angles(poses.stamp)
        R, p = self._segment_poses(poses.stamp)
        sd = self._sd if self._sd is not None and len(self._sd) == n else np.full(n, np.nan)
        self._sd = None
        known = np.isfinite(keypoints).all(axis=1)
        return Estimate(
            self._t(poses.stamp),
            self._tracking,
            keypoints,
            q,
            _or_lost(self._states_of["keypoints"], known),
            sd,
            angles,
            _or_lost(self._states_of["joints"], np.isfinite(angles)),
            R,
            p,
        )

    def _angles(self, stamp: int) -> Array:
        angles = np.full(len(self._hand.joint_names), np.nan)
        if self._joints is not None and self._joints.stamp == stamp:
            for name, value in zip(self._joints.names, self._joints.position, strict=False):
                if name in self._hand.angle_index:
                    angles[self._hand.angle_index[name]] = value
        return angles

    def _segment_poses(self, stamp: int) -> tuple[Array, Array]:
        n = len(self._rows)
        R, p = np.full((n, 3, 3), np.nan), np.full((n, 3), np.nan)
        found = self._segments.get(stamp, [])
        if found:
            rows = [self._rows[t.child] for t in found]
            R[rows] = so3.matrix_from_quat(np.array([t.rotation for t in found]))
            p[rows] = [t.translation for t in found]
        return R, p


def _states(names_of: dict[str, str], names: tuple[str, ...]) -> IntArray:
    """Returns states by name; measured by default, lost if the word is unknown."""
    stored = [names_of.get(n, "measured").upper() for n in names]
    values = [Validity[w] if w in Validity.__members__ else Validity.LOST for w in stored]
    return np.array(values, np.int64)


def _or_lost(states: IntArray, known: np.ndarray) -> IntArray:
    return np.where(known, states, np.int64(Validity.LOST))


def tracking_of(word: str) -> Tracking:
    return Tracking[word.upper()] if word.upper() in Tracking.__members__ else Tracking.LOST
