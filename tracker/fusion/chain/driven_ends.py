"""Standard deviations of the far ends of unsensed segments (docs/chain.md, eq. 55)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.distal import ASIDE, OFFSET, OWN, RATIO, DistalSegments, Synergies
from tracker.fusion.chain.kinematics import (
    MOST_COLUMNS,
    OriginJacobians,
    origin_jacobians,
    points_of,
    put_own,
    segment_origins,
    stretched,
)
from tracker.fusion.chain.layout import Blocks, ChainLayout, ChainSkeleton, Points
from tracker.fusion.chain.state import Body, ChainState
from tracker.geometry import so3
from tracker.geometry.kernels import cross3, joint_angles3, mul3, rotate, rotate_all, tmul3
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolMatrix, IntVector, Matrix, Stack, Vector, Written
from tracker.messages import Array, IntArray

ONE_WAY = 1.6
"""The error of an unsensed joint moves its tip along one line, not three: 97 % of normal errors are
within 2.17 of their standard deviation along the line, and three per axis are 1.73."""

STEP = 1e-5  # rad, of central differences
BEYOND = MOST_COLUMNS + 6  # columns that an end adds to those of its segment's origin


class DrivenEnds(NamedTuple):
    """d distal segments that an estimated joint drives (`Digit`).

    parent (d,) active segment that carries it; source (d,) active segment whose joint drives it,
    free (d, 2) whether that joint abducts and twists; origin (d, 3) m and before (d, 3, 3) position
    and rotation in its parent's B, lateral included; length (d,) m.
    """

    parent: IntVector
    source: IntVector
    free: BoolMatrix
    origin: Matrix
    before: Stack
    length: Vector


class PalmPoints(NamedTuple):
    """k keypoints on the root segment and at the digits' first joints on it: keypoint (k,) row
    among the hand's and glove's, nominal (k, 3) m in the root's B, base (k,) number among the joint
    offsets, -1 for none."""

    keypoint: IntArray
    nominal: Array
    base: IntArray


class OwnBends(NamedTuple):
    """The bending parameters: value (d, 3) and covariance P (3 d, 3 d) of `Synergies`, posture (d,)
    rad sd of the individual variation from posture to posture."""

    value: Matrix
    P: Matrix
    posture: Vector


def driven_ends(layout: ChainLayout, distal: DistalSegments, own: Synergies) -> DrivenEnds:
    """The tables for a hand with a wearer's synergies."""
    digits, hand = distal.digits, layout.hand
    columns = hand.axis_columns
    free = [[columns[layout.active[d.source]][k] >= 0 for k in (0, 2)] for d in digits]
    lateral = distal.lateral(own)
    before = [hand.segments[d.segment].R_rest @ so3.rz(lateral[d.segment]) for d in digits]
    return DrivenEnds(
        np.array([d.parent for d in digits], np.int64),
        np.array([d.source for d in digits], np.int64),
        np.array(free, bool).reshape(-1, 2),
        np.array([hand.segments[d.segment].origin for d in digits]).reshape(-1, 3),
        np.array(before).reshape(-1, 3, 3),
        np.array([hand.segments[d.segment].length for d in digits], float),
    )


def palm_points(layout: ChainLayout) -> PalmPoints:
    """Those of a hand with a glove."""
    hand, glove = layout.hand, layout.glove
    moves_with = glove.keypoint_segments(hand)
    offset = [hand.keypoint_offset, *(k.position[None] for k in glove.keypoints)]
    found: list[tuple[int, Array, int]] = []
    for k, (s, x) in enumerate(zip(moves_with, np.concatenate(offset), strict=True)):
        if s == hand.root:
            found.append((k, x, -1))
        elif hand.parent[s] == hand.root and not x.any():
            row = layout.row_of.get(int(s), -1)
            base = int(layout.base_of[row]) if row >= 0 else -1
            found.append((k, np.array(hand.segments[s].origin), base))
    rows, nominal, bases = zip(*found, strict=True)
    return PalmPoints(np.array(rows, np.int64), np.array(nominal), np.array(bases, np.int64))


class EndDeviations:
    """Standard deviations of the ends of all estimated segments, of the segments they drive, and of
    the keypoints of the palm."""

    def __init__(self, layout: ChainLayout, distal: DistalSegments) -> None:
        self._layout, self._distal = layout, distal
        self.palm = palm_points(layout)
        joint = layout.blocks.joint
        self._offset_at = np.where(self.palm.base >= 0, joint + 3 * self.palm.base, -1)
        self.trust(distal.prior())

    @property
    def driven(self) -> tuple[int, ...]:
        """Rows of the hand's segments that are driven by estimated ones."""
        return tuple(d.segment for d in self._distal.digits)

    def trust(self, own: Synergies, posture: Array | None = None) -> None:
        """Sets the wearer's synergies and ``posture`` (d,) rad, the individual variation of each
        joint; default: the population's."""
        self.driven_ends = driven_ends(self._layout, self._distal, own)
        posture = self._distal.posture_sd if posture is None else posture
        self.own = OwnBends(np.array(own.value), np.array(own.P), posture)

    def __call__(self, state: ChainState) -> Array:
        """(A + d + k,) m: root of the mean variance over three axes."""
        lay = self._layout
        return sd_of_ends(
            lay.skeleton, lay.R_rest, lay.blocks, state.body, lay.tips,
            (self._palm(state), self._offset_at), (self.driven_ends, self.own), state.P,
        )  # fmt: skip

    def _palm(self, state: ChainState) -> Points:
        """The palm's keypoints; (k,) first columns of the offsets among the error states, or -1."""
        base = self.palm.base
        offset = np.zeros((len(base), 3))
        offset[base >= 0] = state.joint[base[base >= 0]]
        return Points(np.zeros(len(base), np.int64), self.palm.nominal, offset)

    def positions(self, state: ChainState) -> Array:
        """(A + d + k, 3) m in G, of the same points."""
        lay = self._layout
        origins = segment_origins(lay.skeleton, state.body, state.p)
        ends = points_of(origins, state.body, lay.tips)
        palm = points_of(origins, state.body, self._palm(state))
        if not len(self.driven):
            return np.concatenate([ends, palm])
        driven, *_ = driven_points(
            lay.skeleton, lay.R_rest, lay.blocks, state.body, self.driven_ends, self.own, state.p,
            state.P,
        )  # fmt: skip
        return np.concatenate([ends, driven[:, 1], palm])


@kernel(nogil=False)
def sd_of_ends(
    skeleton: ChainSkeleton,
    R_rest: Stack,
    at: Blocks,
    body: Body,
    ends: Points,
    palm: tuple[Points, IntVector],
    bent: tuple[DrivenEnds, OwnBends],
    P: Matrix,
) -> Vector:
    """(A + d + k,) m of the ``ends`` of all A segments and of the d driven ones (eq. 55), and of
    the k points of the ``palm`` with the first columns of their offsets, or -1."""
    (points, offset_at), (driven, own) = palm, bent
    known = origin_jacobians(skeleton, at, body)
    n, d, room = len(known.used), len(driven.parent), known.value.shape[2] + BEYOND
    out = np.empty(n + d + len(offset_at))
    h, column = np.empty((3, room)), np.empty(room, np.int64)
    for a in range(n):
        k = _point_row(h, column, known, (skeleton, at, body), ends, a, -1)
        out[a] = np.sqrt(max(_trace(h, column, k, P) / 3.0, 0.0))
    for i in range(len(offset_at)):
        k = _point_row(h, column, known, (skeleton, at, body), points, i, offset_at[i])
        out[n + d + i] = np.sqrt(max(_trace(h, column, k, P) / 3.0, 0.0))
    for i in range(d):
        k, bend, turned = _driven_row(
            h, column, known, (skeleton, R_rest), at, body, (driven, own), i
        )
        total = _trace(h, column, k, P) + ONE_WAY * _own_trace(own, i, bend, turned)
        out[n + i] = np.sqrt(max(total / 3.0, 0.0))
    return out


@kernel(nogil=False)
def driven_points(
    skeleton: ChainSkeleton,
    R_rest: Stack,
    at: Blocks,
    body: Body,
    driven: DrivenEnds,
    own: OwnBends,
    p: Vector,
    P: Matrix,
) -> tuple[Stack, Stack, Stack, Matrix]:
    """For d driven segments: the joint and the end, ``length`` beyond it, in G (d, 2, 3) m; the
    end's Jacobian (d, 3, 2) by flexion and lateral, its covariance (d, 3, 3) m² by the state alone;
    flexion (rad) of the driving joint and factor of the girth (d, 2)."""
    known, origins = origin_jacobians(skeleton, at, body), segment_origins(skeleton, body, p)
    d, room = len(driven.parent), known.value.shape[2] + BEYOND
    points, J = np.empty((d, 2, 3)), np.empty((d, 3, 2))
    C, drive = np.empty((d, 3, 3)), np.empty((d, 2))
    h, column = np.empty((3, room)), np.empty(room, np.int64)
    for i in range(d):
        k, bend, turned = _driven_row(
            h, column, known, (skeleton, R_rest), at, body, (driven, own), i
        )
        a = driven.parent[i]
        x = rotate(driven.before[i], turned)
        joint = origins[a] + rotate(body.R_GB[a], stretched(body.scale[a], driven.origin[i]))
        points[i, 0], points[i, 1] = joint, joint + rotate(body.R_GB[a], x)
        across = rotate(driven.before[i], np.array([turned[2], 0.0, -turned[0]]))
        J[i, :, 0] = rotate(body.R_GB[a], across)
        J[i, :, 1] = rotate(body.R_GB[a], cross3(driven.before[i, :, 2].copy(), x))
        _put_covariance(C[i], h, column, k, P)
        drive[i, 0], drive[i, 1] = bend[0], _girth(skeleton, body, a)
    return points, J, C, drive


@kernel
def _driven_row(
    h: Written[Matrix],
    column: Written[IntVector],
    known: OriginJacobians,
    bones: tuple[ChainSkeleton, Stack],
    at: Blocks,
    body: Body,
    ends: tuple[DrivenEnds, OwnBends],
    i: int,
) -> tuple[int, Vector, Vector]:
    """Jacobian h (3, n) of a driven segment's end by the error states ``column``, where an index
    may occur twice; n, and the results of `_bend` and `_turned`."""
    (skeleton, R_rest), (driven, own) = bones, ends
    bend, gradient = _bend(skeleton, R_rest, body, driven, own, i)
    turned = _turned(skeleton, body, driven, bend, i)
    x = rotate(driven.before[i], turned)
    at_parent = driven.parent[i : i + 1], driven.origin[i : i + 1], x.reshape(1, 3)
    k = _point_row(h, column, known, (skeleton, at, body), Points(*at_parent), 0, -1)
    R = mul3(body.R_GB[driven.parent[i]], driven.before[i])
    across = rotate(R, np.array([turned[2], 0.0, -turned[0]]))  # by flexion, about y
    c = driven.source[i]
    for r in range(3):
        for j in range(3):
            h[r, k + j] = across[r] * gradient[0, j]
            h[r, k + 3 + j] = across[r] * gradient[1, j]
    for j in range(3):
        column[k + j] = at.theta + 3 * c + j
        column[k + 3 + j] = at.theta + 3 * skeleton.parent[c] + j
    return k + 6, bend, turned


@kernel
def _put_covariance(out: Written[Matrix], h: Matrix, column: IntVector, n: int, P: Matrix) -> None:
    """out (3, 3) = h P h^T, as in `_trace`."""
    out[:] = 0.0
    for i in range(n):
        for j in range(n):
            p = P[column[i], column[j]]
            for r in range(3):
                for c in range(3):
                    out[r, c] += h[r, i] * p * h[c, j]


@kernel
def _girth(skeleton: ChainSkeleton, body: Body, a: int) -> float:
    """Mean thickness scale of the digit's segments, from ``a`` down to the base."""
    total, many = 0.0, 0
    while a > 0:
        total += body.scale[a, 1]
        many += 1
        a = skeleton.parent[a]
    return total / max(many, 1)


@kernel
def _point_row(
    h: Written[Matrix],
    column: Written[IntVector],
    known: OriginJacobians,
    chain: tuple[ChainSkeleton, Blocks, Body],
    points: Points,
    k: int,
    offset_at: int,
) -> int:
    """Jacobian h (3, n) of the point ``k`` and the error states of its columns; returns n.
    ``offset_at`` is as in `put_own`."""
    (skeleton, at, body), a = chain, points.segment[k]
    n = known.used[a]
    h[:, :n], column[:n] = known.value[a, :, :n], known.column[a, :n]
    return n + put_own(h[:, n:], column[n:], skeleton, at, body, points, k, offset_at)


@kernel
def _trace(h: Matrix, column: IntVector, n: int, P: Matrix) -> float:
    """Trace of h P h^T, h (3, n) by the error states ``column``, where an index may occur twice."""
    total = 0.0
    for i in range(n):
        for j in range(i + 1):
            product = h[0, i] * h[0, j] + h[1, i] * h[1, j] + h[2, i] * h[2, j]
            total += (1.0 if i == j else 2.0) * product * P[column[i], column[j]]
    return total


@kernel
def _bend(
    skeleton: ChainSkeleton,
    R_rest: Stack,
    body: Body,
    driven: DrivenEnds,
    own: OwnBends,
    i: int,
) -> tuple[Vector, Matrix]:
    """(2,) rad: flexion of the digit's driving and driven joint (eq. 49); gradient (2, 3) of the
    latter by the errors of the driving joint's child and parent."""
    c = driven.source[i]
    R_rel = tmul3(R_rest[c], tmul3(body.R_GB[skeleton.parent[c]], body.R_GB[c]))
    by_child, e = np.empty(3), np.zeros((1, 3))
    for k in range(3):
        e[0, k] = STEP
        ahead = _flexion(rotate_all(R_rel.reshape(1, 3, 3), e)[0], driven, i)
        e[0, k] = -STEP
        by_child[k] = (ahead - _flexion(rotate_all(R_rel.reshape(1, 3, 3), e)[0], driven, i)) / (
            2 * STEP
        )
        e[0, k] = 0.0
    ratio, q = own.value[i, RATIO], _flexion(R_rel, driven, i)
    gradient = np.empty((2, 3))
    gradient[0] = ratio * by_child
    gradient[1] = -ratio * rotate(mul3(R_rest[c], R_rel), by_child)
    return np.array([q, ratio * q + own.value[i, OFFSET]]), gradient


@kernel
def _flexion(R_rel: Matrix, driven: DrivenEnds, i: int) -> float:
    return joint_angles3(R_rel, driven.free[i, 0], driven.free[i, 1])[1]


@kernel
def _turned(
    skeleton: ChainSkeleton, body: Body, driven: DrivenEnds, bend: Vector, i: int
) -> Vector:
    """(3,) m from the joint to the end of the driven segment, before its rotation in the parent."""
    length, many, a = 0.0, 0, driven.parent[i]
    while a > 0:
        length += body.scale[a, 0]
        many += 1
        a = skeleton.parent[a]
    length *= driven.length[i] / max(many, 1)
    return np.array([length * np.cos(bend[1]), 0.0, -length * np.sin(bend[1])])


@kernel
def _own_trace(own: OwnBends, i: int, bend: Vector, turned: Vector) -> float:
    """m² of the end, all axes, from the uncertainty of the digit's own bend (eq. 51).

    Ratio, offset and posture add up along the flexion; the lateral angle is about z.
    """
    first = OWN * i
    P = own.P[first : first + OWN, first : first + OWN]
    q = bend[0]
    flexion = q * q * P[RATIO, RATIO] + 2 * q * P[RATIO, OFFSET] + P[OFFSET, OFFSET]
    flexion += own.posture[i] ** 2
    reach2 = turned[0] ** 2 + turned[2] ** 2
    return reach2 * flexion + turned[0] ** 2 * P[ASIDE, ASIDE]
