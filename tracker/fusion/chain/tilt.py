"""Finger accelerometers as relative tilt.

All IMUs of a hand feel the same gravity and the same motion of the dorsum; what differs is where
they stand on the chain. With f_0 the dorsum's specific force, the specific force at finger IMU j is
predicted as  h_j = R_IB_j R_GB_j^T sum_a R_GB_a c_a + b_a,  c_a = alpha x l + w x (w x l) along the
chain and f_0 added at the root. Gravity itself cancels, so the camera's tilt does not matter. This
is the compensation of Lemak et al. 2020 (eq. 4) carried to three dimensions.
"""

from __future__ import annotations

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tilt_kernel import stacked_rows
from tracker.fusion.time.imu_buffer import Readings
from tracker.messages import Array


def tilt_rows(
    state: ChainState,
    layout: ChainLayout,
    params: ConstraintParams,
    before: Readings,
    sample: Readings,
    after: Readings,
) -> tuple[Array, Array, Array] | None:
    """Rows at ``sample``'s instant; the neighbours give the angular acceleration.

    Returns H (3k, N), innovation (3k,), variances (3k,) for the k finger IMUs that answer; None
    where the root's IMU does not.
    """
    source, gain = layout.drive
    H, r, var = stacked_rows(
        layout.imu_segment, layout.imu_position, layout.imu_of, source, gain, layout.parent,
        layout.origin, layout.base_of, layout.root_lever, state.joint, state.scale, state.R_GB,
        state.R_IB, state.bg, state.ba, before.gyro, before.valid, sample.accel, sample.gyro,
        sample.valid, after.gyro, after.valid, after.t - before.t,
        layout.theta, layout.phi, layout.ba, layout.size, params.tilt, params.tilt_kinematic,
    )  # fmt: skip
    return (H, r, var) if len(r) else None
