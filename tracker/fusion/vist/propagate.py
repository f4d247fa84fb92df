"""Prediction with IMU data, nominal state and joint covariance: eq. 9 of
Lee et al. 2021, doi:10.1126/scirobotics.abe1315.

Errors of one segment, discrete over dt, with a = a_m - b_a and w = w_m - b_g:

    dp  += dv dt + (A_th dth + A_ba dba) dt / 2      A_th = -R_GI [a]x dt
    dv  += A_th dth + A_ba dba                       A_ba = -R_GI dt
    dth  = Exp(w dt)^T dth - dbg dt                  biases, lambda and phi: unchanged

so nine rows and columns of each segment move and Phi P Phi^T needs no dense product.
"""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.fusion.engine import COAST_DAMPING
from tracker.fusion.time.imu_buffer import Readings
from tracker.fusion.vist.layout import BA, BG, ERRORS, LAM, PHI, TH, P, V, VistLayout
from tracker.fusion.vist.params import VistNoise
from tracker.fusion.vist.state import VistState
from tracker.geometry.kernels import exp3
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Stack, Written
from tracker.messages import Array


def propagate(
    state: VistState,
    layout: VistLayout,
    noise: VistNoise,
    sample: Readings,
    dt: float,
    coasting: bool = False,
    covariance: bool = True,
) -> None:
    """Move ``state`` by ``dt`` with the mean readings ``sample`` over the interval.

    ``coasting`` damps the hand's velocity: without images the double integral diverges.
    """
    j = layout.imu_of
    valid, gyro, accel = sample.valid[j], sample.gyro[j], sample.accel[j]
    w, f = gyro - state.bg, accel - state.ba
    if covariance:
        move_covariance(state.P, state.R_GI, w, f, valid, dt)
        _add_noise(state.P, layout, noise, valid, dt)
    state.p_GI, state.v_GI, state.R_GI = _move_nominal(
        layout.chain.parent, state.p_GI, state.v_GI, state.R_GI, w, f, valid, dt
    )
    p_back, v_back = state.held_back
    taken = (1 - np.exp(-COAST_DAMPING * dt)) * state.v_GI[0] if coasting else np.zeros(3)
    state.v_GI = state.v_GI - taken
    state.held_back = np.stack([p_back + v_back * dt, v_back + taken])
    state.t += dt


@kernel
def _move_nominal(
    parent: IntVector,
    p: Matrix,
    v: Matrix,
    R: Stack,
    w: Matrix,
    f: Matrix,
    valid: BoolVector,
    dt: float,
) -> tuple[Matrix, Matrix, Stack]:
    """Eq. 9. A segment without valid IMU moves with its parent; such a root slows down."""
    n = len(parent)
    p_new, v_new, R_new = np.empty_like(p), np.empty_like(v), np.empty_like(R)
    w_G, a_G = np.zeros((n, 3)), np.zeros((n, 3))
    for i in range(n):
        if valid[i]:
            w_G[i] = R[i] @ w[i]
            a_G[i] = R[i] @ exp3(w[i] * (dt / 2)) @ f[i]
            a_G[i, 2] -= GRAVITY
        elif parent[i] >= 0:
            w_G[i], a_G[i] = w_G[parent[i]], a_G[parent[i]]
        else:
            a_G[i] = -COAST_DAMPING * v[i]
        R_new[i] = R[i] @ exp3(R[i].T @ w_G[i] * dt)
        p_new[i] = p[i] + v[i] * dt + a_G[i] * (dt * dt / 2)
        v_new[i] = v[i] + a_G[i] * dt
    return p_new, v_new, R_new


@kernel
def _error_blocks(
    R: Stack, w: Matrix, f: Matrix, valid: BoolVector, dt: float
) -> tuple[Stack, Stack, Stack]:
    """A_th (n, 3, 3), E = Exp(w dt)^T (n, 3, 3), and A_ba (n, 3, 3); zeros for invalid IMUs."""
    n = len(R)
    A_th, A_ba, E = np.zeros((n, 3, 3)), np.zeros((n, 3, 3)), np.empty((n, 3, 3))
    for i in range(n):
        E[i] = np.eye(3)
        if not valid[i]:
            continue
        E[i] = exp3(w[i] * dt).T
        A_ba[i] = -R[i] * dt
        x, y, z = f[i, 0], f[i, 1], f[i, 2]
        for r in range(3):
            A_th[i, r, 0] = -dt * (R[i, r, 1] * z - R[i, r, 2] * y)
            A_th[i, r, 1] = -dt * (R[i, r, 2] * x - R[i, r, 0] * z)
            A_th[i, r, 2] = -dt * (R[i, r, 0] * y - R[i, r, 1] * x)
    return A_th, A_ba, E


@kernel
def move_covariance(
    P_: Written[Matrix], R: Stack, w: Matrix, f: Matrix, valid: BoolVector, dt: float
) -> None:
    """P <- Phi P Phi^T in place; P (21 n, 21 n), R (n, 3, 3), w, f (n, 3), valid (n,) bool."""
    A_th, A_ba, E = _error_blocks(R, w, f, valid, dt)
    size = P_.shape[0]
    new = np.empty((9, size))
    # 1. rows: M = Phi P, with Phi the discrete form of F below eq. 9
    for i in range(len(R)):
        k = i * ERRORS
        turn = -dt if valid[i] else 0.0
        for r in range(3):
            for c in range(size):
                dv, dth = 0.0, turn * P_[k + BG + r, c]
                for s in range(3):
                    dv += A_th[i, r, s] * P_[k + TH + s, c] + A_ba[i, r, s] * P_[k + BA + s, c]
                    dth += E[i, r, s] * P_[k + TH + s, c]
                new[r, c] = P_[k + P + r, c] + dt * (P_[k + V + r, c] + 0.5 * dv)
                new[3 + r, c] = P_[k + V + r, c] + dv
                new[6 + r, c] = dth
        P_[k : k + 9] = new
    # 2. columns: M Phi^T, one row at a time
    move = np.empty(9)
    for row in range(size):
        for i in range(len(R)):
            k = i * ERRORS
            turn = -dt if valid[i] else 0.0
            m = P_[row, k : k + ERRORS]
            for r in range(3):
                dv, dth = 0.0, turn * m[BG + r]
                for s in range(3):
                    dv += A_th[i, r, s] * m[TH + s] + A_ba[i, r, s] * m[BA + s]
                    dth += E[i, r, s] * m[TH + s]
                move[r] = m[P + r] + dt * (m[V + r] + 0.5 * dv)
                move[3 + r] = m[V + r] + dv
                move[6 + r] = dth
            m[:9] = move


def transition(state: VistState, sample: Readings, layout: VistLayout, dt: float) -> Array:
    """Phi (21 n, 21 n) as a dense matrix, equivalent to `move_covariance`."""
    j = layout.imu_of
    w, f = sample.gyro[j] - state.bg, sample.accel[j] - state.ba
    A_th, A_ba, E = _error_blocks(state.R_GI, w, f, sample.valid[j], dt)
    Phi = np.eye(layout.size)
    for i in range(layout.n):
        k = ERRORS * i
        p, v, th, bg, ba = (slice(k + b, k + b + 3) for b in (P, V, TH, BG, BA))
        Phi[p, v] = np.eye(3) * dt
        Phi[v, th], Phi[v, ba] = A_th[i], A_ba[i]
        Phi[p, th], Phi[p, ba] = A_th[i] * dt / 2, A_ba[i] * dt / 2
        Phi[th, th] = E[i]
        Phi[th, bg] = -np.eye(3) * dt * bool(sample.valid[j[i]])
    return Phi


def _add_noise(
    P_: Array, layout: VistLayout, noise: VistNoise, valid: BoolVector, dt: float
) -> None:
    """Adds Q on the diagonal; a segment with an invalid IMU gets large noise."""
    accel = np.where(valid, noise.accel, noise.silent_accel)[:, None]
    q = np.empty((layout.n, ERRORS))
    q[:, P : P + 3] = accel**2 * dt**3 / 3
    q[:, V : V + 3] = accel**2 * dt
    q[:, TH : TH + 3] = np.where(valid, noise.gyro, noise.silent_rotation)[:, None] ** 2 * dt
    q[:, BG : BG + 3] = noise.gyro_bias**2 * dt
    q[:, BA : BA + 3] = noise.accel_bias**2 * dt
    q[:, LAM : LAM + 3] = noise.scale**2 * dt
    q[:, PHI : PHI + 3] = noise.mounting**2 * dt
    P_.flat[:: layout.size + 1] += q.ravel()
