"""Unsensed end joints, measured by the fingertips (docs/chain.md, "Fingertips in the cloth").

A few parameters in addition to the filter. The filter's corrections do not depend on them, and
their correlation with it is neglected, as for the wearer's synergies.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.base.records import record
from tracker.fusion.chain.distal import ASIDE, OFFSET, OWN, RATIO, DistalSegments, Synergies
from tracker.fusion.chain.driven_ends import ONE_WAY, driven_points
from tracker.fusion.chain.finger_view import FingerView, KnownParts, end_images, finger_views
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout, Points
from tracker.fusion.chain.prediction import PosedRig
from tracker.fusion.chain.row_exposure import RowExposure, exposed, marker_velocities
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState
from tracker.messages import Array, BlobFrame, CameraPose, Cloth, IntArray
from tracker.vision.end_cloth import ExpectedEnd, fit_end
from tracker.vision.rig import NEAREST, StereoRig
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, seen_from, visibility

LASTS = 0.5  # s for which a measured end joint is assumed constant
APART = 0.09  # s between two evaluated images
INDEPENDENT_AFTER = 0.5  # s after which outlines are independent of each other: parts of the hand
# that are not exactly where they are assumed remain there
LEAST_LIKELY = 3.0  # ln of the likelihood ratio of the segment to none
PREDICTION_VARIANCE = np.deg2rad(1.0) ** 2 * np.eye(2)  # of the expected bend
CLOTH = 0.001  # m, of the glove's cloth on the skin
LEAST_VISIBLE = 0.5  # probability that a camera sees a tip, required to evaluate it
PEOPLE = 4.0  # measured postures that what is known of people counts as
JOINT_OFF = 0.00275
"""m per axis, sd of an end joint relative to where the filter has it, of what the filter's
covariance does not contain: lengths, places of markers and of joints."""
BEND, SIDE = 0, 1


@record(
    "chain.tip_bends",
    shapes={"bend": "d 2", "drive": "d", "P": "d 2 2", "measured": "0 | d", "squares": "0 | d"},
)
@dataclass(eq=False)
class TipBendsSavedState:
    """The part that changes: for d digits, flexion and lateral (d, 2) rad in addition to the
    prediction from the joints before, at their flexions drive (d,) rad; the covariance P (d, 2, 2)
    rad²; the time, s. Empty before the first measurement. measured (d,) postures and the sum of
    squares (d,) rad² of their flexions; empty in older recordings."""

    bend: Array = field(default_factory=lambda: np.zeros((0, 2)))
    drive: Array = field(default_factory=lambda: np.zeros(0))
    P: Array = field(default_factory=lambda: np.zeros((0, 2, 2)))
    t: float = -np.inf
    measured: Array = field(default_factory=lambda: np.zeros(0))
    squares: Array = field(default_factory=lambda: np.zeros(0))


class TipBends:
    """For one hand with one glove; ``shown`` has the wearer's synergies presently in use."""

    def __init__(
        self, layout: ChainLayout, rig: StereoRig, distal: DistalSegments, shown: ShownHand
    ) -> None:
        self._layout, self._rig, self._distal, self._shown = layout, rig, distal, shown
        self._shape = HandShape.of(layout.hand)
        hand, rows = layout.hand, [d.segment for d in distal.digits]
        first = np.flatnonzero(hand.parent == hand.root).tolist()
        unsensed = [i for i in first if i not in layout.row_of]
        self._known = KnownParts.of(hand, rows, unsensed)
        self._ends = KnownParts.ends_of(hand, rows)
        segments = [hand.segments[i] for i in rows]
        self._radius = np.array([s.radius + CLOTH for s in segments])
        self._reach = np.array([s.length for s in segments]) - self._radius
        self.saved = TipBendsSavedState()

    def forget(self) -> None:
        """Reset, because the hand was found again."""
        self.saved = TipBendsSavedState()

    # ---- estimates

    def worn(self, gains: Array, lateral: Array) -> tuple[Array, Array]:
        """gains (k, 2) and lateral (S,) of `Completion.wear`, corrected by the measured end
        joints."""
        if not len(self.saved.bend):
            return gains, lateral
        gains, lateral = gains.copy(), lateral.copy()
        for digit, bend in zip(self._distal.digits, self.saved.bend, strict=True):
            gains[digit.link, 1] += bend[BEND]
            lateral[digit.segment] += bend[SIDE]
        return gains, lateral

    def trusted(self, own: Synergies) -> tuple[Synergies, Array]:
        """The wearer's synergies corrected by the measured end joints, and (d,) rad of remaining
        sd."""
        posture = self._posture_sd()
        if not len(self.saved.bend):
            return own, posture
        off = np.sqrt(3.0 / ONE_WAY) * JOINT_OFF / (self._reach + self._radius)
        value, P = own.value.copy(), own.P.copy()
        value[:, [OFFSET, ASIDE]] += self.saved.bend
        before = self._prior(own, self.saved.drive)
        for k, now in enumerate(self.saved.P):
            factor = np.ones(OWN)
            factor[[RATIO, OFFSET]] = np.sqrt(now[BEND, BEND] / before[k, BEND, BEND])
            factor[ASIDE] = np.sqrt(now[SIDE, SIDE] / before[k, SIDE, SIDE])
            rows = slice(OWN * k, OWN * k + OWN)
            P[rows], P[:, rows] = factor[:, None] * P[rows], P[:, rows] * factor
            posture[k] *= factor[OFFSET]
            if np.sum(self.saved.measured[k : k + 1]) > 0.0:
                posture[k] = np.hypot(posture[k], off[k])
        return Synergies(value, P), posture

    def _posture_sd(self) -> Array:
        """(d,) rad of the individual variation from posture to posture: that of people, widened
        where this wearer's end joints were seen to deviate more (eq. 61)."""
        usual, now = self._distal.posture_sd, self.saved
        if not len(now.measured):
            return usual.copy()
        seen = (PEOPLE * usual**2 + now.squares) / (PEOPLE + now.measured)
        out: Array = np.sqrt(np.maximum(usual**2, seen))
        return out

    def _prior(self, own: Synergies, drive: Array) -> Array:
        """(d, 2, 2) rad² of flexion and lateral without measurements, for the flexions ``drive``
        (d,) rad of the joints before."""
        P, posture = np.zeros((len(drive), 2, 2)), self._distal.posture_sd
        for k, q in enumerate(drive):
            of = own.P[OWN * k : OWN * k + OWN, OWN * k : OWN * k + OWN]
            flexion = q * q * of[RATIO, RATIO] + 2 * q * of[RATIO, OFFSET] + of[OFFSET, OFFSET]
            P[k, BEND, BEND] = flexion + posture[k] ** 2
            P[k, SIDE, SIDE] = of[ASIDE, ASIDE]
        return P

    # ---- measurement

    def image(
        self,
        state: ChainState,
        frame: BlobFrame,
        pose: CameraPose,
        own: Synergies,
        exposure: RowExposure | None = None,
    ) -> bool:
        """Locates the tips of a hand that was just corrected; returns whether the result of `worn`
        may have changed. ``own`` are the wearer's synergies without tip measurements, ``exposure``
        is that of a rolling shutter."""
        if 0.0 <= state.t - self.saved.t < APART:
            return False
        sides = [b.cloth if b is not None else None for b in (frame.left, frame.right)]
        if not len(self._reach) or (sides == [None, None] and not len(self.saved.bend)):
            return False
        lay, ends = self._layout, self._shown.confidence.ends
        driven = ends.driven_ends._replace(length=self._reach)
        points, J, _, drive = driven_points(
            lay.skeleton, lay.R_rest, lay.blocks, state.body, driven, ends.own, state.p, state.P
        )
        worn, before = self.saved.bend, self.saved.t
        self._age(state.t, own, drive[:, 0])
        shift = self.saved.bend - worn if len(worn) else np.zeros_like(self.saved.bend)
        there = self.in_sight(state, points[:, 1], pose)
        if exposure is not None:
            view = PosedRig.of(self._rig, pose)
            points = self._when_exposed(points, driven.parent, state, exposure, view)
        p_C = (points - pose.p_GC) @ pose.R_GC
        share = min((state.t - before) / INDEPENDENT_AFTER, 1.0) if state.t >= before else 1.0
        views, drawn = self._views(state, sides, pose, p_C)
        if drawn[0][..., 2].min() <= 3 * NEAREST:
            return True
        for k in range(len(J)):
            seen = [v for v in views if there[int(v.is_right), k]]
            if seen:
                others = np.arange(len(J)) != k
                axis, radius = p_C[k, 1] - p_C[k, 0], self._radius[k] * drive[k, 1]
                P = self.saved.P[k] + PREDICTION_VARIANCE
                end = ExpectedEnd(p_C[k, 0], axis, J[k].T @ pose.R_GC, radius, shift[k], P)
                images = end_images(end, (drawn[0][others], drawn[1][others]), self._rig, seen)
                self._correct(k, fit_end(end, images, share), share)
        return True

    def _views(
        self, state: ChainState, cloths: Sequence[Cloth | None], pose: CameraPose, p_C: Array
    ) -> tuple[list[FingerView], tuple[Array, Array]]:
        """The images about the points p_C (d, 2, 3) m, and the capsules in C of the displayed last
        segments: ends (d, 2, 3) m and radii (d,) m."""
        hand, centre = self._displayed(state), p_C.reshape(-1, 3).mean(axis=0)
        views = finger_views(self._rig, pose, cloths, self._known.capsules(*hand), centre)
        ends, radius = self._ends.capsules(*hand)
        return views, ((ends - pose.p_GC) @ pose.R_GC, radius)

    def _when_exposed(
        self,
        points: Array,
        segment: IntArray,
        state: ChainState,
        exposure: RowExposure,
        view: PosedRig,
    ) -> Array:
        """Points (d, 2, 3) m in G, two on each ``segment`` (d,), at the exposure of their own rows,
        relative to the camera pose of the image."""
        at, p_G = np.repeat(segment, 2), points.reshape(-1, 3)
        from_joint = p_G - segment_positions(state, self._layout)[at]
        in_B = np.einsum("nji,nj->ni", state.R_GB[at], from_joint)
        ends = Points(at, np.zeros_like(in_B), np.ascontiguousarray(in_B))
        v_C = marker_velocities(state, self._layout, ends, exposure, view)
        p_C = np.ascontiguousarray((p_G - view.p_GC) @ view.R_GC)
        uv = seen_from(p_G, self._rig, CameraPose(view.R_GC, view.p_GC))
        there = exposed(p_C, v_C, uv, self._rig).p_C
        out: Array = (there @ view.R_GC.T + view.p_GC).reshape(points.shape)
        return out

    def in_sight(self, state: ChainState, middle: Array, pose: CameraPose) -> NDArray[np.bool_]:
        """(2, d) whether a camera sees the tips whose middles are (d, 3) m in G: no part of the
        displayed hand occludes them."""
        R_all, p_all, _ = self._displayed(state)
        to_camera = pose.p_GC - middle
        normal = to_camera / np.linalg.norm(to_camera, axis=1)[:, None]
        segment = np.array([d.segment for d in self._distal.digits], np.int64)
        tips = MarkerRows(middle + self._radius[:, None] * normal, normal, segment)
        prior = visibility(PosedHand(self._shape, R_all, p_all), tips, self._rig, pose)
        return prior >= LEAST_VISIBLE

    def _displayed(self, state: ChainState) -> tuple[Array, Array, Array]:
        """R_GB (S, 3, 3), p_GB (S, 3) m and scale (S, 3) of the displayed hand."""
        p_GB = segment_positions(state, self._layout)
        return self._shown.complete(state.R_GB, p_GB, state.scale3())[:3]

    def _age(self, t: float, own: Synergies, drive: Array) -> None:
        """Ageing: a measured end joint remains valid for a while, then its driving joint determines
        it again (eq. 61)."""
        saved, prior, count = self.saved, self._prior(own, drive), len(drive)
        known = len(saved.measured) == count  # not in older recordings
        measured = saved.measured.copy() if known else np.zeros(count)
        squares = saved.squares.copy() if known else np.zeros(count)
        bend, P = np.zeros((count, 2)), prior
        if len(saved.bend):
            left = float(np.exp(-max(t - saved.t, 0.0) / LASTS))
            bend, P = left * saved.bend, left**2 * saved.P + (1.0 - left**2) * prior
        self.saved = TipBendsSavedState(bend, drive, P, t, measured, squares)

    def _correct(self, k: int, found: Array, share: float) -> None:
        """Corrects the digit ``k`` by the result of `fit_end` (eq. 60), of which the ``share`` is
        new."""
        likely, flexion, lateral, a, b, c = found
        if likely < LEAST_LIKELY:
            return
        before, usual = self.saved.P[k], self._distal.posture_sd[k] ** 2
        self.saved.bend[k] += (flexion, lateral)
        self.saved.P[k] = min(1.0, np.trace(before) / (a + c)) * np.array([[a, b], [b, c]])
        new = share * max(1.0 - self.saved.P[k, 0, 0] / usual, 0.0)
        self.saved.measured[k] += new
        self.saved.squares[k] += new * self.saved.bend[k, BEND] ** 2
