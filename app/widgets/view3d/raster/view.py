"""Data shared by all rays of an image, and the intersections of a bundle of rays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.surfaces import RaySamples, Surfaces
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
"""Replaces a body's row for a triangle."""

DEEPEST = 16
"""Maximum number of layers per ray."""


class View(NamedTuple):
    """Bodies in the camera frame. Of N bodies: kinds (N,), forms (N, 5) m, places (N, 13) see
    `placing.place`, looks (N, 9). Of M lines: lines (M, 6) see `placing.project_line`, owner (M,)
    row of the body. Of V points of surfaces: seen (V, 6) see `surfaces.project_surfaces`, and their
    intersections with the rays. focal, middle_u, middle_v in px; backdrop (H, W) 0xFFRRGGBB is the
    background."""

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
    samples: RaySamples


class RayBundle(NamedTuple):
    """Up to R rays (x, y, 1) of one tile, x and y (R,), and their layers.

    at (R, 3) is row and column of a ray's pixel, and the index of the ray in it; skin (R, 3) the
    colour of the surface that it intersects, part (R,) the part of that surface.

    Layers (R, `DEEPEST`), nearest first, many (R,) of them: depth in m, cover 0..1, row of the
    body. found and share (R,) are for depth and cover of one body; colour (R, 3) and number (R,)
    are the results of `blending.blend`.
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
    """Arrays for this number of rays."""
    layers = (rays, DEEPEST)
    return RayBundle(
        np.empty(rays), np.empty(rays), np.empty((rays, 3), np.int64), np.empty((rays, 3)),
        np.empty(rays, np.int64), np.empty(rays, np.int64),
        np.empty(layers), np.empty(layers), np.empty(layers, np.int64),
        np.empty(rays), np.empty(rays), np.empty((rays, 3)), np.empty(rays, np.int64),
    )  # fmt: skip
