"""Points of the chain in G and their Jacobians (docs/chain.md, eqs. 4 to 7).

A point of segment s is at  p_root + sum over the chain of R_GB (scale * nominal + offset). The
root's own frame is defined by its IMU, whose position is the state: B_0 = p - R_0 (scale_0 * i_0).
Arrays are those of `ChainLayout` and `ChainState`; A active segments, n points.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.layout import Blocks, ChainLayout, ChainSkeleton, Points
from tracker.fusion.chain.state import Body, ChainState
from tracker.geometry.kernels import rotate
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Vector, Written
from tracker.messages import Array, IntArray

MOST_COLUMNS = 8  # of one segment: its orientation, its scales, an offset


class OriginJacobians(NamedTuple):
    """Jacobians of each segment's origin, except for the lever of p in the root.

    The first ``used`` (A,) columns are not zero: their numbers column (A, K), values (A, 3, K).
    """

    used: IntVector
    column: IntMatrix
    value: Stack


def marker_points(state: ChainState, layout: ChainLayout) -> Points:
    """All markers as points of the chain."""
    return Points(layout.marker_segment, layout.marker_position, state.marker)


def segment_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(A, 3) origins p_GB of the active segments."""
    return segment_origins(layout.skeleton, state.body, state.p)


def marker_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(M, 3) in G of all markers."""
    return positions(layout.skeleton, state.body, state.p, marker_points(state, layout))


def marker_jacobians(state: ChainState, layout: ChainLayout, rows: IntArray) -> Array:
    """J_marker_error (n, 3, N) of the markers ``rows``."""
    segment, nominal, offset = marker_points(state, layout)
    markers = Points(segment[rows], nominal[rows], offset[rows])
    return jacobians(
        layout.skeleton, layout.blocks, state.body, markers, layout.blocks.marker + 3 * rows
    )


@kernel
def rotated(R: Stack, segment: IntVector, v: Matrix) -> Matrix:
    """(n, 3) v in G, of v (n, 3) given in the B of ``segment`` (n,), with R_GB (A, 3, 3)."""
    out = np.empty((len(v), 3))
    for k in range(len(v)):
        a = segment[k]
        for i in range(3):
            out[k, i] = R[a, i, 0] * v[k, 0] + R[a, i, 1] * v[k, 1] + R[a, i, 2] * v[k, 2]
    return out


@kernel
def stretched(scale: Vector, x: Vector) -> Vector:
    """(3,) x (3,) scaled by the factors (2,) of length and girth."""
    return np.array([scale[0] * x[0], scale[1] * x[1], scale[1] * x[2]])


@kernel
def joint_lever(skeleton: ChainSkeleton, body: Body, child: int, a: int) -> Vector:
    """(3,) m, the joint of the segment ``child`` in the B of its parent ``a``."""
    x, base = stretched(body.scale[a], skeleton.origin[child]), skeleton.base_of[child]
    return x + body.joint[base] if base >= 0 else x


@kernel(nogil=False)
def positions(skeleton: ChainSkeleton, body: Body, p: Vector, points: Points) -> Matrix:
    """(n, 3) m in G; p (3,) as in `segment_origins`."""
    return points_of(segment_origins(skeleton, body, p), body, points)


@kernel
def points_of(p_GB: Matrix, body: Body, points: Points) -> Matrix:
    """(n, 3) m in G, given the segments' origins p_GB (A, 3)."""
    out = np.empty((len(points.segment), 3))
    for k in range(len(points.segment)):
        a = points.segment[k]
        x = stretched(body.scale[a], points.nominal[k]) + points.offset[k]
        out[k] = p_GB[a] + rotate(body.R_GB[a], x)  # eq. 5
    return out


@kernel(nogil=False)
def segment_origins(skeleton: ChainSkeleton, body: Body, p: Vector) -> Matrix:
    """(A, 3) p_GB; p (3,) m in G is of the point at the skeleton's lever."""
    parent, R = skeleton.parent, body.R_GB
    out = np.empty((len(parent), 3))
    for i in range(len(parent)):
        a = parent[i]
        if a < 0:  # eq. 4
            out[i] = p - rotate(R[i], stretched(body.scale[i], skeleton.lever))
        else:
            out[i] = out[a] + rotate(R[a], joint_lever(skeleton, body, i, a))
    return out


@kernel
def put_link(
    value: Written[Matrix],
    column: Written[IntVector],
    R: Matrix,
    x: Vector,
    nominal: Vector,
    first: int,
    scale: int,
    offset: int,
) -> int:
    """Jacobian of R_GB x by the error states of one segment (eq. 6), and their column numbers.

    x (3,) m is the scaled ``nominal`` (3,) plus an offset, which is a state as well where its first
    column ``offset`` >= 0; ``first`` and ``scale`` are the first columns of the orientation and of
    the scales. Fills value (3, 8) and column (8,); returns the number of columns.
    """
    for r in range(3):
        value[r, 0] = R[r, 2] * x[1] - R[r, 1] * x[2]
        value[r, 1] = R[r, 0] * x[2] - R[r, 2] * x[0]
        value[r, 2] = R[r, 1] * x[0] - R[r, 0] * x[1]
        value[r, 3] = R[r, 0] * nominal[0]
        value[r, 4] = R[r, 1] * nominal[1] + R[r, 2] * nominal[2]
        for k in range(3):
            value[r, 5 + k] = R[r, k]
    for k in range(3):
        column[k], column[5 + k] = first + k, offset + k
    column[3], column[4] = scale, scale + 1
    return 8 if offset >= 0 else 5


@kernel
def from_point(a: int, x: Vector, lever: Vector, scale: Vector) -> Vector:
    """x (3,) m in the B of segment ``a``; in the root, relative to the point whose position is p
    (eq. 7)."""
    return x - stretched(scale, lever) if a == 0 else x


@kernel
def origin_jacobians(skeleton: ChainSkeleton, at: Blocks, body: Body) -> OriginJacobians:
    """Each origin has its parent's columns and those of the link between; the root depends on p."""
    parent, lever, base_of = skeleton.parent, skeleton.lever, skeleton.base_of
    n, ones = len(parent), np.ones(2)
    most = 3 + MOST_COLUMNS * n
    used = np.zeros(n, np.int64)
    column, value = np.zeros((n, most), np.int64), np.zeros((n, 3, most))
    for c in range(n):
        a = parent[c]
        if a < 0:
            used[c] = 3
            for r in range(3):
                column[c, r], value[c, r, r] = r, 1.0
            continue
        k = used[a]
        column[c, :k], value[c, :, :k] = column[a, :k], value[a, :, :k]
        x = from_point(a, joint_lever(skeleton, body, c, a), lever, body.scale[a])
        offset = at.joint + 3 * base_of[c] if base_of[c] >= 0 else -1
        used[c] = k + put_link(
            value[c, :, k:], column[c, k:], body.R_GB[a], x,
            from_point(a, skeleton.origin[c], lever, ones),
            at.theta + 3 * a, at.scale + 2 * a, offset,
        )  # fmt: skip
    return OriginJacobians(used, column, value)


@kernel
def put_own(
    value: Written[Matrix],
    column: Written[IntVector],
    skeleton: ChainSkeleton,
    at: Blocks,
    body: Body,
    points: Points,
    k: int,
    offset_at: int,
) -> int:
    """`put_link` of the point ``k``; ``offset_at`` is the column of its offset, -1 for none."""
    a, lever, nominal = points.segment[k], skeleton.lever, points.nominal[k]
    x = stretched(body.scale[a], nominal) + points.offset[k]
    x = from_point(a, x, lever, body.scale[a])
    unit = from_point(a, nominal, lever, np.ones(2))
    first, second = at.theta + 3 * a, at.scale + 2 * a
    return put_link(value, column, body.R_GB[a], x, unit, first, second, offset_at)


@kernel(nogil=False)
def jacobians(
    skeleton: ChainSkeleton, at: Blocks, body: Body, points: Points, offset_at: IntVector
) -> Stack:
    """J_point_error (n, 3, N). ``offset_at`` (n,) is the column of a point's own offset, or -1."""
    used, column, value = origin_jacobians(skeleton, at, body)
    H = np.zeros((len(points.segment), 3, at.size))
    own, own_column = np.empty((3, MOST_COLUMNS)), np.empty(MOST_COLUMNS, np.int64)
    for k in range(len(points.segment)):
        a = points.segment[k]
        n = put_own(own, own_column, skeleton, at, body, points, k, offset_at[k])
        for r in range(3):
            for i in range(used[a]):
                H[k, r, column[a, i]] = value[a, r, i]
            for i in range(n):
                H[k, r, own_column[i]] = own[r, i]
    return H
