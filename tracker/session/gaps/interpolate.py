"""Interpolates a hand across gaps so that its bones keep their lengths.

Instead of the keypoints, the values that determine them are interpolated: the hand's pose, the
joint angles, and the pose of each segment in its parent. Poses of segments are computed from these,
parents first.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation, Slerp

from tracker.geometry import so3
from tracker.messages import Array, IntArray
from tracker.session.description import SessionInfo
from tracker.session.gaps.merge import merged
from tracker.session.gaps.methods import CUBIC, LINEAR

SPEED_OVER = 0.08  # s next to a gap that determine the speed at its end
SPEED_FOR = 0.3  # s for which that speed continues into a gap; with more, a cubic overshoots
Mask = NDArray[np.bool_]
Rows = tuple[int, int]
"""The rows before and after a gap."""


@dataclass(eq=False)
class RecordedMotion:
    """A hand at increasing times t (N,) s: keypoints (N, K, 3) m, q (N, K, 4) xyzw of the segment
    of each, angles (N, J) rad; NaN where unknown."""

    t: Array
    keypoints: Array
    q: Array
    angles: Array

    def copy(self) -> RecordedMotion:
        """A copy that can be changed."""
        return RecordedMotion(self.t, self.keypoints.copy(), self.q.copy(), self.angles.copy())

    def part(self, rows: slice | IntArray) -> RecordedMotion:
        """A copy of some of the rows."""
        return RecordedMotion(
            self.t[rows].copy(),
            self.keypoints[rows].copy(),
            self.q[rows].copy(),
            self.angles[rows].copy(),
        )


class SessionSkeleton:
    """Assignment of keypoints and angles to the segments of a session's hand."""

    def __init__(self, info: SessionInfo) -> None:
        self.hand = info.hand
        self.segment_of = info.glove.keypoint_segments(info.hand).tolist()
        self.names = info.keypoint_names

    @cached_property
    def origin(self) -> list[int]:
        """(S,) column of the keypoint at which each segment starts."""
        return [self.segment_of.index(s) for s in range(len(self.hand.segments))]

    def points_of(self, segment: int) -> list[int]:
        """Columns of the keypoints that move with a segment, without its origin."""
        own = [k for k, s in enumerate(self.segment_of) if s == segment]
        return [k for k in own if k != self.origin[segment]]

    def angles_of(self, segment: int) -> list[int]:
        """Columns of the angles of the joint at which a segment starts."""
        return [c for c in self.hand.axis_columns[segment] if c >= 0]

    def joint_turns(self, segment: int, angles: Array) -> Rotation:
        """R_parentB of a segment at the angles (n, J): its rest rotation, then its joint's."""
        columns = self.hand.axis_columns[segment]
        turns = np.column_stack(
            [angles[:, c] if c >= 0 else np.zeros(len(angles)) for c in columns]
        )
        rest = Rotation.from_matrix(self.hand.segments[segment].R_rest)
        return rest * Rotation.from_euler("ZYX", turns)


def fill_motion(
    motion: RecordedMotion,
    skeleton: SessionSkeleton,
    missing: Mapping[int, Sequence[Rows]],
    free_angles: Mask,
    method: str = LINEAR,
    shape: RecordedMotion | None = None,
) -> tuple[Mask, Mask]:
    """Fills ``motion``, strictly between the rows given for each column of a keypoint. Returns
    which keypoints (N, K) and which angles (N, J) were filled.

    free_angles (N, J): angles that may be replaced; those of an unfilled joint are not. ``shape``
    has the same rows as ``motion``: a gap follows its course, shifted to fit at both ends. A gap
    with an unknown end, parent or shape is not changed.
    """
    filler = _Filler(motion, skeleton, free_angles, method == CUBIC, shape)
    for segment in range(len(skeleton.hand.segments)):
        for rows in merged(missing.get(skeleton.origin[segment], ())):
            filler.fill_segment(segment, rows)
        for k in skeleton.points_of(segment):
            for rows in merged(missing.get(k, ())):
                filler.fill_point(segment, k, rows)
    return filler.points, filler.angles


class _Filler:
    def __init__(
        self,
        motion: RecordedMotion,
        skeleton: SessionSkeleton,
        free: Mask,
        cubic: bool,
        shape: RecordedMotion | None,
    ) -> None:
        self._m, self._of, self._free, self._shape = motion, skeleton, free, shape
        self._cubic = cubic
        self.points = np.zeros(motion.keypoints.shape[:2], bool)
        self.angles = np.zeros(motion.angles.shape, bool)

    def fill_segment(self, segment: int, rows: Rows) -> None:
        """Fills the pose of a segment, its angles first."""
        for column in self._of.angles_of(segment):
            self._fill_angle(column, rows)
        parent = self._of.hand.parent[segment]
        position = self._local_position(self._m, parent, self._of.origin[segment])
        turn = self._local_turn(self._m, segment)
        inside = self._inside(rows)
        p = self._vectors(position, rows, self._shaped_position(parent, self._of.origin[segment]))
        q = self._turns(segment, turn, rows)
        if p is None or q is None:
            return
        self._put(self._of.origin[segment], parent, inside, p, q)

    def fill_point(self, segment: int, k: int, rows: Rows) -> None:
        """Fills a keypoint that is fixed to a segment."""
        position = self._local_position(self._m, segment, k)
        p = self._vectors(position, rows, self._shaped_position(segment, k))
        if p is None:
            return
        n = len(self._inside(rows))
        self._put(k, segment, self._inside(rows), p, np.tile([0.0, 0.0, 0.0, 1.0], (n, 1)))

    def _put(self, k: int, parent: int, inside: IntArray, p: Array, q: Array) -> None:
        if parent < 0:
            self._m.keypoints[inside, k], self._m.q[inside, k] = p, q
            self.points[inside, k] = True
            return
        column = self._of.origin[parent]
        of_parent = self._m.q[inside, column]
        known = np.isfinite(of_parent).all(axis=1)
        if not known.all():
            return
        R = Rotation.from_quat(of_parent)
        self._m.keypoints[inside, k] = self._m.keypoints[inside, column] + R.apply(p)
        self._m.q[inside, k] = (R * Rotation.from_quat(q)).as_quat()
        self.points[inside, k] = True

    def _fill_angle(self, column: int, rows: Rows) -> None:
        inside = self._inside(rows)
        inside = inside[self._free[inside, column]]
        shape = None if self._shape is None else self._shape.angles[:, [column]]
        found = self._vectors(self._m.angles[:, [column]], rows, shape)
        if found is not None:
            self._m.angles[inside, column] = found[inside - rows[0] - 1, 0]
            self.angles[inside, column] = True

    @staticmethod
    def _inside(rows: Rows) -> IntArray:
        return np.arange(rows[0] + 1, rows[1])

    # --- poses in the parent

    def _local_position(self, m: RecordedMotion, parent: int, k: int) -> Array:
        """(N, 3) m of a keypoint in the parent's B, or in G."""
        if parent < 0:
            return m.keypoints[:, k]
        column = self._of.origin[parent]
        out = np.full((len(m.t), 3), np.nan)
        q = m.q[:, column]
        known = np.isfinite(q).all(axis=1)
        if known.any():
            away = m.keypoints[known, k] - m.keypoints[known, column]
            out[known] = Rotation.from_quat(q[known]).inv().apply(away)
        return out

    def _local_turn(self, m: RecordedMotion, segment: int) -> Array:
        """(N, 4) of a segment in its parent's B, or in G."""
        own, parent = m.q[:, self._of.origin[segment]], self._of.hand.parent[segment]
        if parent < 0:
            return own
        return _product(_inverse(m.q[:, self._of.origin[parent]]), own)

    def _shaped_position(self, parent: int, k: int) -> Array | None:
        return None if self._shape is None else self._local_position(self._shape, parent, k)

    # --- between two rows

    def _vectors(self, values: Array, rows: Rows, shape: Array | None) -> Array | None:
        """(n, C) interpolated between the ``rows`` of values (N, C); None if a required value is
        unknown."""
        a, b = rows
        if shape is not None:
            values = values - shape
        if not np.isfinite(values[[a, b]]).all():
            return None
        u = self._shares(rows)
        out = values[a] + u[:, None] * (values[b] - values[a])
        if self._cubic:
            span = self._m.t[b] - self._m.t[a]
            speeds = [_speed(self._m.t, values, a, -1), _speed(self._m.t, values, b, 1)]
            out = _hermite(u, values[a], values[b], *(_extrapolated(v, span) for v in speeds))
        if shape is None:
            return out
        out = out + shape[a + 1 : b]
        return out if np.isfinite(out).all() else None

    def _turns(self, segment: int, turn: Array, rows: Rows) -> Array | None:
        """(n, 4) rotations of a segment in its parent, interpolated between the ``rows`` of
        ``turns`` (N, 4)."""
        a, b = rows
        base = self._bases(segment, rows)
        if base is not None:
            turn = turn.copy()
            turn[a : b + 1] = _product(_inverse(base), turn[a : b + 1])
        if not np.isfinite(turn[[a, b]]).all():
            return None
        out = self._between(turn, rows, cubic=self._cubic and base is None)
        if base is None:
            return out
        out = _product(base[1:-1], out)
        return out if np.isfinite(out).all() else None

    def _bases(self, segment: int, rows: Rows) -> Array | None:
        """(n + 2, 4) reference rotations at the rows and between them: the shape's, or those of the
        joint's angles; None without either."""
        a, b = rows
        if self._shape is not None:
            return self._local_turn(self._shape, segment)[a : b + 1]
        angles = self._m.angles[a : b + 1]
        columns = self._of.angles_of(segment)
        if not columns or not np.isfinite(angles[:, columns]).all():
            return None
        return np.asarray(self._of.joint_turns(segment, angles).as_quat())

    def _between(self, turn: Array, rows: Rows, cubic: bool) -> Array:
        a, b = rows
        u = self._shares(rows)
        if not cubic:
            ends = Rotation.from_quat(turn[[a, b]])
            return np.asarray(Slerp([0.0, 1.0], ends)(u).as_quat())
        first, last = (Rotation.from_quat(turn[i]) for i in rows)
        vector = (first.inv() * last).as_rotvec()
        span = self._m.t[b] - self._m.t[a]
        v_a = _speed(self._m.t, _rotation_vectors(turn, first), a, -1)
        v_b = _speed(self._m.t, _rotation_vectors(turn, last), b, 1)
        v_b = _right_jacobian_inverse(vector) @ v_b
        course = _hermite(
            u, np.zeros(3), vector, _extrapolated(v_a, span), _extrapolated(v_b, span)
        )
        return np.asarray((first * Rotation.from_rotvec(course)).as_quat())

    def _shares(self, rows: Rows) -> Array:
        t = self._m.t[rows[0] : rows[1] + 1]
        return np.asarray((t[1:-1] - t[0]) / (t[-1] - t[0]))


def _extrapolated(speed: Array, span: float) -> Array:
    """Returns the change at a speed that lasts for at most `SPEED_FOR`."""
    return np.asarray(speed * min(span, SPEED_FOR))


def _hermite(u: Array, a: Array, b: Array, slope_a: Array, slope_b: Array) -> Array:
    """(n, C) at shares u (n,) from ``a`` to ``b``, with the slopes ``slope_a`` and ``slope_b``."""
    u = u[:, None]
    return np.asarray(
        a * (2 * u**3 - 3 * u**2 + 1)
        + b * (3 * u**2 - 2 * u**3)
        + slope_a * (u**3 - 2 * u**2 + u)
        + slope_b * (u**3 - u**2)
    )


def _speed(t: Array, values: Array, row: int, side: int) -> Array:
    """(C,) per s at a row, from a line fitted to it and its neighbours on one side."""
    low, high = (t[row] - SPEED_OVER, t[row]) if side < 0 else (t[row], t[row] + SPEED_OVER)
    first, last = np.searchsorted(t, low - 1e-9), np.searchsorted(t, high + 1e-9, side="right")
    rows = np.arange(first, last)
    rows = rows[np.isfinite(values[rows]).all(axis=1)]
    if len(rows) < 3:
        return np.zeros(values.shape[1])
    away = t[rows] - t[rows].mean()
    return np.asarray(away @ (values[rows] - values[rows].mean(axis=0)) / (away @ away))


def _rotation_vectors(turn: Array, of: Rotation) -> Array:
    """(N, 3) rotation vectors from ``of`` to each turn, in its axes."""
    out = np.full((len(turn), 3), np.nan)
    known = np.isfinite(turn).all(axis=1)
    out[known] = (of.inv() * Rotation.from_quat(turn[known])).as_rotvec()
    return out


def _right_jacobian_inverse(vector: Array) -> Array:
    """(3, 3) inverse right Jacobian: the change of a rotation vector by a small rotation on the
    right."""
    K, angle = so3.skew(vector), float(np.linalg.norm(vector))
    if angle < 1e-6:
        return np.eye(3) + 0.5 * K
    factor = 1 / angle**2 - (1 + np.cos(angle)) / (2 * angle * np.sin(angle))
    return np.asarray(np.eye(3) + 0.5 * K + factor * (K @ K))


def _inverse(q: Array) -> Array:
    return np.asarray(q * [-1.0, -1.0, -1.0, 1.0])


def _product(a: Array, b: Array) -> Array:
    """(N, 4) products of quaternions xyzw; NaN where a factor is."""
    v, w, x, y = a[:, :3], a[:, 3:], b[:, :3], b[:, 3:]
    vector = w * x + y * v + np.cross(v, x)
    return np.hstack([vector, w * y - (v * x).sum(axis=1, keepdims=True)])
