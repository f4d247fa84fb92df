"""Grid lines on a solid, one pixel wide at any distance and orientation."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.solids import BLOCK, CAPSULE
from tracker.geometry.solids import Vector3
from tracker.kernels import kernel

WIDTH_PX = 1.0
CROWDED_PX = 4.0
"""Lines closer than this fade, so that they do not merge."""
MERIDIANS = 10
RING = 1.6  # radii between the rings of a capsule
CAP_RING = 0.7  # radii from a capsule's end to the ring on its cap
CELLS = 8.0  # along the longer side of a block


@kernel(error_model="numpy")
def grid_cover(
    kind: int, size_x: float, size_y: float, p: Vector3, n: Vector3, d: Vector3, scale: float
) -> float:
    """Share (0..1) of a pixel that lines of the grid cover.

    ``size_x``, ``size_y``: length and radius of a capsule, half sides of a block, m. All in S: the
    point p on the surface, the normal n, the ray d; ``scale`` in px/m across the ray, there.
    """
    if kind == CAPSULE:
        return _on_capsule(size_x, size_y, p, n, d, scale)
    if kind == BLOCK:
        cell = max(size_x, size_y) * 2 / CELLS
        across = _cover(_off(p[0], cell), cell, (1.0, 0.0, 0.0), n, d, scale)
        return max(across, _cover(_off(p[1], cell), cell, (0.0, 1.0, 0.0), n, d, scale))
    return 0.0


@kernel(error_model="numpy")
def _on_capsule(
    length: float, radius: float, p: Vector3, n: Vector3, d: Vector3, scale: float
) -> float:
    away = np.sqrt(p[1] * p[1] + p[2] * p[2]) + 1e-9
    step = 2 * np.pi / MERIDIANS
    off = away * _off(np.arctan2(p[2], p[1]), step)
    cover = _cover(off, away * step, (0.0, -p[2] / away, p[1] / away), n, d, scale)
    if 0.0 < p[0] < length:
        spacing = length / max(1.0, np.round(length / (RING * radius)))
        off = _off(p[0], spacing)
    else:
        spacing = CAP_RING * radius
        beyond = -p[0] if p[0] <= 0.0 else p[0] - length
        off = min(beyond, abs(beyond - spacing))
    return max(cover, _cover(off, spacing, (1.0, 0.0, 0.0), n, d, scale))


@kernel(error_model="numpy")
def _off(x: float, step: float) -> float:
    """Distance of x from the nearest multiple of ``step``."""
    return abs(x - step * np.round(x / step))


@kernel(error_model="numpy")
def _cover(off: float, spacing: float, e: Vector3, n: Vector3, d: Vector3, scale: float) -> float:
    """Coverage by lines ``spacing`` m apart, the nearest at a distance of ``off`` m, both measured
    along e.

    A step δ across the ray moves the point on the surface by δ - v (n·δ)/(n·v) with the ray's
    direction v; the coordinate along e changes by (e - n (e·v)/(n·v))·δ.
    """
    length = np.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    facing = n[0] * d[0] + n[1] * d[1] + n[2] * d[2]
    facing = np.copysign(max(abs(facing), 1e-3 * length), facing)
    steep = (e[0] * d[0] + e[1] * d[1] + e[2] * d[2]) / facing
    along = e[0] * n[0] + e[1] * n[1] + e[2] * n[2]
    px = scale / np.sqrt(max(1.0 - 2 * along * steep + steep * steep, 1e-9))
    crossed = min(1.0, 4.0 * (1.0 - along * along))  # a side parallel to the lines shows none
    cover = min(max(0.5 * WIDTH_PX + 0.5 - off * px, 0.0), 1.0)
    return cover * crossed * min(1.0, spacing * px / CROWDED_PX)
