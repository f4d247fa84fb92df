"""One finger IMU's row of relative tilt, compiled; `tracker.fusion.tilt` says what it is."""

from __future__ import annotations

import numba
import numpy as np

from tracker.geometry.kernels import cross3, skew3


@numba.njit(cache=True)
def tilt_row(  # type: ignore[no-untyped-def]
    j, segment, position, parent, origin, joint, root_lever, scale3, R_GB, R_IB, ba,
    w, alpha, f_0, root_imu, theta, phi, ba_at, size,
):  # fmt: skip
    """J_f_error (3, size), predicted reading (3,), size of the kinematic part (m/s²).

    IMU ``j`` stands on the active ``segment`` at ``position`` (3,) m in its B; parent (A,), origin
    and joint (A, 3) m, scale3 (A, 3), R_GB (A, 3, 3), w (A, 3) rad/s and alpha (A, 3) rad/s² are of
    the active segments, R_IB and ba of the IMUs, f_0 (3,) m/s² of the root in its B. theta, phi and
    ba_at are where these blocks of the error state start.
    """
    h = np.zeros((3, size))
    kinematic_G = np.zeros(3)
    M = R_IB[j] @ R_GB[segment].T
    a, lever = segment, scale3[segment] * position
    while True:
        c = cross3(alpha[a], lever) + cross3(w[a], cross3(w[a], lever))
        kinematic_G += R_GB[a] @ c
        total = c + f_0 if a == 0 else c
        h[:, theta + 3 * a : theta + 3 * a + 3] -= M @ R_GB[a] @ skew3(total)
        child, a = a, parent[a]
        if a < 0:
            break
        lever = scale3[a] * origin[child] + joint[child]
        if a == 0:
            lever = lever - scale3[0] * root_lever
    s = R_GB[segment].T @ (kinematic_G + R_GB[0] @ f_0)
    turn, R_0 = R_IB[j] @ skew3(s), M @ R_GB[0]
    h[:, theta + 3 * segment : theta + 3 * segment + 3] += turn
    h[:, phi + 3 * j : phi + 3 * j + 3] -= turn
    h[:, ba_at + 3 * j : ba_at + 3 * j + 3] += np.eye(3)
    h[:, phi + 3 * root_imu : phi + 3 * root_imu + 3] += R_0 @ skew3(f_0)
    h[:, ba_at + 3 * root_imu : ba_at + 3 * root_imu + 3] -= R_0 @ R_IB[root_imu].T
    return h, R_IB[j] @ s + ba[j], np.sqrt(kinematic_G @ kinematic_G)
