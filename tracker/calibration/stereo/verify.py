"""Is a calibration right? Asked on views that it has never seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracker.calibration.stereo.views import StereoView
from tracker.messages import Array
from tracker.vision.rig import StereoRig


@dataclass(frozen=True)
class VerifyParams:
    """Up to ``good_px`` a rig is good, up to ``usable_px`` it may be used with a warning."""

    least_views: int = 4
    good_px: float = 0.5
    usable_px: float = 1.0
    shape: float = 0.01  # relative error of distances on the board


@dataclass(frozen=True, eq=False)
class Verification:
    """``epipolar`` (views,) px RMS: how far a corner's rows in the two rectified images differ.

    ``shape`` is the median relative error of the distances between corners in 3D, ``offset_px`` the
    median signed difference of rows.
    """

    epipolar: Array
    rms_px: float
    worst_px: float
    offset_px: float
    shape: float

    def verdict(self, params: VerifyParams | None = None) -> tuple[str, str]:
        """("good" | "usable" | "refused" | "waiting", a sentence)."""
        p = params or VerifyParams()
        missing = p.least_views - len(self.epipolar)
        if missing > 0:
            return "waiting", f"{missing} more fresh views are needed."
        if self.rms_px > p.usable_px or self.shape > 2 * p.shape:
            return "refused", (
                f"Rows disagree by {self.rms_px:.2f} px and sizes by {100 * self.shape:.1f} %: "
                "calibrate again with more, and more different, views."
            )
        if self.rms_px > p.good_px or self.shape > p.shape:
            return "usable", (
                f"Rows disagree by {self.rms_px:.2f} px, sizes by {100 * self.shape:.1f} %. "
                "It can be used; a new calibration would place the hand better."
            )
        return "good", (
            f"Rows agree to {self.rms_px:.2f} px and sizes to {100 * self.shape:.2f} %."
        )


def verify(rig: StereoRig, views: Sequence[StereoView]) -> Verification:
    """What fresh views say of ``rig``; NaN figures without any."""
    if not views:
        nan = float("nan")
        return Verification(np.zeros(0), nan, nan, nan, nan)
    rows, shapes = [], []
    for view in views:
        left, right = rig.left.rectify(view.left), rig.right.rectify(view.right)
        rows.append(left[:, 1] - right[:, 1])
        shapes.append(_shape_error(view.points, rig.triangulate(left, right)))
    epipolar = np.array([np.sqrt(np.mean(r**2)) for r in rows])
    every = np.concatenate(rows)
    return Verification(
        epipolar=epipolar,
        rms_px=float(np.sqrt(np.mean(every**2))),
        worst_px=float(np.max(np.abs(every))),
        offset_px=float(np.median(every)),
        shape=float(np.median(shapes)),
    )


def _shape_error(points: Array, p_C: Array) -> float:
    """Relative error of the distances of all corners from the first to the farther ones.

    Pairs less than half a board apart say more of pixel noise than of the rig.
    """
    true = np.linalg.norm(points[:, None] - points[None], axis=2)
    found = np.linalg.norm(p_C[:, None] - p_C[None], axis=2)
    far = true > 0.5 * true.max()
    if not np.all(np.isfinite(found[far])):
        return float("inf")
    return float(np.abs(np.median(found[far] / true[far]) - 1))
