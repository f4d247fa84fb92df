"""Moving the chain's state with IMU data, nominal state and covariance."""

from __future__ import annotations

import numba
import numpy as np

from tracker import GRAVITY
from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import ChainParams, NoiseParams
from tracker.fusion.state import ChainState
from tracker.geometry.kernels import exp3, skew3, turn_all
from tracker.messages import Array, ImuSample

G_VECTOR = np.array([0.0, 0.0, -GRAVITY])
COAST_DAMPING = 2.0  # 1/s: how fast a velocity that no marker confirms dies away


def body_rates(state: ChainState, layout: ChainLayout, sample: ImuSample) -> Array:
    """(A, 3) rad/s of each active segment in its own B.

    A segment without a (valid) IMU turns with its parent, and bends as its synergy says.
    """
    source, gain = layout.drive
    return _body_rates(
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


@numba.njit(cache=True)
def _body_rates(  # type: ignore[no-untyped-def]
    imu_of, parent, source, gain, R_GB, R_IB, bg, gyro, valid
):  # fmt: skip
    w = np.zeros((len(parent), 3))
    for i in range(len(parent)):
        j = imu_of[i]
        if j >= 0 and valid[j]:
            w[i] = R_IB[j].T @ (gyro[j] - bg[j])
        elif parent[i] >= 0:
            w[i] = R_GB[i].T @ (R_GB[parent[i]] @ w[parent[i]])
            s = source[i]
            if 0 <= s < i:
                relative = w[s] - R_GB[s].T @ (R_GB[parent[s]] @ w[parent[s]])
                w[i, 1] += gain[i, 0] * relative[1]
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
        _move_covariance(state, layout, Phi, _noise(layout, params.noise, f, dt))
        _add_turn_noise(state, layout, params.noise, sample, dt)
    _move_nominal(state, w, f, dt, coasting)


def _move_nominal(state: ChainState, w: Array, f: Array | None, dt: float, coasting: bool) -> None:
    if f is None:
        state.p = state.p + state.v * dt
        state.v = state.v * np.exp(-COAST_DAMPING * dt)
    else:
        R_mid = state.R_GB[0] @ exp3(w[0] * (dt / 2))
        a_G = R_mid @ f + G_VECTOR
        state.p = state.p + state.v * dt + a_G * dt * dt / 2
        state.v = state.v + a_G * dt
    if coasting:
        state.v = state.v * np.exp(-COAST_DAMPING * dt)
    state.R_GB = turn_all(state.R_GB, w * dt)
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
    Phi = _orientation_rows(
        layout.imu_of,
        layout.parent,
        state.R_GB,
        state.R_IB,
        sample.valid,
        w,
        dt,
        layout.theta,
        layout.bg,
        layout.phi,
        layout.scale,
    )
    if f is not None:
        _root_rows(Phi, state, layout, f, dt)
    return Phi


@numba.njit(cache=True)
def _orientation_rows(  # type: ignore[no-untyped-def]
    imu_of, parent, R_GB, R_IB, valid, w, dt, theta, bg, phi, width
):
    Phi = np.eye(theta + 3 * len(parent), width)
    for r in range(3):
        Phi[r, 3 + r] = dt
    for i in range(len(parent)):
        k = theta + 3 * i
        j = imu_of[i]
        if j >= 0 and valid[j]:
            Phi[k : k + 3, k : k + 3] = exp3(w[i] * dt).T
            Phi[k : k + 3, phi + 3 * j : phi + 3 * j + 3] = skew3(w[i]) * dt
            Phi[k : k + 3, bg + 3 * j : bg + 3 * j + 3] = -R_IB[j].T * dt
        elif parent[i] >= 0:
            # R_rel stays: theta_c moves by R_rel^T times what theta_parent moved by
            a = theta + 3 * parent[i]
            R_ca = R_GB[i].T @ R_GB[parent[i]]
            moved = Phi[a : a + 3].copy()
            for r in range(3):
                moved[r, a + r] -= 1.0
            Phi[k : k + 3] += R_ca @ moved
    return Phi


def _root_rows(Phi: Array, state: ChainState, layout: ChainLayout, f: Array, dt: float) -> None:
    """p and v against the root's orientation, mounting and accelerometer bias."""
    j = layout.imu_of[0]
    R = state.R_GB[0]
    J_a_theta = -R @ skew3(f)
    J_a_ba = -R @ state.R_IB[j].T
    th = slice(layout.theta, layout.theta + 3)
    phi = slice(layout.phi + 3 * j, layout.phi + 3 * j + 3)
    ba = slice(layout.ba + 3 * j, layout.ba + 3 * j + 3)
    for rows, gain in ((slice(3, 6), dt), (slice(0, 3), dt * dt / 2)):
        Phi[rows, th] = J_a_theta * gain
        Phi[rows, phi] = -J_a_theta * gain  # a turn of the mounting turns f the other way
        Phi[rows, ba] = J_a_ba * gain


def _noise(layout: ChainLayout, noise: NoiseParams, f: Array | None, dt: float) -> Array:
    """(N,) diagonal of the discrete process noise, but for the orientations'."""
    q = np.zeros(layout.size)
    accel = noise.accel if f is not None else noise.free_accel
    q[0:3] = accel**2 * dt**3 / 3
    q[3:6] = accel**2 * dt
    q[layout.bg : layout.phi] = noise.gyro_bias**2 * dt
    q[layout.phi : layout.ba] = noise.mounting**2 * dt
    q[layout.ba : layout.scale] = noise.accel_bias**2 * dt
    q[layout.scale : layout.joint] = noise.scale**2 * dt
    q[layout.joint :] = noise.offset**2 * dt
    return q


def _add_turn_noise(
    state: ChainState, layout: ChainLayout, noise: NoiseParams, sample: ImuSample, dt: float
) -> None:
    """Noise of the orientations: a segment without an IMU takes its parent's along."""
    felt = np.array([j >= 0 and bool(sample.valid[j]) for j in layout.imu_of])
    sd = np.where(felt, noise.gyro, noise.free_rotation)
    if not felt[0]:
        sd[0] = noise.free_root_rotation
    block = slice(layout.theta, layout.n_dynamic)
    if felt.all():
        rows = np.arange(layout.theta, layout.n_dynamic)
        state.P[rows, rows] += np.repeat(sd**2 * dt, 3)
        return
    n = len(layout.active)
    L = np.zeros((3 * n, 3 * n))
    for i in range(n):
        rows_i = slice(3 * i, 3 * i + 3)
        L[rows_i, rows_i] = np.eye(3) * sd[i]
        a = int(layout.parent[i])
        if not felt[i] and a >= 0:
            L[rows_i] += (state.R_GB[i].T @ state.R_GB[a]) @ L[3 * a : 3 * a + 3]
    state.P[block, block] += L @ L.T * dt


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
