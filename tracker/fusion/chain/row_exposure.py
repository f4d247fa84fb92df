"""What a camera sees that exposes one row after the other (docs/chain.md, eqs. 64 to 66).

A marker is where it is when its own row is exposed, up to half the readout before or after the
image's instant. It is moved there by its velocity against the camera, which the root's velocity and
the gyroscopes tell.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.kinematics import points_of, segment_origins
from tracker.fusion.chain.layout import ChainLayout, ChainSkeleton, Drive, Points
from tracker.fusion.chain.prediction import PosedRig, Prediction, seen_covariance
from tracker.fusion.chain.propagate import body_rates
from tracker.fusion.chain.state import Body, ChainState, ImuErrors
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry.kernels import cross3, rotate, rotate_back
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Stack, Stack4, Vector, Written
from tracker.messages import Array, BlobFrame, CameraMotion, CameraPose
from tracker.vision.rig import Readout, StereoIntrinsics, StereoRig, projected, row_delays

ROUNDS = 3  # a marker at 2 m/s moves on by a tenth of the way that its delay takes it


class RowExposure(NamedTuple):
    """What moves while the rows of an image are exposed: gyro (n, 3) rad/s and valid (n,) of the
    IMUs at the image's instant, the camera's velocity v_GC (3,) m/s and rate w_GC (3,) rad/s in
    G."""

    gyro: Matrix
    valid: BoolVector
    v_GC: Vector
    w_GC: Vector

    @staticmethod
    def of(frame: BlobFrame, rig: StereoRig, buffer: ImuBuffer) -> RowExposure | None:
        """None of a global shutter."""
        return None if rig.line_time == 0.0 else RowExposure.moving(frame, buffer)

    @staticmethod
    def of_stamp(frame: BlobFrame, buffer: ImuBuffer) -> RowExposure | None:
        """What moves while an image's instant is uncertain; None where that is negligible."""
        return None if frame.stamp_sd == 0.0 else RowExposure.moving(frame, buffer)

    @staticmethod
    def moving(frame: BlobFrame, buffer: ImuBuffer) -> RowExposure:
        """What moves at the instant of an image."""
        now = buffer.at(frame.t)
        gyro = np.zeros((buffer.imus, 3)) if now is None else now.gyro
        valid = np.zeros(buffer.imus, np.bool_) if now is None else now.valid
        camera = frame.motion or CameraMotion(np.zeros(3), np.zeros(3))
        return RowExposure(gyro, valid, camera.v_G.copy(), camera.w_G.copy())

    def turned_back(self, uv: Array, right: bool, rig: StereoRig, pose: CameraPose) -> Array:
        """Rectified pixels uv (n, 2) of one camera as they would be if the camera had turned in all
        rows as in the middle one."""
        if len(uv) == 0 or not self.w_GC.any():
            return uv
        both = np.stack([uv, uv])
        delay = rig.row_delays(both)[int(right)]
        rays = (uv - [rig.cx, rig.cy]) / [rig.fx, rig.fy]
        rays = np.column_stack([rays, np.ones(len(rays))])
        rays += delay[:, None] * np.cross(pose.R_GC.T @ self.w_GC, rays)
        out: Array = rays[:, :2] / rays[:, 2:] * [rig.fx, rig.fy] + [rig.cx, rig.cy]
        return out


class Exposed(NamedTuple):
    """Points when their own rows are exposed: rectified pixels uv (2, n, 2) of both cameras, and
    the mean of both of where they then are against the camera, p_C (n, 3) m, and of how much later
    than the image that is, delay (n,) s."""

    uv: Stack
    p_C: Matrix
    delay: Vector


def exposed(p_C: Matrix, v_C: Matrix, uv: Stack, rig: StereoRig) -> Exposed:
    """Points p_C (n, 3) m that move with v_C (n, 3) m/s against the camera; uv (2, n, 2) px are
    where they are at the image's instant (eq. 65)."""
    return Exposed(*exposed_later(p_C, v_C, uv, rig.rows, rig.intrinsics))


def marker_velocities(
    state: ChainState, layout: ChainLayout, markers: Points, exposure: RowExposure, view: PosedRig
) -> Matrix:
    """(n, 3) m/s against the camera, in C (eq. 64)."""
    return velocities_in(
        layout.drive, layout.skeleton, state.body, state.p, state.v, state.imus, markers,
        exposure, view,
    )  # fmt: skip


def root_velocities(
    state: ChainState, layout: ChainLayout, p_C: Array, exposure: RowExposure, view: PosedRig
) -> Array:
    """(n, 3) m/s of points p_C (n, 3) m against the camera, in C, if they move with the root."""
    R_GB = state.R_GB[0]
    w = body_rates(layout.drive, state.R_GB, state.imus, exposure.gyro, exposure.valid)
    p_G = p_C @ view.R_GC.T + view.p_GC
    own = state.v + np.cross(R_GB @ w[0], p_G - state.p)
    camera = exposure.v_GC + np.cross(exposure.w_GC, p_G - view.p_GC)
    out: Array = (own - camera) @ view.R_GC
    return out


@kernel(nogil=False)
def velocities_in(
    drive: Drive,
    skeleton: ChainSkeleton,
    body: Body,
    p: Vector,
    v: Vector,
    imus: ImuErrors,
    points: Points,
    exposure: RowExposure,
    view: PosedRig,
) -> Matrix:
    """`marker_velocities` of the state's parts."""
    parent, R = skeleton.parent, body.R_GB
    w = body_rates(drive, R, imus, exposure.gyro, exposure.valid)
    p_GB = segment_origins(skeleton, body, p)
    p_G = points_of(p_GB, body, points)
    # 1. the segments' rates and their origins' velocities in G
    w_G, v_G = np.empty_like(w), np.empty_like(w)
    for i in range(len(parent)):
        a = parent[i]
        w_G[i] = rotate(R[i], w[i])
        if a < 0:
            v_G[i] = v + cross3(w_G[i], p_GB[i] - p)
        else:
            v_G[i] = v_G[a] + cross3(w_G[a], p_GB[i] - p_GB[a])
    # 2. the points', against the camera
    out = np.empty((len(points.segment), 3))
    for k in range(len(out)):
        a = points.segment[k]
        own = v_G[a] + cross3(w_G[a], p_G[k] - p_GB[a])
        camera = exposure.v_GC + cross3(exposure.w_GC, p_G[k] - view.p_GC)
        out[k] = rotate_back(view.R_GC, own - camera)
    return out


@kernel(nogil=False)
def exposed_later(
    p_C: Matrix, v_C: Matrix, uv: Stack, rows: Readout, camera: StereoIntrinsics
) -> tuple[Stack, Matrix, Vector]:
    """`exposed`, as a plain tuple."""
    delay = row_delays(uv, rows)
    for _ in range(ROUNDS):
        uv = pixels_after(p_C, v_C, delay, camera)
        delay = row_delays(uv, rows)
    mean, there = np.empty(len(p_C)), np.empty_like(p_C)
    for k in range(len(p_C)):
        mean[k] = (delay[0, k] + delay[1, k]) / 2
        for i in range(3):
            there[k, i] = p_C[k, i] + mean[k] * v_C[k, i]
    return uv, there, mean


@kernel(nogil=False)
def pixels_after(p_C: Matrix, v_C: Matrix, delay: Matrix, camera: StereoIntrinsics) -> Stack:
    """(2, n, 2) rectified pixels of points p_C (n, 3) m, each camera's ``delay`` (2, n) s later."""
    uv = np.empty((2, len(p_C), 2))
    there = np.empty_like(p_C)
    for c in range(2):
        for k in range(len(p_C)):
            for i in range(3):
                there[k, i] = p_C[k, i] + delay[c, k] * v_C[k, i]
        shift = camera.baseline if c else 0.0
        uv[c] = projected(there, shift, camera.fx, camera.fy, camera.cx, camera.cy)
    return uv


def with_velocity(prediction: Prediction, delay: Vector, P: Matrix, pixel_px: float) -> None:
    """Let the markers' rows depend on the root's velocity for their ``delay`` (M,) s, in place
    (eq. 66)."""
    add_velocity(
        prediction.H, prediction.HP, prediction.cov, prediction.S, prediction.A, prediction.rows,
        delay, P, pixel_px,
    )  # fmt: skip


@kernel(nogil=False)
def add_velocity(
    H: Written[Stack],
    HP: Written[Stack],
    cov: Written[Stack],
    S: Written[Stack4],
    A: Stack4,
    rows: IntVector,
    delay: Vector,
    P: Matrix,
    pixel_px: float,
) -> None:
    """`with_velocity` of the prediction's parts."""
    for i in range(len(rows)):
        m = rows[i]
        d = delay[m]
        # 1. cov of p + d v: cov of p, d (C + Cᵀ) for C = cov of p and v, and d² cov of v
        for r in range(3):
            for s in range(3):
                cross = HP[i, r, 3 + s] + HP[i, s, 3 + r]
                cov[i, r, s] += d * cross + d * d * P[3 + r, 3 + s]
        # 2. H and H P
        for r in range(3):
            H[i, r, 3 + r] += d
            for c in range(len(P)):
                HP[i, r, c] += d * P[3 + r, c]
        # 3. the same in each camera's pixels
        for c in range(2):
            S[c, i] = seen_covariance(A[c, m], cov[i], pixel_px)
