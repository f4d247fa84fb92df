"""Points of the chain in G and their Jacobians (mathematics of the chain filter).

A point of segment s stands at  p_root + sum over the chain of R_GB (scale * nominal + offset). The
root's own frame hangs on its IMU, whose position is the state: B_0 = p - R_0 (scale_0 * i_0).
Arrays are those of `ChainLayout` and `ChainState`; A active segments, n points.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.geometry.kernels import rotate
from tracker.kernels import kernel
from tracker.messages import Array, IntArray


def segment_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(A, 3) origins p_GB of the active segments."""
    return segment_origins(
        layout.parent,
        layout.origin,
        layout.base_of,
        layout.root_lever,
        state.joint,
        state.scale,
        state.R_GB,
        state.p,
    )


def marker_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(M, 3) in G of all markers."""
    return points_of(
        segment_positions(state, layout),
        state.R_GB,
        state.scale,
        layout.marker_segment,
        layout.glove.marker_position,
        state.marker,
    )


def point_jacobians(
    state: ChainState,
    layout: ChainLayout,
    segment: IntArray,
    nominal: Array,
    offset: Array,
    offset_column: IntArray,
) -> Array:
    """J_point_error (n, 3, N). ``offset_column`` is where a point's own offset stands, or -1."""
    return _jacobians(
        layout.parent,
        layout.origin,
        layout.base_of,
        layout.root_lever,
        state.joint,
        state.scale,
        state.R_GB,
        segment,
        nominal,
        offset,
        offset_column,
        layout.theta,
        layout.scale,
        layout.joint,
        layout.size,
    )


def marker_jacobians(state: ChainState, layout: ChainLayout, rows: IntArray) -> Array:
    """J_marker_error (n, 3, N) of the markers ``rows``."""
    return point_jacobians(
        state,
        layout,
        layout.marker_segment[rows],
        layout.glove.marker_position[rows],
        state.marker[rows],
        layout.marker + 3 * rows,
    )


def tip_sd(state: ChainState, layout: ChainLayout) -> Array:
    """(A,) m: root of the mean variance of each active segment's end."""
    return _tip_spread(
        layout.parent,
        layout.origin,
        layout.base_of,
        layout.root_lever,
        state.joint,
        state.scale,
        state.R_GB,
        layout.tip,
        layout.theta,
        layout.scale,
        layout.joint,
        state.P,
    )


@kernel
def turned(R, segment, v):  # type: ignore[no-untyped-def]
    """(n, 3) v in G, of v (n, 3) given in the B of ``segment`` (n,), with R_GB (A, 3, 3)."""
    out = np.empty((len(v), 3))
    for k in range(len(v)):
        a = segment[k]
        for i in range(3):
            out[k, i] = R[a, i, 0] * v[k, 0] + R[a, i, 1] * v[k, 1] + R[a, i, 2] * v[k, 2]
    return out


@kernel
def stretched(scale, x):  # type: ignore[no-untyped-def]
    """(3,) x (3,) grown by the factors (2,) of length and girth."""
    return np.array([scale[0] * x[0], scale[1] * x[1], scale[1] * x[2]])


@kernel
def joint_lever(scale, origin, joint, base_of, child, a):  # type: ignore[no-untyped-def]
    """(3,) m where the joint of the segment ``child`` stands in the B of its parent ``a``."""
    x = stretched(scale[a], origin[child])
    return x + joint[base_of[child]] if base_of[child] >= 0 else x


@kernel
def points_of(p_GB, R, scale, segment, nominal, offset):  # type: ignore[no-untyped-def]
    """(n, 3) in G of points given in the B of their active ``segment`` (n,), m.

    ``nominal`` (n, 3) grows with the scale (A, 2), ``offset`` (n, 3) does not.
    """
    out = np.empty((len(segment), 3))
    for k in range(len(segment)):
        a = segment[k]
        out[k] = p_GB[a] + rotate(R[a], stretched(scale[a], nominal[k]) + offset[k])
    return out


@kernel
def segment_origins(parent, origin, base_of, lever, joint, scale, R, p):  # type: ignore[no-untyped-def]
    """(A, 3) p_GB; ``lever`` (3,) m is of the point that p is of, in the root's B."""
    out = np.empty((len(parent), 3))
    for i in range(len(parent)):
        a = parent[i]
        if a < 0:
            out[i] = p - rotate(R[i], stretched(scale[i], lever))
        else:
            out[i] = out[a] + rotate(R[a], joint_lever(scale, origin, joint, base_of, i, a))
    return out


MOST_COLUMNS = 8  # that a segment adds: its orientation, its scales, an offset


@kernel
def put_link(value, column, R, x, nominal, first, scale, offset):  # type: ignore[no-untyped-def]
    """Slopes of R_GB x by the error states of one segment, and where these states stand.

    x (3,) m is what ``nominal`` (3,) has grown to, with an offset that is a state too where its
    first column ``offset`` >= 0; ``first`` and ``scale`` are those of the orientation and of the
    scales. Fills value (3, 8) and column (8,); returns how many columns it fills.
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
def from_point(a, x, lever, scale):  # type: ignore[no-untyped-def]
    """x (3,) m in the B of segment ``a``, in the root's counted from the point that p is of."""
    return x - stretched(scale, lever) if a == 0 else x


@kernel
def origin_slopes(  # type: ignore[no-untyped-def]
    parent, origin, base_of, lever, joint, scale, R, theta, scale_at, joint_at
):  # fmt: skip
    """What each segment's origin depends on, but for the lever of p in the root.

    count (A,), column (A, K) and value (A, 3, K) of the columns that are not zero; of the root, p.
    """
    n, ones = len(parent), np.ones(2)
    most = 3 + MOST_COLUMNS * n
    count = np.zeros(n, np.int64)
    column, value = np.zeros((n, most), np.int64), np.zeros((n, 3, most))
    for c in range(n):
        a = parent[c]
        if a < 0:
            count[c] = 3
            for r in range(3):
                column[c, r], value[c, r, r] = r, 1.0
            continue
        k = count[a]
        column[c, :k], value[c, :, :k] = column[a, :k], value[a, :, :k]
        x = from_point(a, joint_lever(scale, origin, joint, base_of, c, a), lever, scale[a])
        offset = joint_at + 3 * base_of[c] if base_of[c] >= 0 else -1
        count[c] = k + put_link(
            value[c, :, k:], column[c, k:], R[a], x, from_point(a, origin[c], lever, ones),
            theta + 3 * a, scale_at + 2 * a, offset,
        )  # fmt: skip
    return count, column, value


@kernel
def put_own(  # type: ignore[no-untyped-def]
    value, column, a, nominal, offset, lever, scale, R, theta, scale_at, offset_at
):  # fmt: skip
    """`put_link` of a point of segment ``a`` at ``nominal`` and ``offset`` (3,) m in its B."""
    x = from_point(a, stretched(scale[a], nominal) + offset, lever, scale[a])
    unit = from_point(a, nominal, lever, np.ones(2))
    first, second = theta + 3 * a, scale_at + 2 * a
    return put_link(value, column, R[a], x, unit, first, second, offset_at)


@kernel
def _jacobians(  # type: ignore[no-untyped-def]
    parent, origin, base_of, lever, joint, scale, R, segment, nominal, offset, offset_column,
    theta, scale_at, joint_at, size,
):  # fmt: skip
    count, column, value = origin_slopes(
        parent, origin, base_of, lever, joint, scale, R, theta, scale_at, joint_at
    )
    H = np.zeros((len(segment), 3, size))
    own, at = np.empty((3, MOST_COLUMNS)), np.empty(MOST_COLUMNS, np.int64)
    for k in range(len(segment)):
        a = segment[k]
        n = put_own(own, at, a, nominal[k], offset[k], lever, scale, R, theta, scale_at,
                    offset_column[k])  # fmt: skip
        for r in range(3):
            for i in range(count[a]):
                H[k, r, column[a, i]] = value[a, r, i]
            for i in range(n):
                H[k, r, at[i]] = own[r, i]
    return H


@kernel
def _tip_spread(  # type: ignore[no-untyped-def]
    parent, origin, base_of, lever, joint, scale, R, tip, theta, scale_at, joint_at, P
):  # fmt: skip
    """(A,) root of a third of the trace of H P H^T of the segments' ends ``tip`` (A, 3) m in B."""
    count, column, value = origin_slopes(
        parent, origin, base_of, lever, joint, scale, R, theta, scale_at, joint_at
    )
    out, none = np.empty(len(parent)), np.zeros(3)
    for a in range(len(parent)):
        k, h, at = count[a], value[a], column[a]
        k += put_own(h[:, k:], at[k:], a, tip[a], none, lever, scale, R, theta, scale_at, -1)
        total = 0.0
        for i in range(k):
            for j in range(i + 1):
                product = h[0, i] * h[0, j] + h[1, i] * h[1, j] + h[2, i] * h[2, j]
                total += (1.0 if i == j else 2.0) * product * P[at[i], at[j]]
        out[a] = np.sqrt(max(total / 3.0, 0.0))
    return out
