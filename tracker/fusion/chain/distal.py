"""Fingertips, also of segments that the filter does not estimate (docs/chain.md, "Fingertips").

A distal segment without IMU and markers bends with the joint before it,

    flexion = ratio * flexion of the source + offset,

and is rotated laterally by a fixed angle, since real joint axes differ from those of the hand file.
These three parameters belong to the wearer, one set per digit; their prior is the variation between
people. Equation numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.kinematics import jacobians, segment_positions
from tracker.fusion.chain.layout import ChainLayout, Points
from tracker.fusion.chain.params import SynergyParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.geometry.kernels import joint_angles3
from tracker.hand.names import CHAINS
from tracker.messages import Array

RATIO, OFFSET, ASIDE = range(3)
OWN = 3  # parameters of a digit
STEP = 1e-5  # rad, of central differences
THUMB_RATIO_OF_FILE = 0.75  # sd of people's ratios about that of the hand file


class Digit(NamedTuple):
    """A digit whose distal segment is not estimated.

    Rows: ``segment`` of the hand; ``parent`` and ``source`` are active segments: the one that
    carries it, and the one whose joint angle drives it; ``link`` among the hand's synergies.
    """

    name: str
    segment: int
    parent: int
    source: int
    link: int


@record("chain.synergies", shapes={"value": "d 3", "P": "3d 3d"})
@dataclass(eq=False)
class Synergies:
    """The synergies of the d digits of `DistalSegments`: value (d, 3) ratio, offset (rad) and
    lateral (rad); covariance P (3 d, 3 d)."""

    value: Array
    P: Array

    @classmethod
    def none(cls) -> Synergies:
        """Those of no digit."""
        return cls(np.zeros((0, OWN)), np.zeros((0, 0)))

    def moved(self, dx: Array, P: Array) -> Synergies:
        """A copy corrected by an error vector (3 d,), with a new covariance."""
        return Synergies(self.value + dx.reshape(self.value.shape), P)


class FlexionRow(NamedTuple):
    """An angle (rad) and its Jacobians by the state's errors H (N,) and the synergies' (3 d,)."""

    value: float
    H: Array
    H_own: Array


class PointRows(NamedTuple):
    """A point (3,) m in G, Jacobians H (3, N), H_own (3, 3 d)."""

    p: Array
    H: Array
    H_own: Array


class DistalSegments:
    """The distal segments of one hand with one glove."""

    def __init__(self, layout: ChainLayout, params: SynergyParams) -> None:
        self._layout, self._params = layout, params
        self.digits = tuple(_digits(layout))
        self._number = {d.segment: k for k, d in enumerate(self.digits)}

    # ---- parameters

    def prior(self) -> Synergies:
        """The hand file's lines, turned about ``middle`` to the mean ratio of people, with the
        variation between people as covariance."""
        p, lines = self._params, self._file_lines()
        slope = np.array([p.thumb_slope if d.name == "thumb" else p.slope for d in self.digits])
        offset = lines[:, OFFSET] + (lines[:, RATIO] - slope) * self._middle
        value = np.column_stack([slope, offset, np.zeros(len(slope))])
        return Synergies(value, self._prior_covariance(self._prior_sd))

    def of_hand_file(self) -> Synergies:
        """The hand file's own lines, with which recordings without a saved prior were started."""
        sd, lines = self._prior_sd.copy(), self._file_lines()
        for k, d in enumerate(self.digits):
            if d.name == "thumb":
                sd[k, RATIO] = THUMB_RATIO_OF_FILE
        value = np.column_stack([lines, np.zeros(len(lines))])
        return Synergies(value, self._prior_covariance(sd))

    def _file_lines(self) -> Array:
        """(d, 2) ratio and offset (rad) in the hand file."""
        links = [self._layout.hand.synergies[d.link] for d in self.digits]
        return np.array([(s.ratio, s.offset) for s in links]).reshape(-1, 2)

    def _prior_covariance(self, sd: Array) -> Array:
        """(3 d, 3 d): a line that is uncertain by its ratio beside ``middle``; sd (d, 3)."""
        P = np.diag(sd.ravel() ** 2)
        for k, middle in enumerate(self._middle):
            row = OWN * k
            ratio = P[row + RATIO, row + RATIO]
            P[row + OFFSET, row + OFFSET] += middle**2 * ratio
            P[row + RATIO, row + OFFSET] = P[row + OFFSET, row + RATIO] = -middle * ratio
        return P

    @cached_property
    def _prior_sd(self) -> Array:
        """(d, 3)."""
        p = self._params
        finger = (p.ratio, np.deg2rad(p.offset_deg), np.deg2rad(p.aside_deg))
        thumb = (p.thumb_ratio, np.deg2rad(p.thumb_offset_deg), np.deg2rad(p.thumb_aside_deg))
        rows = [thumb if d.name == "thumb" else finger for d in self.digits]
        return np.array(rows).reshape(-1, OWN)

    @cached_property
    def _middle(self) -> Array:
        """(d,) rad."""
        p = self._params
        degrees = [p.thumb_middle_deg if d.name == "thumb" else p.middle_deg for d in self.digits]
        return np.deg2rad(np.array(degrees, float))

    @cached_property
    def posture_sd(self) -> Array:
        """(d,) rad."""
        p = self._params
        degrees = [p.thumb_posture_deg if d.name == "thumb" else p.posture_deg for d in self.digits]
        return np.deg2rad(np.array(degrees, float))

    def gains(self, synergies: Synergies) -> Array:
        """(k, 2) ratio and offset (rad) of all the hand's synergies.

        A finger without its own estimate bends its end joint like the fingers with one.
        """
        hand = self._layout.hand
        out = np.array([[s.ratio, s.offset] for s in hand.synergies]).reshape(-1, 2)
        fingers = [k for k, d in enumerate(self.digits) if d.name != "thumb"]
        if fingers:
            known = {hand.synergies[self.digits[k].link].angle for k in fingers}
            files = np.array([out[self.digits[k].link] for k in fingers])
            change = (synergies.value[fingers, :ASIDE] - files).mean(axis=0)
            for k, s in enumerate(hand.synergies):
                if s.angle.endswith("_dip_flexion") and s.angle not in known:
                    out[k] += change
        for k, d in enumerate(self.digits):
            out[d.link] = synergies.value[k, :ASIDE]
        return out

    def lateral(self, synergies: Synergies) -> Array:
        """(S,) rad by which each of the hand's segments is rotated laterally."""
        out = np.zeros(len(self._layout.hand.segments))
        for k, d in enumerate(self.digits):
            out[d.segment] = synergies.value[k, ASIDE]
        return out

    # ---- angles and points

    def flexion(self, state: ChainState, own: Synergies, joint: str) -> FlexionRow | None:
        """Flexion of the named joint; None where it is neither estimated nor driven."""
        hand = self._layout.hand
        child = next((hand.index[j.child] for j in hand.joints if j.name == joint), None)
        if child is None:
            return None
        if child in self._layout.row_of:
            value, H = self._active_flexion(state, self._layout.row_of[child])
            return FlexionRow(value, H, np.zeros(own.value.size))
        k = self._number.get(child)
        return None if k is None else self._bend(state, own, k)

    def _active_flexion(self, state: ChainState, child: int) -> tuple[float, Array]:
        """Between an active segment and its parent, and its Jacobian (N,)."""
        lay, at = self._layout, self._layout.blocks
        a = lay.parent[child]
        columns = lay.hand.axis_columns[lay.active[child]]
        free = columns[0] >= 0, columns[2] >= 0
        R_rel = lay.R_rest[child].T @ state.R_GB[a].T @ state.R_GB[child]
        by_child = np.array(
            [
                (
                    joint_angles3(R_rel @ so3.exp(e), *free)[1]
                    - joint_angles3(R_rel @ so3.exp(-e), *free)[1]
                )
                / (2 * STEP)
                for e in STEP * np.eye(3)
            ]
        )
        H = np.zeros(at.size)
        H[at.theta + 3 * child : at.theta + 3 * child + 3] = by_child
        H[at.theta + 3 * a : at.theta + 3 * a + 3] = -lay.R_rest[child] @ R_rel @ by_child
        return joint_angles3(R_rel, *free)[1], H

    def _bend(self, state: ChainState, own: Synergies, k: int) -> FlexionRow:
        """Flexion of the distal joint of digit ``k`` (eqs. 49 and 51)."""
        q, H_q = self._active_flexion(state, self.digits[k].source)
        ratio, offset, _ = own.value[k]
        H_own = np.zeros(own.value.size)
        H_own[OWN * k + RATIO], H_own[OWN * k + OFFSET] = q, 1.0
        return FlexionRow(ratio * q + offset, ratio * H_q, H_own)

    def knows(self, digit: str) -> bool:
        """Whether the digit's distal segment is estimated, or driven by one that is."""
        row = self._layout.hand.index.get(CHAINS[digit][-1], -1)
        return row in self._layout.row_of or row in self._number

    def carrier(self, digit: str) -> int:
        """The active segment that is a digit's distal segment, or carries it."""
        row = self._layout.hand.index[CHAINS[digit][-1]]
        own = self._layout.row_of.get(row)
        return self.digits[self._number[row]].parent if own is None else own

    def point(self, state: ChainState, own: Synergies, digit: str, x: Array) -> PointRows:
        """A point of a digit's distal segment, x (3,) in its B in nominal size, m."""
        row = self._layout.hand.index[CHAINS[digit][-1]]
        if row in self._layout.row_of:
            p, H = self.fixed(state, self._layout.row_of[row], x)
            return PointRows(p, H, np.zeros((3, own.value.size)))
        return self._driven_point(state, own, self._number[row], x)

    def _driven_point(self, state: ChainState, own: Synergies, k: int, x: Array) -> PointRows:
        """As a point of the parent, plus the driven rotation (eqs. 50 and 51)."""
        d = self.digits[k]
        segment = self._layout.hand.segments[d.segment]
        bend = self._bend(state, own, k)
        before = segment.R_rest @ so3.rz(own.value[k, ASIDE])
        turned = so3.ry(bend.value) @ (self.scale(state, d) * x)
        p, H = self.fixed(state, d.parent, segment.origin, before @ turned)
        R_G = state.R_GB[d.parent] @ before
        by_flexion = R_G @ np.cross([0.0, 1.0, 0.0], turned)
        H_own = np.outer(by_flexion, bend.H_own)
        H_own[:, OWN * k + ASIDE] = R_G @ np.cross([0.0, 0.0, 1.0], turned)
        return PointRows(p, H + np.outer(by_flexion, bend.H), H_own)

    def scale(self, state: ChainState, digit: Digit) -> Array:
        """(3,) factors of a distal segment: those of the digit's estimated ones (`Completion`)."""
        rows, a = [], digit.parent
        while a > 0:
            rows.append(a)
            a = int(self._layout.parent[a])
        return np.asarray(state.scale3()[rows].mean(axis=0))

    def girth(self, state: ChainState, digit: str) -> float:
        """Scale of the thickness of a digit's distal segment."""
        row = self._layout.hand.index[CHAINS[digit][-1]]
        if row in self._layout.row_of:
            return float(state.scale[self._layout.row_of[row], 1])
        return float(self.scale(state, self.digits[self._number[row]])[1])

    def fixed(
        self, state: ChainState, segment: int, nominal: Array, offset: Array | None = None
    ) -> tuple[Array, Array]:
        """(3,) m in G and Jacobian (3, N) of a point of an active segment, nominal and offset (3,)
        in its B as in `Points`."""
        lay, offset = self._layout, np.zeros(3) if offset is None else offset
        point = Points(np.array([segment]), nominal[None], offset[None])
        H = jacobians(lay.skeleton, lay.blocks, state.body, point, np.array([-1]))[0]
        x = state.scale3()[segment] * nominal + offset
        return segment_positions(state, lay)[segment] + state.R_GB[segment] @ x, H


def _digits(layout: ChainLayout) -> list[Digit]:
    hand = layout.hand
    child_of = {f"{j.name}_flexion": hand.index[j.child] for j in hand.joints}
    out = []
    for name, chain in CHAINS.items():
        row = hand.index.get(chain[-1], -1)
        if row < 0 or row in layout.row_of or hand.parent[row] not in layout.row_of:
            continue
        for link, s in enumerate(hand.synergies):
            source = layout.row_of.get(child_of.get(s.of, -1))
            if child_of.get(s.angle) == row and source is not None:
                out.append(Digit(name, row, layout.row_of[hand.parent[row]], source, link))
    return out
