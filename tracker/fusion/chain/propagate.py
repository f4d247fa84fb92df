"""Propagates the chain's nominal state and covariance with IMU data (docs/chain.md).

A segment with an IMU rotates by its gyroscope; one without rotates with its parent and bends by its
synergy. The root's accelerometer moves the hand as a whole. Phi differs from the identity in a few
columns per row, so products with it use a list of those columns. Shapes are those of `ChainState`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker import GRAVITY
from tracker.fusion.chain.layout import Blocks, ChainLayout, Drive
from tracker.fusion.chain.params import ChainParams, RandomWalks
from tracker.fusion.chain.state import ChainState, Dynamic, ImuErrors
from tracker.fusion.engine import COAST_DAMPING
from tracker.fusion.output.motion import JOINT_RATE_SD
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals, Moment, Packets, cut
from tracker.geometry.kernels import exp3, mul3, rotate, rotate_all, rotate_back, skew3, tmul3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    BoolVector,
    IntMatrix,
    IntVector,
    Matrix,
    Stack,
    Vector,
    Written,
)


class Coasting(NamedTuple):
    """Velocity is damped from ``patience`` s after ``last_good`` (s) on: without images the double
    integral diverges."""

    last_good: float
    patience: float


NEVER_COASTING = Coasting(float("inf"), 0.0)


class SensedMotion(NamedTuple):
    """Motion measured by the IMUs: w (A, 3) rad/s of each active segment in its own B, f (3,) m/s²
    specific force of the root's IMU in its B, and whether it is ``felt`` (valid)."""

    w: Matrix
    f: Vector
    felt: bool


def propagate(
    state: ChainState,
    layout: ChainLayout,
    params: ChainParams,
    way: Intervals,
    coasting: Coasting = NEVER_COASTING,
) -> None:
    """Propagate ``state`` in place through the intervals of ``way``."""
    random_walks = params.noise.random_walks
    state.p, state.v, state.R_GB = steps(
        layout.drive, layout.blocks, random_walks, way, coasting, state.dynamic, state.imus, state.P
    )
    state.t = float(way.stop[-1])


def carry(
    state: ChainState, layout: ChainLayout, buffer: ImuBuffer, t: float, coasting: bool = False
) -> None:
    """Propagate the nominal state alone, without its covariance, to ``t`` through the packets."""
    if t <= state.t:
        return
    state.p, state.v, state.R_GB, state.t = carried(
        layout.drive, state.dynamic, state.imus, buffer.table, state.t, t, coasting
    )


def transition(state: ChainState, layout: ChainLayout, readings: Moment, dt: float) -> Matrix:
    """(D, scale) Phi: the dynamic rows against all columns before the scales."""
    return transition_by(layout.drive, layout.blocks, state.R_GB, state.imus, readings, dt)


@kernel(nogil=False)
def steps(
    drive: Drive,
    at: Blocks,
    random_walks: RandomWalks,
    way: Intervals,
    coasting: Coasting,
    dynamic: Dynamic,
    imus: ImuErrors,
    P: Written[Matrix],
) -> tuple[Vector, Vector, Stack]:
    """Through all intervals of ``way``: P in place; returns p, v, R_GB at the end."""
    p, v, R_GB = dynamic
    for k in range(len(way.stop)):
        dt, valid = way.stop[k] - way.start[k], way.valid[k]
        # 1. rates and force by the mean readings
        motion = motion_by(drive, R_GB, imus, way.accel[k], way.gyro[k], valid)
        # 2. P <- Phi P Phi^T + Q, linearised at the start of the interval (eq. 16)
        move_covariance(P, phi_of(drive, at, R_GB, imus.R_IB, valid, motion, dt))
        add_random_walks(P, at, random_walks, accel_noise(random_walks, R_GB[0], motion), dt)
        add_rotation_noise(P, at, drive, R_GB, valid, random_walks, dt)
        # 3. the nominal state
        damped = way.start[k] - coasting.last_good > coasting.patience
        p, v, R_GB = move_nominal(Dynamic(p, v, R_GB), motion, dt, damped)
    return p, v, R_GB


@kernel(nogil=False)
def carried(
    drive: Drive,
    dynamic: Dynamic,
    imus: ImuErrors,
    packets: Packets,
    start: float,
    end: float,
    coasting: bool,
) -> tuple[Vector, Vector, Stack, float]:
    """p, v, R_GB after propagation from ``start`` to ``end`` through the packets, and the time
    reached."""
    p, v, R_GB = dynamic
    starts, stops, accel, gyro, valid = cut(packets, start, end)
    for k in range(len(stops)):
        motion = motion_by(drive, R_GB, imus, accel[k], gyro[k], valid[k])
        dt = stops[k] - starts[k]
        p, v, R_GB = move_nominal(Dynamic(p, v, R_GB), motion, dt, coasting)
        start = stops[k]
    return p, v, R_GB, start


@kernel
def motion_by(
    drive: Drive, R_GB: Stack, imus: ImuErrors, accel: Matrix, gyro: Matrix, valid: BoolVector
) -> SensedMotion:
    """`SensedMotion` by readings accel, gyro (n, 3)."""
    w = body_rates(drive, R_GB, imus, gyro, valid)
    f, felt = root_force(drive, imus, accel, valid)
    return SensedMotion(w, f, felt)


@kernel
def body_rates(
    drive: Drive, R_GB: Stack, imus: ImuErrors, gyro: Matrix, valid: BoolVector
) -> Matrix:
    """(A, 3) rad/s of each active segment in its own B."""
    parent = drive.parent
    w = np.zeros((len(parent), 3))
    for i in range(len(parent)):
        j = drive.imu_of[i]
        if j >= 0 and valid[j]:
            w[i] = rotate_back(imus.R_IB[j], gyro[j] - imus.bg[j])  # eq. 8
        elif parent[i] >= 0:
            w[i] = rotate_back(R_GB[i], rotate(R_GB[parent[i]], w[parent[i]]))  # eq. 9
            s = drive.source[i]
            if 0 <= s < i:
                relative = w[s] - rotate_back(R_GB[s], rotate(R_GB[parent[s]], w[parent[s]]))
                w[i, 1] += drive.gain[i, 0] * relative[1]
    return w


@kernel(nogil=False)
def rates_now(
    drive: Drive,
    at: Blocks,
    R_GB: Stack,
    imus: ImuErrors,
    P: Matrix,
    gyro: Matrix,
    valid: BoolVector,
    gyro_sd: float,
) -> tuple[Matrix, Vector, Vector]:
    """(A, 3) rad/s of each active segment in its own B by readings gyro (n, 3); (A,) rad/s, their
    sd per axis: from ``gyro_sd`` (rad/s) and, in P (N, N), bias and mounting; (A,) rad, sd of each
    rotation relative to the parent, for the root of the whole rotation."""
    w = body_rates(drive, R_GB, imus, gyro, valid)
    sd, turn_sd = np.empty(len(w)), np.empty(len(w))
    for i in range(len(w)):
        j, a = drive.imu_of[i], drive.parent[i]
        if j >= 0 and valid[j]:
            turn2 = w[i, 0] ** 2 + w[i, 1] ** 2 + w[i, 2] ** 2
            bg, phi = _mean_variance(P, at.bg + 3 * j), _mean_variance(P, at.phi + 3 * j)
            sd[i] = np.sqrt(gyro_sd**2 + bg + turn2 * phi)
        else:
            sd[i] = np.sqrt((sd[a] ** 2 if a >= 0 else 0.0) + JOINT_RATE_SD**2)
        turn_sd[i] = np.sqrt(max(_turn_variance(P, at.theta, R_GB, i, a), 0.0))
    return w, sd, turn_sd


@kernel
def _turn_variance(P: Matrix, theta: int, R_GB: Stack, i: int, a: int) -> float:
    """rad², mean of three axes, of the rotation of segment ``i`` relative to ``a``, -1 for none."""
    c = theta + 3 * i
    own = _mean_variance(P, c)
    if a < 0:
        return own
    p = theta + 3 * a
    R_ca = tmul3(R_GB[i], R_GB[a])
    shared = 0.0  # trace of the covariance of both errors, the parent's in the child's axes
    for k in range(3):
        for m in range(3):
            shared += P[c + k, p + m] * R_ca[k, m]
    return own + _mean_variance(P, p) - 2.0 / 3.0 * shared


@kernel
def _mean_variance(P: Matrix, first: int) -> float:
    """Mean variance of three error states in P (N, N)."""
    return (P[first, first] + P[first + 1, first + 1] + P[first + 2, first + 2]) / 3


@kernel
def root_force(
    drive: Drive, imus: ImuErrors, accel: Matrix, valid: BoolVector
) -> tuple[Vector, bool]:
    """(3,) m/s² specific force of the root's IMU in its B, and whether it is valid."""
    j = drive.imu_of[0]
    if j < 0 or not valid[j]:
        return np.zeros(3), False
    return rotate_back(imus.R_IB[j], accel[j] - imus.ba[j]), True  # eq. 10


@kernel
def move_nominal(
    dynamic: Dynamic, motion: SensedMotion, dt: float, coasting: bool
) -> tuple[Vector, Vector, Stack]:
    """p, v and R_GB after ``dt``, in new arrays (eq. 11)."""
    p, v, R_GB = dynamic
    w, f, felt = motion
    p_new, v_new = np.empty(3), np.empty(3)
    a_G = np.zeros(3)
    damping = 1.0
    if felt:
        a_G = rotate(R_GB[0], rotate(exp3(w[0] * (dt / 2)), f))
        a_G[2] -= GRAVITY
    else:
        damping = np.exp(-COAST_DAMPING * dt)
    if coasting:
        damping *= np.exp(-COAST_DAMPING * dt)
    for k in range(3):
        p_new[k] = p[k] + v[k] * dt + a_G[k] * dt * dt / 2
        v_new[k] = (v[k] + a_G[k] * dt) * damping
    return p_new, v_new, rotate_all(R_GB, w * dt)


@kernel(nogil=False)
def transition_by(
    drive: Drive, at: Blocks, R_GB: Stack, imus: ImuErrors, readings: Moment, dt: float
) -> Matrix:
    """`phi_of` for mean readings."""
    valid = readings.valid
    motion = motion_by(drive, R_GB, imus, readings.accel, readings.gyro, valid)
    return phi_of(drive, at, R_GB, imus.R_IB, valid, motion, dt)


@kernel
def phi_of(
    drive: Drive,
    at: Blocks,
    R_GB: Stack,
    R_IB: Stack,
    valid: BoolVector,
    motion: SensedMotion,
    dt: float,
) -> Matrix:
    """(D, scale) Phi: the dynamic rows against all columns before the scales."""
    parent, w = drive.parent, motion.w
    Phi = np.eye(at.theta + 3 * len(parent), at.scale)
    # 1. position by velocity (eq. 15)
    for r in range(3):
        Phi[r, 3 + r] = dt
    # 2. orientations
    for i in range(len(parent)):
        k = at.theta + 3 * i
        j = drive.imu_of[i]
        if j >= 0 and valid[j]:
            # eq. 13
            Phi[k : k + 3, k : k + 3] = exp3(w[i] * dt).T
            Phi[k : k + 3, at.phi + 3 * j : at.phi + 3 * j + 3] = skew3(w[i]) * dt
            Phi[k : k + 3, at.bg + 3 * j : at.bg + 3 * j + 3] = -R_IB[j].T * dt
        elif parent[i] >= 0:
            # eq. 14. R_rel is constant: theta_c moves by R_ca times the change of theta_parent
            a = at.theta + 3 * parent[i]
            R_ca = tmul3(R_GB[i], R_GB[parent[i]])
            moved = Phi[a : a + 3].copy()
            for r in range(3):
                moved[r, a + r] -= 1.0
            Phi[k : k + 3] += R_ca @ moved
    # 3. velocity and position by the variables in the specific force (eq. 15)
    if motion.felt:
        j = drive.imu_of[0]
        _put_root_rows(Phi, at, j, R_GB[0], R_IB[j], motion.f, dt)
    return Phi


@kernel
def _put_root_rows(
    Phi: Written[Matrix], at: Blocks, imu: int, R: Matrix, R_IB: Matrix, f: Vector, dt: float
) -> None:
    """Eq. 15: p and v by the root's orientation, its IMU's mounting and accelerometer bias."""
    J_a_theta = -mul3(R, skew3(f))
    J_a_ba = -mul3(R, R_IB.T)
    theta, phi, ba = at.theta, at.phi + 3 * imu, at.ba + 3 * imu
    for first, gain in ((3, dt), (0, dt * dt / 2)):
        for r in range(3):
            for c in range(3):
                Phi[first + r, theta + c] = J_a_theta[r, c] * gain
                # a rotation of the mounting rotates f by its inverse
                Phi[first + r, phi + c] = -J_a_theta[r, c] * gain
                Phi[first + r, ba + c] = J_a_ba[r, c] * gain


@kernel
def move_covariance(P: Written[Matrix], Phi: Matrix) -> None:
    """P <- Phi P Phi^T in place (eq. 16), touching only the dynamic rows and columns."""
    D, n = len(Phi), len(P)
    count, column = _columns(Phi)
    # 1. rows (D, N) = Phi P
    rows = np.zeros((D, n))
    for r in range(D):
        out = rows[r]
        for k in range(count[r]):
            factor, row = Phi[r, column[r, k]], P[column[r, k]]
            for i in range(n):
                out[i] += factor * row[i]
    # 2. the dynamic corner: rows Phi^T, of which one triangle is computed
    for r in range(D):
        for s in range(r + 1):
            total = 0.0
            for k in range(count[s]):
                total += rows[r, column[s, k]] * Phi[s, column[s, k]]
            P[r, s] = total
            P[s, r] = total
        P[r, D:] = rows[r, D:]
    # 3. the other columns, mirrored
    for i in range(D, n):
        for r in range(D):
            P[i, r] = rows[r, i]


@kernel
def _columns(Phi: Matrix) -> tuple[IntVector, IntMatrix]:
    """Number of non-zero entries of each row, and their columns (D, most)."""
    D, width = Phi.shape
    count, column = np.zeros(D, np.int64), np.empty((D, width), np.int64)
    for r in range(D):
        for c in range(width):
            if Phi[r, c] != 0.0:
                column[r, count[r]] = c
                count[r] += 1
    return count, column


@kernel
def accel_noise(random_walks: RandomWalks, R: Matrix, motion: SensedMotion) -> float:
    """m/s²·√s of the root's acceleration; errors of scale and axes grow with it (eq. 17)."""
    if not motion.felt:
        return random_walks.free_accel
    a_G = rotate(R, motion.f)
    a_G[2] -= GRAVITY
    moved = a_G[0] ** 2 + a_G[1] ** 2 + a_G[2] ** 2
    return np.sqrt(random_walks.accel**2 + random_walks.accel_gain**2 * moved)


@kernel
def add_random_walks(
    P: Written[Matrix], at: Blocks, random_walks: RandomWalks, accel: float, dt: float
) -> None:
    """Adds the noise of all states except orientations over ``dt``, on the diagonal (eq. 17), with
    the `accel_noise` ``accel``."""
    for r in range(3):
        P[r, r] += accel**2 * dt**3 / 3
        P[3 + r, 3 + r] += accel**2 * dt
    for i in range(at.bg, len(P)):
        sd = random_walks.gyro_bias
        if i >= at.axis:
            sd = 0.0
        elif i >= at.marker:
            sd = random_walks.slip * np.sqrt(max(0.0, 1.0 - P[i, i] / random_walks.slip_most**2))
        elif i >= at.joint:
            sd = random_walks.offset
        elif i >= at.scale:
            sd = random_walks.scale
        elif i >= at.ba:
            sd = random_walks.accel_bias
        elif i >= at.phi:
            sd = random_walks.mounting
        P[i, i] += sd**2 * dt


@kernel
def add_rotation_noise(
    P: Written[Matrix],
    at: Blocks,
    drive: Drive,
    R_GB: Stack,
    valid: BoolVector,
    random_walks: RandomWalks,
    dt: float,
) -> None:
    """Adds the noise of the orientations in place; a segment without an IMU shares its parent's
    (eq. 18).

    The variances differ for a sensed rotation, an unsensed one relative to the parent, and an
    unsensed root.
    """
    felt, free = random_walks.gyro**2 * dt, random_walks.free_rotation**2 * dt
    free_root = random_walks.free_root_rotation**2 * dt
    parent, imu_of = drive.parent, drive.imu_of
    n = len(parent)
    # 1. covariances (3, 3) of the pairs of segments
    C = np.zeros((n, n, 3, 3))
    for i in range(n):
        a, own = parent[i], felt
        if imu_of[i] < 0 or not valid[imu_of[i]]:
            own = free if a >= 0 else free_root
            if a >= 0:
                R_ca = tmul3(R_GB[i], R_GB[a])
                for k in range(i):
                    C[i, k] = mul3(R_ca, C[a, k])
                    C[k, i] = C[i, k].T
                C[i, i] = mul3(mul3(R_ca, C[a, a]), R_ca.T)
        for r in range(3):
            C[i, i, r, r] += own
    # 2. into P
    for i in range(n):
        for k in range(n):
            for r in range(3):
                for c in range(3):
                    P[at.theta + 3 * i + r, at.theta + 3 * k + c] += C[i, k, r, c]
