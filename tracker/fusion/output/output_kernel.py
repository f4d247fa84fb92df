"""The arithmetic of `tracker.fusion.output.output`, compiled: it runs at the glove's rate."""

from __future__ import annotations

import numpy as np

from tracker.fusion.output.completion import complete
from tracker.geometry.kernels import quats
from tracker.kernels import kernel
from tracker.messages import Validity

LOST, INFERRED, MEASURED = int(Validity.LOST), int(Validity.INFERRED), int(Validity.MEASURED)


@kernel
def whole_hand(  # type: ignore[no-untyped-def]
    parent, origin, R_rest, columns, limits, links, gains, row, segment, offset, end_of,
    ancestor, steps, angle_child, angle_parent, angle_column, R, p, scale3, sensed, active_sd,
    inferred_sd, coasting, lost,
):  # fmt: skip
    """The fields of an `Estimate` but for its time and tracking, in their order.

    The first eight arguments are the tables of `Completion`; the others as in the functions below.
    While the hand is ``lost`` no keypoint has a place.
    """
    R_all, p_all, scale, angles, known = complete(
        parent, origin, R_rest, columns, limits, links, gains, row, R, p, scale3
    )
    points, q = keypoint_places(segment, offset, R_all, p_all, scale)
    of_segment = segment_states(row, sensed)
    state = keypoint_states(of_segment, segment, end_of, coasting)
    if lost:
        state[:], points[:], q[:] = LOST, np.nan, np.nan
    sd = keypoint_spread(segment, ancestor, steps, active_sd, inferred_sd)
    angle_state = angle_states(of_segment, angle_child, angle_parent, angle_column, known)
    return points, q, state, sd, angles, angle_state, R_all, p_all


@kernel
def sensed_lately(  # type: ignore[no-untyped-def]
    felt, imu_segment, seen, marker_segment, segments, t, lately
):  # fmt: skip
    """(A,) 1 for each of the active ``segments`` with an IMU that answered, or a marker that was
    seen, less than ``lately`` s before ``t``; felt (n,) and seen (M,) s say when each was last."""
    out = np.zeros(segments, np.int64)
    for j in range(len(felt)):
        if t - felt[j] < lately:
            out[imu_segment[j]] = 1
    for j in range(len(seen)):
        if t - seen[j] < lately:
            out[marker_segment[j]] = 1
    return out


@kernel
def keypoint_places(segment, offset, R, p, scale):  # type: ignore[no-untyped-def]
    """Keypoints (K, 3) m in G and their quaternions (K, 4).

    segment (K,) the row each moves with, offset (K, 3) m in its nominal B; R (S, 3, 3), p (S, 3)
    and scale (S, 3) of all segments.
    """
    q_all = quats(R)
    points, q = np.empty((len(segment), 3)), np.empty((len(segment), 4))
    for k in range(len(segment)):
        s = segment[k]
        q[k] = q_all[s]
        for i in range(3):
            points[k, i] = p[s, i]
            for j in range(3):
                points[k, i] += R[s, i, j] * scale[s, j] * offset[k, j]
    return points, q


@kernel
def segment_states(row, sensed):  # type: ignore[no-untyped-def]
    """(S,) measured where the active segment of ``row`` (S,), -1 for none, is sensed (A,)."""
    out = np.full(len(row), INFERRED)
    for s in range(len(row)):
        if row[s] >= 0 and sensed[row[s]] != 0:
            out[s] = MEASURED
    return out


@kernel
def angle_states(segment_state, child, parent, column, known):  # type: ignore[no-untyped-def]
    """(J,) measured where an angle is known and both its segments (J,) are."""
    out = np.full(len(known), INFERRED)
    for k in range(len(column)):
        both = segment_state[child[k]] == MEASURED and segment_state[parent[k]] == MEASURED
        if both and known[column[k]]:
            out[column[k]] = MEASURED
    return out


@kernel
def keypoint_states(segment_state, segment, end_of, coasting):  # type: ignore[no-untyped-def]
    """(K,) as the segment (K,) it moves with, or the one it is the far end of, -1 for none.

    While coasting nothing of a hand's place is measured.
    """
    out = np.empty(len(segment), np.int64)
    for k in range(len(segment)):
        state = segment_state[segment[k]]
        if end_of[k] >= 0:
            state = max(state, segment_state[end_of[k]])
        out[k] = min(state, INFERRED) if coasting else state
    return out


@kernel
def keypoint_spread(segment, ancestor, steps, active_sd, inferred_sd):  # type: ignore[no-untyped-def]
    """(K,) m: of the nearest estimated ancestor's (S,), and of the steps (S,) from it."""
    out = np.empty(len(segment))
    for k in range(len(segment)):
        s = segment[k]
        out[k] = np.sqrt(active_sd[ancestor[s]] ** 2 + steps[s] * inferred_sd**2)
    return out
