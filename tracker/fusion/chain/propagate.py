"""Moving the chain's state with IMU data, nominal state and covariance."""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain import propagate_kernel as kernel
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.state import ChainState
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals, Readings
from tracker.messages import Array


def body_rates(state: ChainState, layout: ChainLayout, sample: Readings) -> Array:
    """(A, 3) rad/s of each active segment in its own B.

    A segment without a (valid) IMU turns with its parent, and bends as its synergy says.
    """
    source, gain = layout.drive
    return kernel.body_rates(
        layout.imu_of,
        layout.parent,
        source,
        gain,
        state.R_GB,
        state.R_IB,
        state.bg,
        sample.gyro,
        sample.valid,
    )


def root_force(state: ChainState, layout: ChainLayout, sample: Readings) -> Array | None:
    """(3,) specific force of the root's IMU in its B, m/s²; None where it does not answer."""
    f, felt = kernel.root_force(layout.imu_of, state.R_IB, state.ba, sample.accel, sample.valid)
    return f if felt else None


def transition(state: ChainState, layout: ChainLayout, sample: Readings, dt: float) -> Array:
    """(D, scale) Phi: the dynamic rows against all columns before the scales."""
    f = root_force(state, layout, sample)
    return kernel.transition(
        layout.imu_of,
        layout.parent,
        state.R_GB,
        state.R_IB,
        sample.valid,
        body_rates(state, layout, sample),
        np.zeros(3) if f is None else f,
        f is not None,
        dt,
        layout.theta,
        layout.bg,
        layout.phi,
        layout.ba,
        layout.scale,
    )


def propagate(
    state: ChainState,
    layout: ChainLayout,
    params: ChainParams,
    way: Intervals,
    part: slice = slice(None),
    coasting: tuple[float, float] = (np.inf, 0.0),
) -> None:
    """Move ``state`` in place through a ``part`` of the intervals of ``way``.

    ``coasting`` is an instant (s) and how long after it (s) velocity begins to be damped: without
    images a double integral flies away.
    """
    noise = params.noise
    source, gain = layout.drive
    state.p, state.v, state.R_GB = kernel.steps(
        layout.imu_of, layout.parent, source, gain,
        state.p, state.v, state.R_GB, state.bg, state.R_IB, state.ba, state.P,
        way.start[part], way.stop[part], way.accel[part], way.gyro[part], way.valid[part],
        *coasting, layout.theta, layout.bg, layout.phi, layout.ba, layout.scale, layout.joint,
        noise.accel, noise.free_accel, noise.gyro, noise.free_rotation, noise.free_root_rotation,
        noise.gyro_bias, noise.mounting, noise.accel_bias, noise.scale, noise.offset,
    )  # fmt: skip
    state.t = float(way.stop[part][-1])


def carry(
    state: ChainState, layout: ChainLayout, buffer: ImuBuffer, t: float, coasting: bool = False
) -> None:
    """Move the nominal state, its covariance left behind, to ``t`` with the packets on the way."""
    if t <= state.t:
        return
    source, gain = layout.drive
    state.p, state.v, state.R_GB, state.t = kernel.carry(
        layout.imu_of, layout.parent, source, gain,
        state.p, state.v, state.R_GB, state.bg, state.R_IB, state.ba,
        *buffer.table, state.t, t, coasting,
    )  # fmt: skip
