"""The rows of relative tilt, compiled; `tracker.fusion.chain.tilt` says what they are."""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.kinematics import from_point, joint_lever, stretched
from tracker.fusion.chain.propagate_kernel import body_rates, root_force
from tracker.geometry.kernels import cross3, mul3, rotate, rotate_back, skew3
from tracker.kernels import kernel


@kernel
def stacked_rows(  # type: ignore[no-untyped-def]
    imu_segment, imu_position, imu_of, source, gain, parent, origin, base_of, root_lever, joint,
    scale, R_GB, R_IB, bg, ba, gyro_0, valid_0, accel, gyro, valid, gyro_1, valid_1, span,
    theta, phi, ba_at, size, sd, sd_kinematic,
):  # fmt: skip
    """H (3k, size), innovation (3k,) and variances (3k,) of the k finger IMUs that answer.

    Arguments as in `_row` and `body_rates`; accel (n, 3) m/s² and gyro (n, 3) rad/s read now, the
    other two ``span`` s apart before and after; ``sd`` m/s² and ``sd_kinematic`` the share of the
    kinematic part. Nothing where the root's IMU does not answer.
    """
    n = len(imu_segment)
    H, r, var = np.zeros((3 * n, size)), np.empty(3 * n), np.empty(3 * n)
    f_0, felt = root_force(imu_of, R_IB, ba, accel, valid)
    tree = imu_of, parent, source, gain, R_GB, R_IB, bg
    w = body_rates(*tree, gyro, valid)
    alpha = (body_rates(*tree, gyro_1, valid_1) - body_rates(*tree, gyro_0, valid_0)) / span
    end = 0
    for j in range(n):
        if not felt or imu_segment[j] == 0 or not valid[j]:
            continue
        predicted, kinematic = _row(
            H[end : end + 3], j, imu_segment[j], imu_position[j], parent, origin, base_of,
            root_lever, joint, scale, R_GB, R_IB, ba, w, alpha, f_0, imu_of[0], theta, phi, ba_at,
        )  # fmt: skip
        for i in range(3):
            r[end + i] = accel[j, i] - predicted[i]
            var[end + i] = sd**2 + (sd_kinematic * kinematic) ** 2
        end += 3
    return H[:end], r[:end], var[:end]


@kernel
def _row(  # type: ignore[no-untyped-def]
    h, j, segment, position, parent, origin, base_of, root_lever, joint, scale, R_GB, R_IB, ba,
    w, alpha, f_0, root_imu, theta, phi, ba_at,
):  # fmt: skip
    """Fills h = J_f_error (3, size); the predicted reading (3,) and its kinematic part (m/s²).

    IMU ``j`` stands on the active ``segment`` at ``position`` (3,) m in its B; parent (A,), origin
    (A, 3) m, scale (A, 2), R_GB (A, 3, 3), w (A, 3) rad/s and alpha (A, 3) rad/s² are of the active
    segments, joint (B, 3) m of finger bases, R_IB and ba of the IMUs, f_0 (3,) m/s² of the root in
    its B. theta, phi and ba_at are where these blocks of the error state start.
    """
    kinematic_G = np.zeros(3)
    M = mul3(R_IB[j], R_GB[segment].T)
    a, lever = segment, stretched(scale[segment], position)
    while True:
        c = cross3(alpha[a], lever) + cross3(w[a], cross3(w[a], lever))
        kinematic_G += rotate(R_GB[a], c)
        total = c + f_0 if a == 0 else c
        _add(h, theta + 3 * a, mul3(mul3(M, R_GB[a]), skew3(total)), -1.0)
        child, a = a, parent[a]
        if a < 0:
            break
        x = joint_lever(scale, origin, joint, base_of, child, a)
        lever = from_point(a, x, root_lever, scale[a])
    s = rotate_back(R_GB[segment], kinematic_G + rotate(R_GB[0], f_0))
    turn, R_0 = mul3(R_IB[j], skew3(s)), mul3(M, R_GB[0])
    _add(h, theta + 3 * segment, turn, 1.0)
    _add(h, phi + 3 * j, turn, -1.0)
    _add(h, ba_at + 3 * j, np.eye(3), 1.0)
    _add(h, phi + 3 * root_imu, mul3(R_0, skew3(f_0)), 1.0)
    _add(h, ba_at + 3 * root_imu, mul3(R_0, R_IB[root_imu].T), -1.0)
    return rotate(R_IB[j], s) + ba[j], np.sqrt(np.sum(kinematic_G**2))


@kernel
def _add(h, column, block, sign):  # type: ignore[no-untyped-def]
    """h[:, column : column + 3] += sign * block."""
    for r in range(3):
        for c in range(3):
            h[r, column + c] += sign * block[r, c]
