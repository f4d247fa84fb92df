"""Finger accelerometers as relative tilt.

All IMUs of a hand feel the same gravity and the same motion of the dorsum; what differs is where
they stand on the chain. With f_0 the dorsum's specific force, the specific force at finger IMU j is
predicted as  h_j = R_IB_j R_GB_j^T sum_a R_GB_a c_a + b_a,  c_a = alpha x l + w x (w x l) along the
chain and f_0 added at the root. Gravity itself cancels, so the camera's tilt does not matter. This
is the compensation of Lemak et al. 2020 (eq. 4) carried to three dimensions.
"""

from __future__ import annotations

from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import ConstraintParams
from tracker.fusion.propagate import body_rates, root_force
from tracker.fusion.state import ChainState
from tracker.fusion.tilt_kernel import stacked_rows
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
    H, r, var = stacked_rows(
        layout.imu_segment, layout.imu_position, layout.parent, layout.origin,
        state.joint_offsets(layout), layout.root_lever, state.scale3(), state.R_GB, state.R_IB,
        state.ba, sample.accel, sample.valid, w, alpha, f_0, int(layout.imu_of[0]),
        layout.theta, layout.phi, layout.ba, layout.size, params.tilt, params.tilt_kinematic,
    )  # fmt: skip
    return (H, r, var) if len(r) else None
