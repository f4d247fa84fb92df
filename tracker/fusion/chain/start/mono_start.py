"""Finding the hand in one image: IMUs determine the posture, the hand's size its distance.

`search` votes for a translation among stereo points. With one camera there are only rays: for each
posture, heading and distance on a grid, every pair (blob seen, marker expected) of one hue proposes
a position, and the one supported by most blobs wins. The best ones are then refined in all three
directions: by perspective, near markers are farther apart, which determines the distance as
accurately as the size of the hand is known. Equation numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.start.search import Pose
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, CameraPose, IntArray

SIZE_KEPT = 0.1  # factor on the size's standard deviation at a start with one camera
SIZE_SD = 0.065  # relative, of the population: the distance uncertainty after such a start
UNMEASURED = 0.05  # from which on nothing is known beyond the population
ROUGH = 0.04  # up to which the size is known well enough for errors to be normal
COVERING = 1.3  # times the size's sd, in the sd of points: `with_distance_uncertainty`
UNKNOWN_COVERING = 2.0  # likewise while nothing is known beyond the population
KNOWN_SIZE_SD = 0.015  # lower limit: with a ruler, or two cameras
WRONG = 0.05  # m, maximum error of a measured point
SIZE_SDS, POSE_SDS = 2.2, 4.0  # standard deviations of size and pose within that
UNMEASURED_SDS = 3.0  # the former while nothing is known about the size


@dataclass(frozen=True)
class MonoParams:
    """How one image is searched. Lengths in m."""

    nearest: float = 0.20
    farthest: float = 0.75
    distances: int = 8  # of a geometric grid
    radius: float = 0.012  # across the ray, within which a blob supports a marker
    min_score: float = 0.55  # share of the expected markers that must be supported
    min_support: int = 6
    facing_cos: float = 0.25
    distance_sd: float = 0.10  # relative uncertainty of a hand's size


@dataclass(frozen=True, eq=False)
class Rays:
    """Blobs of one camera: direction (n, 2) at depth 1 in C, hue (n,); its position camera_C (3,)
    m."""

    direction: Array
    hue: IntArray
    camera_C: Array


def vote_mono(
    state: ChainState,
    layout: ChainLayout,
    postures: list[Array],
    headings: Array,
    rays: Rays,
    pose: CameraPose,
    params: MonoParams | None = None,
) -> Pose | None:
    """The best pose over all postures and headings (rad, added to each posture's), if unambiguous.

    R_GB (A, 3, 3) of each posture; the pose is that of the root's IMU in G.
    """
    params = params or MonoParams()
    if len(rays.direction) < params.min_support:
        return None
    best: Pose | None = None
    for R_posture in postures:
        for heading in headings:
            found = _vote_one(state, layout, so3.rz(heading) @ R_posture, rays, pose, params)
            if found is not None and (best is None or _rank(found) > _rank(best)):
                best = found
    if best is None or best.score < params.min_score or best.support < params.min_support:
        return None
    return best


def fix_size(state: ChainState, layout: ChainLayout, p_GC: Array, share: float) -> None:
    """Fixes the size, and adds ``share`` of the distance from the camera at p_GC (3,) m as its
    sd."""
    ray = state.p - p_GC
    state.P[:3, :3] += share**2 * np.outer(ray, ray)  # eq. 43
    keep_size(state.P, layout)


def keep_size(P: Array, layout: ChainLayout) -> None:
    """Reduces the size covariance: one camera cannot separate hand size and distance."""
    rows = slice(layout.blocks.scale, layout.blocks.joint)
    P[rows, :] *= SIZE_KEPT  # eq. 43
    P[:, rows] *= SIZE_KEPT


def release_size(P: Array, layout: ChainLayout, prior: PriorParams) -> None:
    """Restores the size covariance once the second camera sees the hand."""
    rows = slice(layout.blocks.scale, layout.blocks.joint)
    P[rows, rows] += initial_covariance(layout, prior)[rows, rows]


def with_distance_uncertainty(sd: Array, p: Array, pose: CameraPose, size_sd: float) -> Array:
    """sd (n,) m of points p (n, 3) m in G, whose relative distance uncertainty is that of the
    hand's size: with a wrong size, all points are moved along their rays in the same ratio.

    As in `Estimate.keypoint_sd`, the root of the mean variance over three axes, one of which is the
    ray. An error along one axis exceeds three of these for 8 % of people, and lasts. For 3 % of
    people, as for errors along three axes, √3 of them must be 2.17 standard deviations of the size.
    While nothing is known about the size, the points of each person are to be covered, not those of
    97 of 100: √3 of them are 22.5 %. The 99th percentile of people is 19 %: hand length 189 mm ±
    6.1 % (ANSUR II) while the file's is 183 mm, and girth varies by 5.4 % given the length, which
    counts half, since the markers' distances along and across the hand show the distance; errors of
    posture add to it.
    """
    ray = np.linalg.norm(p - pose.p_GC, axis=1)
    out: Array = np.sqrt(sd**2 + (_covering(size_sd) * ray) ** 2 / 3)  # eq. 44
    return out


def _covering(size_sd: float) -> float:
    """The relative size uncertainty in the sd of points."""
    unknown = min(max((size_sd - ROUGH) / (UNMEASURED - ROUGH), 0.0), 1.0)
    return size_sd * (COVERING + unknown * (UNKNOWN_COVERING - COVERING))


def assumed_size_sd(known_sd: float) -> float:
    """Relative uncertainty assumed for a size known to ``known_sd`` (relative)."""
    return min(max(known_sd, KNOWN_SIZE_SD), SIZE_SD)


def measured_sd(p: Array, pose: CameraPose, size_sd: float) -> float:
    """m, result of `with_distance_uncertainty` for a hand at p (3,) m in G with relative size
    uncertainty ``size_sd``: points with a larger sd may be wrong by more than `WRONG`.

    A wrong size persists as long as the hand is in view, and pose errors act along the ray as well,
    so they add up.
    """
    ray = float(np.linalg.norm(p - pose.p_GC))
    sds = UNMEASURED_SDS if size_sd >= UNMEASURED else SIZE_SDS
    sd = max(WRONG - sds * size_sd * ray, 0.0) / POSE_SDS
    return float(np.sqrt(sd**2 + (_covering(size_sd) * ray) ** 2 / 3)) if sd > 0.0 else 0.0


def _rank(pose: Pose) -> float:
    return pose.score * pose.support


def _vote_one(
    state: ChainState,
    layout: ChainLayout,
    R: Array,
    rays: Rays,
    pose: CameraPose,
    params: MonoParams,
) -> Pose | None:
    trial = state.copy_nominal()
    trial.R_GB, trial.p = R, np.zeros(3)
    m_C = marker_positions(trial, layout) @ pose.R_GC
    normal_G = np.einsum("mij,mj->mi", R[layout.marker_segment], layout.glove.marker_normal)
    middle = np.array([*np.median(rays.direction, axis=0), 1.0])
    to_camera = -(pose.R_GC @ middle) / np.linalg.norm(middle)
    weight = np.clip((normal_G @ to_camera - params.facing_cos) / 0.3, 0.0, 1.0)
    rows = np.flatnonzero(weight > 0)
    if len(rows) < params.min_support:
        return None
    depths = np.geomspace(params.nearest, params.farthest, params.distances)
    position, score, support = best_position(
        rays.direction,
        rays.hue,
        np.ascontiguousarray(m_C[rows]),
        layout.glove.marker_hue[rows],
        weight[rows],
        depths,
        params.radius,
    )
    p_G = pose.R_GC @ (position + rays.camera_C) + pose.p_GC
    return Pose(R, p_G, score / float(weight.sum()), support)


@kernel
def best_position(
    seen: Matrix,
    hue: IntVector,
    markers: Matrix,
    marker_hue: IntVector,
    weight: Vector,
    depths: Vector,
    radius: float,
) -> tuple[Vector, float, int]:
    """The translation (3,) m in the camera's axes with the largest weighted support.

    seen (n, 2) at depth 1; markers (m, 3) m relative to the unknown position. Returns the refined
    position, its weighted support and the number of supported markers.
    """
    best, position = -1.0, np.zeros(3)
    t = np.zeros(3)
    # 1. every pair of one hue proposes a position at each distance of the grid; all markers vote
    for z in depths:
        t[2] = z
        for i in range(len(seen)):
            for j in range(len(markers)):
                if hue[i] != marker_hue[j]:
                    continue
                for a in range(2):
                    t[a] = seen[i, a] * (markers[j, 2] + z) - markers[j, a]  # eq. 42
                total = 0.0
                for k in range(len(markers)):
                    d2, _ = _nearest(seen, hue, markers[k], marker_hue[k], t)
                    total += weight[k] * max(0.0, 1.0 - d2 / radius**2)
                if total > best:
                    best, position = total, t.copy()
    # 2. the winner is refined in all three directions
    return _fit(seen, hue, markers, marker_hue, weight, radius, position)


@kernel
def _nearest(
    seen: Matrix, hue: IntVector, marker: Vector, marker_hue: int, t: Vector
) -> tuple[float, int]:
    """Squared distance (m²) across the ray of the nearest blob of the marker's hue, and its row."""
    z = max(marker[2] + t[2], 0.02)
    best, row = np.inf, -1
    for i in range(len(seen)):
        if hue[i] == marker_hue:
            x = seen[i, 0] * z - marker[0] - t[0]
            y = seen[i, 1] * z - marker[1] - t[1]
            if x * x + y * y < best:
                best, row = x * x + y * y, i
    return best, row


@kernel
def _fit(
    seen: Matrix,
    hue: IntVector,
    markers: Matrix,
    marker_hue: IntVector,
    weight: Vector,
    radius: float,
    position: Vector,
) -> tuple[Vector, float, int]:
    """Rounds of least squares over supported markers, in the position's three directions."""
    t, score, support = position.copy(), 0.0, 0
    for _ in range(4):
        A, b = np.zeros((3, 3)), np.zeros(3)
        score, support = 0.0, 0
        for k in range(len(markers)):
            d2, i = _nearest(seen, hue, markers[k], marker_hue[k], t)
            if d2 >= radius * radius:
                continue
            w = weight[k] * (1.0 - d2 / radius**2)
            score += w
            support += 1
            for a in range(2):  # seen * (z_marker + t_z) - (marker + t) = 0 across the ray
                row = np.zeros(3)
                row[a], row[2] = -1.0, seen[i, a]
                A += w * np.outer(row, row)
                b += w * row * (markers[k, a] - seen[i, a] * markers[k, 2])
        if support < 4:
            break
        A[2, 2] += 1e-3 * A[0, 0]  # flat patterns do not determine the distance: keep the grid's
        b[2] += 1e-3 * A[0, 0] * t[2]
        t[:] = np.linalg.solve(A, b)
    return t, score, support
