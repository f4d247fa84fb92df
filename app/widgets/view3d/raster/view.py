"""What all rays of one image share, and what a bundle of them meets."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Vector, Written

LINES = 3
"""Kind of a body that has no surface; the others are those of `solids`."""

RED, GREEN, BLUE, OPACITY, AMBIENT, SPECULAR, WIDTH, STYLE, GROUP = range(9)  # of a look
OVER, ALONE = 1.0, 2.0  # STYLE, as `app.widgets.view3d.scene.Grid`

DEEPEST = 16
"""Layers that are kept of one ray."""


class View(NamedTuple):
    """Bodies before a camera. Of N bodies: kinds (N,), forms (N, 5) m, places (N, 13) as
    `placing.place` has them, looks (N, 9). Of M lines: lines (M, 6) as `placing.project_line` has
    them, owner (M,) row of the body. focal, middle_u, middle_v in px; background (3,)."""

    kinds: IntVector
    forms: Matrix
    places: Matrix
    looks: Matrix
    lines: Matrix
    owner: IntVector
    focal: float
    middle_u: float
    middle_v: float
    background: Vector


class RayBundle(NamedTuple):
    """Up to R rays (x, y, 1) of one tile, x and y (R,), and the layers that each meets.

    Layers (R, `DEEPEST`), nearest first, of which many (R,) are there: depth in m, cover as a
    share, row of the body. found and share (R,) are for depth and cover of one body; colour (R, 3)
    and number (R,) are what `blending.blend` makes of all.
    """

    x: Written[Vector]
    y: Written[Vector]
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
        np.empty(rays), np.empty(rays), np.empty(rays, np.int64),
        np.empty(layers), np.empty(layers), np.empty(layers, np.int64),
        np.empty(rays), np.empty(rays), np.empty((rays, 3)), np.empty(rays, np.int64),
    )  # fmt: skip
