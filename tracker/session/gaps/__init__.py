"""Gaps of a session: where a keypoint is not measured, why, and how they are filled."""
