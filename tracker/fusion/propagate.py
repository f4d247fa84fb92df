"""Moving the chain's state with IMU data, nominal state and covariance."""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import ChainParams, NoiseParams
from tracker.fusion.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array, ImuSample

G_VECTOR = np.array([0.0, 0.0, -GRAVITY])
COAST_DAMPING = 2.0  # 1/s: how fast a velocity that no marker confirms dies away


def body_rates(state: ChainState, layout: ChainLayout, sample: ImuSample) -> Array:
    """(A, 3) rad/s of each active segment in its own B.

    A segment without a (valid) IMU turns with its parent.
    """
    w = np.zeros((len(layout.active), 3))
    for i in range(len(w)):
        j = layout.imu_of[i]
        if j >= 0 and sample.valid[j]:
            w[i] = state.R_IB[j].T @ (sample.gyro[j] - state.bg[j])
        elif layout.parent[i] >= 0:
            a = layout.parent[i]
            w[i] = state.R_GB[i].T @ (state.R_GB[a] @ w[a])
    return w


def root_force(state: ChainState, layout: ChainLayout, sample: ImuSample) -> Array | None:
    """(3,) specific force of the root's IMU in its B, m/s²; None where it does not answer."""
    j = layout.imu_of[0]
    if j < 0 or not sample.valid[j]:
        return None
    return state.R_IB[j].T @ (sample.accel[j] - state.ba[j])


def propagate(
    state: ChainState,
    layout: ChainLayout,
    params: ChainParams,
    sample: ImuSample,
    dt: float,
    coasting: bool = False,
    covariance: bool = True,
) -> None:
    """Move ``state`` in place by ``dt`` with the mean readings ``sample`` over the interval.

    ``coasting`` damps the velocity: without pictures a double integral flies away.
    """
    w = body_rates(state, layout, sample)
    f = root_force(state, layout, sample)
    if covariance:
        Phi = _transition(state, layout, sample, w, f, dt)
        _move_covariance(state, layout, Phi, _noise(layout, params.noise, sample, f, dt))
    _move_nominal(state, w, f, dt, coasting)


def _move_nominal(state: ChainState, w: Array, f: Array | None, dt: float, coasting: bool) -> None:
    if f is None:
        state.p = state.p + state.v * dt
        state.v = state.v * np.exp(-COAST_DAMPING * dt)
    else:
        R_mid = state.R_GB[0] @ so3.exp(w[0] * dt / 2)
        a_G = R_mid @ f + G_VECTOR
        state.p = state.p + state.v * dt + a_G * dt * dt / 2
        state.v = state.v + a_G * dt
    if coasting:
        state.v = state.v * np.exp(-COAST_DAMPING * dt)
    state.R_GB = state.R_GB @ so3.exp(w * dt)
    state.t += dt


def _transition(
    state: ChainState,
    layout: ChainLayout,
    sample: ImuSample,
    w: Array,
    f: Array | None,
    dt: float,
) -> Array:
    """(D, scale) Phi: the dynamic rows against all columns before the scales."""
    D, width = layout.n_dynamic, layout.scale
    Phi = np.eye(D, width)
    Phi[0:3, 3:6] = np.eye(3) * dt
    shrink = so3.exp(w * dt).swapaxes(-1, -2)
    spin = so3.skew(w) * dt
    for i in range(len(layout.active)):
        rows = slice(layout.theta + 3 * i, layout.theta + 3 * i + 3)
        j = layout.imu_of[i]
        if j >= 0 and sample.valid[j]:
            Phi[rows, rows] = shrink[i]
            Phi[rows, layout.phi + 3 * j : layout.phi + 3 * j + 3] = spin[i]
            Phi[rows, layout.bg + 3 * j : layout.bg + 3 * j + 3] = -state.R_IB[j].T * dt
        elif layout.parent[i] >= 0:
            _follow_parent(Phi, state, layout, i, rows)
    if f is not None:
        _root_rows(Phi, state, layout, f, dt)
    return Phi


def _follow_parent(Phi: Array, state: ChainState, layout: ChainLayout, i: int, rows: slice) -> None:
    """R_rel stays: theta_c moves by R_rel^T times what theta_parent moved by."""
    a = int(layout.parent[i])
    R_ca = state.R_GB[i].T @ state.R_GB[a]
    parent = Phi[layout.theta + 3 * a : layout.theta + 3 * a + 3].copy()
    parent[:, layout.theta + 3 * a : layout.theta + 3 * a + 3] -= np.eye(3)
    Phi[rows] += R_ca @ parent


def _root_rows(Phi: Array, state: ChainState, layout: ChainLayout, f: Array, dt: float) -> None:
    """p and v against the root's orientation, mounting and accelerometer bias."""
    j = layout.imu_of[0]
    R = state.R_GB[0]
    J_a_theta = -R @ so3.skew(f)
    J_a_ba = -R @ state.R_IB[j].T
    th = slice(layout.theta, layout.theta + 3)
    phi = slice(layout.phi + 3 * j, layout.phi + 3 * j + 3)
    ba = slice(layout.ba + 3 * j, layout.ba + 3 * j + 3)
    for rows, gain in ((slice(3, 6), dt), (slice(0, 3), dt * dt / 2)):
        Phi[rows, th] = J_a_theta * gain
        Phi[rows, phi] = -J_a_theta * gain  # a turn of the mounting turns f the other way
        Phi[rows, ba] = J_a_ba * gain


def _noise(
    layout: ChainLayout, noise: NoiseParams, sample: ImuSample, f: Array | None, dt: float
) -> Array:
    """(N,) diagonal of the discrete process noise."""
    q = np.zeros(layout.size)
    accel = noise.accel if f is not None else 10 * noise.accel
    q[0:3] = accel**2 * dt**3 / 3
    q[3:6] = accel**2 * dt
    for i in range(len(layout.active)):
        j = layout.imu_of[i]
        sd = noise.gyro if j >= 0 and sample.valid[j] else noise.free_rotation
        q[layout.theta + 3 * i : layout.theta + 3 * i + 3] = sd**2 * dt
    q[layout.bg : layout.phi] = noise.gyro_bias**2 * dt
    q[layout.phi : layout.ba] = noise.mounting**2 * dt
    q[layout.ba : layout.scale] = noise.accel_bias**2 * dt
    q[layout.scale : layout.joint] = noise.scale**2 * dt
    q[layout.joint :] = (1e-4) ** 2 * dt
    return q


def _move_covariance(state: ChainState, layout: ChainLayout, Phi: Array, q: Array) -> None:
    """P <- Phi P Phi^T + Q, touching only the dynamic rows and columns."""
    D, width = Phi.shape
    P = state.P
    rows = Phi @ P[:width]  # (D, N)
    block = rows[:, :width] @ Phi.T
    P[:D] = rows
    P[:, :D] = rows.T
    P[:D, :D] = (block + block.T) / 2
    P.flat[:: P.shape[0] + 1] += q
