"""Tracking with one of two cameras, or with a device that has only one.

A device with one camera is a `StereoRig` whose other camera produces no images: see
`one_camera_rig`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import BlobFrame, CameraPose
from tracker.vision.rig import Camera, StereoRig

LENSES = ("both", "left", "right")
"""The values of `tracker.engine.settings.Settings.lenses`."""
UNUSED_BASELINE = 0.06  # m, baseline of a rig without a right camera


def check_lenses(lenses: str, rig: StereoRig | None = None) -> None:
    """Raises ConfigError for a value that is not in `LENSES`, and for the right camera where there
    is only one."""
    if lenses not in LENSES:
        raise ConfigError(notice("camera.lenses", lenses=lenses, known=LENSES))
    if lenses == "right" and rig is not None and rig.one_camera:
        raise ConfigError(notice("camera.one_is_left"))


def through(frame: BlobFrame, lenses: str) -> BlobFrame:
    """The part of a frame from the cameras in use."""
    if lenses == "left" and frame.right is not None:
        return replace(frame, right=None, rejected_right=None)
    if lenses == "right" and frame.left is not None:
        return replace(frame, left=None, rejected_left=None)
    return frame


def one_camera_rig(camera: Camera, pose: CameraPose, line_time: float = 0.0) -> StereoRig:
    """A rig for a device with one camera, the left one, whose pose is that of ``camera.R``'s
    axes; ``line_time`` as of the rig."""
    P_left = np.column_stack([camera.P[:, :3], np.zeros(3)])
    P_right = P_left.copy()
    P_right[0, 3] = -UNUSED_BASELINE * P_left[0, 0]
    left, right = (replace(camera, P=P) for P in (P_left, P_right))
    return StereoRig(left, right, pose, True, line_time)


def with_one_camera(rig: StereoRig) -> StereoRig:
    """A stereo rig without its right camera."""
    return one_camera_rig(rig.left, rig.pose, rig.line_time)
