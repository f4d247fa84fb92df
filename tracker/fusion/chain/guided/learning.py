"""Learns calibration and synergies from held poses (docs/chain.md, "Guided poses").

By the time a pose is confirmed as held, the filter has moved on. Its rows are therefore reduced to
a form that can be applied later: the posture is eliminated with P at the time of the sample, and
the remainder depends on the calibration alone, which hardly changes in between. The reduced rows
also enter the keyframe solution and each new start.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve
from scipy.special import chdtri

from tracker.base.records import record
from tracker.fusion.chain.distal import OFFSET, OWN, DistalSegments, PointRows, Synergies
from tracker.fusion.chain.filter import ChainFilter
from tracker.fusion.chain.guided.holds import HeldSample, Hold, ReducedRows, chosen
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import GuidedParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.geometry.kernels import relative_rotations
from tracker.geometry.solids import nearest_to_axis
from tracker.hand.model import Segment
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import POSES, GuidedPose, HeldFlexion
from tracker.messages import Array

CALIBRATION = ("bg", "R_IB", "ba", "scale", "joint", "marker", "axis")
"""Calibration arrays of a state, in the order of the error state."""


@record("chain.guided", accepted="told")
@dataclass(eq=False)
class GuidedSavedState:
    """The complete state of the learning."""

    over: int = 0  # number of completed holds
    last: float = -np.inf  # s of the last sample
    samples: list[HeldSample] = field(default_factory=list)  # of the present hold
    accepted: list[ReducedRows] = field(default_factory=list)
    synergies: Synergies | None = None  # None: same as before the first pose
    base: Synergies | None = None  # before the first pose, of a wearer profile; None: ``prior``
    prior: Synergies = field(default_factory=Synergies.none)
    """Of an unknown wearer. Empty in recordings that were started with the hand file's lines."""


class GuidedLearning:
    """For one hand with one glove; the owner appends to ``holds``."""

    def __init__(
        self, layout: ChainLayout, distal: DistalSegments, params: GuidedParams, holds: list[Hold]
    ) -> None:
        self._layout, self._distal, self._params = layout, distal, params
        self._rows = PoseRows(layout, distal, params)
        self._holds = holds
        self.saved = GuidedSavedState(prior=distal.prior())

    @property
    def synergies(self) -> Synergies:
        """The present estimate."""
        return self.saved.synergies or self._base

    @property
    def _base(self) -> Synergies:
        """The synergies before the first pose."""
        return self.saved.base or self._prior

    @property
    def _prior(self) -> Synergies:
        prior = self.saved.prior
        return prior if len(prior.value) else self._distal.of_hand_file()

    def apply_profile(self, known: Synergies | None) -> None:
        """Start over with the synergies of a wearer profile, or (None) of an unknown wearer."""
        self.saved.accepted, self.saved.base, self.saved.synergies = [], known, known

    # ---- while the filter runs

    def step(self, filter_: ChainFilter) -> bool:
        """Call after the filter has moved on; returns whether something was learned from a pose."""
        learned = False
        while self.saved.over < len(self._holds):
            hold = self._holds[self.saved.over]
            self._sample(filter_.state, hold)
            if not hold.is_over(filter_.state.t):
                break
            learned |= self._finish(filter_, hold)
        return learned

    def _sample(self, state: ChainState, hold: Hold) -> None:
        due = state.t - self.saved.last >= self._params.sample_period
        if not due or not hold.may_count(state.t):
            return
        self.saved.last = state.t
        posture = relative_rotations(state.R_GB, self._layout.parent)
        rows = self._rows(state, self.synergies, POSES[hold.pose])
        reduced = [self._reduced(state, hold.pose, r) for r in rows]
        self.saved.samples.append(HeldSample(state.t, posture, reduced))

    def _finish(self, filter_: ChainFilter, hold: Hold) -> bool:
        """Learns from a completed hold if it is valid."""
        samples, self.saved.samples = self.saved.samples, []
        self.saved.over += 1
        sample = chosen(hold, samples, self._params.moving) if hold.held else None
        if sample is None:
            return False
        accepted = [rows for rows in sample.rows if self._learn(filter_, rows)]
        self.saved.accepted += accepted
        return bool(accepted)

    def _reduced(self, state: ChainState, pose: str, rows: HeldRows) -> ReducedRows:
        """``rows`` with the posture eliminated using P (eq. 53)."""
        n = self._layout.n_dynamic
        P_cc = state.P[n:, n:]
        HP = rows.H @ state.P
        unit = np.sqrt(np.diag(P_cc))
        factor = cho_factor(P_cc / np.outer(unit, unit), lower=True)
        H = (cho_solve(factor, (HP[:, n:] / unit).T) / unit[:, None]).T
        R = rows.R + HP @ rows.H.T - HP[:, n:] @ H.T
        saved = [np.array(getattr(state, name)) for name in CALIBRATION]
        return ReducedRows(
            pose, H, rows.H_own, rows.r, (R + R.T) / 2, saved, self.synergies.value.copy()
        )

    # ---- learning

    def innovation(self, rows: ReducedRows, state: ChainState, own: Array) -> Array:
        """(m,) of ``rows`` at another state's calibration and other synergies (d, 3)."""
        moved = calibration_error(rows.calibration, state)
        return np.asarray(rows.r - rows.H @ moved - rows.H_own @ (own - rows.own).ravel())

    def _learn(self, filter_: ChainFilter, rows: ReducedRows) -> bool:
        """Corrects calibration and synergies, unless the pose fails the gate (eq. 54)."""
        own, state, n = self.synergies, filter_.state, self._layout.n_dynamic
        r = self.innovation(rows, state, own.value)
        by_own = rows.H_own @ own.P @ rows.H_own.T
        by_state = rows.H @ state.P[n:, n:] @ rows.H.T
        distance = float(r @ np.linalg.solve(by_own + by_state + rows.R, r))
        if distance > chdtri(len(r), 1 - self._params.gate):
            return False
        R = rows.R * max(1.0, distance / len(r))  # held less accurately than usual
        filter_.learn(rows.H, r, R + by_own)
        gain = own.P @ rows.H_own.T @ np.linalg.inv(by_own + by_state + R)
        P = own.P - gain @ rows.H_own @ own.P
        self.saved.synergies = own.moved(gain @ r, (P + P.T) / 2)
        return True

    def again(self, filter_: ChainFilter) -> None:
        """Applies the learned poses to the calibration after the filter was reinitialized."""
        if self.saved.accepted:
            own, accepted = self._base, self.saved.accepted
            H_own = np.concatenate([t.H_own for t in accepted])
            r = np.concatenate([self.innovation(t, filter_.state, own.value) for t in accepted])
            R = block_diag(*(t.R for t in accepted)) + H_own @ own.P @ H_own.T
            filter_.learn(np.concatenate([t.H for t in accepted]), r, R)

    def information(self, state: ChainState) -> tuple[Array, Array]:
        """(C, C) and (C,) of the normal equations for the calibration of a state, the synergies
        eliminated: the information of all poses."""
        own, n = self._base, self._layout.blocks.size - self._layout.n_dynamic
        N, g = np.zeros((n, n)), np.zeros(n)
        N_own, g_own = np.linalg.inv(own.P), np.zeros(own.value.size)
        N_both = np.zeros((n, own.value.size))
        for rows in self.saved.accepted:
            r = self.innovation(rows, state, own.value)
            weighed, weighed_own = (np.linalg.solve(rows.R, H).T for H in (rows.H, rows.H_own))
            N, N_own = N + weighed @ rows.H, N_own + weighed_own @ rows.H_own
            N_both += weighed @ rows.H_own
            g, g_own = g + weighed @ r, g_own + weighed_own @ r
        back = np.linalg.solve(N_own, np.column_stack([N_both.T, g_own]))
        return N - N_both @ back[:, :-1], g - N_both @ back[:, -1]


def calibration_error(begin: list[Array], state: ChainState) -> Array:
    """(C,) error vector from the calibration arrays ``begin`` to those of a state."""
    parts = []
    for name, before in zip(CALIBRATION, begin, strict=True):
        now = getattr(state, name)
        turned = so3.log(np.swapaxes(before, 1, 2) @ now) if name == "R_IB" else now - before
        parts.append(turned.ravel())
    return np.concatenate(parts)


# ---- measurement rows of a held pose, in groups that are accepted or rejected as a whole
#
# Equation numbers are those of docs/chain.md (these rows are eq. 52).

PAD = 0.006  # m from a fingertip to the middle of its pad
LEAST_APART = 1e-3  # m between two axes, below which the direction of their distance is undefined


class HeldRows(NamedTuple):
    """Jacobians H (m, N) by the state's errors and H_own (m, 3 d) by the synergies', innovation
    r (m,) and its noise R (m, m)."""

    H: Array
    H_own: Array
    r: Array
    R: Array


class PoseRows:
    """For one hand with one glove."""

    def __init__(self, layout: ChainLayout, distal: DistalSegments, params: GuidedParams) -> None:
        self._layout, self._distal, self._params = layout, distal, params

    def __call__(self, state: ChainState, own: Synergies, pose: GuidedPose) -> list[HeldRows]:
        """The rows of ``pose``, linearised at ``state`` and ``own``."""
        thumb = [f for f in pose.flexions if f.joint.startswith("thumb")]
        fingers = [f for f in pose.flexions if not f.joint.startswith("thumb")]
        found = [self._flexions(state, own, thumb), self._flexions(state, own, fingers)]
        if pose.on_table:
            found.append(self._plane(state, own))
        if pose.touches:
            found.append(self._contact(state, own, pose.touches))
        return [self._with_posture(rows) for rows in found if rows is not None]

    def _with_posture(self, rows: HeldRows) -> HeldRows:
        """Adds the individual bend of the distal joint, constant while the pose is held."""
        by = rows.H_own[:, OFFSET::OWN] * self._distal.posture_sd
        return rows._replace(R=rows.R + by @ by.T)

    def _flexions(
        self, state: ChainState, own: Synergies, held: list[HeldFlexion]
    ) -> HeldRows | None:
        found = [(f, self._distal.flexion(state, own, f.joint)) for f in held]
        # of an end joint that follows another, a pose says how it is held, not how it bends freely
        known = [(f, row) for f, row in found if row is not None and not row.H_own.any()]
        if not known:
            return None
        return HeldRows(
            np.array([row.H for _, row in known]),
            np.array([row.H_own for _, row in known]),
            np.array([f.value - row.value for f, row in known]),
            np.diag([self._variance(f) for f, _ in known]),
        )

    def _variance(self, held: HeldFlexion) -> float:
        """rad². Few people hold a pose as accurately as is possible, and which ones is unknown."""
        p = self._params
        return (p.flexion * held.sd) ** 2 + (p.by_will * held.by_will) ** 2

    # ---- the table

    def _plane(self, state: ChainState, own: Synergies) -> HeldRows | None:
        """The pads of the fingers and the corners of the palm lie in one unknown plane."""
        points = [
            self._distal.point(state, own, finger, self._pad(finger))
            for finger in FINGERS
            if finger in self._fingers
        ]
        if not points:
            return None
        points += self._palm(state, own)
        p = np.array([x.p for x in points])
        along = np.linalg.svd(p - p.mean(axis=0))[2]  # two directions in the plane, its normal
        free = np.column_stack([np.ones(len(p)), (p - p.mean(axis=0)) @ along[:2].T])
        rest = np.linalg.qr(free, mode="complete")[0][:, 3:].T  # neither tilt nor height
        normal = along[2]
        return HeldRows(
            rest @ np.array([normal @ x.H for x in points]),
            rest @ np.array([normal @ x.H_own for x in points]),
            -rest @ (p @ normal),
            self._params.table**2 * np.eye(len(rest)),
        )

    @property
    def _fingers(self) -> list[str]:
        return [f for f in FINGERS if self._distal.knows(f)]

    def _palm(self, state: ChainState, own: Synergies) -> list[PointRows]:
        """Three corners of the dorsum's palmar side."""
        root = self._layout.hand.segments[self._layout.hand.root]
        x, y, z = root.length, root.width / 3, -root.radius
        corners = np.array([[0.0, 0.0, z], [x, y, z], [x, -y, z]])
        rows = [self._distal.fixed(state, 0, corner) for corner in corners]
        return [PointRows(p, H, np.zeros((3, own.value.size))) for p, H in rows]

    # ---- two pads

    def _contact(self, state: ChainState, own: Synergies, finger: str) -> HeldRows | None:
        """The surfaces touch (one row), at the middle of both pads (two rows)."""
        pair = ("thumb", finger)
        if not all(self._distal.knows(digit) for digit in pair):
            return None
        ends = [self._axis(state, own, d) for d in pair]
        share = _nearest(*ends)
        nearest = [
            self._distal.point(state, own, d, np.array([s * self._segment(d).length, 0.0, 0.0]))
            for d, s in zip(pair, share, strict=True)
        ]
        axes = nearest[0].p - nearest[1].p
        apart = float(np.linalg.norm(axes))
        if apart < LEAST_APART:
            return None
        normal = axes / apart
        gap = apart - sum(self._radius(state, own, d) for d in pair)
        pads = [self._distal.point(state, own, d, self._pad(d)) for d in pair]
        across = np.linalg.svd(normal[None])[2][1:]
        between = pads[0].p - pads[1].p
        by_pads = across @ (pads[0].H - pads[1].H)
        # both directions rotate with the finger
        s = self._distal.carrier(finger)
        first = self._layout.blocks.theta + 3 * s
        by_pads[:, first : first + 3] += np.cross(across @ state.R_GB[s], between @ state.R_GB[s])
        p = self._params
        return HeldRows(
            np.vstack([normal @ (nearest[0].H - nearest[1].H), by_pads]),
            np.vstack(
                [
                    normal @ (nearest[0].H_own - nearest[1].H_own),
                    across @ (pads[0].H_own - pads[1].H_own),
                ]
            ),
            -np.r_[gap, across @ between],
            np.diag([p.gap**2, p.pad**2, p.pad**2]),
        )

    def _axis(self, state: ChainState, own: Synergies, digit: str) -> tuple[Array, Array]:
        """Both ends of a distal segment, m in G."""
        tip = np.array([self._segment(digit).length, 0.0, 0.0])
        begin, end = (self._distal.point(state, own, digit, x).p for x in (np.zeros(3), tip))
        return begin, end

    def _segment(self, digit: str) -> Segment:
        hand = self._layout.hand
        return hand.segments[hand.index[CHAINS[digit][-1]]]

    def _radius(self, state: ChainState, own: Synergies, digit: str) -> float:
        return float(self._segment(digit).radius * self._distal.girth(state, digit))

    def _pad(self, digit: str) -> Array:
        segment = self._segment(digit)
        return np.array([segment.length - PAD, 0.0, -segment.radius])


def _nearest(first: tuple[Array, Array], second: tuple[Array, Array]) -> tuple[float, float]:
    """Fractions along two lines, each from one end (3,) to the other, of their closest points."""
    d, w = first[1] - first[0], first[0] - second[0]
    along = second[1] - second[0]
    length = float(np.linalg.norm(along))
    u = along / length
    t, x = nearest_to_axis(float(d @ d), float(d @ u), float(d @ w), float(u @ w), length)
    return t, x / length
