"""Lens distortion, by OpenCV's models: plumb bob (5 coefficients), rational (8), with thin prism
(12) and tilted sensor (14), and the fisheye (4, equidistant: Kannala & Brandt 2006)."""

from __future__ import annotations

import math
from typing import NamedTuple

import cv2
import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector
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


class Lens(NamedTuple):
    """A camera's matrix and distortion for kernels: focal lengths and principal point, px, the
    coefficients D (14,), zeros where the model has fewer, and the sensor's tilt (3, 3)."""

    fx: float
    fy: float
    cx: float
    cy: float
    D: Vector
    tilt: Matrix
    fisheye: bool

    @staticmethod
    def of(K: Array, D: Array, fisheye: bool) -> Lens:
        """K (3, 3), D (n,); a skew of K is ignored, as by OpenCV."""
        all_D = np.zeros(COUNTS[-1])
        all_D[: len(np.ravel(D))] = np.ravel(D)
        tilt = np.eye(3) if fisheye else _tilt(*all_D[12:])
        fx, fy, cx, cy = (float(x) for x in (K[0, 0], K[1, 1], K[0, 2], K[1, 2]))
        return Lens(fx, fy, cx, cy, all_D, tilt, bool(fisheye))


def distorted(rays: Array, K: Array, D: Array, fisheye: bool) -> Array:
    """Raw pixels (n, 2) of directions (n, 3) in the camera."""
    return imaged(np.ascontiguousarray(rays, float), Lens.of(K, D, fisheye))


@kernel(nogil=False)
def imaged(rays: Matrix, lens: Lens) -> Matrix:
    """Raw pixels (n, 2) of directions (n, 3) in the camera."""
    out = np.empty((len(rays), 2))
    for k in range(len(rays)):
        out[k] = pixel_of(rays[k, 0], rays[k, 1], rays[k, 2], lens)
    return out


@kernel(nogil=False)
def pixel_of(x: float, y: float, z: float, lens: Lens) -> tuple[float, float]:
    """The raw pixel of one direction in the camera."""
    x, y = x / z, y / z
    D, r_2 = lens.D, x * x + y * y
    if lens.fisheye:
        r = math.sqrt(r_2)
        theta = math.atan(r)
        t_2 = theta * theta
        powers = 1.0 + t_2 * (D[0] + t_2 * (D[1] + t_2 * (D[2] + t_2 * D[3])))
        scale = theta * powers / r if r > 1e-8 else 1.0
        return lens.fx * x * scale + lens.cx, lens.fy * y * scale + lens.cy
    radial = (1.0 + r_2 * (D[0] + r_2 * (D[1] + r_2 * D[4]))) / (
        1.0 + r_2 * (D[5] + r_2 * (D[6] + r_2 * D[7]))
    )
    xy = 2.0 * x * y
    x_d = x * radial + D[2] * xy + D[3] * (r_2 + 2.0 * x * x) + r_2 * (D[8] + r_2 * D[9])
    y_d = y * radial + D[2] * (r_2 + 2.0 * y * y) + D[3] * xy + r_2 * (D[10] + r_2 * D[11])
    T = lens.tilt
    depth = T[2, 0] * x_d + T[2, 1] * y_d + T[2, 2]
    x_t = (T[0, 0] * x_d + T[0, 1] * y_d + T[0, 2]) / depth
    y_t = (T[1, 0] * x_d + T[1, 1] * y_d + T[1, 2]) / depth
    return lens.fx * x_t + lens.cx, lens.fy * y_t + lens.cy


def _tilt(about_x: float, about_y: float) -> Array:
    """(3, 3) that takes points of a sensor at right angles to the axis to one tilted by two angles,
    rad (Louhichi et al. 2007)."""
    s_x, c_x, s_y, c_y = np.sin(about_x), np.cos(about_x), np.sin(about_y), np.cos(about_y)
    turned = np.array([[c_y, 0, -s_y], [0, 1, 0], [s_y, 0, c_y]]) @ np.array(
        [[1, 0, 0], [0, c_x, s_x], [0, -s_x, c_x]]
    )
    onto = np.array([[turned[2, 2], 0, -turned[0, 2]], [0, turned[2, 2], -turned[1, 2]], [0, 0, 1]])
    tilt: Array = np.ascontiguousarray(onto @ turned)
    return tilt


def fisheye_reach(D: Array, radius: float) -> float:
    """rad from the axis at which a fisheye images a point ``radius`` focal lengths from the centre;
    NaN where its model turns back before that, or beyond `WIDEST`."""
    theta = np.linspace(0.0, WIDEST, 500)
    powers = theta[:, None] ** np.arange(2, 10, 2)
    imaged = theta * (1.0 + powers @ np.asarray(D, float))
    end = np.searchsorted(imaged, radius) if np.all(np.diff(imaged) > 0) else len(theta)
    return float(theta[end]) if end < len(theta) else float("nan")
