"""OpenXR's joints instead of our keypoints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.hand.openxr import JOINTS, joint_radii, keypoint_rows, openxr_joints
from tracker.messages import IntArray
from tracker.session.edits import Mask
from tracker.session.export.axes import turned
from tracker.session.export.series import EstimateSeries

WORLD = "y-up"
"""Name of OpenXR's world among the axes."""


def openxr_series(m: EstimateSeries) -> EstimateSeries:
    """Converts a series in G to OpenXR's 26 joints as keypoints, all in OpenXR's world and joint
    axes.

    Joints that are interpolated between others have no standard deviation.
    """
    radii = joint_radii(m.info.hand)
    hand = openxr_joints(m.keypoints, m.q, m.state, m.keypoint_names, radii)
    rows = np.array(keypoint_rows(m.keypoint_names))
    return replace(
        turned(m, WORLD),
        keypoint_names=JOINTS,
        keypoints=hand.position,
        q=hand.orientation,
        state=hand.state,
        sd=np.where(rows >= 0, m.sd[:, rows], np.nan),
        point_filled=_filled(m, rows),
        radius=radii,
    )


def _filled(m: EstimateSeries, rows: IntArray) -> Mask | None:
    """(N, 26) joints in gaps that were filled; a joint between others counts if one of them was."""
    if m.point_filled is None:
        return None
    any_filled = m.point_filled.any(axis=1, keepdims=True)
    return np.asarray(np.where(rows >= 0, m.point_filled[:, rows], any_filled))
