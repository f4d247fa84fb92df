"""Variances of a hand whose nominal state is propagated beyond the filter's (docs/chain.md)."""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.fusion.chain.layout import Blocks, ChainLayout, V
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.state import ChainState
from tracker.geometry.kernels import mul3, skew3
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix
from tracker.messages import Array


def ahead_variance(state: ChainState, layout: ChainLayout, noise: NoiseParams, tau: float) -> float:
    """m² per axis that the root's position gains in ``tau`` s (eq. 56).

    The velocity error contributes linearly in time; a tilt error is mistaken for acceleration, as
    is an accelerometer bias, both quadratically.
    """
    at = layout.blocks
    velocity, tilt = _mean_variance(state.P, V), _mean_variance(state.P, at.theta)
    bias = _mean_variance(state.P, at.ba) if layout.imu_of[0] >= 0 else 0.0
    pull = GRAVITY**2 * tilt + bias
    return velocity * tau**2 + pull * tau**4 / 4 + noise.accel**2 * tau**3 / 3


def velocity_variance(
    state: ChainState, layout: ChainLayout, noise: NoiseParams, tau: float, accel: Array
) -> float:
    """m²/s² per axis of the root's velocity after ``tau`` s (eq. 78); accel (3,) m/s² is the last
    reading of its IMU."""
    j, R_GB = int(layout.imu_of[0]), state.R_GB[0]
    R_IB, ba = (state.R_IB[j], state.ba[j]) if j >= 0 else (np.eye(3), np.zeros(3))
    pull = acceleration_variance(state.P, layout.blocks, j, R_GB, R_IB)
    moved = R_GB @ (R_IB.T @ (accel - ba)) - (0.0, 0.0, GRAVITY)
    density = noise.accel**2 + noise.accel_gain**2 * float(moved @ moved)  # eq. 17
    random = _mean_variance(state.P, V) + density * tau
    return state.velocity_ratio * random + pull * tau**2


@kernel(nogil=False)
def acceleration_variance(P: Matrix, at: Blocks, imu: int, R_GB: Matrix, R_IB: Matrix) -> float:
    """(m/s²)², mean of three axes, of the acceleration of a hand at rest by the orientation of the
    root segment, R_GB (3, 3), and the mounting and bias of its ``imu`` (eq. 15), whose errors are
    correlated in P (N, N); without ``imu``, -1, by the orientation."""
    f = GRAVITY * R_GB[2]  # specific force at rest, in B
    J_theta = mul3(R_GB, skew3(f))
    if imu < 0:
        return _trace_by(J_theta, J_theta, P, at.theta, at.theta) / 3
    J_ba = mul3(R_GB, R_IB.T)
    theta, phi, ba = at.theta, at.phi + 3 * imu, at.ba + 3 * imu
    own = _trace_by(J_theta, J_theta, P, theta, theta) + _trace_by(J_theta, J_theta, P, phi, phi)
    own += _trace_by(J_ba, J_ba, P, ba, ba)
    shared = _trace_by(J_theta, J_ba, P, theta, ba) - _trace_by(J_theta, J_ba, P, phi, ba)
    shared -= _trace_by(J_theta, J_theta, P, theta, phi)
    return max(own + 2.0 * shared, 0.0) / 3


@kernel
def _trace_by(left: Matrix, right: Matrix, P: Matrix, row: int, column: int) -> float:
    """Trace of left P_rc rightᵀ for the block (3, 3) of P at ``row`` and ``column``."""
    total = 0.0
    for i in range(3):
        for k in range(3):
            for m in range(3):
                total += left[i, k] * P[row + k, column + m] * right[i, m]
    return total


def _mean_variance(P: Array, first: int) -> float:
    """Mean variance of three error states in P (N, N)."""
    return float(P[first, first] + P[first + 1, first + 1] + P[first + 2, first + 2]) / 3
