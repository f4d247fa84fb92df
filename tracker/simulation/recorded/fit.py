"""Fits a skeleton to recorded points: scale, positions of the points, and the pose of each
frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.hand.model import HandModel
from tracker.hand.names import KEYPOINTS
from tracker.messages import Array, IntArray
from tracker.simulation.kinematics import forward_many
from tracker.simulation.recorded.solver import FittedSkeleton, PointTargets, Posture, solve_frames
from tracker.simulation.recorded.track import PointTrack


@dataclass(frozen=True)
class SkeletonFitParams:
    """Standard deviations of the fit's terms."""

    point: float = 0.003  # m
    rest: float = 1.0  # rad, of an angle about zero
    change: float = 0.15  # rad between two frames
    synergy: float = 0.3  # rad
    iterations: int = 4
    rounds: int = 3  # of refining the positions of the points
    keep: float = 0.3  # weight of a point's nominal position in each round


@dataclass(frozen=True, eq=False)
class RecordedFit:
    """angles (n, J) rad, R_GB (n, 3, 3), p_GB (n, 3) m of the dorsum in the file's frame, scaled to
    the hand; residual (n, T) m, NaN for missing points."""

    angles: Array
    R_GB: Array
    p_GB: Array
    residual: Array


def fit_hand(
    hand: HandModel, track: PointTrack, params: SkeletonFitParams | None = None
) -> RecordedFit:
    """Angles and poses that align the hand's points with the track's, for all frames."""
    p = params or SkeletonFitParams()
    segment, local = _targets(hand, track.targets)
    k = _most_open(track)
    scale, R, origin = _umeyama(hand, segment, local, track.points[k])
    points = track.points / scale
    start = np.zeros(len(hand.joint_names)), R, origin / scale
    _place_on_dorsum(hand, local, points[k], start[1], start[2])
    nominal = local.copy()
    for _ in range(p.rounds):
        fit = _solve(hand, segment, local, points[k::-1], start, p)
        start = fit.angles[-1], fit.R_GB[-1], fit.p_GB[-1]
        fit = _solve(hand, segment, local, points, start, p)
        local = _refined(hand, fit, segment, points, nominal, p.keep)
        start = fit.angles[k], fit.R_GB[k], fit.p_GB[k]
    return fit


def _solve(
    hand: HandModel,
    segment: IntArray,
    local: Array,
    points: Array,
    start: tuple[Array, Array, Array],
    p: SkeletonFitParams,
) -> RecordedFit:
    weights = 1 / np.array([p.point, p.rest, p.change, p.synergy])
    posture = Posture(*(np.ascontiguousarray(x) for x in start))
    points = np.ascontiguousarray(points)
    targets = PointTargets(segment, local)
    return RecordedFit(
        *solve_frames(_skeleton(hand), targets, points, posture, weights, p.iterations)
    )


def _skeleton(hand: HandModel) -> FittedSkeleton:
    index = hand.angle_index
    coupling = [[index[s.angle], index[s.of], s.ratio, s.offset] for s in hand.synergies]
    limits = np.ascontiguousarray(hand.angle_limits, float)
    return FittedSkeleton(*_tree(hand), limits, np.array(coupling, float).reshape(-1, 4))


def _tree(hand: HandModel) -> tuple[IntArray, Array, Array, IntArray]:
    """parent (S,), origin (S, 3), R_rest (S, 3, 3) and angle columns (S, 3) of the skeleton."""
    return (
        np.array(hand.parent, np.int64),
        np.array([s.origin for s in hand.segments]),
        np.array([s.R_rest for s in hand.segments]),
        np.array(hand.axis_columns, np.int64),
    )


def _targets(hand: HandModel, targets: tuple[str, ...]) -> tuple[IntArray, Array]:
    """Segment row (T,) and position in B (T, 3); NaN for an unknown position on the dorsum."""
    segment, local = [], []
    for name in targets:
        if name.startswith("dorsum:"):
            segment.append(hand.index["dorsum"])
            local.append([np.nan] * 3)
            continue
        if name not in hand.keypoint_names:
            raise FileError(notice("motion.no_point", hand=hand.name, point=name))
        s = hand.segments[hand.index[KEYPOINTS[name][0]]]
        segment.append(hand.index[s.name])
        local.append([s.length if KEYPOINTS[name][1] else 0.0, 0.0, 0.0])
    return np.array(segment, np.int64), np.array(local)


def _most_open(track: PointTrack) -> int:
    """The complete frame with the largest spread of points: the flattest hand."""
    centred = track.points - np.nanmean(track.points, axis=1, keepdims=True)
    size = np.sum(np.sum(centred**2, axis=2), axis=1)  # NaN for missing points
    if not np.isfinite(size).any():
        raise FileError(notice("motion.never_whole"))
    return int(np.nanargmax(size))


def _umeyama(
    hand: HandModel, segment: IntArray, local: Array, points: Array
) -> tuple[float, Array, Array]:
    """scale, R and t with points ≈ scale R model + t for the flat hand (Umeyama 1991)."""
    R_GB, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    model = p[segment] + np.einsum("nij,nj->ni", R_GB[segment], local)
    known = np.isfinite(model[:, 0]) & np.isfinite(points[:, 0])
    x, y = model[known], points[known]
    dx, dy = x - x.mean(axis=0), y - y.mean(axis=0)
    U, D, Vt = np.linalg.svd(dy.T @ dx)
    sign = np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))])
    R = U @ sign @ Vt
    scale = float(np.trace(np.diag(D) @ sign) / np.sum(dx**2))
    return scale, R, y.mean(axis=0) - scale * R @ x.mean(axis=0)


def _place_on_dorsum(hand: HandModel, local: Array, points: Array, R: Array, p: Array) -> None:
    """Determine the positions of dorsum markers from the open frame."""
    unknown = np.isnan(local[:, 0])
    local[unknown] = (points[unknown] - p) @ R


def _refined(
    hand: HandModel, fit: RecordedFit, segment: IntArray, points: Array, nominal: Array, keep: float
) -> Array:
    """Each point's mean position in its segment over all frames, regularised towards the nominal
    one."""
    local = nominal.copy()
    untwisted = np.zeros(len(hand.segments))
    R_GB, p_GB = forward_many(*_tree(hand), untwisted, fit.angles, fit.R_GB, fit.p_GB)
    for i, s in enumerate(segment):
        seen = np.isfinite(points[:, i, 0])
        inside = np.einsum("nji,nj->ni", R_GB[seen, s], points[seen, i] - p_GB[seen, s])
        local[i] = keep * nominal[i] + (1 - keep) * np.median(inside, axis=0)
    return local
