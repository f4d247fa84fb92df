"""Tracking with one camera of two, or with a device that has only one.

A device with one camera is a `StereoRig` whose other camera gives no images: see `one_camera_rig`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import BlobFrame, CameraPose
from tracker.vision.rig import Camera, StereoRig

LENSES = ("both", "left", "right")
"""What `tracker.engine.settings.Settings.lenses` may say."""
UNUSED_BASELINE = 0.06  # m, of the camera that is not there


def check_lenses(lenses: str, rig: StereoRig | None = None) -> None:
    """Raises ConfigError for a word that is none of `LENSES`, and for the right camera where there
    is only one."""
    if lenses not in LENSES:
        raise ConfigError(notice("camera.lenses", lenses=lenses, known=LENSES))
    if lenses == "right" and rig is not None and rig.one_camera:
        raise ConfigError(notice("camera.one_is_left"))


def through(frame: BlobFrame, lenses: str) -> BlobFrame:
    """What the cameras in use see of it."""
    if lenses == "left" and frame.right is not None:
        return replace(frame, right=None, rejected_right=None)
    if lenses == "right" and frame.left is not None:
        return replace(frame, left=None, rejected_left=None)
    return frame


def one_camera_rig(camera: Camera, pose: CameraPose) -> StereoRig:
    """A rig for a device with one camera, the left one, whose pose is that of ``camera.R``'s
    axes."""
    P_left = np.column_stack([camera.P[:, :3], np.zeros(3)])
    P_right = P_left.copy()
    P_right[0, 3] = -UNUSED_BASELINE * P_left[0, 0]
    left, right = (replace(camera, P=P) for P in (P_left, P_right))
    return StereoRig(left, right, pose, one_camera=True)


def with_one_camera(rig: StereoRig) -> StereoRig:
    """What is left of a stereo camera whose right one is taken away."""
    return one_camera_rig(rig.left, rig.pose)
