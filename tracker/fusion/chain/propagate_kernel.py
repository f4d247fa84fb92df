"""The arithmetic of `tracker.fusion.chain.propagate`, compiled; shapes are those of `ChainState`.

Phi differs from the identity in a handful of columns a row, so products with it go through a list
of those columns.
"""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.fusion.engine import COAST_DAMPING
from tracker.fusion.time.imu_buffer import cut
from tracker.geometry.kernels import exp3, mul3, rotate, rotate_all, rotate_back, skew3, tmul3
from tracker.kernels import kernel


@kernel
def body_rates(  # type: ignore[no-untyped-def]
    imu_of, parent, source, gain, R_GB, R_IB, bg, gyro, valid
):  # fmt: skip
    """(A, 3) rad/s of each active segment in its own B."""
    w = np.zeros((len(parent), 3))
    for i in range(len(parent)):
        j = imu_of[i]
        if j >= 0 and valid[j]:
            w[i] = rotate_back(R_IB[j], gyro[j] - bg[j])
        elif parent[i] >= 0:
            w[i] = rotate_back(R_GB[i], rotate(R_GB[parent[i]], w[parent[i]]))
            s = source[i]
            if 0 <= s < i:
                relative = w[s] - rotate_back(R_GB[s], rotate(R_GB[parent[s]], w[parent[s]]))
                w[i, 1] += gain[i, 0] * relative[1]
    return w


@kernel
def root_force(imu_of, R_IB, ba, accel, valid):  # type: ignore[no-untyped-def]
    """(3,) m/s² specific force of the root's IMU in its B, and whether it answers."""
    j = imu_of[0]
    if j < 0 or not valid[j]:
        return np.zeros(3), False
    return rotate_back(R_IB[j], accel[j] - ba[j]), True


@kernel
def move_nominal(p, v, R_GB, w, f, felt, dt, coasting):  # type: ignore[no-untyped-def]
    """p, v and R_GB after ``dt``, in new arrays; ``felt`` says whether f (3,) counts."""
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


@kernel
def transition(  # type: ignore[no-untyped-def]
    imu_of, parent, R_GB, R_IB, valid, w, f, felt, dt, theta, bg, phi, ba, width
):  # fmt: skip
    """(D, width) Phi: the dynamic rows against all columns before the scales."""
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
            R_ca = tmul3(R_GB[i], R_GB[parent[i]])
            moved = Phi[a : a + 3].copy()
            for r in range(3):
                moved[r, a + r] -= 1.0
            Phi[k : k + 3] += R_ca @ moved
    if felt:
        _root_rows(Phi, R_GB[0], R_IB[imu_of[0]], f, dt, theta, phi + 3 * imu_of[0],
                   ba + 3 * imu_of[0])  # fmt: skip
    return Phi


@kernel
def _root_rows(Phi, R, R_IB, f, dt, theta, phi, ba):  # type: ignore[no-untyped-def]
    """p and v against the root's orientation, mounting and accelerometer bias."""
    J_a_theta = -mul3(R, skew3(f))
    J_a_ba = -mul3(R, R_IB.T)
    for first, gain in ((3, dt), (0, dt * dt / 2)):
        for r in range(3):
            for c in range(3):
                Phi[first + r, theta + c] = J_a_theta[r, c] * gain
                # a turn of the mounting turns f the other way
                Phi[first + r, phi + c] = -J_a_theta[r, c] * gain
                Phi[first + r, ba + c] = J_a_ba[r, c] * gain


@kernel
def move_covariance(P, Phi):  # type: ignore[no-untyped-def]
    """P <- Phi P Phi^T in place, touching only the dynamic rows and columns."""
    D, n = len(Phi), len(P)
    count, column = _columns(Phi)
    rows = np.zeros((D, n))
    for r in range(D):
        out = rows[r]
        for k in range(count[r]):
            factor, row = Phi[r, column[r, k]], P[column[r, k]]
            for i in range(n):
                out[i] += factor * row[i]
    for r in range(D):
        for s in range(r + 1):
            total = 0.0
            for k in range(count[s]):
                total += rows[r, column[s, k]] * Phi[s, column[s, k]]
            P[r, s] = total
            P[s, r] = total
        P[r, D:] = rows[r, D:]
    for i in range(D, n):
        for r in range(D):
            P[i, r] = rows[r, i]


@kernel
def add_walks(  # type: ignore[no-untyped-def]
    P, dt, accel, gyro_bias, mounting, accel_bias, scale, offset, bg, phi, ba, scale_at, joint
):  # fmt: skip
    """The noise of all but the orientations over ``dt``, on the diagonal; densities per root s."""
    for r in range(3):
        P[r, r] += accel**2 * dt**3 / 3
        P[3 + r, 3 + r] += accel**2 * dt
    for i in range(bg, len(P)):
        sd = gyro_bias
        if i >= joint:
            sd = offset
        elif i >= scale_at:
            sd = scale
        elif i >= ba:
            sd = accel_bias
        elif i >= phi:
            sd = mounting
        P[i, i] += sd**2 * dt


@kernel
def _columns(Phi):  # type: ignore[no-untyped-def]
    """How many entries of each row are not zero, and their columns (D, most)."""
    D, width = Phi.shape
    count, column = np.zeros(D, np.int64), np.empty((D, width), np.int64)
    for r in range(D):
        for c in range(width):
            if Phi[r, c] != 0.0:
                column[r, count[r]] = c
                count[r] += 1
    return count, column


@kernel
def add_turn_noise(P, R_GB, parent, imu_of, valid, theta, var, free, free_root):  # type: ignore[no-untyped-def]
    """Noise of the orientations, in place: a segment without an IMU takes its parent's along.

    var, free and free_root are the variances (rad²) of a turn that is felt, of one against the
    parent that is not, and of the root's that is not.
    """
    n = len(parent)
    C = np.zeros((n, n, 3, 3))
    for i in range(n):
        a, own = parent[i], var
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
    for i in range(n):
        for k in range(n):
            for r in range(3):
                for c in range(3):
                    P[theta + 3 * i + r, theta + 3 * k + c] += C[i, k, r, c]


@kernel
def steps(  # type: ignore[no-untyped-def]
    imu_of, parent, source, gain, p, v, R_GB, bg, R_IB, ba, P, start, stop, accel, gyro, valid,
    last_good, patience, theta, bg_at, phi_at, ba_at, scale_at, joint_at,
    accel_sd, free_accel_sd, gyro_sd, free_sd, free_root_sd,
    gyro_bias_sd, mounting_sd, accel_bias_sd, scale_sd, offset_sd,
):  # fmt: skip
    """Through the intervals start, stop (k,) with mean readings (k, n, 3): P in place, and p, v,
    R_GB at the end.

    Intervals that begin later than ``patience`` after ``last_good`` (s) damp v. Deviations are
    those of `NoiseParams`.
    """
    for k in range(len(stop)):
        dt = stop[k] - start[k]
        w = body_rates(imu_of, parent, source, gain, R_GB, R_IB, bg, gyro[k], valid[k])
        f, felt = root_force(imu_of, R_IB, ba, accel[k], valid[k])
        Phi = transition(
            imu_of, parent, R_GB, R_IB, valid[k], w, f, felt, dt, theta, bg_at, phi_at, ba_at,
            scale_at,
        )  # fmt: skip
        move_covariance(P, Phi)
        add_walks(
            P, dt, accel_sd if felt else free_accel_sd, gyro_bias_sd, mounting_sd, accel_bias_sd,
            scale_sd, offset_sd, bg_at, phi_at, ba_at, scale_at, joint_at,
        )  # fmt: skip
        add_turn_noise(
            P, R_GB, parent, imu_of, valid[k], theta, gyro_sd**2 * dt, free_sd**2 * dt,
            free_root_sd**2 * dt,
        )  # fmt: skip
        p, v, R_GB = move_nominal(p, v, R_GB, w, f, felt, dt, start[k] - last_good > patience)
    return p, v, R_GB


@kernel
def carry(  # type: ignore[no-untyped-def]
    imu_of, parent, source, gain, p, v, R_GB, bg, R_IB, ba, t, accel, gyro, valid, start, end,
    coasting,
):  # fmt: skip
    """p, v, R_GB after the way from ``start`` to ``end`` past the packets t (m,) s with readings
    (m, n, 3), and when that is."""
    starts, stops, accel, gyro, valid = cut(t, accel, gyro, valid, start, end)
    for k in range(len(stops)):
        w = body_rates(imu_of, parent, source, gain, R_GB, R_IB, bg, gyro[k], valid[k])
        f, felt = root_force(imu_of, R_IB, ba, accel[k], valid[k])
        dt = stops[k] - starts[k]
        p, v, R_GB = move_nominal(p, v, R_GB, w, f, felt, dt, coasting)
        start = stops[k]
    return p, v, R_GB, start
