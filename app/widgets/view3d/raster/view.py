"""What all rays of one image share, and what a bundle of them meets."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.surfaces import Samples, Surfaces
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    IntMatrix,
    IntVector,
    Matrix,
    UInt32Matrix,
    Vector,
    Written,
)

RED, GREEN, BLUE, OPACITY, AMBIENT, SPECULAR, WIDTH, STYLE, GROUP = range(9)  # of a look
OVER, ALONE = 1.0, 2.0  # STYLE, as `app.widgets.view3d.scene.Grid`

SURFACE = -1
"""In place of a body's row: a triangle."""

DEEPEST = 16
"""Layers that are kept of one ray."""


class View(NamedTuple):
    """Bodies before a camera. Of N bodies: kinds (N,), forms (N, 5) m, places (N, 13) as
    `placing.place` has them, looks (N, 9). Of M lines: lines (M, 6) as `placing.project_line` has
    them, owner (M,) row of the body. Of V points of surfaces: seen (V, 6) as
    `surfaces.project_surfaces` has them, and what the rays meet of them. focal, middle_u, middle_v
    in px; backdrop (H, W) 0xFFRRGGBB is what is behind all."""

    kinds: IntVector
    forms: Matrix
    places: Matrix
    looks: Matrix
    lines: Matrix
    owner: IntVector
    focal: float
    middle_u: float
    middle_v: float
    backdrop: UInt32Matrix
    surfaces: Surfaces
    seen: Matrix
    samples: Samples


class RayBundle(NamedTuple):
    """Up to R rays (x, y, 1) of one tile, x and y (R,), and the layers that each meets.

    at (R, 3) is row and column of a ray's pixel, and which ray of it; skin (R, 3) the colour of the
    surface that it meets, part (R,) which of its parts.

    Layers (R, `DEEPEST`), nearest first, of which many (R,) are there: depth in m, cover as a
    share, row of the body. found and share (R,) are for depth and cover of one body; colour (R, 3)
    and number (R,) are what `blending.blend` makes of all.
    """

    x: Written[Vector]
    y: Written[Vector]
    at: Written[IntMatrix]
    skin: Written[Matrix]
    part: Written[IntVector]
    many: Written[IntVector]
    depth: Written[Matrix]
    cover: Written[Matrix]
    body: Written[IntMatrix]
    found: Written[Vector]
    share: Written[Vector]
    colour: Written[Matrix]
    number: Written[IntVector]


@kernel(error_model="numpy")
def new_bundle(rays: int) -> RayBundle:
    """Arrays for so many."""
    layers = (rays, DEEPEST)
    return RayBundle(
        np.empty(rays), np.empty(rays), np.empty((rays, 3), np.int64), np.empty((rays, 3)),
        np.empty(rays, np.int64), np.empty(rays, np.int64),
        np.empty(layers), np.empty(layers), np.empty(layers, np.int64),
        np.empty(rays), np.empty(rays), np.empty((rays, 3)), np.empty(rays, np.int64),
    )  # fmt: skip
