"""Finger accelerometers as relative tilt.

All IMUs of a hand feel the same gravity and the same motion of the dorsum; what differs is where
they stand on the chain. With f_0 the dorsum's specific force, the specific force at finger IMU j is
predicted as  h_j = R_IB_j R_GB_j^T sum_a R_GB_a c_a + b_a,  c_a = alpha x l + w x (w x l) along the
chain and f_0 added at the root. Gravity itself cancels, so the camera's tilt does not matter. This
is the compensation of Lemak et al. 2020 (eq. 4) carried to three dimensions.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import ConstraintParams
from tracker.fusion.propagate import body_rates, root_force
from tracker.fusion.state import ChainState
from tracker.geometry.kernels import cross3, skew3
from tracker.messages import Array, ImuSample


def tilt_rows(
    state: ChainState,
    layout: ChainLayout,
    params: ConstraintParams,
    before: ImuSample,
    sample: ImuSample,
    after: ImuSample,
) -> tuple[Array, Array, Array] | None:
    """Rows at ``sample``'s instant; the neighbours give the angular acceleration.

    Returns H (3k, N), innovation (3k,), variances (3k,) for the k finger IMUs that answer; None
    where the root's IMU does not.
    """
    f_0 = root_force(state, layout, sample)
    if f_0 is None:
        return None
    w = body_rates(state, layout, sample)
    span = after.t - before.t
    alpha = (body_rates(state, layout, after) - body_rates(state, layout, before)) / span
    H: list[Array] = []
    r: list[Array] = []
    var: list[Array] = []
    for j, segment in enumerate(layout.imu_segment):
        if segment == 0 or not sample.valid[j]:
            continue
        chain = _levers(state, layout, int(segment), layout.imu_position[j])
        h, predicted, kinematic = _row(state, layout, j, chain, w, alpha, f_0)
        H.append(h)
        r.append(sample.accel[j] - predicted)
        sd2 = params.tilt**2 + (params.tilt_kinematic * kinematic) ** 2
        var.append(np.full(3, sd2))
    if not H:
        return None
    return np.concatenate(H), np.concatenate(r), np.concatenate(var)


def _levers(
    state: ChainState, layout: ChainLayout, segment: int, position: Array
) -> list[tuple[int, Array]]:
    """(segment, lever in its B) from the point back to the root's IMU."""
    scale, joint = state.scale3(), state.joint_offsets(layout)
    out = [(segment, scale[segment] * position)]
    a = segment
    while layout.parent[a] >= 0:
        c, a = a, int(layout.parent[a])
        lever = scale[a] * layout.origin[c] + joint[c]
        if a == 0:
            lever = lever - scale[0] * layout.root_lever
        out.append((a, lever))
    return out


def _row(
    state: ChainState,
    layout: ChainLayout,
    j: int,
    chain: list[tuple[int, Array]],
    w: Array,
    alpha: Array,
    f_0: Array,
) -> tuple[Array, Array, float]:
    """J_f_error (3, N), predicted reading (3,), size of the kinematic part (m/s²)."""
    segment = chain[0][0]
    c_of = [(a, cross3(alpha[a], lever) + cross3(w[a], cross3(w[a], lever))) for a, lever in chain]
    kinematic_G = sum((state.R_GB[a] @ c for a, c in c_of), np.zeros(3))
    s_G = kinematic_G + state.R_GB[0] @ f_0
    s = state.R_GB[segment].T @ s_G
    R_IB = state.R_IB[j]
    M = R_IB @ state.R_GB[segment].T
    h = np.zeros((3, layout.size))
    for a, c in c_of:
        total = c + f_0 if a == 0 else c
        h[:, layout.theta + 3 * a : layout.theta + 3 * a + 3] -= M @ state.R_GB[a] @ skew3(total)
    turn = R_IB @ skew3(s)
    h[:, layout.theta + 3 * segment : layout.theta + 3 * segment + 3] += turn
    h[:, layout.phi + 3 * j : layout.phi + 3 * j + 3] -= turn
    h[:, layout.ba + 3 * j : layout.ba + 3 * j + 3] += np.eye(3)
    root = layout.imu_of[0]
    R_0 = M @ state.R_GB[0]
    h[:, layout.phi + 3 * root : layout.phi + 3 * root + 3] += R_0 @ skew3(f_0)
    h[:, layout.ba + 3 * root : layout.ba + 3 * root + 3] -= R_0 @ state.R_IB[root].T
    return h, R_IB @ s + state.ba[j], float(np.linalg.norm(kinematic_G))
