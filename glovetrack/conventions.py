"""The hand in the orders and axes of other programs: OpenXR, MediaPipe, MANO, dex-retargeting."""

from tracker.hand.conventions import to_mano, to_mediapipe, to_operator
from tracker.hand.openxr import joint_radii, to_openxr

__all__ = ["joint_radii", "to_mano", "to_mediapipe", "to_openxr", "to_operator"]
