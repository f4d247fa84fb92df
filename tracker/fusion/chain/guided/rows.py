"""Measurement rows of a held pose, in groups that are accepted or rejected as a whole.

Equation numbers are those of docs/chain.md (these rows are eq. 52).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.distal import OFFSET, OWN, DistalSegments, PointRows, Synergies
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import GuidedParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry.solids import nearest_to_axis
from tracker.hand.model import Segment
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import GuidedPose, HeldFlexion
from tracker.messages import Array

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
