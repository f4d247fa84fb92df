"""Searches for a misplaced digit: tries other postures against the stereo points.

A digit with a wrong initial posture may not recover: its markers lie outside its gates, and its
IMUs measure tilt and rotation but not heading. Postures on a grid of its joint angles are scored by
voting, as whole hands are in `start.search`, with a penalty for those that contradict the
accelerometers.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.kinematics import marker_positions, segment_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Stack, Vector
from tracker.messages import Array, IntArray

STEPS = {"flexion": 5, "abduction": 3, "twist": 1}  # of the grid, per joint axis
MOST_STEPS = {
    "flexion": 6,
    "abduction": 5,
    "twist": 1,
}  # for a joint with wide abduction
WIDE = 0.9  # rad between the abduction limits of such a joint
RADIUS = 0.018  # m, within which a point supports a marker
TILT_SD = 0.3  # rad: the grid's own coarseness, and motion in the accelerometers
TILT_WEIGHT = 0.15  # markers per sd² of tilt error
FACING_COS = 0.25
ROTATION_SD = 0.25  # rad sd of a digit found by this search
BETTER = 0.3  # markers by which another posture must be better supported to be tried
MOST_TURN = 1.2  # rad, limit of the rotation that aligns a posture with the measured tilt


class SupportPoints(NamedTuple):
    """Stereo points p_G (n, 3) m of hue (n,), each of which supports a marker of its hue within
    ``radius`` m."""

    p_G: Matrix
    hue: IntVector
    radius: float


class DigitPostures(NamedTuple):
    """K postures of one digit in the root's B, its base joint at the origin: marker (K, m, 3) m,
    normal (K, m, 3), up to scale; R (K, a, 3, 3) of its segments; rows of both in the layout; reach
    (m), distance of the farthest marker from the base joint."""

    marker: Stack
    normal: Stack
    R: Array
    markers: IntArray
    segments: IntArray
    reach: float


@dataclass(frozen=True, eq=False)
class SeenPoints:
    """Stereo points that may belong to the digit: p_G (n, 3) m, hue (n,), fresh (n,) where a
    camera's blob is not matched yet; camera at p_GC (3,)."""

    p_G: Array
    hue: IntArray
    fresh: BoolVector
    p_GC: Array

    def within(self, p: Array, reach: float) -> SeenPoints:
        """Those at most ``reach`` m from p (3,) m."""
        near = np.einsum("ni,ni->n", self.p_G - p, self.p_G - p) <= reach * reach
        return SeenPoints(self.p_G[near], self.hue[near], self.fresh[near], self.p_GC)

    @property
    def support(self) -> SupportPoints:
        """The points as input of `posture_scores`."""
        return SupportPoints(self.p_G, self.hue, RADIUS)

    def way(self, p: Array) -> Array:
        """(3,) unit vector from p (3,) m to the camera."""
        d = self.p_GC - p
        return np.asarray(d / np.linalg.norm(d))


class DigitSearch:
    """Candidate postures for each digit of one hand, created on first use."""

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        self._digit = digit_of(layout)
        self.count = int(self._digit.max(initial=-1)) + 1
        self._postures: dict[int, DigitPostures] = {}

    def other(self, state: ChainState, digit: int, seen: SeenPoints) -> Array | None:
        """R_GB (A, 3, 3) with the digit in the best-supported posture; None where that is the
        present one."""
        grid = self._postures_of(digit)
        root, base = state.R_GB[0], segment_positions(state, self._layout)[grid.segments[0]]
        length = float(state.scale[grid.segments, 0].mean())
        seen = seen.within(base, length * grid.reach + RADIUS)
        if not seen.fresh.any():
            return None
        hue = self._layout.glove.marker_hue[grid.markers]
        least = self.support(state, digit, seen) + BETTER
        if _at_most(hue, seen.hue) <= least:
            return None
        score = posture_scores(
            grid.marker * length, grid.normal, root, base, seen.way(base), hue, seen.support
        )
        score -= TILT_WEIGHT * self._tilt_errors(state, grid, root)
        best = int(np.argmax(score))
        if score[best] <= least:
            return None
        R = state.R_GB.copy()
        for i, a in enumerate(grid.segments):
            R[a] = self._as_felt(root @ grid.R[best, i], state.R_GB[a], int(a))
        return R

    def support(self, state: ChainState, digit: int, seen: SeenPoints) -> float:
        """Number of the digit's markers that the points support in ``state``: each counts 1 at its
        point and 0 from `RADIUS` on."""
        grid = self._postures_of(digit)
        base = segment_positions(state, self._layout)[grid.segments[0]]
        p_G = marker_positions(state, self._layout)[grid.markers][None]
        R = state.R_GB[self._layout.marker_segment[grid.markers]]
        normal = np.einsum("mij,mj->mi", R, self._layout.glove.marker_normal[grid.markers])
        normal = np.ascontiguousarray(normal)[None]
        hue, origin = self._layout.glove.marker_hue[grid.markers], np.zeros(3)
        way = seen.way(base)
        return float(posture_scores(p_G, normal, np.eye(3), origin, way, hue, seen.support)[0])

    def _tilt_errors(self, state: ChainState, grid: DigitPostures, root: Array) -> Array:
        """(K,) sum of squares, in sd, of the tilt measured by the digit's IMUs against each
        posture."""
        felt = [i for i, a in enumerate(grid.segments) if self._layout.imu_of[a] >= 0]
        if not felt:
            return np.zeros(len(grid.R))
        up_root = root[2]  # G's z in the root's B
        ups = np.einsum("kaij,i->kaj", grid.R[:, felt], up_root)
        apart = np.linalg.norm(ups - state.R_GB[grid.segments[felt], 2][None], axis=2)
        out: Array = np.sum((apart / TILT_SD) ** 2, axis=1)
        return out

    def _as_felt(self, R: Array, before: Array, segment: int) -> Array:
        """R (3, 3) rotated to the tilt of ``before``, which an IMU measures."""
        if self._layout.imu_of[segment] < 0:
            return R
        axis = np.cross(before[2], R[2])
        angle = float(np.arctan2(np.linalg.norm(axis), before[2] @ R[2]))
        if not 1e-6 < angle < MOST_TURN:
            return R
        turned: Array = R @ so3.exp(axis / np.linalg.norm(axis) * angle)
        return turned

    def doubtful(self, P: Array, digit: int) -> None:
        """Set the digit's rotations in P (N, N) to the uncertainty of a posture off the grid."""
        for a in self._postures_of(digit).segments:
            rows = self._layout.blocks.theta + 3 * int(a) + np.arange(3)
            P[rows, :] = 0.0
            P[:, rows] = 0.0
            P[rows, rows] = ROTATION_SD**2

    def _postures_of(self, digit: int) -> DigitPostures:
        if digit not in self._postures:
            self._postures[digit] = _made(self._layout, np.flatnonzero(self._digit == digit))
        return self._postures[digit]


def _at_most(markers: IntArray, points: IntArray) -> int:
    """Upper bound: markers of hues (m,) that points of hues (n,) can support, one point each."""
    hues = int(max(markers.max(initial=-1), points.max(initial=-1))) + 1
    there = np.bincount(points, minlength=hues), np.bincount(markers, minlength=hues)
    return int(np.minimum(*there).sum())


def _made(layout: ChainLayout, segments: IntArray) -> DigitPostures:
    """The grid over the joints of the active ``segments``, base first; other joints at 0 rad."""
    hand = layout.hand
    rest_R, rest_p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    of = hand.parent[layout.active[segments[0]]]
    R, p = [rest_R[of][None]], [np.zeros((1, 3))]
    for i in layout.active[segments]:
        parent = hand.parent[i]
        to_parent = rest_R[of].T @ rest_R[parent] @ hand.segments[i].R_rest
        joint = _joint_grid(layout, int(i))
        turned = R[-1][:, None] @ (to_parent @ joint)[None]
        origin = p[-1] + R[-1] @ (rest_R[of].T @ (rest_p[i] - rest_p[of]))
        R = [np.repeat(x, len(joint), axis=0) for x in R] + [turned.reshape(-1, 3, 3)]
        p = [np.repeat(x, len(joint), axis=0) for x in (*p, origin)]
        of = i
    rotation, place = np.stack(R[1:], axis=1), np.stack(p[1:], axis=1)
    markers = np.flatnonzero(np.isin(layout.marker_segment, segments))
    rows = np.searchsorted(segments, layout.marker_segment[markers])
    glove = layout.glove
    at = np.einsum("kmij,mj->kmi", rotation[:, rows], glove.marker_position[markers])
    normal = np.einsum("kmij,mj->kmi", rotation[:, rows], glove.marker_normal[markers])
    marker = place[:, rows] + at - place[:, :1]
    reach = float(np.sqrt((marker**2).sum(axis=2).max(initial=0.0)))
    # einsum and indexing may return another memory layout, which would compile the kernel again
    marker, normal = np.ascontiguousarray(marker), np.ascontiguousarray(normal)
    return DigitPostures(marker, normal, rotation, markers, segments, reach)


def _joint_grid(layout: ChainLayout, segment: int) -> Array:
    """(n, 3, 3) rotations of a segment's joint on the grid of its angles."""
    hand = layout.hand
    joint = hand.joint_of[hand.segments[segment].name]
    wide = "abduction" in joint.axes and np.ptp(joint.limits["abduction"]) >= WIDE
    steps = MOST_STEPS if wide else STEPS
    columns = [hand.angle_index[f"{joint.name}_{axis}"] for axis in joint.axes]
    values = [
        _steps(hand.angle_limits[c], steps[axis])
        for c, axis in zip(columns, joint.axes, strict=True)
    ]
    out, angles = [], np.zeros(len(hand.joint_names))
    for combination in product(*values):
        angles[columns] = combination
        out.append(hand.joint_rotation(segment, angles))
    return np.array(out)


def _steps(limits: Array, steps: int) -> Array:
    """Angles within the limits (2,), and that nearest to 0 rad."""
    low, high = limits.tolist()
    middle = [min(max(0.0, low), high)]
    inner = np.linspace(low, high, steps + 2)[1:-1] if steps > 1 else middle
    return np.unique(np.concatenate([inner, middle]))


@kernel
def posture_scores(
    marker: Stack,
    normal: Stack,
    R: Matrix,
    base: Vector,
    way: Vector,
    hue: IntVector,
    points: SupportPoints,
) -> Vector:
    """(K,) supported markers: marker and normal (K, m, 3) in axes R (3, 3) about base (3,), ``way``
    (3,) the unit vector to the camera; markers that face away do not count."""
    p_G, point_hue, reach2 = points.p_G, points.hue, points.radius * points.radius
    out = np.zeros(len(marker))
    for k in range(len(marker)):
        for j in range(marker.shape[1]):
            facing, at = 0.0, np.empty(3)
            for r in range(3):
                turned = 0.0
                at[r] = base[r]
                for s in range(3):
                    turned += R[r, s] * normal[k, j, s]
                    at[r] += R[r, s] * marker[k, j, s]
                facing += turned * way[r]
            weight = min(max((facing - FACING_COS) / 0.3, 0.0), 1.0)
            if weight <= 0.0:
                continue
            best = reach2
            for i in range(len(p_G)):
                if point_hue[i] == hue[j]:
                    d2 = 0.0
                    for r in range(3):
                        d2 += (p_G[i, r] - at[r]) ** 2
                    best = min(best, d2)
            out[k] += weight * (1.0 - best / reach2)
    return out
