"""The 21 landmarks of an estimate, in MediaPipe's order, and the frames in which they are sent."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from glovetrack.conventions import MEDIAPIPE
from tracker.geometry import so3
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.publisher import Names

WRIST = MEDIAPIPE.index("wrist")
UNITY_OF_G = np.array([[0.0, -1, 0], [0, 0, 1], [1, 0, 0]])  # x right, y up, z forward
CAMERA_OF_G = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])  # x right, y down, z away


@dataclass(frozen=True, eq=False)
class Landmarks:
    """points (21, 3) m in G and R_GB (3, 3) of the dorsum; NaN where lost."""

    points: Array
    R_GB: Array

    @property
    def has_wrist(self) -> bool:
        return bool(np.isfinite(self.points[WRIST]).all() and np.isfinite(self.R_GB).all())

    @property
    def whole(self) -> bool:
        """Whether no landmark is lost."""
        return bool(np.isfinite(self.points).all())


@lru_cache
def _rows(keypoints: tuple[str, ...]) -> list[int]:
    return [keypoints.index(n) for n in MEDIAPIPE]


def landmarks_of(e: Estimate, names: Names) -> Landmarks:
    """For an estimate whose rows are ``names``."""
    rows = _rows(names.keypoints)
    lost = (e.keypoint_state[rows] == Validity.LOST)[:, None]
    wrist_q = e.keypoint_q[rows[WRIST]]
    R = np.full((3, 3), np.nan) if lost[WRIST] else so3.matrix_from_quat(wrist_q)
    return Landmarks(np.where(lost, np.nan, e.keypoints[rows]), R)
