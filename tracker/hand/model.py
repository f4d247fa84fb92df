"""A hand: segments in a tree, joints with free axes and limits, synergies.

Segments are stored parents first, so that a single pass computes the forward kinematics.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tracker.geometry import so3
from tracker.hand.names import AXES, KEYPOINTS
from tracker.messages import Array


@dataclass(frozen=True, eq=False)
class Segment:
    """One bone. ``origin`` (3,) of its joint in the parent's B, m; ``R_rest`` (3, 3) R_parentB."""

    name: str
    parent: str | None
    origin: Array
    R_rest: Array
    length: float
    radius: float
    width: float  # of a slab (the dorsum); 0 for a capsule


@dataclass(frozen=True, eq=False)
class Joint:
    """The joint at a segment's origin; ``limits`` (rad) per free axis name.

    ``stiff`` are free axes that hardly rotate, ``fist`` the flexion in a fist as a share of its
    upper limit.
    """

    name: str
    child: str
    axes: tuple[str, ...]
    limits: dict[str, tuple[float, float]]
    stiff: tuple[str, ...]
    fist: float


@dataclass(frozen=True)
class Synergy:
    """angle = ratio * other + offset (rad), for an unsensed joint angle."""

    angle: str
    of: str
    ratio: float
    offset: float


@dataclass(frozen=True, eq=False)
class HandModel:
    """A skeleton of one side at nominal size; its length is measured to the far end of the segment
    ``length_to``."""

    name: str
    side: str  # "right" or "left"
    length: float  # wrist to a fingertip, by default that of the middle finger; m
    length_to: str
    segments: tuple[Segment, ...]
    joints: tuple[Joint, ...]
    synergies: tuple[Synergy, ...]

    @cached_property
    def segment_names(self) -> tuple[str, ...]:
        return tuple(s.name for s in self.segments)

    @cached_property
    def index(self) -> dict[str, int]:
        """Segment name to its row."""
        return {s.name: i for i, s in enumerate(self.segments)}

    @cached_property
    def parent(self) -> tuple[int, ...]:
        """Row of each segment's parent, -1 for the root."""
        return tuple(-1 if s.parent is None else self.index[s.parent] for s in self.segments)

    @cached_property
    def root(self) -> int:
        """Row of the segment without a parent."""
        return self.parent.index(-1)

    @cached_property
    def length_path(self) -> tuple[int, ...]:
        """Rows of the segments along which the hand's length is measured, from the root on."""
        path = [self.index[self.length_to]]
        while self.parent[path[0]] >= 0:
            path.insert(0, self.parent[path[0]])
        return tuple(path)

    @cached_property
    def joint_of(self) -> dict[str, Joint]:
        """Child segment name to its joint."""
        return {j.child: j for j in self.joints}

    @cached_property
    def joint_names(self) -> tuple[str, ...]:
        """Names of all angles, ``<joint>_<axis>``, joint by joint in segment order."""
        names: list[str] = []
        for s in self.segments:
            joint = self.joint_of.get(s.name)
            if joint is not None:
                names += [f"{joint.name}_{axis}" for axis in joint.axes]
        return tuple(names)

    @cached_property
    def angle_index(self) -> dict[str, int]:
        return {n: i for i, n in enumerate(self.joint_names)}

    @cached_property
    def angle_limits(self) -> Array:
        """(J, 2) rad."""
        rows = [
            j.limits[axis]
            for s in self.segments
            if (j := self.joint_of.get(s.name)) is not None
            for axis in j.axes
        ]
        return np.array(rows, float).reshape(-1, 2)

    @cached_property
    def axis_columns(self) -> tuple[tuple[int, int, int], ...]:
        """Per segment the columns of (abduction, flexion, twist) among the angles, -1 if fixed."""
        return tuple(
            tuple(self._column(s.name, axis) for axis in AXES)  # type: ignore[misc]
            for s in self.segments
        )

    def _column(self, segment: str, axis: str) -> int:
        joint = self.joint_of.get(segment)
        if joint is None or axis not in joint.axes:
            return -1
        return self.angle_index[f"{joint.name}_{axis}"]

    @cached_property
    def keypoint_names(self) -> tuple[str, ...]:
        """Those of the 21 keypoints of the conventions that this skeleton has."""
        return tuple(k for k, (segment, _) in KEYPOINTS.items() if segment in self.index)

    @cached_property
    def keypoint_segment(self) -> tuple[int, ...]:
        return tuple(self.index[KEYPOINTS[k][0]] for k in self.keypoint_names)

    @cached_property
    def keypoint_offset(self) -> Array:
        """(K, 3) position of each keypoint in its segment's B, m."""
        rows = [
            [self.segments[i].length if KEYPOINTS[k][1] else 0.0, 0.0, 0.0]
            for k, i in zip(self.keypoint_names, self.keypoint_segment, strict=True)
        ]
        return np.array(rows, float)

    def forward(
        self, angles: Array, R_GB: Array, p_GB: Array, scale: Array | None = None
    ) -> tuple[Array, Array]:
        """Pose of every segment from joint angles and the root's pose.

        angles (J,) rad; scale (S, 3) factors along each B's axes, ones if absent.
        Returns R_GB (S, 3, 3), p_GB (S, 3).
        """
        n = len(self.segments)
        R, p = np.empty((n, 3, 3)), np.empty((n, 3))
        for i, s in enumerate(self.segments):
            a = self.parent[i]
            if a < 0:
                R[i], p[i] = R_GB, p_GB
                continue
            origin = s.origin if scale is None else s.origin * scale[a]
            R[i] = R[a] @ s.R_rest @ self.joint_rotation(i, angles)
            p[i] = p[a] + R[a] @ origin
        return R, p

    def joint_rotation(self, i: int, angles: Array) -> Array:
        """Rz(abduction) Ry(flexion) Rx(twist) of segment ``i``'s joint, (3, 3)."""
        abd, flex, twist = (0.0 if c < 0 else float(angles[c]) for c in self.axis_columns[i])
        return so3.rz(abd) @ so3.ry(flex) @ so3.rx(twist)

    def apply_synergies(self, angles: Array, known: Array) -> tuple[Array, Array]:
        """Fill unmeasured angles. ``known`` (J,) bool.

        Returns the angles and the mask of those computed by a synergy. Synergies may be chained; an
        angle whose source is itself unknown keeps its value.
        """
        out, have = np.array(angles, float), np.array(known, bool)
        inferred = np.zeros(len(out), bool)
        for _ in self.synergies:
            for s in self.synergies:
                i, j = self.angle_index[s.angle], self.angle_index[s.of]
                if not have[i] and have[j]:
                    out[i], have[i], inferred[i] = s.ratio * out[j] + s.offset, True, True
        return np.clip(out, *_inferred_limits(out, inferred, self.angle_limits)), inferred

    def keypoints(self, R: Array, p: Array, scale: Array | None = None) -> Array:
        """(K, 3) positions in G of the 21 keypoints from segment poses."""
        seg = list(self.keypoint_segment)
        offset = self.keypoint_offset if scale is None else self.keypoint_offset * scale[seg]
        return p[seg] + np.einsum("kij,kj->ki", R[seg], offset)


def _inferred_limits(angles: Array, inferred: Array, limits: Array) -> tuple[Array, Array]:
    """Bounds that limit inferred angles to anatomy and leave measured ones unchanged."""
    low = np.where(inferred, limits[:, 0], -np.inf)
    high = np.where(inferred, limits[:, 1], np.inf)
    return low, high
