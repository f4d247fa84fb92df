"""The outline of surfaces, drawn at pixels that are at their edge."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.placing import Pinhole
from app.widgets.view3d.raster.surfaces import (
    RaySamples,
    Surfaces,
    fill_middle,
    fill_more,
    project_surfaces,
)
from app.widgets.view3d.raster.tiles import TILE
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolMatrix, BoolVector, UInt32Matrix, Vector, Written

STEP = 0.008  # m, difference in depth of neighbouring pixels that draws a line within the outline
"""Less than the distance of a finger from the palm behind it."""


@kernel(error_model="numpy")
def draw_outline(
    surfaces: Surfaces,
    camera: Pinhole,
    samples: RaySamples,
    ink: Vector,
    image: Written[UInt32Matrix],
) -> None:
    """Draw the outline of surfaces over the image in ``ink`` (3,); ``samples`` is a buffer."""
    height, width = image.shape
    columns = (width + TILE - 1) // TILE
    touched = np.zeros((height + TILE - 1) // TILE * columns, np.bool_)
    seen = project_surfaces(surfaces, camera)
    boxes = fill_middle(surfaces, seen, samples, touched)
    near, edged = np.zeros((height, width), np.bool_), np.zeros(len(touched), np.bool_)
    for tile in range(len(touched)):
        if touched[tile]:
            _mark(samples, (tile // columns * TILE, tile % columns * TILE), columns, near, edged)
    fill_more(surfaces, seen, boxes, near, edged, samples)
    for tile in range(len(edged)):
        if edged[tile] and touched[tile]:
            _draw_tile(samples, near, tile // columns * TILE, tile % columns * TILE, ink, image)


@kernel(error_model="numpy")
def _mark(
    samples: RaySamples,
    corner: tuple[int, int],
    columns: int,
    near: Written[BoolMatrix],
    edged: Written[BoolVector],
) -> None:
    """Mark the pixels of a tile next to an edge of the surface or a step in it, and the tiles
    around each of them."""
    inverse, (top, left) = samples.inverse, corner
    height, width = near.shape
    for v in range(max(top, 1), min(top + TILE, height - 1)):
        for u in range(max(left, 1), min(left + TILE, width - 1)):
            full, low, high = 0, np.float32(np.inf), np.float32(0.0)
            for row in range(v - 1, v + 2):
                for column in range(u - 1, u + 2):
                    z = inverse[0, row, column]
                    full += z > 0.0
                    if z > 0.0:
                        low, high = min(low, z), max(high, z)
            if (0 < full < 9) or (full == 9 and 1.0 / low - 1.0 / high > STEP):
                near[v, u] = True
                for row in range((v - 1) // TILE, (v + 1) // TILE + 1):
                    for column in range((u - 1) // TILE, (u + 1) // TILE + 1):
                        edged[row * columns + column] = True


@kernel(error_model="numpy")
def _draw_tile(
    samples: RaySamples,
    near: BoolMatrix,
    top: int,
    left: int,
    ink: Vector,
    image: Written[UInt32Matrix],
) -> None:
    """Draw the outline in one tile."""
    height, width = image.shape
    for v in range(max(top, 1), min(top + TILE, height - 1)):
        for u in range(max(left, 1), min(left + TILE, width - 1)):
            if near[v - 1 : v + 2, u - 1 : u + 2].any():
                share = _edge(samples, near, v, u)
                if share > 0.0:
                    image[v, u] = _over(image[v, u], ink, share)


@kernel(error_model="numpy")
def _edge(samples: RaySamples, near: BoolMatrix, v: int, u: int) -> float:
    """Share (0..1) of a pixel that the outline covers."""
    inverse = samples.inverse
    low, high, jump = 4, 0, False
    mine = inverse[0, v, u]
    for row in range(v - 1, v + 2):
        for column in range(u - 1, u + 2):
            other = inverse[0, row, column]
            many = 4 if other > 0.0 else 0
            if near[row, column]:
                many = 0
                for m in range(4):
                    many += inverse[m, row, column] > 0.0
            low, high = min(low, many), max(high, many)
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
