"""The outline of surfaces: where one side of a pixel shows them and the other does not."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.placing import Pinhole
from app.widgets.view3d.raster.surfaces import Samples, Surfaces, fill_samples, project_surfaces
from app.widgets.view3d.raster.tiles import TILE
from tracker.kernels import kernel
from tracker.kernels.arrays import UInt32Matrix, Vector, Written

STEP = 0.008  # m of depth between neighbours that make a line inside the outline
"""A finger before the palm is farther from it than this."""


@kernel(error_model="numpy")
def draw_outline(
    surfaces: Surfaces,
    camera: Pinhole,
    samples: Samples,
    ink: Vector,
    image: Written[UInt32Matrix],
) -> None:
    """Draw the outline of surfaces over the image, in ``ink`` (3,); ``samples`` is room for it."""
    height, width = image.shape
    rows, columns = (height + TILE - 1) // TILE, (width + TILE - 1) // TILE
    touched = np.zeros(rows * columns, np.bool_)
    fill_samples(surfaces, project_surfaces(surfaces, camera), samples, touched)
    for tile in range(len(touched)):
        if not touched[tile]:
            continue
        top, left = tile // columns * TILE, tile % columns * TILE
        if not _may_have_edge(samples, top, left):
            continue
        for v in range(max(top, 1), min(top + TILE, height - 1)):
            for u in range(max(left, 1), min(left + TILE, width - 1)):
                share = _edge(samples, v, u)
                if share > 0.0:
                    image[v, u] = _over(image[v, u], ink, share)


@kernel(error_model="numpy")
def _may_have_edge(samples: Samples, top: int, left: int) -> bool:
    """Whether a tile and the pixels around it are neither all empty nor, within `STEP`, one sheet:
    most of a hand's tiles are."""
    inverse = samples.inverse
    height, width = inverse.shape[0], inverse.shape[1]
    some_full, some_empty, low, high = False, False, np.inf, 0.0
    for v in range(max(top - 1, 0), min(top + TILE + 1, height)):
        for u in range(max(left - 1, 0), min(left + TILE + 1, width)):
            for m in range(4):
                if inverse[v, u, m] > 0.0:
                    some_full = True
                else:
                    some_empty = True
            near = np.float64(inverse[v, u, 0])
            if near > 0.0:
                low, high = min(low, near), max(high, near)
    if some_full and some_empty:
        return True
    return some_full and 1.0 / low - 1.0 / high > STEP


@kernel(error_model="numpy")
def _edge(samples: Samples, v: int, u: int) -> float:
    """Share (0..1) of a pixel that the outline covers."""
    inverse = samples.inverse
    low, high, jump = 4, 0, False
    mine = inverse[v, u, 0]
    for row in range(v - 1, v + 2):
        for column in range(u - 1, u + 2):
            many = 0
            for m in range(4):
                many += inverse[row, column, m] > 0.0
            low, high = min(low, many), max(high, many)
            other = inverse[row, column, 0]
            if mine > 0.0 and other > 0.0 and 1.0 / other - 1.0 / mine > STEP:
                jump = True
    if jump:
        return 0.9
    return 0.25 * (high - low)


@kernel(error_model="numpy", inline="always")
def _over(below: int, ink: Vector, share: float) -> np.uint32:
    """A share of ink over a colour 0xFFRRGGBB."""
    out = np.uint32(0xFF)
    for k in range(3):
        part = np.float64(np.int64(below) >> (16 - 8 * k) & 255)
        out = out << np.uint32(8) | np.uint32(part + share * (255.0 * ink[k] - part) + 0.5)
    return np.uint32(out)
