"""The rows of relative tilt, compiled; `tracker.fusion.tilt` says what they are."""

from __future__ import annotations

import numpy as np

from tracker.geometry.kernels import act3, cross3, mul3, skew3, tact3
from tracker.kernels import kernel


@kernel
def stacked_rows(  # type: ignore[no-untyped-def]
    imu_segment, imu_position, parent, origin, joint, root_lever, scale3, R_GB, R_IB, ba,
    accel, valid, w, alpha, f_0, root_imu, theta, phi, ba_at, size, sd, sd_kinematic,
):  # fmt: skip
    """H (3k, size), innovation (3k,) and variances (3k,) of the k finger IMUs that answer.

    Arguments as in `_row`; accel (n, 3) m/s² and valid (n,) of the packet, ``sd`` m/s² and
    ``sd_kinematic`` the share of the kinematic part.
    """
    n = len(imu_segment)
    H, r, var = np.zeros((3 * n, size)), np.empty(3 * n), np.empty(3 * n)
    end = 0
    for j in range(n):
        if imu_segment[j] == 0 or not valid[j]:
            continue
        predicted, kinematic = _row(
            H[end : end + 3], j, imu_segment[j], imu_position[j], parent, origin, joint, root_lever,
            scale3, R_GB, R_IB, ba, w, alpha, f_0, root_imu, theta, phi, ba_at,
        )  # fmt: skip
        for i in range(3):
            r[end + i] = accel[j, i] - predicted[i]
            var[end + i] = sd**2 + (sd_kinematic * kinematic) ** 2
        end += 3
    return H[:end], r[:end], var[:end]


@kernel
def _row(  # type: ignore[no-untyped-def]
    h, j, segment, position, parent, origin, joint, root_lever, scale3, R_GB, R_IB, ba,
    w, alpha, f_0, root_imu, theta, phi, ba_at,
):  # fmt: skip
    """Fills h = J_f_error (3, size); the predicted reading (3,) and its kinematic part (m/s²).

    IMU ``j`` stands on the active ``segment`` at ``position`` (3,) m in its B; parent (A,), origin
    and joint (A, 3) m, scale3 (A, 3), R_GB (A, 3, 3), w (A, 3) rad/s and alpha (A, 3) rad/s² are of
    the active segments, R_IB and ba of the IMUs, f_0 (3,) m/s² of the root in its B. theta, phi and
    ba_at are where these blocks of the error state start.
    """
    kinematic_G = np.zeros(3)
    M = mul3(R_IB[j], R_GB[segment].T)
    a, lever = segment, scale3[segment] * position
    while True:
        c = cross3(alpha[a], lever) + cross3(w[a], cross3(w[a], lever))
        kinematic_G += act3(R_GB[a], c)
        total = c + f_0 if a == 0 else c
        _add(h, theta + 3 * a, mul3(mul3(M, R_GB[a]), skew3(total)), -1.0)
        child, a = a, parent[a]
        if a < 0:
            break
        lever = scale3[a] * origin[child] + joint[child]
        if a == 0:
            lever = lever - scale3[0] * root_lever
    s = tact3(R_GB[segment], kinematic_G + act3(R_GB[0], f_0))
    turn, R_0 = mul3(R_IB[j], skew3(s)), mul3(M, R_GB[0])
    _add(h, theta + 3 * segment, turn, 1.0)
    _add(h, phi + 3 * j, turn, -1.0)
    _add(h, ba_at + 3 * j, np.eye(3), 1.0)
    _add(h, phi + 3 * root_imu, mul3(R_0, skew3(f_0)), 1.0)
    _add(h, ba_at + 3 * root_imu, mul3(R_0, R_IB[root_imu].T), -1.0)
    return act3(R_IB[j], s) + ba[j], np.sqrt(np.sum(kinematic_G**2))


@kernel
def _add(h, column, block, sign):  # type: ignore[no-untyped-def]
    """h[:, column : column + 3] += sign * block."""
    for r in range(3):
        for c in range(3):
            h[r, column + c] += sign * block[r, c]
