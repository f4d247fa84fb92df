"""The hand in the orders and axes of other programs: OpenXR, MediaPipe, MANO, dex-retargeting.

Sources: MediaPipe's 21 landmarks (ai.google.dev/edge/mediapipe/solutions/vision/hand_landmarker);
MANO (Romero, Tzionas, Black 2017), whose joints are numbered wrist, index, middle, little, ring,
thumb, and to which smplx appends the tips of thumb, index, middle, ring, little; dex-retargeting
(src/dex_retargeting/constants.py and single_hand_detector.py of its example), whose operator frame
is its estimate of MANO's wrist frame times OPERATOR2MANO.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.geometry import so3
from tracker.hand.names import FINGERS, KEYPOINTS
from tracker.hand.openxr import joint_radii, to_openxr
from tracker.messages import Array

MEDIAPIPE = tuple(KEYPOINTS)
"""Our keypoints have MediaPipe's order: wrist, thumb CMC to tip, index MCP to tip, … little."""

MANO_FINGERS = ("index", "middle", "little", "ring")
MANO = (
    "wrist",
    *(f"{f}_{part}" for f in MANO_FINGERS for part in ("mcp", "pip", "dip")),
    *(f"thumb_{part}" for part in ("cmc", "mcp", "ip")),
    *(f"{f}_tip" for f in ("thumb", *FINGERS)),
)
"""MANO's 16 joints, then the five tips."""

R_B_OPERATOR = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
"""Columns: the operator's axes in B, on both sides: x out of the palm, z to the fingers."""


FITTED = ("wrist", "index_mcp", "middle_mcp")


def in_order(points: Array, keypoint_names: Sequence[str], order: Sequence[str]) -> Array:
    """(..., len(order), d) rows of ``points`` (..., K, d); NaN where a keypoint is not there."""
    row_of = {n: i for i, n in enumerate(keypoint_names)}
    out = np.full((*points.shape[:-2], len(order), points.shape[-1]), np.nan)
    for i, name in enumerate(order):
        if name in row_of:
            out[..., i, :] = points[..., row_of[name], :]
    return out


def to_mediapipe(points: Array, keypoint_names: Sequence[str]) -> Array:
    """(..., 21, 3) m of keypoints (..., K, 3) in MediaPipe's order, in their own axes.

    MediaPipe's own world landmarks have a camera's axes (x right, y down) about the hand's centre.
    """
    return in_order(points, keypoint_names, MEDIAPIPE)


def to_mano(points: Array, keypoint_names: Sequence[str]) -> Array:
    """(..., 21, 3) m of keypoints (..., K, 3) in MANO's order: 16 joints and the tips."""
    return in_order(points, keypoint_names, MANO)


def to_operator(points: Array, q: Array, keypoint_names: Sequence[str]) -> Array:
    """(..., 21, 3) m from the wrist in dex-retargeting's operator frame, in MediaPipe's order.

    Keypoints (..., K, 3) and q (..., K, 4) xyzw in any one frame. That project fits the frame to
    wrist, index and middle knuckle; here it is the dorsum's measured one. NaN where the wrist is
    lost.
    """
    wrist = list(keypoint_names).index("wrist")
    R = so3.matrix_from_quat(q[..., wrist, :]) @ R_B_OPERATOR
    from_wrist = to_mediapipe(points, keypoint_names) - points[..., wrist, None, :]
    return np.asarray(from_wrist @ R)


def operator_frame(landmarks: Array, R: Array) -> Array:
    """(3, 3) columns: axes of the operator frame that dex-retargeting fits to landmarks (21, 3).

    In the landmarks' axes: z along the palm from the wrist to the middle knuckle, x out of the
    palm, normal to the plane of wrist, index and middle knuckle. ``R`` (3, 3) is the dorsum's
    orientation, which decides on which side the palm is; the fitted frame differs from it by the
    constant 2.4° of the reference hand, whose index knuckle is not in the dorsum's plane.
    """
    wrist, index, middle = landmarks[[MEDIAPIPE.index(n) for n in FITTED]]
    z = middle - wrist
    x = np.cross(index - wrist, z)
    x = x if x @ (R @ R_B_OPERATOR[:, 0]) > 0 else -x
    x, z = x / np.linalg.norm(x), z / np.linalg.norm(z)
    return np.stack([x, np.cross(z, x), z], axis=1)


__all__ = [
    "joint_radii",
    "operator_frame",
    "to_mano",
    "to_mediapipe",
    "to_openxr",
    "to_operator",
]
