"""Least squares over keyframes: one pose per keyframe, one calibration for all (eq. 45).

The work is divided into steps of one keyframe each, one step per image, so that no image is delayed
and the time at which the result is available depends on the data alone. The solution replaces the
filter's calibration: both are estimated from the same data, so they must not be fused. Equation
numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.bundle.keyframes import Keyframe, Keyframes
from tracker.fusion.chain.constraints import Constraints
from tracker.fusion.chain.guided.learning import CALIBRATION, GuidedLearning, calibration_error
from tracker.fusion.chain.kinematics import marker_jacobians, marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixel_rows import stack_rows
from tracker.fusion.chain.prediction import PosedRig, pixel_jacobians
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, profile_of
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.chain.tilt import tilt_rows
from tracker.geometry import so3
from tracker.messages import Array, IntArray
from tracker.vision.rig import StereoRig


class KeyframeRows:
    """Rows of pixels, anatomy and finger accelerometers for a keyframe, each divided by its noise.

    A marker's placement is a state here, so only the slip of the cloth remains as its noise.
    """

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._rig, self._params = layout, rig, params
        anatomy = replace(params.constraint, rotation=params.bundle.rotation)
        self._constraints = Constraints(layout, anatomy)

    def __call__(self, state: ChainState, frame: Keyframe) -> tuple[Array, Array]:
        """H (m, N) and residual r (m,) at ``state``, both scaled to unit noise."""
        H_px, r_px = self._pixels(state, frame)
        H_c, r_c, variance = self._constraints.rows(state)
        parts = [(H_px, r_px), _scaled(H_c, r_c, variance)]
        tilt = tilt_rows(state, self._layout, self._params.constraint, frame.packets)
        if tilt is not None:
            parts.append(_scaled(*tilt))
        return np.concatenate([H for H, _ in parts]), np.concatenate([r for _, r in parts])

    def _pixels(self, state: ChainState, frame: Keyframe) -> tuple[Array, Array]:
        lay, rig, noise = self._layout, self._rig, self._params.noise
        rows = np.flatnonzero(np.isfinite(frame.uv[..., 0]).any(axis=0))
        p_G = marker_positions(state, lay)[rows]
        p_C = (p_G - frame.pose.p_GC) @ frame.pose.R_GC
        uv = np.stack([rig.project(p_C), rig.project(p_C, right=True)])
        H = marker_jacobians(state, lay, rows)
        A = pixel_jacobians(p_C, PosedRig.of(rig, frame.pose))
        slip = noise.pixel._replace(marker=self._params.bundle.slip)
        residual = np.ascontiguousarray(frame.uv[:, rows] - uv)
        H_px, _, r, R = stack_rows(H, np.zeros_like(H), A, residual, slip)
        L = np.linalg.cholesky(R)
        return np.linalg.solve(L, H_px), np.linalg.solve(L, r)


def _scaled(H: Array, r: Array, variance: Array) -> tuple[Array, Array]:
    sd = np.sqrt(variance)
    return H / sd[:, None], r / sd


ASK_EVERY = 0.03  # s
MOST_MISFIT = 1.5  # mean square of whitened residuals; about 0.2 for a well-tracked hand
MOST_SCALE = 0.35  # deviation from the file's size
MOST_ROTATION = 0.7  # rad of a mounting, about each axis
MOST_SHIFT = 0.008  # m of a marker, along each axis
POSITION_SD = 0.05  # m, prior sd of a keyframe's hand position about the filter's


@record(
    "chain.bundle", shapes={"p": "3", "R_GB": "A 3 3", "back": "b c", "N": "0 | n n", "g": "0 | n"}
)
@dataclass(eq=False)
class BundleWork:
    """What changes: stored postures and, while a solution is computed, the partial sums."""

    asked_at: float = -np.inf
    next_at: float = np.nan
    pause: float = 0.0
    keyframes: Keyframes = field(default_factory=Keyframes)
    frames: list[Keyframe] = field(default_factory=list)  # of the current solution
    p: list[Array] = field(default_factory=list)
    R_GB: list[Array] = field(default_factory=list)
    back: list[Array] = field(default_factory=list)  # (D, C + 1) pose change: gain and constant
    calibration: ChainState | None = None
    sweep: int = 0
    N: Array = field(default_factory=lambda: np.zeros(0))
    g: Array = field(default_factory=lambda: np.zeros(0))
    misfit: float = 0.0  # sum of squared whitened residuals in this sweep
    rows: int = 0


def resize_keyframes(work: BundleWork, factor: float, t: float) -> None:
    """The hand's size has changed by ``factor`` at ``t``: the hand of each keyframe is farther away
    in proportion. A solution in progress is started again."""
    kept = work.keyframes.stored
    kept[:] = [replace(f, p=f.pose.p_GC + factor * (f.p - f.pose.p_GC)) for f in kept]
    if work.calibration is not None:
        work.calibration, work.frames, work.p, work.R_GB, work.back = None, [], [], [], []
        work.pause, work.next_at = work.pause / 2, t


class WithoutPose(NamedTuple):
    """A keyframe's information N (C, C), g (C,) about the calibration, its pose eliminated, and the
    pose's change ``back`` (D, C + 1): gain and constant."""

    N: Array
    g: Array
    back: Array


class KeyframePose(NamedTuple):
    """Error states ``moves`` (D,) of a keyframe's pose, ``stiff`` (D,) the inverse variances of its
    prior, and ``away`` (D,) its deviation from it."""

    moves: IntArray
    stiff: Array
    away: Array


def without_pose(H: Array, r: Array, pose: KeyframePose, n: int) -> WithoutPose:
    """Rows H (m, N) and residual r (m,) of unit noise with the pose eliminated: Schur complement
    (eq. 46). The calibration begins at the error state ``n``."""
    D, G = H[:, pose.moves], H[:, n:]
    A = D.T @ D + np.diag(pose.stiff)
    B = np.column_stack([D.T @ G, D.T @ r - pose.stiff * pose.away])
    back = np.asarray(np.linalg.solve(A, B), float)
    N = G.T @ G - B[:, :-1].T @ back[:, :-1]
    return WithoutPose(N, G.T @ r - B[:, :-1].T @ back[:, -1], back)


def pose_prior(layout: ChainLayout, orientation: float) -> tuple[IntArray, Array]:
    """``moves`` and ``stiff`` of a keyframe's pose, with the sd ``orientation`` (rad)."""
    moves = np.r_[0:3, layout.blocks.theta : layout.n_dynamic]
    stiff: Array = np.full(len(moves), orientation**-2)
    stiff[:3] = POSITION_SD**-2
    return moves, stiff


def off_nominal(state: ChainState | WearerProfile, layout: ChainLayout) -> Array:
    """(C,) deviation of a calibration from the nominal values in the files."""
    fresh = initial_state(layout)
    return np.concatenate(
        [
            state.bg.ravel(),
            so3.log(layout.R_IB.swapaxes(1, 2) @ state.R_IB).ravel(),
            state.ba.ravel(),
            (state.scale - fresh.scale).ravel(),
            state.joint.ravel(),
            state.marker.ravel(),
            state.axis,
        ]
    )


class SideInformation(NamedTuple):
    """Information besides the keyframes: from guided poses and (None: population prior) the
    wearer."""

    poses: GuidedLearning
    known: WearerProfile | None


class Bundle:
    """Keyframe calibration of one chain filter; itself immutable."""

    def __init__(
        self,
        layout: ChainLayout,
        rig: StereoRig,
        params: ChainParams,
        most_shift: float = MOST_SHIFT,
    ) -> None:
        """A solution with a marker more than ``most_shift`` m off is discarded."""
        self._layout, self._params, self._most_shift = layout, params.bundle, most_shift
        self._rows = KeyframeRows(layout, rig, params)
        n = layout.n_dynamic
        before = initial_covariance(layout, params.prior)[n:, n:]
        self._information = np.asarray(np.linalg.inv(before), float)
        self._moves, self._stiff = pose_prior(layout, params.bundle.orientation)

    def wants(self, work: BundleWork, t: float) -> bool:
        """Whether the next posture is due: at most thirty per second."""
        if t - work.asked_at < ASK_EVERY:
            return False
        work.asked_at = t
        return True

    def lacks(self, work: BundleWork, relative: Array) -> bool:
        """Whether a posture (`Keyframe.relative`) is new."""
        return work.keyframes.lacks(relative, self._params)

    def offer(self, work: BundleWork, frame: Keyframe | None) -> None:
        """Store a posture."""
        if frame is not None:
            work.keyframes.offer(frame, self._params)

    def step(
        self, work: BundleWork, state: ChainState, extra: SideInformation | None = None
    ) -> WearerProfile | None:
        """Processes one keyframe; returns the wearer profile once a solution is complete.

        The information in ``extra`` is included.
        """
        if work.calibration is None:
            self._begin_when_due(work, state, extra)
            return None
        k = len(work.back)
        self._linearise(work, k)
        if len(work.back) < len(work.frames):
            return None
        return self._move_on(work, extra)

    # ---- one solution

    def _begin_when_due(
        self, work: BundleWork, state: ChainState, extra: SideInformation | None
    ) -> None:
        p = self._params
        if np.isnan(work.next_at):
            work.pause = p.first_after
            work.next_at = state.t + p.first_after
        if state.t < work.next_at or len(work.keyframes.stored) < p.least_keyframes:
            return
        work.pause *= 2.0
        work.next_at = state.t + work.pause
        work.frames = list(work.keyframes.stored)
        work.p = [f.p for f in work.frames]
        work.R_GB = [f.R_GB for f in work.frames]
        work.calibration = replace(state.copy(), P=np.zeros((0, 0)))
        work.sweep = 0
        self._begin_sweep(work, extra)

    def _begin_sweep(self, work: BundleWork, extra: SideInformation | None) -> None:
        """Initialises the sums with the priors of hand and mountings and with the guided poses."""
        assert work.calibration is not None
        work.back, work.misfit, work.rows = [], 0.0, 0
        information, off = self._information, off_nominal(work.calibration, self._layout)
        known = extra.known if extra is not None else None
        if known is not None:
            information = np.asarray(np.linalg.inv(known.P), float)
            off = calibration_error([getattr(known, n) for n in CALIBRATION], work.calibration)
        work.N, work.g = information.copy(), -information @ off
        if extra is not None:
            N, g = extra.poses.information(work.calibration)
            work.N, work.g = work.N + N, work.g + g

    def _linearise(self, work: BundleWork, k: int) -> None:
        """Adds keyframe ``k`` with its own pose eliminated."""
        assert work.calibration is not None
        frame, n = work.frames[k], self._layout.n_dynamic
        H, r = self._rows(replace(work.calibration, p=work.p[k], R_GB=work.R_GB[k]), frame)
        work.misfit, work.rows = work.misfit + float(r @ r), work.rows + len(r)
        away = np.concatenate(
            [work.p[k] - frame.p, so3.log(frame.R_GB.swapaxes(1, 2) @ work.R_GB[k]).ravel()]
        )
        N, g, back = without_pose(H, r, KeyframePose(self._moves, self._stiff, away), n)
        work.N += N
        work.g += g
        work.back.append(back)

    def _move_on(
        self, work: BundleWork, extra: SideInformation | None = None
    ) -> WearerProfile | None:
        """Solves for the calibration and updates it and all poses; the profile after the last
        sweep.

        Postures that do not fit are dropped before they can bias the calibration.
        """
        assert work.calibration is not None
        if work.misfit > MOST_MISFIT * work.rows:
            self._drop(work)
            return None
        self._move(work, work.calibration)
        work.sweep += 1
        if work.sweep < self._params.sweeps:
            self._begin_sweep(work, extra)
            return None
        solved, N = work.calibration, work.N
        if not self._believable(solved):
            self._drop(work)
            return None
        self._end(work)
        return self._profile(solved, np.asarray(np.linalg.inv(N), float))

    def _move(self, work: BundleWork, calibration: ChainState) -> None:
        lay = self._layout
        change = np.linalg.solve(work.N, work.g)  # eq. 47
        for k, back in enumerate(work.back):
            pose = np.zeros(lay.blocks.size)
            pose[self._moves] = back[:, -1] - back[:, :-1] @ change
            moved = replace(calibration.copy(), p=work.p[k].copy(), R_GB=work.R_GB[k])
            inject(moved, lay, pose)
            work.p[k], work.R_GB[k] = moved.p, moved.R_GB
        inject(calibration, lay, np.concatenate([np.zeros(lay.n_dynamic), change]))

    def _end(self, work: BundleWork) -> None:
        work.calibration, work.frames, work.p, work.R_GB, work.back = None, [], [], [], []

    def _drop(self, work: BundleWork) -> None:
        """Discard all postures, because some belong to another hand."""
        self._end(work)
        work.keyframes.stored.clear()

    def _believable(self, solved: ChainState) -> bool:
        """Whether the solution is plausible for a person wearing the glove."""
        far = so3.log(self._layout.R_IB.swapaxes(1, 2) @ solved.R_IB)
        largest = (np.abs(far).max(initial=0.0), np.abs(solved.marker).max(initial=0.0))
        within = np.abs(solved.scale - 1).max() < MOST_SCALE
        return bool(within and largest[0] < MOST_ROTATION and largest[1] < self._most_shift)

    def _profile(self, solved: ChainState, P: Array) -> WearerProfile:
        """The solution, with the wobble of the mountings added to its covariance."""
        lay, n = self._layout, self._layout.n_dynamic
        rows = np.arange(lay.blocks.phi - n, lay.blocks.ba - n)
        P[rows, rows] += self._params.wobble**2
        full = np.zeros((lay.blocks.size, lay.blocks.size))
        full[n:, n:] = P
        return profile_of(replace(solved, P=full), lay)


def adopt(state: ChainState, layout: ChainLayout, found: WearerProfile) -> None:
    """Replaces the filter's calibration, except gyro biases, by the keyframe solution.

    The IMUs keep their orientation in G, so each segment turns with its mounting; the covariance of
    the pose is unchanged, and its correlation with the calibration is set to zero.
    """
    n, first = layout.n_dynamic, layout.blocks.phi
    R_BB = state.R_IB.swapaxes(1, 2) @ found.R_IB  # new B to old B
    R = state.R_GB.copy()
    R[layout.imu_segment] = R[layout.imu_segment] @ R_BB  # eq. 48
    state.R_GB = R
    for name in ("R_IB", "ba", "scale", "joint", "marker", "axis"):
        setattr(state, name, getattr(found, name).copy())
    state.P[first:, :] = 0.0
    state.P[:, first:] = 0.0
    state.P[first:, first:] = found.P[first - n :, first - n :]
