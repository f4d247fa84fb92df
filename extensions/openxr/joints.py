"""From estimates to the joints that an API layer may report: all of them, or no hand.

A layer must not call a hand active unless every joint has a pose. A joint that is lost therefore
keeps its last pose relative to the wrist for `HOLD`, with state lost and without a velocity; after
that, and whenever the wrist is lost, the hand is inactive.
"""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.openxr.layout import JOINT, Velocity
from tracker.base.notices import notice
from tracker.hand.openxr import JOINTS, WRIST, OpenXrHand, keypoint_rows, openxr_motion
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.payload import openxr_of
from tracker.streaming.publisher import Names, StreamError

HOLD = 1.0  # s for which a lost joint keeps its pose on the hand
SPAN = 0.015  # s over which a velocity is a difference at least; half of it is its delay
LONGEST_SPAN = 0.05  # s, beyond which no velocity is computed from a difference
JointArray = NDArray[np.void]
"""(26,) of `JOINT`."""
NONE = np.zeros(len(JOINTS), JOINT)


class JointPoses(NamedTuple):
    """p (26, 3) m and q (26, 4) xyzw of one instant; ``known`` (26,) bool."""

    t: float
    p: Array
    q: Array
    known: NDArray[np.bool_]


class HandJoints(NamedTuple):
    """``array`` (26,) of `JOINT`, None while the hand is inactive."""

    array: JointArray | None
    velocity: Velocity


class JointSeries:
    """The joints of one hand, estimate by estimate in order of time.

    Raises StreamError if the hand lacks one of OpenXR's joints.
    """

    def __init__(self, names: Names) -> None:
        self._names = names
        self._radii = np.array(names.radii)
        if not np.isfinite(self._radii).all():
            lacking = ", ".join(n for n, r in zip(JOINTS, names.radii, strict=True) if r != r)
            raise StreamError(notice("openxr.joints_missing", joints=lacking))
        self._rows = np.array(keypoint_rows(names.keypoints))
        self._seen = np.full(len(JOINTS), -np.inf)  # s, when each joint last had a pose
        self._p_W = np.zeros((len(JOINTS), 3))  # m in the wrist's axes, at that time
        self._q_W = np.tile([0.0, 0.0, 0.0, 1.0], (len(JOINTS), 1))
        self._before: deque[JointPoses] = deque()

    def add(self, estimate: Estimate) -> HandJoints:
        """The joints of the next estimate."""
        hand = openxr_of(estimate, self._names)
        known = hand.state != Validity.LOST
        poses = self._poses(hand, known) if known[WRIST] else None
        if poses is None:
            self._before.clear()
            return HandJoints(None, Velocity.UNKNOWN)
        out = NONE.copy()
        out["position"], out["orientation"] = poses.p, poses.q
        out["radius"], out["state"] = self._radii, hand.state
        out["sd"] = np.where(
            (self._rows >= 0) & known, estimate.keypoint_sd[np.maximum(self._rows, 0)], np.nan
        )
        velocity = self._add_motion(out, estimate, hand)
        if velocity == Velocity.UNKNOWN:
            velocity = self._add_differences(out, poses)
        self._before.append(poses)
        return HandJoints(out, velocity)

    def _add_motion(self, out: JointArray, estimate: Estimate, hand: OpenXrHand) -> Velocity:
        """The engine's own velocities; NaN of joints without such."""
        motion = openxr_motion(estimate, self._names.keypoints, hand)
        out["linear"], out["angular"] = motion.linear, motion.angular
        out["linear_sd"], out["angular_sd"] = motion.linear_sd, motion.angular_sd
        is_known = bool(np.isfinite(motion.linear[WRIST]).all())
        return Velocity.FILTER if is_known else Velocity.UNKNOWN

    def _poses(self, hand: OpenXrHand, known: NDArray[np.bool_]) -> JointPoses | None:
        """Every joint's, those that are lost where they were on the hand; None without such."""
        p, q = hand.position, hand.orientation
        back = inverse(q[WRIST])
        self._seen[known] = hand.t
        self._p_W[known] = rotate(back, p[known] - p[WRIST])
        self._q_W[known] = product(back, q[known])
        if (self._seen < hand.t - HOLD).any():
            return None
        if not known.all():
            p = np.where(known[:, None], p, p[WRIST] + rotate(q[WRIST], self._p_W))
            q = np.where(known[:, None], q, product(q[WRIST], self._q_W))
        return JointPoses(hand.t, p, q, known)

    def _add_differences(self, out: JointArray, now: JointPoses) -> Velocity:
        """Differences from the newest poses that are `SPAN` old; NaN of joints without such."""
        out["linear"], out["angular"] = np.nan, np.nan
        out["linear_sd"] = out["angular_sd"] = np.nan
        while len(self._before) > 1 and now.t - self._before[1].t >= SPAN:
            self._before.popleft()
        if not self._before or not SPAN <= now.t - self._before[0].t <= LONGEST_SPAN:
            return Velocity.UNKNOWN
        before = self._before[0]
        dt, known = now.t - before.t, now.known & before.known
        out["linear"][known] = ((now.p - before.p) / dt)[known]
        out["angular"][known] = rotation_vector(product(now.q, inverse(before.q)))[known] / dt
        return Velocity.DIFFERENCE


# Quaternions (..., 4) xyzw in arrays; for a hand's 26 in a tenth of the time of SciPy's class.

_CONJUGATE = np.array([-1.0, -1.0, -1.0, 1.0])
_AHEAD, _BEHIND = [1, 2, 0], [2, 0, 1]


def inverse(q: Array) -> Array:
    """For unit quaternions."""
    return np.asarray(q * _CONJUGATE)


def product(a: Array, b: Array) -> Array:
    """The turns ``a`` after ``b``."""
    va, wa, vb, wb = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    w = wa * wb - (va * vb).sum(axis=-1, keepdims=True)
    return np.concatenate([wa * vb + wb * va + _cross(va, vb), w], axis=-1)


def rotate(q: Array, v: Array) -> Array:
    """Vectors (..., 3) turned by unit quaternions."""
    u, w = q[..., :3], q[..., 3:]
    twice = 2 * _cross(u, v)
    return np.asarray(v + w * twice + _cross(u, twice))


def rotation_vector(q: Array) -> Array:
    """(..., 3) rad, at most π long, of unit quaternions."""
    q = np.where(q[..., 3:] < 0, -q, q)
    v, w = q[..., :3], q[..., 3:]
    n = np.sqrt((v * v).sum(axis=-1, keepdims=True))
    small = n < 1e-8
    return np.asarray(v * np.where(small, 2.0, 2 * np.arctan2(n, w) / np.where(small, 1.0, n)))


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[..., _AHEAD] * b[..., _BEHIND] - a[..., _BEHIND] * b[..., _AHEAD])
