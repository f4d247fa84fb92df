"""The hand in the 3D scene: segments, markers, fingertip trails and the ground."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.viewmodels.hand_skin import scales
from app.words import tr
from tracker.hand.model import HandModel
from tracker.kernels.arrays import BoolVector
from tracker.messages import (
    RECENT,
    Array,
    Calibration,
    Estimate,
    FrameResult,
    IntArray,
    Tracking,
    Validity,
)

TRAIL_POINTS = 90  # 3 s of images at 30 a second
FOLLOW = 0.3
FOLLOW_S = 1 / 30
"""Relative movement of the view's centre towards the hand in this time, independent of the frame
rate."""
JUMP = 0.25  # m; a hand this far from the view's centre is centred at once
SIDE_OFFSET = 0.09  # m from the centre, of each of two hands whose position is unknown
MARKER_NEVER, MARKER_RECENT, MARKER_NOW = 0, 1, 2


CELL = 0.05  # m
HALF = 6  # cells from the centre to the edge
UNDER = 0.06  # m, minimum distance of the ground below the hand when it is placed
FAR = 0.3  # m above the ground at which the ground is placed again
AXIS = CELL  # m, length of the drawn axes, with the scale next to one of them
STRONG, FAINT = 0.34, 0.16  # every second line, and those between


WIDEST = 0.0024  # m, at the fingertip
SMOOTH = np.array([1.0, 2.0, 3.0, 2.0, 1.0]) / 9.0


def ribbon_faces(points: int) -> IntArray:
    """(F, 3) triangles of a ribbon of so many points, visible from both sides."""
    i = 2 * np.arange(points - 1)
    one = np.concatenate([np.stack([i, i + 1, i + 2], 1), np.stack([i + 2, i + 1, i + 3], 1)])
    return np.concatenate([one, one[:, ::-1]])


def ribbon(trail: Array, eye: Array, colour: tuple[float, ...]) -> tuple[Array, Array, Array]:
    """Points (2N, 3) m, normals (2N, 3) and looks (2N, 7) along a trail (N, 3), oldest first."""
    padded = np.concatenate([trail[[0, 0]], trail, trail[[-1, -1]]])
    path = sum(w * padded[k : k + len(trail)] for k, w in enumerate(SMOOTH))
    path[-1] = trail[-1]
    forward = np.gradient(path, axis=0)
    to_eye = eye - path
    side = np.cross(forward, to_eye)
    length = np.linalg.norm(side, axis=1, keepdims=True)
    side = np.where(length > 1e-9, side / np.maximum(length, 1e-9), 0.0)
    age = np.linspace(0.0, 1.0, len(trail))[:, None]
    half = 0.5 * WIDEST * (0.25 + 0.75 * age) * side
    points = np.stack([path - half, path + half], axis=1).reshape(-1, 3)
    normals = np.repeat(to_eye / np.linalg.norm(to_eye, axis=1, keepdims=True), 2, axis=0)
    looks = np.tile([*colour, 1.0, 0.6, 0.0, 0.0], (len(points), 1))
    looks[:, 3] = np.repeat(age[:, 0], 2)
    return points, normals, looks


@dataclass(frozen=True, eq=False)
class GroundGrid:
    """Lines (M, 6) m in G from end to end with strength (M,); corner (3,), the position of the
    axes."""

    ends: Array
    strength: Array
    corner: Array


class HandGround:
    """A grid that stays in place until the hand leaves it."""

    def __init__(self) -> None:
        self._middle: Array | None = None
        self.grid = GroundGrid(np.empty((0, 6)), np.empty(0), np.zeros(3))

    def follow(self, points: Array) -> bool:
        """Place the grid below the points (N, 3) m of a hand; whether it has moved."""
        low, at = float(points[:, 2].min()), points.mean(axis=0)
        if self._middle is not None:
            above, offset = low - self._middle[2], np.abs(at - self._middle)[:2].max()
            if 0.0 < above < FAR and offset < 2 * CELL:
                return False
        height = CELL * np.floor((low - UNDER) / CELL)
        self._middle = np.array([*(2 * CELL * np.round(at[:2] / (2 * CELL))), height])
        self.grid = _grid(self._middle)
        return True


def _grid(middle: Array) -> GroundGrid:
    reach, ends, strength = HALF * CELL, [], []
    for k in range(-HALF, HALF + 1):
        share = (STRONG if k % 2 == 0 else FAINT) * (1.0 - (k / (HALF + 1)) ** 2)
        for axis in (0, 1):
            across, along = np.zeros(3), np.zeros(3)
            across[axis], along[1 - axis] = k * CELL, reach
            ends.append([*(middle + across - along), *(middle + across + along)])
            strength.append(share)
    corner = middle + [-2 * CELL, -2 * CELL, 0.0]
    return GroundGrid(np.array(ends), np.array(strength), corner)


@dataclass(frozen=True)
class ShownParts:
    """Optional parts of the 3D view."""

    markers: bool = True
    uncertainty: bool = True
    camera: bool = True
    reference: bool = True
    axes: bool = False
    trail: bool = False


@dataclass(frozen=True, eq=False)
class HandScene:
    """The contents of the 3D view, all in G.

    segment_R (S, 3, 3), segment_p (S, 3); segment_state (S,) `Validity`; markers (M, 3) m;
    marker_state (M,); tips (T, 3) m, tip_sd (T,) m; scale (S, 3) of the wearer; reference, the
    second hand (R (S, 3, 3), p (S, 3)) or None; reference_points (K, 3) m, its keypoints where the
    whole hand is not known, otherwise NaN; R_GC, p_GC of the camera; trail (`TRAIL_POINTS`, 3)
    m, path of a fingertip, oldest first.
    """

    segment_R: Array
    segment_p: Array
    segment_state: IntArray
    markers: Array
    marker_state: IntArray
    tips: Array
    tip_sd: Array
    scale: Array
    reference: tuple[Array, Array] | None
    reference_points: Array
    R_GC: Array
    p_GC: Array
    caption: str
    trail: Array


class HandSceneModel:
    """Creates a `HandScene` from each snapshot; stores when each marker was last matched."""

    def __init__(self, setup: EngineSetup, of_two: bool = False) -> None:
        """``of_two``: another hand is drawn, too; a hand of unknown position is drawn on its own
        side."""
        self._setup = setup
        offset = {"left": SIDE_OFFSET, "right": -SIDE_OFFSET}[setup.side] if of_two else 0.0
        self._nowhere = np.array([0.0, offset, 0.0])
        names = setup.glove.keypoint_names(setup.hand)
        self._tip_rows = [i for i, n in enumerate(names) if n.endswith("_tip")]
        self._marker_segment = setup.glove.marker_segment(setup.hand)
        self._seen_at = np.full(len(setup.glove.markers), -np.inf)
        self._last: tuple[Array, Array] | None = None
        self._trail_of: int | None = None
        self._trail: deque[Array] = deque(maxlen=TRAIL_POINTS)
        self._no_trail = np.full((TRAIL_POINTS, 3), np.nan)
        self._no_points = np.full((len(names), 3), np.nan)
        self._scaled: tuple[Calibration | None, Array] = None, scales(setup.hand, None)

    @property
    def tip_names(self) -> list[str]:
        """Fingertips with an optional trail."""
        names = self._setup.glove.keypoint_names(self._setup.hand)
        return [names[i].removesuffix("_tip") for i in self._tip_rows]

    def set_trail(self, tip: str) -> None:
        """Draw the path of this fingertip; empty for none."""
        names = self.tip_names
        self._trail_of = self._tip_rows[names.index(tip)] if tip in names else None
        self._trail.clear()

    def _trail_points(self, estimate: Estimate) -> Array:
        """(`TRAIL_POINTS`, 3), padded with the oldest point; all NaN without a trail."""
        if self._trail_of is not None and np.isfinite(estimate.keypoints[self._trail_of]).all():
            self._trail.append(estimate.keypoints[self._trail_of])
        if not self._trail:
            return self._no_trail
        points, out = np.array(self._trail), np.empty((TRAIL_POINTS, 3))
        out[: TRAIL_POINTS - len(points)] = points[0]
        out[TRAIL_POINTS - len(points) :] = points
        return out

    def _scale(self, calibration: Calibration | None) -> Array:
        """(S, 3), computed again only for another calibration."""
        if calibration is not self._scaled[0]:
            self._scaled = calibration, scales(self._setup.hand, calibration)
        return self._scaled[1]

    def scene(self, view: Snapshot, with_reference: bool = False) -> HandScene | None:
        """The scene; None before the first estimate with a pose."""
        estimate = view.estimate
        if estimate is None:
            return None
        located = estimate.tracking != Tracking.LOST
        located = located and bool(np.isfinite(estimate.segment_p).all())
        if located:
            self._last = (estimate.segment_R, estimate.segment_p)
        elif np.isfinite(estimate.segment_p).all() and np.isfinite(estimate.segment_R).all():
            self._last = (estimate.segment_R, self._at_last_place(estimate.segment_p))
        if self._last is None:
            return None
        R, p = self._last
        other = view.reference() if with_reference else None
        scale = self._scale(view.calibration)
        pose = view.setup.camera.rig.pose
        if view.frame is not None and view.frame.pose is not None:
            pose = view.frame.pose
        return HandScene(
            segment_R=R,
            segment_p=p,
            segment_state=self._segment_states(view, estimate, located),
            markers=self._markers(R, p, scale),
            scale=scale,
            marker_state=self._marker_states(view.result, estimate.t),
            tips=estimate.keypoints[self._tip_rows],
            tip_sd=estimate.keypoint_sd[self._tip_rows],
            reference=(other.R_GB, other.p_GB) if other is not None and other.is_whole else None,
            reference_points=(
                other.keypoints if other is not None and not other.is_whole else self._no_points
            ),
            R_GC=pose.R_GC,
            p_GC=pose.p_GC,
            trail=self._trail_points(estimate),
            caption=self._caption(view, estimate, located),
        )

    def _segment_states(self, view: Snapshot, estimate: Estimate, located: bool) -> IntArray:
        """All lost if neither glove nor camera sends data any more."""
        if len(view.imu) > 0 and not (view.packets_arrive or view.images_arrive):
            return np.full(len(view.setup.hand.segments), int(Validity.LOST), np.int64)
        return segment_states(view.setup.hand, estimate, located)

    def _at_last_place(self, p_GB: Array) -> Array:
        """(S, 3) m: a hand of unknown position turns and bends at the last position of its root."""
        place = self._last[1][0] if self._last is not None else self._nowhere
        return np.asarray(p_GB - p_GB[0] + place)

    def _caption(self, view: Snapshot, estimate: Estimate, located: bool) -> str:
        if len(view.imu) > 0 and not (view.packets_arrive or view.images_arrive):
            return tr("No data. Showing the last pose.")
        if located:
            return ""
        if view.setup.player is not None and not np.isfinite(estimate.angles).any():
            return tr("No estimates here. Showing the last pose.")
        if self._setup.whole:
            return tr("Position lost. Showing the last known position.")
        return tr("Position unknown. Orientation and finger angles from the IMUs only.")

    def _markers(self, R: Array, p: Array, scale: Array) -> Array:
        """(M, 3) m in G."""
        seg = self._marker_segment
        at = self._setup.glove.marker_position * scale[seg]
        return np.asarray(p[seg] + np.einsum("mij,mj->mi", R[seg], at))

    def _marker_states(self, result: FrameResult | None, t: float) -> IntArray:
        states = np.full(len(self._seen_at), MARKER_NEVER, np.int64)
        if result is not None:
            matched = (result.match_left >= 0) | (result.match_right >= 0)
            self._seen_at[matched] = result.t
            states[t - self._seen_at < RECENT] = MARKER_RECENT
            states[matched & (result.visible >= 0)] = MARKER_NOW
        return states


def view_direction(name: str, R_GB: Array) -> Array:
    """(3,) direction from a dorsum of rotation ``R_GB`` (3, 3) to the viewer: "back", "palm" or
    "side"."""
    x, y, z = R_GB.T
    return {"back": z - 0.35 * x, "palm": -z - 0.35 * x, "side": y + 0.2 * z}[name]


def followed(
    target: Array, scenes: Sequence[HandScene], found_before: bool, elapsed: float = FOLLOW_S
) -> Array:
    """(3,) new centre of the view, moved from ``target`` towards the hand or the centre of both
    within ``elapsed`` s; immediately if a hand has just been found or is far away."""
    share = 1.0 - (1.0 - FOLLOW) ** (max(elapsed, 0.0) / FOLLOW_S)
    centre = np.mean([scene.segment_p.mean(axis=0) for scene in scenes], axis=0)
    near = found_before and float(np.linalg.norm(centre - target)) < JUMP
    return np.asarray(target + (share if near else 1.0) * (centre - target))


@lru_cache(maxsize=4)
def _state_columns(hand: HandModel) -> tuple[IntArray, BoolVector]:
    """(S, 3) columns of each segment's angles, repeated where it has fewer; (S,) whether its state
    is that of the position: it is the root or has no angle."""
    columns = np.zeros((len(hand.segments), 3), np.int64)
    for row, known in zip(columns, hand.axis_columns, strict=True):
        own = [c for c in known if c >= 0]
        row[:] = (own * 3)[:3] if own else 0
    rigid = (np.array(hand.axis_columns) < 0).all(axis=1) | (np.array(hand.parent) < 0)
    return columns, rigid


def segment_states(hand: HandModel, estimate: Estimate, located: bool) -> IntArray:
    """(S,) state of each segment: the worst of its joint's angles; the root as the wrist, and lost
    if the position is."""
    columns, rigid = _state_columns(hand)
    out = estimate.angle_state[columns].min(axis=1).astype(np.int64)
    out[rigid] = estimate.keypoint_state[0] if located else Validity.LOST
    return out
