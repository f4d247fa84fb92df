"""Makes a rig from two cameras and the rigid motion between them, or from one camera."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.messages import Array, CameraPose
from tracker.vision.lenses import one_camera_rig
from tracker.vision.rig import Camera, StereoRig, default_pose


@dataclass(frozen=True, eq=False)
class Intrinsics:
    """One camera before rectification: K (3, 3) px, D (n,) of `tracker.vision.lens_models`."""

    width: int
    height: int
    K: Array
    D: Array
    fisheye: bool = False


def rectified_rig(
    left: Intrinsics, right: Intrinsics, R: Array, T: Array, pose: CameraPose | None = None
) -> StereoRig:
    """The rig of X_right = R X_left + T, with R (3, 3) and T (3,) m.

    ``pose`` is that of the rectified left camera; default: that of the evaluation's tripod.
    """
    size = (left.width, left.height)
    cameras = (left.K, left.D, _as_large(right, left), right.D, size)
    # OpenCV 5 takes T as a column only.
    motion = (np.ascontiguousarray(R, float), np.array(T, float).reshape(3, 1))
    if left.fisheye != right.fisheye:
        raise ConfigError(failure("stereo.mixed_lenses"))
    if left.fisheye:
        R1, R2, P1, P2, _ = cv2.fisheye.stereoRectify(
            *cameras, *motion, flags=cv2.CALIB_ZERO_DISPARITY, balance=0.0
        )
    else:
        R1, R2, P1, P2, *_ = cv2.stereoRectify(
            *cameras, *motion, flags=cv2.CALIB_ZERO_DISPARITY, alpha=0
        )
    return StereoRig(
        Camera(left.width, left.height, left.K, left.D, R1, P1, left.fisheye),
        Camera(right.width, right.height, right.K, right.D, R2, P2, right.fisheye),
        pose or default_pose(),
    )


def _as_large(camera: Intrinsics, other: Intrinsics) -> Array:
    """K (3, 3) of the camera as if its images were scaled and cropped to the other's size: OpenCV
    rectifies images of one size, and these may differ."""
    scale = other.width / camera.width
    K = camera.K.copy()
    K[:2] *= scale
    K[1, 2] += (other.height - scale * camera.height) / 2
    return K


def rig_of_one(camera: Intrinsics, pose: CameraPose | None = None) -> StereoRig:
    """The rig of a camera alone; ``pose`` as in `rectified_rig`."""
    P = np.column_stack([camera.K, np.zeros(3)])
    size = (camera.width, camera.height)
    alone = Camera(*size, camera.K, camera.D, np.eye(3), P, camera.fisheye)
    return one_camera_rig(alone, pose or default_pose())
