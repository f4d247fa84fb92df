"""Finger accelerometers as relative tilt.

All IMUs of a hand measure the same gravity and the same motion of the dorsum; their readings differ
by their positions on the chain. With f_0 the dorsum's specific force, the specific force at finger
IMU j is predicted as  h_j = R_IB_j R_GB_j^T sum_a R_GB_a c_a + b_a,  c_a = alpha x l + w x (w x l)
along the chain and f_0 added at the root. Gravity itself cancels, so the camera's tilt does not
matter. This is the compensation of Lemak et al. 2020 (doi:10.3390/computers9020040, eqs. 2 and 3)
extended to three dimensions; equation numbers below are those of docs/chain.md.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.kinematics import from_point, joint_lever, stretched
from tracker.fusion.chain.layout import Blocks, ChainLayout, ChainSkeleton, Drive, MountedImus
from tracker.fusion.chain.params import ConstraintParams
from tracker.fusion.chain.propagate import body_rates, root_force
from tracker.fusion.chain.state import Body, ChainState, ImuErrors
from tracker.fusion.time.imu_buffer import Around
from tracker.geometry.kernels import cross3, mul3, rotate, rotate_back, skew3
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector, Written
from tracker.messages import Array


class _Noise(NamedTuple):
    """sd m/s², and the share of the kinematic part added to it."""

    sd: float
    kinematic: float


class _Rigid(NamedTuple):
    """w (A, 3) rad/s, alpha (A, 3) rad/s² of the active segments, f_0 (3,) m/s² of the root, each
    in its B; the IMU that measured f_0."""

    w: Matrix
    alpha: Matrix
    f_0: Vector
    root_imu: int


def tilt_rows(
    state: ChainState, layout: ChainLayout, params: ConstraintParams, around: Around
) -> tuple[Array, Array, Array] | None:
    """Rows at the time of ``around.now``.

    Returns H (3k, N), innovation (3k,), variances (3k,) for the k valid finger IMUs; None where the
    root's IMU is invalid.
    """
    noise = _Noise(params.tilt, params.tilt_kinematic)
    H, r, var = stacked_rows(
        layout.imus, layout.drive, layout.skeleton, layout.blocks, state.body, state.imus, around,
        noise,
    )  # fmt: skip
    return (H, r, var) if len(r) else None


@kernel(nogil=False)
def stacked_rows(
    mounted: MountedImus,
    drive: Drive,
    skeleton: ChainSkeleton,
    at: Blocks,
    body: Body,
    imus: ImuErrors,
    around: Around,
    noise: _Noise,
) -> tuple[Matrix, Vector, Vector]:
    """H (3k, N), innovation (3k,) and variances (3k,) of the k valid finger IMUs; empty where the
    root's IMU is invalid."""
    n = len(mounted.segment)
    H, r, var = np.zeros((3 * n, at.size)), np.empty(3 * n), np.empty(3 * n)
    before, now, after = around
    # 1. the motion of the hand
    f_0, felt = root_force(drive, imus, now.accel, now.valid)
    w = body_rates(drive, body.R_GB, imus, now.gyro, now.valid)
    w_1 = body_rates(drive, body.R_GB, imus, after.gyro, after.valid)
    w_0 = body_rates(drive, body.R_GB, imus, before.gyro, before.valid)
    rigid = _Rigid(w, (w_1 - w_0) / (after.t - before.t), f_0, drive.imu_of[0])
    # 2. the reading of each finger's IMU, and its prediction
    end = 0
    for j in range(n):
        if not felt or mounted.segment[j] == 0 or not now.valid[j]:
            continue
        predicted, kinematic = _put_row(
            H[end : end + 3], j, mounted, skeleton, at, body, imus, rigid
        )
        for i in range(3):
            r[end + i] = now.accel[j, i] - predicted[i]
            var[end + i] = noise.sd**2 + (noise.kinematic * kinematic) ** 2  # eq. 31
        end += 3
    return H[:end], r[:end], var[:end]


@kernel
def _put_row(
    h: Written[Matrix],
    j: int,
    mounted: MountedImus,
    skeleton: ChainSkeleton,
    at: Blocks,
    body: Body,
    imus: ImuErrors,
    rigid: _Rigid,
) -> tuple[Vector, float]:
    """Fills h = J_f_error (3, N) of IMU ``j``; its predicted reading (3,) and the kinematic part
    of that (m/s²)."""
    segment, R_GB, R_IB = mounted.segment[j], body.R_GB, imus.R_IB
    w, alpha, f_0, root_imu = rigid
    kinematic_G = np.zeros(3)
    M = mul3(R_IB[j], R_GB[segment].T)
    # 1. along the chain: the contribution of each link, and its derivative by the link's
    # orientation (eq. 30)
    a, lever = segment, stretched(body.scale[segment], mounted.position[j])
    while True:
        c = cross3(alpha[a], lever) + cross3(w[a], cross3(w[a], lever))  # eq. 28
        kinematic_G += rotate(R_GB[a], c)
        total = c + f_0 if a == 0 else c
        _add(h, at.theta + 3 * a, mul3(mul3(M, R_GB[a]), skew3(total)), -1.0)
        child, a = a, skeleton.parent[a]
        if a < 0:
            break
        x = joint_lever(skeleton, body, child, a)
        lever = from_point(a, x, skeleton.lever, body.scale[a])
    # 2. eq. 29, and by the segment's own orientation, mounting and bias (eq. 30)
    s = rotate_back(R_GB[segment], kinematic_G + rotate(R_GB[0], f_0))
    J_f_theta, R_0 = mul3(R_IB[j], skew3(s)), mul3(M, R_GB[0])
    _add(h, at.theta + 3 * segment, J_f_theta, 1.0)
    _add(h, at.phi + 3 * j, J_f_theta, -1.0)
    _add(h, at.ba + 3 * j, np.eye(3), 1.0)
    # 3. by the root's mounting and bias, through f_0 (eq. 30)
    _add(h, at.phi + 3 * root_imu, mul3(R_0, skew3(f_0)), 1.0)
    _add(h, at.ba + 3 * root_imu, mul3(R_0, R_IB[root_imu].T), -1.0)
    return rotate(R_IB[j], s) + imus.ba[j], np.sqrt(np.sum(kinematic_G**2))


@kernel
def _add(h: Written[Matrix], column: int, block: Matrix, sign: float) -> None:
    """h[:, column : column + 3] += sign * block."""
    for r in range(3):
        for c in range(3):
            h[r, column + c] += sign * block[r, c]
