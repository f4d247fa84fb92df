"""The motion of a camera during the exposure of an image's rows, from its poses in the last images.

The rates between the last two images and between the two before are extrapolated to the image's
instant: a head that turns back and forth changes its rate by a tenth between images.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.base.records import record
from tracker.geometry import so3
from tracker.messages import Array, BlobFrame, CameraMotion, CameraPose

LONGEST = 0.15  # s between two images, beyond which the motion is unknown
LEAST = 1e-3  # s
FASTEST = 20.0  # rad/s; a larger difference between poses is not a single motion


@record("camera_motion.pose")
@dataclass(frozen=True, eq=False)
class TimedPose:
    """The camera at ``t`` (s), and how it moved about the middle between the image before and
    this one; None if unknown."""

    t: float
    pose: CameraPose
    since: CameraMotion | None = None
    middle: float = 0.0


class CameraMotionEstimate:
    """Takes the images of a camera with a rolling shutter in order."""

    def __init__(self) -> None:
        self.last: TimedPose | None = None
        """The saved state."""

    def moved(self, frame: BlobFrame) -> BlobFrame:
        """Returns the frame with the motion of its camera; without it if there is no pose, or if
        the previous image is too old."""
        if frame.pose is None:
            return frame
        before, self.last = self.last, TimedPose(frame.t, frame.pose)
        if before is None or not LEAST <= frame.t - before.t <= LONGEST:
            return frame
        since = _between(before, self.last)
        if np.linalg.norm(since.w_G) > FASTEST:
            return frame
        middle = (before.t + frame.t) / 2
        self.last = replace(self.last, since=since, middle=middle)
        return replace(frame, motion=_carried_on(before, self.last))


def _between(before: TimedPose, now: TimedPose) -> CameraMotion:
    """The mean motion from one image to the next."""
    dt = now.t - before.t
    turn: Array = so3.log(now.pose.R_GC @ before.pose.R_GC.T)
    return CameraMotion((now.pose.p_GC - before.pose.p_GC) / dt, turn / dt)


def _carried_on(before: TimedPose, now: TimedPose) -> CameraMotion:
    """The motion at the instant of ``now``, along the line through the last two."""
    assert now.since is not None
    if before.since is None:
        return now.since
    ahead = (now.t - now.middle) / (now.middle - before.middle)
    v, w = (
        new + ahead * (new - old)
        for new, old in (
            (now.since.v_G, before.since.v_G),
            (now.since.w_G, before.since.w_G),
        )
    )
    return CameraMotion(v, w)
