"""Gaps of a session: when a keypoint is not measured, why, and how such gaps are filled."""
