"""Lens distortion, by OpenCV's models: plumb bob (5 coefficients), rational (8), with thin prism
(12) and tilted sensor (14), and the fisheye (4, equidistant: Kannala & Brandt 2006)."""

from __future__ import annotations

import cv2
import numpy as np

from tracker.messages import Array

COUNTS = (5, 8, 12, 14)
"""Numbers of coefficients of lenses that are not fisheyes."""
FISHEYE = 4
EXACT = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 60, 1e-7)
"""Iterations and px; OpenCV's own five leave errors of a pixel in the corners of wide lenses."""
_OF_VERSION_4 = getattr(cv2, "undistortPointsIter", None)
"""OpenCV 4 has a function of its own for it."""
WIDEST = np.deg2rad(85.0)  # from the axis, of what a rectified image can show


def padded(D: Array) -> Array | None:
    """The coefficients with zeros up to the next of `COUNTS`, without trailing zeros; None if there
    are too many."""
    D = np.trim_zeros(np.asarray(D, float).reshape(-1), "b")
    count = next((n for n in COUNTS if n >= len(D)), None)
    return None if count is None else np.pad(D, (0, count - len(D)))


def undistorted(uv: Array, K: Array, D: Array, fisheye: bool, R: Array, P: Array) -> Array:
    """Raw pixels (n, 2) as a camera with the rotation R (3, 3) and the matrix P (3, 3) sees them
    without distortion (n, 2)."""
    points = np.ascontiguousarray(uv, float).reshape(-1, 1, 2)
    if fisheye:
        return cv2.fisheye.undistortPoints(points, K, D, R=R, P=P).reshape(-1, 2)
    if _OF_VERSION_4 is not None:
        return np.asarray(_OF_VERSION_4(points, K, D, R, P, EXACT), float).reshape(-1, 2)
    return cv2.undistortPoints(points, K, D, R=R, P=P, criteria=EXACT).reshape(-1, 2)


def distorted(rays: Array, K: Array, D: Array, fisheye: bool) -> Array:
    """Raw pixels (n, 2) of directions (n, 3) in the camera."""
    points, zero = np.ascontiguousarray(rays, float).reshape(-1, 1, 3), np.zeros(3)
    if fisheye:
        raw, _ = cv2.fisheye.projectPoints(points, zero, zero, K, D)
    else:
        raw, _ = cv2.projectPoints(points, zero, zero, K, D)
    return raw.reshape(-1, 2)


def fisheye_reach(D: Array, radius: float) -> float:
    """rad from the axis at which a fisheye images a point ``radius`` focal lengths from the centre;
    NaN where its model turns back before that, or beyond `WIDEST`."""
    theta = np.linspace(0.0, WIDEST, 500)
    powers = theta[:, None] ** np.arange(2, 10, 2)
    imaged = theta * (1.0 + powers @ np.asarray(D, float))
    end = np.searchsorted(imaged, radius) if np.all(np.diff(imaged) > 0) else len(theta)
    return float(theta[end]) if end < len(theta) else float("nan")
