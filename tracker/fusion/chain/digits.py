"""Looking for a digit whose markers are not where it is: other postures tried on stereo points.

A digit that starts wrong may stay wrong: its own markers lie outside its gates, its IMUs tell tilt
and turning but no heading. Postures on a grid of its joints' angles vote as whole hands do in
`start.search`; those that the accelerometers speak against count less.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.kinematics import marker_positions, segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import digit_of
from tracker.geometry import so3
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector
from tracker.messages import Array, IntArray

STEPS = {"flexion": 5, "abduction": 3, "twist": 1}  # of the grid, each joint axis
MOST_STEPS = {
    "flexion": 6,
    "abduction": 5,
    "twist": 1,
}  # of a widely abducting one
WIDE = 0.9  # rad between limits of abduction, from which a joint is such a one
RADIUS = 0.018  # m, within which a point supports a marker
TILT_SD = 0.3  # rad: the grid's own coarseness, and motion in the accelerometers
TILT_WEIGHT = 0.15  # markers that one sd² of tilt counts
FACING_COS = 0.25
ROTATION_SD = 0.25  # rad of a digit that was found so
BETTER = 1.0  # markers by which another posture must be supported more
MOST_TURN = 1.2  # rad by which a posture is turned to the tilt that is felt


class DigitPostures(NamedTuple):
    """K postures of one digit in the root's B, its base joint at the origin: marker (K, m, 3) m,
    normal (K, m, 3), up to scale; R (K, a, 3, 3) of its segments; rows of both in the layout."""

    marker: Stack
    normal: Stack
    R: Array
    markers: IntArray
    segments: IntArray


@dataclass(frozen=True, eq=False)
class SeenPoints:
    """Stereo points that may be the digit's: p_G (n, 3) m, hue (n,); camera at p_GC (3,)."""

    p_G: Array
    hue: IntArray
    p_GC: Array


class DigitSearch:
    """Postures of each digit of one hand, made when they are first needed."""

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        self._digit = digit_of(layout)
        self._postures: dict[int, DigitPostures] = {}

    def other(self, state: ChainState, digit: int, seen: SeenPoints) -> Array | None:
        """R_GB (A, 3, 3) with the digit in the posture that the points support best; None where
        that is the one it has."""
        grid = self._postures_of(digit)
        if len(seen.p_G) == 0 or len(grid.markers) == 0:
            return None
        root, base = state.R_GB[0], segment_positions(state, self._layout)[grid.segments[0]]
        length = float(state.scale[grid.segments, 0].mean())
        hue = self._layout.glove.marker_hue[grid.markers]
        way = seen.p_GC - base
        way /= np.linalg.norm(way)
        score = posture_scores(
            grid.marker * length, grid.normal, root, base, way, hue, seen.p_G, seen.hue
        )
        score -= TILT_WEIGHT * self._tilt_errors(state, grid, root)
        best = int(np.argmax(score))
        if score[best] <= self._present(state, grid, way, hue, seen) + BETTER:
            return None
        R = state.R_GB.copy()
        for i, a in enumerate(grid.segments):
            R[a] = self._as_felt(root @ grid.R[best, i], state.R_GB[a], int(a))
        return R

    def _present(
        self, state: ChainState, grid: DigitPostures, way: Array, hue: IntArray, seen: SeenPoints
    ) -> float:
        """Score of the posture that the digit has."""
        p_G = marker_positions(state, self._layout)[grid.markers][None]
        R = state.R_GB[self._layout.marker_segment[grid.markers]]
        normal = np.einsum("mij,mj->mi", R, self._layout.glove.marker_normal[grid.markers])[None]
        origin = np.zeros(3)
        return float(
            posture_scores(p_G, normal, np.eye(3), origin, way, hue, seen.p_G, seen.hue)[0]
        )

    def _tilt_errors(self, state: ChainState, grid: DigitPostures, root: Array) -> Array:
        """(K,) sum of squares, in sd, of what the digit's IMUs feel against each posture."""
        felt = [i for i, a in enumerate(grid.segments) if self._layout.imu_of[a] >= 0]
        if not felt:
            return np.zeros(len(grid.R))
        up_root = root[2]  # G's z in the root's B
        ups = np.einsum("kaij,i->kaj", grid.R[:, felt], up_root)
        apart = np.linalg.norm(ups - state.R_GB[grid.segments[felt], 2][None], axis=2)
        out: Array = np.sum((apart / TILT_SD) ** 2, axis=1)
        return out

    def _as_felt(self, R: Array, before: Array, segment: int) -> Array:
        """R (3, 3) turned so that it has the tilt of ``before``, which an IMU feels."""
        if self._layout.imu_of[segment] < 0:
            return R
        axis = np.cross(before[2], R[2])
        angle = float(np.arctan2(np.linalg.norm(axis), before[2] @ R[2]))
        if not 1e-6 < angle < MOST_TURN:
            return R
        turned: Array = R @ so3.exp(axis / np.linalg.norm(axis) * angle)
        return turned

    def doubtful(self, P: Array, digit: int) -> None:
        """Make the digit's rotations as unsure in P (N, N) as a posture off the grid is."""
        for a in self._postures_of(digit).segments:
            rows = self._layout.blocks.theta + 3 * int(a) + np.arange(3)
            P[rows, :] = 0.0
            P[:, rows] = 0.0
            P[rows, rows] = ROTATION_SD**2

    def _postures_of(self, digit: int) -> DigitPostures:
        if digit not in self._postures:
            self._postures[digit] = _made(self._layout, np.flatnonzero(self._digit == digit))
        return self._postures[digit]


def _made(layout: ChainLayout, segments: IntArray) -> DigitPostures:
    """The grid over the joints of the active ``segments``, base first."""
    hand = layout.hand
    columns, values = [], []
    for a in segments:
        joint = hand.joint_of[hand.segments[layout.active[a]].name]
        spread = [np.ptp(joint.limits[x]) for x in joint.axes if x == "abduction"]
        steps = MOST_STEPS if spread and spread[0] >= WIDE else STEPS
        for axis in joint.axes:
            column = hand.angle_index[f"{joint.name}_{axis}"]
            low, high = hand.angle_limits[column]
            middle = [min(max(0.0, low), high)]
            grid = np.linspace(low, high, steps[axis] + 2)[1:-1] if steps[axis] > 1 else middle
            columns.append(column)
            values.append(np.unique(np.concatenate([grid, middle])))
    markers = np.flatnonzero(np.isin(layout.marker_segment, segments))
    shape = len(markers), 3
    marker, normal, rotations = [], [], []
    for combination in product(*values):
        angles = np.zeros(len(hand.joint_names))
        angles[columns] = combination
        R, p = hand.forward(angles, np.eye(3), np.zeros(3))
        rows = layout.active[layout.marker_segment[markers]]
        base = p[layout.active[segments[0]]]
        at = np.einsum("mij,mj->mi", R[rows], layout.glove.marker_position[markers])
        marker.append((p[rows] + at - base).reshape(shape))
        normal.append(np.einsum("mij,mj->mi", R[rows], layout.glove.marker_normal[markers]))
        rotations.append(R[layout.active[segments]])
    return DigitPostures(np.array(marker), np.array(normal), np.array(rotations), markers, segments)


@kernel
def posture_scores(
    marker: Stack,
    normal: Stack,
    R: Matrix,
    base: Vector,
    way: Vector,
    hue: IntVector,
    points: Matrix,
    point_hue: IntVector,
) -> Vector:
    """(K,) markers that points support: marker and normal (K, m, 3) in axes R (3, 3) about base
    (3,), ``way`` (3,) the unit vector to the camera; a marker turned away has no say."""
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
            best = RADIUS * RADIUS
            for i in range(len(points)):
                if point_hue[i] == hue[j]:
                    d2 = 0.0
                    for r in range(3):
                        d2 += (points[i, r] - at[r]) ** 2
                    best = min(best, d2)
            out[k] += weight * (1.0 - best / (RADIUS * RADIUS))
    return out
