"""Finding the hand without a prior: posture from gravity, position by votes of same-hue pairs.

1. Every IMU measures gravity, so each segment's tilt is known; joint angles that agree with all
   tilts and are closest to a few typical postures are the articulations tried.
2. For each articulation and each heading on a grid, every pair (point seen, marker expected) of one
   hue proposes a translation; the translation that most markers support wins.

All same-hue stereo pairs take part, right and wrong ones: a wrong pair finds no support. Equation
numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, IntArray

TILT_SD = 0.15  # rad: bias, mounting and motion in one accelerometer direction
POSTURE_SD = 0.6  # rad around the typical posture
STEP = 1e-5  # rad, of the difference quotients
POSTURES = (0.0, 0.45, 1.0)  # share of full flexion: flat, relaxed, fist


@dataclass(frozen=True)
class SearchParams:
    """How an image is searched for a hand."""

    heading_step_deg: float = 10.0
    radius: float = 0.018  # m, within which a point supports a marker
    min_score: float = 0.45  # share of the expected markers that must be supported
    min_points: int = 5
    max_candidates: int = 2500
    facing_cos: float = 0.25


@dataclass(frozen=True, eq=False)
class Pose:
    """A hypothesis: R_GB (A, 3, 3), p (3,) of the root's IMU, score 0..1, supported markers."""

    R_GB: Array
    p: Array
    score: float
    support: int


@dataclass(frozen=True, eq=False)
class StereoPoints:
    """Stereo points of one image: p_G (n, 3), hue (n,); camera centre p_GC (3,)."""

    p_G: Array
    hue: IntArray
    p_GC: Array


def postures_from_gravity(
    layout: ChainLayout, R_IB: Array, force: Array, valid: Array
) -> list[Array]:
    """Articulations that agree with the accelerometers, R_GB (A, 3, 3) each, heading zero.

    force (n, 3) mean specific force per IMU in I; rows of invalid IMUs are ignored.
    """
    up_B = np.einsum("nji,nj->ni", R_IB, force)
    up_B /= np.maximum(np.linalg.norm(up_B, axis=1, keepdims=True), 1e-9)
    root = layout.imu_of[0]
    if root < 0 or not valid[root]:
        return []
    R_root = _level(up_B[root])
    out: list[Array] = []
    for share in POSTURES:
        angles = _fit_angles(layout, R_root, up_B, valid, _typical(layout, share))
        R, _ = layout.hand.forward(angles, R_root, np.zeros(3))
        out.append(R[layout.active])
    return _distinct(out)


def _level(up_B: Array) -> Array:
    """R_GB with G's z along ``up_B`` and heading zero (x of B as far ahead as possible)."""
    axis = np.array([1.0, 0, 0]) if abs(up_B[0]) < 0.9 else np.array([0, 0, 1.0])
    x_G = axis - (axis @ up_B) * up_B
    x_G /= np.linalg.norm(x_G)
    return np.array([x_G, np.cross(up_B, x_G), up_B])


def _typical(layout: ChainLayout, share: float) -> Array:
    """Joint angles of a posture with every flexion at ``share`` of that of a fist."""
    hand = layout.hand
    out = np.zeros(len(hand.joint_names))
    for joint in hand.joints:
        if "flexion" in joint.axes:
            i = hand.angle_index[f"{joint.name}_flexion"]
            out[i] = share * joint.fist * hand.angle_limits[i, 1]
    return out


def _fit_angles(
    layout: ChainLayout, R_root: Array, up_B: Array, valid: Array, typical: Array
) -> Array:
    """Gauss-Newton on tilts and posture prior with the joint limits as bounds (eq. 40)."""
    hand = layout.hand
    tilts = _Tilts(layout, R_root, up_B, valid)
    angles = typical.copy()
    for _ in range(6):
        R = tilts.rotations(angles)
        tilt, prior = tilts.residual(R), (angles - typical) / POSTURE_SD
        J = np.zeros((tilt.size + len(angles), len(angles)))
        for i in range(len(angles)):
            moved = angles.copy()
            moved[i] += STEP
            J[: tilt.size, i] = (tilts.residual(tilts.moved(R, moved, i)) - tilt) / STEP
            J[tilt.size + i, i] = ((moved[i] - typical[i]) / POSTURE_SD - prior[i]) / STEP
        r = np.concatenate([tilt, prior])
        step = np.linalg.solve(J.T @ J, -J.T @ r)
        angles = np.clip(angles + np.clip(step, -0.5, 0.5), *hand.angle_limits.T)
    return angles


class _Tilts:
    """Tilt residuals against the accelerometers. For a finite difference in one joint, only the
    affected segments are recomputed."""

    def __init__(self, layout: ChainLayout, R_root: Array, up_B: Array, valid: Array) -> None:
        hand, of_imu = layout.hand, layout.active[layout.imu_segment]
        use = [j for j in range(len(up_B)) if valid[j] and layout.imu_segment[j] != 0]
        self._hand, self._R_root = hand, R_root
        self._segments, self._up = of_imu[use], up_B[use]
        lines = [_line_to(hand, int(s)) for s in self._segments]
        self._rows = sorted({row for line in lines for row in line})
        self._with: list[list[int]] = [[] for _ in hand.joint_names]  # rows that an angle affects
        for row in self._rows:
            columns = {c for k in _line_to(hand, row) for c in hand.axis_columns[k] if c >= 0}
            for c in columns:
                self._with[c].append(row)

    def rotations(self, angles: Array) -> Array:
        """R_GB (S, 3, 3); segments that carry no IMU keep the identity."""
        R = np.tile(np.eye(3), (len(self._hand.segments), 1, 1))
        R[self._hand.root] = self._R_root
        return self._turn(R, self._rows, angles)

    def moved(self, R: Array, angles: Array, column: int) -> Array:
        """The result of `rotations` after a change of one of the ``angles``."""
        return self._turn(R.copy(), self._with[column], angles) if self._with[column] else R

    def residual(self, R: Array) -> Array:
        """(3 k,) of k accelerometers, in standard deviations."""
        return np.ravel(R[self._segments, 2] - self._up) / TILT_SD

    def _turn(self, R: Array, rows: list[int], angles: Array) -> Array:
        hand = self._hand
        for i in rows:
            R[i] = R[hand.parent[i]] @ hand.segments[i].R_rest @ hand.joint_rotation(i, angles)
        return R


def _line_to(hand: HandModel, row: int) -> list[int]:
    """Segments from the root's child to ``row``."""
    line: list[int] = []
    while hand.parent[row] >= 0:
        line.append(row)
        row = hand.parent[row]
    return line[::-1]


def _distinct(postures: list[Array], tolerance: float = 0.15) -> list[Array]:
    """Postures whose segments differ by more than ``tolerance`` rad somewhere."""
    out: list[Array] = []
    for R in postures:
        apart = [np.linalg.norm(so3.log(R.swapaxes(1, 2) @ K), axis=1).max() for K in out]
        if not apart or min(apart) > tolerance:
            out.append(R)
    return out


def vote(
    state: ChainState,
    layout: ChainLayout,
    postures: list[Array],
    headings: Array,
    seen: StereoPoints,
    params: SearchParams,
    most: int = 6,
) -> list[Pose]:
    """The best poses over all postures and headings (rad, added to each posture's), best first."""
    if len(seen.p_G) < params.min_points:
        return []
    poses: list[Pose] = []
    for R_posture in postures:
        for heading in headings:
            R = so3.rz(heading) @ R_posture
            pose = _vote_one(state, layout, R, seen, params)
            if pose is not None:
                poses.append(pose)
    poses.sort(key=lambda q: -q.score * q.support)
    return [
        q for q in poses[:most] if q.score >= params.min_score and q.support >= params.min_points
    ]


def _vote_one(
    state: ChainState, layout: ChainLayout, R: Array, seen: StereoPoints, params: SearchParams
) -> Pose | None:
    trial = state.copy_nominal()
    trial.R_GB, trial.p = R, np.zeros(3)
    m = marker_positions(trial, layout)
    normal = np.einsum("mij,mj->mi", R[layout.marker_segment], layout.glove.marker_normal)
    to_camera = seen.p_GC - np.median(seen.p_G, axis=0)
    to_camera /= np.linalg.norm(to_camera)
    weight = np.clip((normal @ to_camera - params.facing_cos) / 0.3, 0.0, 1.0)
    rows = np.flatnonzero(weight > 0)
    if len(rows) < params.min_points:
        return None
    shift, score, support = _best_shift(
        seen.p_G,
        seen.hue,
        m[rows],
        layout.glove.marker_hue[rows],
        weight[rows],
        params.radius,
        params.max_candidates,
    )
    return Pose(R, shift, score / float(weight.sum()), support)


@kernel
def _best_shift(
    points: Matrix,
    hue: IntVector,
    markers: Matrix,
    marker_hue: IntVector,
    weight: Vector,
    radius: float,
    most: int,
) -> tuple[Vector, float, int]:
    """The translation with the largest weighted support, refined to the mean of its supporters."""
    n, m = len(points), len(markers)
    sorted_points, first = _by_hue(points, hue, marker_hue.max())
    # 1. stride over pairs of one hue, so that at most ``most`` propose a translation
    pairs = 0
    for i in range(n):
        for j in range(m):
            if hue[i] == marker_hue[j]:
                pairs += 1
    stride = max(1, (pairs + most - 1) // most)
    # 2. all markers vote on each (eq. 41), until it cannot win any more
    best, best_shift, count = -1.0, np.zeros(3), 0
    for i in range(n):
        for j in range(m):
            if hue[i] != marker_hue[j]:
                continue
            count += 1
            if count % stride:
                continue
            t = points[i] - markers[j]
            s, left = 0.0, weight.sum()
            for k in range(m):
                if s + left <= best:
                    break
                own = sorted_points[first[marker_hue[k]] : first[marker_hue[k] + 1]]
                s += weight[k] * _support(own, markers[k], t, radius)
                left -= weight[k]
            if s > best:
                best, best_shift = s, t
    # 3. the winner is moved to the mean of its supporters
    return _refine(points, hue, markers, marker_hue, weight, radius, best_shift)


@kernel
def _by_hue(points: Matrix, hue: IntVector, highest: int) -> tuple[Matrix, IntVector]:
    """Points (n, 3) sorted by hue and within it by x; hue h starts at row ``first[h]``."""
    order = np.argsort(points[:, 0], kind="mergesort")
    out, first = np.empty_like(points), np.zeros(highest + 2, np.int64)
    n = 0
    for h in range(highest + 1):
        first[h] = n
        for i in order:
            if hue[i] == h:
                out[n] = points[i]
                n += 1
    first[highest + 1] = n
    return out, first


@kernel
def _support(points: Matrix, marker: Vector, t: Vector, radius: float) -> float:
    """1 at the marker, 0 at ``radius`` and beyond, for the nearest of the points (n, 3) of its hue,
    sorted by x."""
    best = radius * radius
    x = marker[0] + t[0]
    low, high = 0, len(points)
    while low < high:  # the first within reach along x
        middle = (low + high) // 2
        if points[middle, 0] < x - radius:
            low = middle + 1
        else:
            high = middle
    for i in range(low, len(points)):
        if points[i, 0] > x + radius:
            break
        d2 = 0.0
        for r in range(3):
            d = points[i, r] - marker[r] - t[r]
            d2 += d * d
        if d2 < best:
            best = d2
    return 1.0 - best / (radius * radius)


@kernel
def _refine(
    points: Matrix,
    hue: IntVector,
    markers: Matrix,
    marker_hue: IntVector,
    weight: Vector,
    radius: float,
    shift: Vector,
) -> tuple[Vector, float, int]:
    """Two rounds of weighted mean over supported markers. Returns shift, score, support."""
    score, support = 0.0, 0
    for _ in range(3):
        total, mean = 0.0, np.zeros(3)
        score, support = 0.0, 0
        for k in range(len(markers)):
            best, nearest = radius * radius, -1
            for i in range(len(points)):
                if hue[i] == marker_hue[k]:
                    d = points[i] - markers[k] - shift
                    d2 = d @ d
                    if d2 < best:
                        best, nearest = d2, i
            if nearest >= 0:
                w = weight[k] * (1.0 - best / (radius * radius))
                score += w
                support += 1
                total += w
                mean += w * (points[nearest] - markers[k])
        if total > 0:
            shift = mean / total
    return shift, score, support
