"""Points of the chain in G and their Jacobians (mathematics of the chain filter).

A point of segment s stands at  p_root + sum over the chain of R_GB (scale * nominal + offset). The
root's own frame hangs on its IMU, whose position is the state: B_0 = p - R_0 (scale_0 * i_0).
Arrays are those of `ChainLayout` and `ChainState`; A active segments, n points.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.layout import ChainLayout
from tracker.fusion.state import ChainState
from tracker.geometry.kernels import act3
from tracker.kernels import kernel
from tracker.messages import Array, IntArray


def segment_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(A, 3) origins p_GB of the active segments."""
    return _origins(
        layout.parent,
        layout.origin,
        state.joint_offsets(layout),
        state.scale3(),
        state.R_GB,
        state.p,
        layout.root_lever,
    )


def point_positions(
    state: ChainState, layout: ChainLayout, segment: IntArray, nominal: Array, offset: Array
) -> Array:
    """(n, 3) in G of points given in their active segment's B (m)."""
    p_GB = segment_positions(state, layout)
    return _points(p_GB, state.R_GB, state.scale3(), segment, nominal, offset)


def marker_positions(state: ChainState, layout: ChainLayout) -> Array:
    """(M, 3) in G of all markers."""
    return point_positions(
        state, layout, layout.marker_segment, layout.glove.marker_position, state.marker
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
        state.joint_offsets(layout),
        layout.base_of,
        state.scale3(),
        state.R_GB,
        layout.root_lever,
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
    rows = np.arange(len(layout.active))
    none = np.full(len(rows), -1, np.int64)
    H = point_jacobians(state, layout, rows, layout.tip, np.zeros_like(layout.tip), none)
    return _spread(H, state.P)


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
def _points(p_GB, R, scale, segment, nominal, offset):  # type: ignore[no-untyped-def]
    out = turned(R, segment, scale[segment] * nominal + offset)
    for k in range(len(out)):
        out[k] += p_GB[segment[k]]
    return out


@kernel
def _origins(parent, origin, joint, scale, R, p, lever):  # type: ignore[no-untyped-def]
    out = np.empty((len(parent), 3))
    for i in range(len(parent)):
        a = parent[i]
        if a < 0:
            out[i] = p - act3(R[i], scale[i] * lever)
        else:
            out[i] = out[a] + act3(R[a], scale[a] * origin[i] + joint[i])
    return out


@kernel
def _add_lever(H, R, x, column, sign):  # type: ignore[no-untyped-def]
    """H[:, column:column+3] += sign * (-R [x]x)."""
    for r in range(3):
        H[r, column] -= sign * (R[r, 1] * x[2] - R[r, 2] * x[1])
        H[r, column + 1] -= sign * (R[r, 2] * x[0] - R[r, 0] * x[2])
        H[r, column + 2] -= sign * (R[r, 0] * x[1] - R[r, 1] * x[0])


@kernel
def _add_scale(H, R, nominal, column, sign):  # type: ignore[no-untyped-def]
    for r in range(3):
        H[r, column] += sign * R[r, 0] * nominal[0]
        H[r, column + 1] += sign * (R[r, 1] * nominal[1] + R[r, 2] * nominal[2])


@kernel
def _jacobians(  # type: ignore[no-untyped-def]
    parent, origin, joint, base_of, scale, R, lever, segment, nominal, offset, offset_column,
    theta, scale_column, joint_column, size,
):  # fmt: skip
    H = np.zeros((len(segment), 3, size))
    for k in range(len(segment)):
        h = H[k]
        for r in range(3):
            h[r, r] = 1.0
        a = segment[k]
        if offset_column[k] >= 0:
            h[:, offset_column[k] : offset_column[k] + 3] = R[a]
        _add_lever(h, R[a], scale[a] * nominal[k] + offset[k], theta + 3 * a, 1.0)
        _add_scale(h, R[a], nominal[k], scale_column + 2 * a, 1.0)
        while parent[a] >= 0:
            c = a
            a = parent[c]
            _add_lever(h, R[a], scale[a] * origin[c] + joint[c], theta + 3 * a, 1.0)
            _add_scale(h, R[a], origin[c], scale_column + 2 * a, 1.0)
            if base_of[c] >= 0:
                column = joint_column + 3 * base_of[c]
                h[:, column : column + 3] = R[a]
        _add_lever(h, R[a], scale[a] * lever, theta + 3 * a, -1.0)
        _add_scale(h, R[a], lever, scale_column + 2 * a, -1.0)
    return H


@kernel
def _spread(H, P):  # type: ignore[no-untyped-def]
    """(n,) root of a third of the trace of H P H^T, of H (n, 3, N) with few entries a row."""
    n, size = len(H), len(P)
    out, column = np.empty(n), np.empty(size, np.int64)
    for k in range(n):
        total = 0.0
        for r in range(3):
            h, count = H[k, r], 0
            for i in range(size):
                if h[i] != 0.0:
                    column[count] = i
                    count += 1
            for a in range(count):
                i = column[a]
                total += h[i] * h[i] * P[i, i]
                for b in range(a):
                    total += 2.0 * h[i] * P[i, column[b]] * h[column[b]]
        out[k] = np.sqrt(max(total / 3.0, 0.0))
    return out
