"""Messages built from the paper's states: calibration and frame results."""

from __future__ import annotations

import numpy as np

from tracker import GRAVITY
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.output.motion import JOINT_RATE_SD, Rates
from tracker.fusion.vist.layout import BA, BG, ERRORS, LAM, PHI, TH, V, VistLayout
from tracker.fusion.vist.markers import Expected, Matched
from tracker.fusion.vist.params import VistNoise
from tracker.fusion.vist.state import VistState
from tracker.geometry import so3
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    CameraPose,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import Camera, StereoRig
from tracker.vision.visibility import both_cameras

GYRO_SD = 0.03  # rad/s per axis, of a gyroscope reading


def calibration_of(layout: VistLayout, state: VistState) -> Calibration:
    """Scales, mountings and biases with their standard deviations."""
    sd = np.sqrt(np.maximum(np.diag(state.P), 0.0)).reshape(layout.n, ERRORS)
    length, length_sd = hand_length(layout, state)
    return Calibration(
        t=state.t,
        segments=layout.chain.names,
        scale=state.scale.copy(),
        scale_sd=sd[:, LAM : LAM + 3].copy(),
        mounting=so3.log(layout.R_IB.swapaxes(1, 2) @ state.R_IB),
        mounting_sd=sd[:, PHI : PHI + 3].copy(),
        gyro_bias=state.bg.copy(),
        gyro_bias_sd=sd[:, BG : BG + 3].copy(),
        accel_bias=state.ba.copy(),
        accel_bias_sd=sd[:, BA : BA + 3].copy(),
        hand_length=length,
        hand_length_sd=length_sd,
    )


def ahead_variance(state: VistState, layout: VistLayout, noise: VistNoise, tau: float) -> Array:
    """(n,) m² per axis that each segment's position gains while the nominal state alone is
    propagated for ``tau`` s (docs/chain.md, eq. 56): each has its own velocity, tilt and bias."""
    variance = np.diagonal(state.P).reshape(layout.n, ERRORS)
    velocity, tilt, bias = (variance[:, k : k + 3].mean(axis=1) for k in (V, TH, BA))
    pull = GRAVITY**2 * tilt + bias
    gained: Array = velocity * tau**2 + pull * tau**4 / 4 + noise.accel**2 * tau**3 / 3
    return gained


def rates_of(layout: VistLayout, state: VistState, past: VistState, packet: ImuSample) -> Rates:
    """The motion of the segments of ``state`` at the time of ``packet``; ``past`` has its
    covariance. A segment whose IMU is invalid rotates with its parent."""
    variance = np.diagonal(past.P).reshape(layout.n, ERRORS)
    v_var, bias, mounting = (variance[:, k : k + 3].mean(axis=1) for k in (V, BG, PHI))
    j, R_GB = layout.imu_of, state.R_GB
    w = np.einsum("nji,nj->ni", state.R_IB, packet.gyro[j] - state.bg)
    w_var = GYRO_SD**2 + bias + (w * w).sum(axis=1) * mounting
    for i in np.flatnonzero(~packet.valid[j]):
        a = layout.chain.parent[i]
        w[i] = R_GB[i].T @ R_GB[a] @ w[a] if a >= 0 else 0.0
        w_var[i] = (w_var[a] if a >= 0 else 0.0) + JOINT_RATE_SD**2
    lever = np.einsum("nij,nj->ni", R_GB, state.scale * layout.imu_position)
    v = state.v_GI - np.cross(np.einsum("nij,nj->ni", R_GB, w), lever)
    v_sd = np.sqrt(v_var + 2 / 3 * (lever * lever).sum(axis=1) * w_var)
    return Rates(v, w, v_sd, np.sqrt(w_var), np.sqrt(_turn_variance(layout, past)))


def _turn_variance(layout: VistLayout, state: VistState) -> Array:
    """(n,) rad², mean of three axes, of each segment's rotation relative to its parent."""
    n, parent, R = layout.n, layout.chain.parent, state.R_GI
    P = state.P.reshape(n, ERRORS, n, ERRORS)[:, TH : TH + 3, :, TH : TH + 3]
    own = np.einsum("iaia->i", P) / 3
    out = own.copy()
    for i in range(1, n):
        a = parent[i]
        shared = np.sum(P[i, :, a] * (R[i].T @ R[a]))
        out[i] = own[i] + own[a] - 2 / 3 * shared
    return np.maximum(out, 0.0)


def hand_length(layout: VistLayout, state: VistState) -> tuple[float, float]:
    """The hand's length (m) and its standard deviation, from the length scales.

    A segment without a state has the scale of the one before it.
    """
    hand, row_of = layout.hand, layout.chain.row_of
    gain, last = np.zeros(layout.n), 0
    for row in hand.length_path:
        last = row_of.get(row, last)
        gain[last] += hand.segments[row].length
    rows = np.arange(LAM, layout.size, ERRORS)
    variance = float(gain @ state.P[np.ix_(rows, rows)] @ gain)
    return float(gain @ state.scale[:, 0]), float(np.sqrt(max(variance, 0.0)))


def frame_result(
    frame: BlobFrame,
    layout: VistLayout,
    rig: StereoRig,
    pose: CameraPose,
    tracking: Tracking,
    expected: Expected,
    matched: Matched,
    seen: tuple[SeenBlobs, ...],
) -> FrameResult:
    """The result of an image, in raw pixels; one row per marker of the whole glove."""
    m, used_markers = len(layout.glove.markers), layout.used_markers
    p_C = (expected.p_G - pose.p_GC) @ pose.R_GC
    uv = [rig.project(p_C), rig.project(p_C, right=True)]
    source = np.full((2, m), -1, np.int64)
    residual = np.full((m, 4), np.nan)
    for c, rows in enumerate((matched.left, matched.right)):
        source[c, used_markers[matched.marker]] = seen[c].source[rows]
        residual[used_markers[matched.marker], 2 * c : 2 * c + 2] = (
            seen[c].uv[rows] - uv[c][matched.marker]
        )
    visible = np.zeros(m)
    visible[used_markers] = both_cameras(expected.prior)
    cov = np.full((m, 2, 2), np.nan)
    cov[used_markers] = _pixel_covariance(rig, pose, p_C, expected.cov)
    return FrameResult(
        t=frame.t,
        tracking=tracking,
        predicted_left=_raw(rig.left, uv[0], used_markers, m),
        predicted_right=_raw(rig.right, uv[1], used_markers, m),
        predicted_cov=cov,
        visible=visible,
        match_left=source[0],
        match_right=source[1],
        residual=residual,
        stereo_points=len(matched),
    )


def _pixel_covariance(rig: StereoRig, pose: CameraPose, p_C: Array, cov_G: Array) -> Array:
    """(m, 2, 2) px² of the left projections of points with cov_G (m, 3, 3) m²."""
    z = np.where(p_C[:, 2] < 0.01, np.nan, p_C[:, 2])
    A = np.zeros((len(p_C), 2, 3))
    A[:, 0, 0], A[:, 1, 1] = rig.fx / z, rig.fy / z
    A[:, 0, 2], A[:, 1, 2] = -rig.fx * p_C[:, 0] / z**2, -rig.fy * p_C[:, 1] / z**2
    A = A @ pose.R_GC.T
    return A @ cov_G @ A.swapaxes(1, 2)


def _raw(camera: Camera, uv: Array, used_markers: IntArray, m: int) -> Array:
    """(m, 2) raw pixels; NaN where a point is not in front of the camera or has no state."""
    out = np.full((m, 2), np.nan)
    ok = np.isfinite(uv[:, 0])
    out[used_markers[ok]] = camera.unrectify(uv[ok])
    return out
