"""Coverage and depth of lines in the image."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix


@kernel(error_model="numpy")
def nearest_share(lines: Matrix, m: int, u: float, v: float) -> float:
    """Position (0..1) on row m of `placing.project_line`'s lines nearest to a point of the image,
    px."""
    du, dv = lines[m, 3] - lines[m, 0], lines[m, 4] - lines[m, 1]
    square = du * du + dv * dv
    if square == 0.0:
        return 0.0
    return min(max(((u - lines[m, 0]) * du + (v - lines[m, 1]) * dv) / square, 0.0), 1.0)


@kernel(error_model="numpy")
def distance_px(lines: Matrix, m: int, u: float, v: float) -> float:
    """Distance of a point of the image from a line, px."""
    share = nearest_share(lines, m, u, v)
    du = lines[m, 0] + share * (lines[m, 3] - lines[m, 0]) - u
    dv = lines[m, 1] + share * (lines[m, 4] - lines[m, 1]) - v
    return float(np.sqrt(du * du + dv * dv))


@kernel(error_model="numpy")
def stroke_cover(lines: Matrix, m: int, u: float, v: float, width_px: float) -> float:
    """Share (0..1) of the pixel around (u, v) px that a line of this width covers."""
    return min(max(0.5 * width_px + 0.5 - distance_px(lines, m, u, v), 0.0), min(1.0, width_px))


@kernel(error_model="numpy")
def stroke_depth(lines: Matrix, m: int, u: float, v: float) -> float:
    """Depth (m) of a line where it is nearest to (u, v) px: 1/z is linear in the image."""
    share = nearest_share(lines, m, u, v)
    return 1.0 / (lines[m, 2] + share * (lines[m, 5] - lines[m, 2]))
