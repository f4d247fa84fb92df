"""Messages built from a chain filter's state: calibration, frame results."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.prediction import Prediction
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, Matrix, Stack, Vector
from tracker.messages import Array, BlobFrame, Calibration, FrameResult, IntArray, Tracking
from tracker.vision.rig import Camera, StereoRig


def calibration_of(layout: ChainLayout, state: ChainState) -> Calibration:
    """Scales, mountings and biases with their standard deviations."""
    sd = np.sqrt(np.maximum(np.diag(state.P), 0.0))
    n = len(layout.active)
    scale_sd = sd[layout.blocks.scale : layout.blocks.joint].reshape(n, 2)[:, [0, 1, 1]]
    per_imu = {
        "mounting": (
            so3.log(layout.R_IB.swapaxes(1, 2) @ state.R_IB),
            sd[layout.blocks.phi : layout.blocks.ba].reshape(-1, 3),
        ),
        "gyro_bias": (state.bg, sd[layout.blocks.bg : layout.blocks.phi].reshape(-1, 3)),
        "accel_bias": (state.ba, sd[layout.blocks.ba : layout.blocks.scale].reshape(-1, 3)),
    }
    rows: dict[str, Array] = {}
    for name, (value, value_sd) in per_imu.items():
        for key, source in ((name, value), (f"{name}_sd", value_sd)):
            full = np.full((n, 3), np.nan)
            full[layout.imu_segment] = source
            rows[key] = full
    length, length_sd = hand_length(layout, state)
    return Calibration(
        t=state.t,
        segments=layout.names,
        scale=state.scale3(),
        scale_sd=scale_sd,
        hand_length=length,
        hand_length_sd=length_sd,
        **rows,
    )


def with_size_uncertainty(found: Calibration, size_sd: float) -> Calibration:
    """With the uncertainty of sizes at least that of the common size, a share; girths too."""
    return replace(
        found,
        scale_sd=np.maximum(found.scale_sd, size_sd),
        hand_length_sd=max(found.hand_length_sd, size_sd * found.hand_length),
    )


def hand_length(layout: ChainLayout, state: ChainState) -> tuple[float, float]:
    """The hand's length (m) and its standard deviation, from the length scales."""
    gain = length_gain(layout)
    P = state.P[
        layout.blocks.scale : layout.blocks.joint : 2, layout.blocks.scale : layout.blocks.joint : 2
    ]
    return float(gain @ state.scale[:, 0]), max(float(gain @ P @ gain), 0.0) ** 0.5


def length_gain(layout: ChainLayout) -> Array:
    """(A,) m by which each segment's length scale contributes to the hand's length."""
    hand, last = layout.hand, 0
    gain = np.zeros(len(layout.active))
    for row in hand.length_path:
        last = layout.row_of.get(row, last)
        gain[last] += hand.segments[row].length
    return gain


def frame_result(
    frame: BlobFrame,
    rig: StereoRig,
    tracking: Tracking,
    prediction: Prediction,
    seen: tuple[SeenBlobs, ...],
    match: IntArray,
) -> FrameResult:
    """The result of an image, in raw pixels."""
    residual, source, cov, visible, stereo_points = _details(prediction, match, *seen)
    return FrameResult(
        t=frame.t,
        tracking=tracking,
        predicted_left=_raw(rig.left, prediction.uv[0]),
        predicted_right=_raw(rig.right, prediction.uv[1]),
        predicted_cov=cov,
        visible=visible,
        match_left=source[0],
        match_right=source[1],
        residual=residual,
        stereo_points=stereo_points,
    )


@kernel(nogil=False)
def _details(
    prediction: Prediction, match: IntMatrix, left: SeenBlobs, right: SeenBlobs
) -> tuple[Matrix, IntMatrix, Stack, Vector, int]:
    """residual (M, 4) px, source (2, M) rows of the message, cov (M, 2, 2) px² of the left image,
    visible (M,), and the number of markers matched (2, M) in both."""
    uv, prior = prediction.uv, prediction.prior
    m = uv.shape[1]
    residual, source = np.full((m, 4), np.nan), np.full((2, m), -1, np.int64)
    cov, visible, stereo_points = np.full((m, 2, 2), np.nan), np.empty(m), 0
    for j in range(m):
        visible[j] = max(prior[0, j], prior[1, j])
        stereo_points += match[0, j] >= 0 and match[1, j] >= 0
        for c in range(2):
            k = match[c, j]
            if k >= 0:
                blob = left.uv[k] if c == 0 else right.uv[k]
                residual[j, 2 * c] = blob[0] - uv[c, j, 0]
                residual[j, 2 * c + 1] = blob[1] - uv[c, j, 1]
                source[c, j] = left.source[k] if c == 0 else right.source[k]
    for k in range(len(prediction.rows)):
        cov[prediction.rows[k]] = prediction.S[0, k]
    return residual, source, cov, visible, stereo_points


def _raw(camera: Camera, uv: Array) -> Array:
    if camera.is_rectified:
        return uv.copy()  # a message owns its arrays
    out = np.full_like(uv, np.nan)
    ok = np.isfinite(uv[:, 0])
    out[ok] = camera.unrectify(uv[ok])
    return out
