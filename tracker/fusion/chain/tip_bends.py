"""Unsensed end joints, measured by the fingertips (docs/chain.md, "Fingertips in the cloth").

A few parameters in addition to the filter. The filter's corrections do not depend on them, and
their correlation with it is neglected, as for the wearer's synergies.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag

from tracker.base.records import record
from tracker.fusion.chain.distal import ASIDE, OFFSET, OWN, RATIO, DistalSegments, Synergies
from tracker.fusion.chain.driven_ends import driven_points
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout, Points
from tracker.fusion.chain.prediction import PosedRig, pixel_jacobians
from tracker.fusion.chain.row_exposure import RowExposure, exposed, marker_velocities
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState
from tracker.messages import Array, BlobFrame, CameraPose, IntArray
from tracker.vision.cloth import ClothMap, cloth_map
from tracker.vision.rig import NEAREST, Camera, StereoRig
from tracker.vision.tip_scan import ExpectedTip, scan_tip
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, seen_from, visibility

LASTS = 1.0  # s for which a measured end joint is assumed constant
APART = 0.15  # s between two evaluated images: successive outlines are not independent
CLOTH = 0.001  # m, of the glove's cloth on the skin
LEAST_VISIBLE = 0.5  # probability that a camera sees a tip, required to evaluate it
END = 0.008  # m along the finger: gloves end slightly before a fingertip or beyond it
PIXEL_PX = 1.5  # of a position in the image
GATE = 9.0  # innovation squared over its variance, for each of its numbers
STEP_PX = 1.0  # of the difference quotient from rectified to raw pixels
BEND, SIDE = 0, 1


@record("chain.tip_bends", shapes={"bend": "d 2", "drive": "d", "P": "d 2 2"})
@dataclass(eq=False)
class TipBendsSavedState:
    """The part that changes: for d digits, flexion and lateral (d, 2) rad in addition to the
    prediction from the joints before, at their flexions drive (d,) rad; the covariance P (d, 2, 2)
    rad²; and the time, s. Empty before the first measurement."""

    bend: Array = field(default_factory=lambda: np.zeros((0, 2)))
    drive: Array = field(default_factory=lambda: np.zeros(0))
    P: Array = field(default_factory=lambda: np.zeros((0, 2, 2)))
    t: float = -np.inf


class TipBends:
    """For one hand with one glove; ``shown`` has the wearer's synergies presently in use."""

    def __init__(
        self, layout: ChainLayout, rig: StereoRig, distal: DistalSegments, shown: ShownHand
    ) -> None:
        self._layout, self._rig, self._distal, self._shown = layout, rig, distal, shown
        self._shape = HandShape.of(layout.hand)
        segments = [layout.hand.segments[d.segment] for d in distal.digits]
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
        posture = self._distal.posture_sd
        if not len(self.saved.bend):
            return own, posture
        value, P, posture = own.value.copy(), own.P.copy(), posture.copy()
        value[:, [OFFSET, ASIDE]] += self.saved.bend
        before = self._prior(own, self.saved.drive)
        for k, now in enumerate(self.saved.P):
            factor = np.ones(OWN)
            factor[[RATIO, OFFSET]] = np.sqrt(now[BEND, BEND] / before[k, BEND, BEND])
            factor[ASIDE] = np.sqrt(now[SIDE, SIDE] / before[k, SIDE, SIDE])
            rows = slice(OWN * k, OWN * k + OWN)
            P[rows], P[:, rows] = factor[:, None] * P[rows], P[:, rows] * factor
            posture[k] *= factor[OFFSET]
        return Synergies(value, P), posture

    def _prior(self, own: Synergies, drive: Array) -> Array:
        """(d, 2, 2) rad² of flexion and lateral without measurements, for the flexions ``drive``
        (d,) rad of the joints before."""
        P = np.zeros((len(drive), 2, 2))
        for k, q in enumerate(drive):
            of = own.P[OWN * k : OWN * k + OWN, OWN * k : OWN * k + OWN]
            flexion = q * q * of[RATIO, RATIO] + 2 * q * of[RATIO, OFFSET] + of[OFFSET, OFFSET]
            P[k, BEND, BEND] = flexion + self._distal.posture_sd[k] ** 2
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
        points, J, C, drive = driven_points(
            lay.skeleton, lay.R_rest, lay.blocks, state.body, driven, ends.own, state.p, state.P
        )
        worn = self.saved.bend
        self._age(state.t, own, drive[:, 0])
        shift = np.zeros_like(J[..., 0, :]) if not len(worn) else worn - self.saved.bend
        maps = [None if c is None else cloth_map(c) for c in sides]
        view, there = PosedRig.of(self._rig, pose), self.in_sight(state, points[:, 1], pose)
        if exposure is not None:
            points = self._when_exposed(points, driven.parent, state, exposure, view)
        for k in range(len(J)):
            p_C = (points[k] - pose.p_GC) @ pose.R_GC
            if p_C[:, 2].min() <= NEAREST:
                continue
            A = pixel_jacobians(np.ascontiguousarray(p_C[1:]), view)[:, 0]
            radius = self._radius[k] * drive[k, 1] / p_C[1, 2] * self._rig.fx
            along = (points[k, 1] - points[k, 0]) / self._reach[k] * END
            tip = _Tip(p_C, A, radius, J[k], C[k] + np.outer(along, along), shift[k])
            seen = [m if sees else None for m, sees in zip(maps, there[:, k], strict=True)]
            self._correct(k, tip, seen)
        return True

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
        p_GB = segment_positions(state, self._layout)
        R_all, p_all, *_ = self._shown.complete(state.R_GB, p_GB, state.scale3())
        to_camera = pose.p_GC - middle
        normal = to_camera / np.linalg.norm(to_camera, axis=1)[:, None]
        segment = np.array([d.segment for d in self._distal.digits], np.int64)
        tips = MarkerRows(middle + self._radius[:, None] * normal, normal, segment)
        prior = visibility(PosedHand(self._shape, R_all, p_all), tips, self._rig, pose)
        return prior >= LEAST_VISIBLE

    def _age(self, t: float, own: Synergies, drive: Array) -> None:
        """Ageing: a measured end joint remains valid for a while, then its driving joint determines
        it again (eq. 61)."""
        saved, prior = self.saved, self._prior(own, drive)
        if not len(saved.bend):
            self.saved = TipBendsSavedState(np.zeros((len(drive), 2)), drive, prior, t)
            return
        left = float(np.exp(-max(t - saved.t, 0.0) / LASTS))
        P = left**2 * saved.P + (1.0 - left**2) * prior
        self.saved = TipBendsSavedState(left * saved.bend, drive, P, t)

    def _correct(self, k: int, tip: _Tip, maps: list[ClothMap | None]) -> None:
        """Corrects the digit ``k`` by its tip in the images (eq. 60)."""
        x, P = self.saved.bend, self.saved.P
        r, R, A = [], [], []
        for c, (camera, cloth) in enumerate(
            zip((self._rig.left, self._rig.right), maps, strict=True)
        ):
            if cloth is None:
                continue
            spread = tip.C + tip.J @ P[k] @ tip.J.T
            S = tip.A[c] @ spread @ tip.A[c].T + PIXEL_PX**2 * np.eye(2)
            seen = _seen(cloth, camera, self._rig.project(tip.p_C, right=bool(c)), tip.radius, S)
            if seen is not None:
                A.append(tip.A[c])
                r.append(seen[0] + tip.A[c] @ tip.J @ tip.shift)
                R.append(seen[1] + PIXEL_PX**2 * np.eye(2))
        if not r:
            return
        H = np.concatenate(A) @ tip.J
        innovation, noise = np.concatenate(r), block_diag(*R)
        S = H @ P[k] @ H.T + np.concatenate(A) @ tip.C @ np.concatenate(A).T + noise
        if innovation @ np.linalg.solve(S, innovation) > GATE * len(innovation):
            return
        K = np.linalg.solve(S, H @ P[k]).T
        x[k] += K @ innovation
        P[k] -= K @ H @ P[k]


class _Tip(NamedTuple):
    """For a digit: joint and middle of the tip p_C (2, 3) m, A (2, 2, 3) of the latter in both
    images, radius px, J (3, 2) and C (3, 3) of `driven_points`, shift (2,) rad from the present
    estimate to the values in use."""

    p_C: Array
    A: Array
    radius: float
    J: Array
    C: Array
    shift: Array


def _seen(
    cloth: ClothMap, camera: Camera, uv: Array, radius: float, S: Array
) -> tuple[Array, Array] | None:
    """The offset (2,) of a tip from its prediction, and its variance (2, 2), in rectified px; None
    where the image does not show the tip (eq. 59).

    uv (2, 2) rectified px of joint and middle; the image is evaluated as it was recorded.
    """
    joint, middle = uv
    steps = np.array([joint, middle, middle + (STEP_PX, 0.0), middle + (0.0, STEP_PX)])
    raw = camera.unrectify(steps)
    B = (raw[2:] - raw[1]).T / STEP_PX
    scale = float(np.sqrt(abs(np.linalg.det(B))))
    expected = ExpectedTip(raw[1].copy(), raw[0].copy(), radius * scale, B @ S @ B.T)
    found, u, v, uu, uv_, vv = scan_tip(cloth, expected)
    if not found:
        return None
    back = np.linalg.inv(B)
    return back @ (u, v), back @ np.array([[uu, uv_], [uv_, vv]]) @ back.T
