"""Verifies a calibration on views that were not used for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from tracker.base.notices import Notice, failure, notice, warning
from tracker.calibration.stereo.views import StereoView
from tracker.messages import Array
from tracker.vision.lens_models import distorted, undistorted
from tracker.vision.rig import Camera, StereoRig


@dataclass(frozen=True)
class VerifyParams:
    """Up to ``good_px`` a rig is good, up to ``usable_px`` it may be used with a warning."""

    least_views: int = 4
    good_px: float = 0.5
    usable_px: float = 1.0
    shape: float = 0.01  # relative error of distances on the board


@dataclass(frozen=True, eq=False)
class Verification:
    """``off_px`` (views,) px RMS: the difference of a corner's rows in the two rectified images,
    or, for a single camera, the distance of corners from their projections with the board's best
    pose.

    ``shape`` is the median relative error of the distances between corners in 3D, ``offset_px`` the
    median signed difference of rows; both are 0 for a single camera.
    """

    off_px: Array
    rms_px: float
    worst_px: float
    offset_px: float
    shape: float
    one_camera: bool = False

    def verdict(self, params: VerifyParams | None = None) -> tuple[str, Notice]:
        """("good" | "usable" | "refused" | "waiting", reason)."""
        p = params or VerifyParams()
        missing = p.least_views - len(self.off_px)
        if missing > 0:
            return "waiting", notice("verify.more_views", missing=missing)
        if self.one_camera:
            return self._verdict_of_one(p)
        off = {"rms_px": self.rms_px, "size_percent": 100 * self.shape}
        if self.rms_px > p.usable_px or self.shape > 2 * p.shape:
            return "refused", failure("verify.rows_bad", **off)
        if self.rms_px > p.good_px or self.shape > p.shape:
            return "usable", warning("verify.rows_fair", **off)
        return "good", notice("verify.rows_good", **off)

    def _verdict_of_one(self, p: VerifyParams) -> tuple[str, Notice]:
        if self.rms_px > p.usable_px:
            return "refused", failure("verify.corners_bad", rms_px=self.rms_px)
        if self.rms_px > p.good_px:
            return "usable", warning("verify.corners_fair", rms_px=self.rms_px)
        return "good", notice("verify.corners_good", rms_px=self.rms_px)


def verify(rig: StereoRig, views: Sequence[StereoView]) -> Verification:
    """Evaluates ``rig`` on new views; NaN figures without any. Views with another number of images
    than it has cameras are ignored."""
    views = [v for v in views if len(v.sides) == len(rig.sides)]
    if not views:
        nan = float("nan")
        return Verification(np.zeros(0), nan, nan, nan, nan, rig.one_camera)
    if rig.one_camera:
        return _verify_one(rig.left, views)
    rows, shapes = [], []
    for view in views:
        assert view.right is not None
        left, right = rig.left.rectify(view.left), rig.right.rectify(view.right)
        rows.append(left[:, 1] - right[:, 1])
        shapes.append(_shape_error(view.points, rig.triangulate(left, right)))
    every = np.concatenate(rows)
    return Verification(
        off_px=np.array([np.sqrt(np.mean(r**2)) for r in rows]),
        rms_px=float(np.sqrt(np.mean(every**2))),
        worst_px=float(np.max(np.abs(every))),
        offset_px=float(np.median(every)),
        shape=float(np.median(shapes)),
    )


def _verify_one(camera: Camera, views: Sequence[StereoView]) -> Verification:
    """Fits only the board's pose in each view: a wrong lens model cannot match tilted boards."""
    off = []
    for view in views:
        seen = undistorted(view.left, camera.K, camera.D, camera.fisheye, np.eye(3), camera.K)
        _, turn, place = cv2.solvePnP(view.points, seen, camera.K, None)
        p_C = view.points @ cv2.Rodrigues(turn)[0].T + place.reshape(3)
        expected = distorted(p_C, camera.K, camera.D, camera.fisheye)
        off.append(np.linalg.norm(expected - view.left, axis=1))
    every = np.concatenate(off)
    return Verification(
        off_px=np.array([np.sqrt(np.mean(o**2)) for o in off]),
        rms_px=float(np.sqrt(np.mean(every**2))),
        worst_px=float(np.max(every)),
        offset_px=0.0,
        shape=0.0,
        one_camera=True,
    )


def _shape_error(points: Array, p_C: Array) -> float:
    """Relative error of the distances of all corners from the first to the farther ones.

    Pairs less than half a board apart are dominated by pixel noise.
    """
    true = np.linalg.norm(points[:, None] - points[None], axis=2)
    found = np.linalg.norm(p_C[:, None] - p_C[None], axis=2)
    far = true > 0.5 * true.max()
    if not np.all(np.isfinite(found[far])):
        return float("inf")
    return float(np.abs(np.median(found[far] / true[far]) - 1))
