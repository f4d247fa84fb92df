"""A rig out of two cameras and the rigid motion between them."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracker.messages import Array, CameraPose
from tracker.vision.rig import Camera, StereoRig, default_pose


@dataclass(frozen=True, eq=False)
class Intrinsics:
    """One camera before rectification: K (3, 3) px, D (5,) k1 k2 p1 p2 k3."""

    width: int
    height: int
    K: Array
    D: Array


def rectified_rig(
    left: Intrinsics, right: Intrinsics, R: Array, T: Array, pose: CameraPose | None = None
) -> StereoRig:
    """The rig of X_right = R X_left + T, with R (3, 3) and T (3,) m.

    ``pose`` is that of the rectified left camera; the evaluation's stand where it is not given.
    """
    size = (left.width, left.height)
    # OpenCV 5 takes T as a column only.
    R1, R2, P1, P2, *_ = cv2.stereoRectify(
        left.K,
        left.D,
        right.K,
        right.D,
        size,
        np.asarray(R, float),
        np.asarray(T, float).reshape(3, 1),
        flags=cv2.CALIB_ZERO_DISPARITY,
        alpha=0,
    )
    return StereoRig(
        Camera(left.width, left.height, left.K, left.D, R1, P1),
        Camera(right.width, right.height, right.K, right.D, R2, P2),
        pose or default_pose(),
    )
