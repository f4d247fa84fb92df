"""Rasterization of triangles: the nearest triangle on each of a pixel's rays.

The rays are those of `image`: one through a pixel's centre and, at edges, `MORE`. Most pixels of a
hand need only the first, so the others are computed later and only where necessary. 1/z and the
barycentric coordinates of a triangle are linear in the image: each row of a triangle's pixels is a
span between three lines.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.placing import NEAR, Pinhole
from app.widgets.view3d.raster.tiles import TILE
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    BoolMatrix,
    BoolVector,
    Float32Stack,
    Int32Stack,
    IntMatrix,
    IntVector,
    Matrix,
    Vector,
    Written,
)

MORE = ((0.376, 0.137), (-0.306, 0.257), (-0.069, -0.394))
"""px from a pixel's centre to further rays: including the first, no two are in the same row or
column."""
FARTHEST = 0.4  # px from the centre to the farthest ray
NOTHING = -1
SEEN = 10
"""Values of a projected point: u, v px, 1/z, and the result of `skin.light` for its dress."""
TOUCH = 1e-9  # barycentric tolerance: neighbours leave no gap where a ray meets their edge
LEVEL = 1e-12  # 1/px


class Surfaces(NamedTuple):
    """V points: points, normals (V, 3) in G; dress (V, 7): red, green, blue, opacity, ambient,
    hatch, dots, 0..1; along (V,) m, the coordinate of the hatching. F triangles: faces (F, 3),
    counter-clockwise from outside; part (F,), -1 for a hidden one."""

    points: Matrix
    normals: Matrix
    dress: Matrix
    along: Vector
    faces: IntMatrix
    part: IntVector


class RaySamples(NamedTuple):
    """For each ray (4, H, W): 1/z of the nearest triangle, 1/m, 0 for none, and its row."""

    inverse: Written[Float32Stack]
    face: Written[Int32Stack]


class Plane(NamedTuple):
    """A projected triangle: at pixel (u, v) the barycentric coordinates of its first two corners
    are a0 u + b0 v + c0 and a1 u + b1 v + c1, and 1/z is a u + b v + c."""

    a0: float
    b0: float
    c0: float
    a1: float
    b1: float
    c1: float
    a: float
    b: float
    c: float


@kernel(error_model="numpy")
def project_surfaces(surfaces: Surfaces, camera: Pinhole) -> Matrix:
    """(V, `SEEN`): u, v px and 1/z, which is 0 for points behind the camera; the rest is for
    `skin`."""
    R, p, focal = camera.R_GC, camera.p_GC, camera.focal
    points = surfaces.points
    out = np.zeros((len(points), SEEN))
    for i in range(len(points)):
        x, y, z = points[i, 0] - p[0], points[i, 1] - p[1], points[i, 2] - p[2]
        depth = R[0, 2] * x + R[1, 2] * y + R[2, 2] * z
        if not depth > NEAR:
            continue
        out[i, 0] = camera.middle_u + focal * (R[0, 0] * x + R[1, 0] * y + R[2, 0] * z) / depth
        out[i, 1] = camera.middle_v + focal * (R[0, 1] * x + R[1, 1] * y + R[2, 1] * z) / depth
        out[i, 2] = 1.0 / depth
    return out


@kernel(error_model="numpy")
def fill_middle(
    surfaces: Surfaces, seen: Matrix, samples: RaySamples, touched: Written[BoolVector]
) -> IntMatrix:
    """The nearest triangle at the pixel centres of the tiles touched (T,); samples of other tiles
    are not changed.

    Returns (F, 4) the bounding box of each triangle in pixels: left, right, top, bottom.
    """
    boxes = _boxes(surfaces, seen, samples, touched)
    _clear(samples, touched)
    inverse, face = samples.inverse, samples.face
    for f in range(len(boxes)):
        left, right, top, bottom = boxes[f, 0], boxes[f, 1], boxes[f, 2], boxes[f, 3]
        if left >= right:
            continue
        g = _plane(surfaces, f, seen)
        for v in range(top, bottom):
            low, high = _span(g, (left, right), v, (0.5, 0.5), -TOUCH, -TOUCH, -TOUCH)
            near = 0.5 * g.a + g.b * (v + 0.5) + g.c
            for u in range(low, high):
                z = np.float32(near + g.a * u)
                if z > inverse[0, v, u]:
                    inverse[0, v, u], face[0, v, u] = z, f
    return boxes


@kernel(error_model="numpy")
def fill_more(
    surfaces: Surfaces,
    seen: Matrix,
    boxes: IntMatrix,
    wanted: BoolMatrix,
    tiles: BoolVector,
    samples: RaySamples,
) -> None:
    """The nearest triangle of `MORE` rays in the pixels ``wanted`` (H, W) of ``tiles`` (T,)."""
    columns = (wanted.shape[1] + TILE - 1) // TILE
    _clear_more(wanted, tiles, samples)
    for f in range(len(boxes)):
        left, right, top, bottom = boxes[f, 0], boxes[f, 1], boxes[f, 2], boxes[f, 3]
        if left >= right or not _any_tile(boxes, f, tiles, columns):
            continue
        g = _plane(surfaces, f, seen)
        reach0 = -FARTHEST * (abs(g.a0) + abs(g.b0))
        reach1 = -FARTHEST * (abs(g.a1) + abs(g.b1))
        reach2 = -FARTHEST * (abs(g.a0 + g.a1) + abs(g.b0 + g.b1))
        for v in range(top, bottom):
            low, high = _span(g, (left, right), v, (0.5, 0.5), reach0, reach1, reach2)
            for u in range(low, high):
                if wanted[v, u]:
                    _keep_more(g, f, u, v, samples)


@kernel(error_model="numpy", inline="always")
def _keep_more(g: Plane, f: int, u: int, v: int, samples: RaySamples) -> None:
    """Update a pixel's `MORE` rays that intersect triangle f."""
    for m in range(len(MORE)):
        x, y = u + 0.5 + MORE[m][0], v + 0.5 + MORE[m][1]
        s, t = g.a0 * x + g.b0 * y + g.c0, g.a1 * x + g.b1 * y + g.c1
        if s >= -TOUCH and t >= -TOUCH and s + t <= 1.0 + TOUCH:
            near = np.float32(g.a * x + g.b * y + g.c)
            if near > samples.inverse[m + 1, v, u]:
                samples.inverse[m + 1, v, u], samples.face[m + 1, v, u] = near, f


@kernel(error_model="numpy", inline="always")
def _plane(surfaces: Surfaces, f: int, seen: Matrix) -> Plane:
    """The coefficients of triangle f, which faces the camera."""
    i, j, k = surfaces.faces[f, 0], surfaces.faces[f, 1], surfaces.faces[f, 2]
    u0, v0, u1, v1 = seen[i, 0], seen[i, 1], seen[j, 0], seen[j, 1]
    u2, v2 = seen[k, 0], seen[k, 1]
    double = (u0 - u2) * (v1 - v2) - (u1 - u2) * (v0 - v2)
    a0, b0 = (v1 - v2) / double, (u2 - u1) / double
    a1, b1 = (v2 - v0) / double, (u0 - u2) / double
    c0, c1 = -a0 * u2 - b0 * v2, -a1 * u2 - b1 * v2
    z0, z1, z2 = seen[i, 2] - seen[k, 2], seen[j, 2] - seen[k, 2], seen[k, 2]
    a, b, c = a0 * z0 + a1 * z1, b0 * z0 + b1 * z1, c0 * z0 + c1 * z1 + z2
    return Plane(a0, b0, c0, a1, b1, c1, a, b, c)


@kernel(error_model="numpy", inline="always")
def _span(
    g: Plane,
    across: tuple[int, int],
    v: int,
    at: tuple[float, float],
    least0: float,
    least1: float,
    least2: float,
) -> tuple[int, int]:
    """First pixel of row v, and one past the last, within ``across`` in which ``at`` of the pixel
    has at least these barycentric coordinates."""
    y = v + at[1]
    s, t = g.a0 * at[0] + g.b0 * y + g.c0, g.a1 * at[0] + g.b1 * y + g.c1
    low, high = float(across[0]), float(across[1] - 1)
    low, high = _cut(low, high, s - least0, g.a0)
    low, high = _cut(low, high, t - least1, g.a1)
    low, high = _cut(low, high, 1.0 - s - t - least2, -g.a0 - g.a1)
    if not low <= high:
        return 0, 0
    return int(np.ceil(low)), int(np.floor(high)) + 1


@kernel(error_model="numpy", inline="always")
def _cut(low: float, high: float, value: float, slope: float) -> tuple[float, float]:
    """The part of low to high in which value + slope u >= 0."""
    if slope > LEVEL:
        return max(low, -value / slope), high
    if slope < -LEVEL:
        return low, min(high, -value / slope)
    return (low, high) if value >= 0.0 else (1.0, 0.0)


@kernel(error_model="numpy")
def _boxes(
    surfaces: Surfaces, seen: Matrix, samples: RaySamples, touched: Written[BoolVector]
) -> IntMatrix:
    """(F, 4) bounding boxes of the triangles in pixels, empty if hidden, behind the camera, facing
    away or outside the image; and the tiles that any may show in."""
    height, width = samples.inverse.shape[1], samples.inverse.shape[2]
    columns = (width + TILE - 1) // TILE
    boxes = np.zeros((len(surfaces.faces), 4), np.int64)
    for f in range(len(boxes)):
        if surfaces.part[f] < 0:
            continue
        i, j, k = surfaces.faces[f, 0], surfaces.faces[f, 1], surfaces.faces[f, 2]
        if seen[i, 2] <= 0.0 or seen[j, 2] <= 0.0 or seen[k, 2] <= 0.0:
            continue
        # v points down: counter-clockwise from outside has a negative area
        double = (seen[k, 0] - seen[i, 0]) * (seen[j, 1] - seen[i, 1])
        double -= (seen[j, 0] - seen[i, 0]) * (seen[k, 1] - seen[i, 1])
        if not double > 1e-9:
            continue
        left = min(seen[i, 0], seen[j, 0], seen[k, 0]) - FARTHEST
        right = max(seen[i, 0], seen[j, 0], seen[k, 0]) + FARTHEST
        top = min(seen[i, 1], seen[j, 1], seen[k, 1]) - FARTHEST
        bottom = max(seen[i, 1], seen[j, 1], seen[k, 1]) + FARTHEST
        if not (right >= 0.0 and left < width and bottom >= 0.0 and top < height):
            continue
        boxes[f, 0], boxes[f, 1] = int(max(left, 0.0)), int(min(right + 1.0, width))
        boxes[f, 2], boxes[f, 3] = int(max(top, 0.0)), int(min(bottom + 1.0, height))
        for row in range(boxes[f, 2] // TILE, (boxes[f, 3] - 1) // TILE + 1):
            for column in range(boxes[f, 0] // TILE, (boxes[f, 1] - 1) // TILE + 1):
                touched[row * columns + column] = True
    return boxes


@kernel(error_model="numpy", inline="always")
def _any_tile(boxes: IntMatrix, f: int, tiles: BoolVector, columns: int) -> bool:
    """Whether triangle f may be visible in one of these tiles."""
    for row in range(boxes[f, 2] // TILE, (boxes[f, 3] - 1) // TILE + 1):
        for column in range(boxes[f, 0] // TILE, (boxes[f, 1] - 1) // TILE + 1):
            if tiles[row * columns + column]:
                return True
    return False


@kernel(error_model="numpy")
def _clear(samples: RaySamples, touched: BoolVector) -> None:
    """Clear the samples of these tiles and of the pixels around them: clearing all samples of a
    large image takes longer than drawing a hand."""
    height, width = samples.inverse.shape[1], samples.inverse.shape[2]
    columns = (width + TILE - 1) // TILE
    for tile in range(len(touched)):
        if touched[tile]:
            top, left = tile // columns * TILE, tile % columns * TILE
            first, last = max(left - 1, 0), min(left + TILE + 1, width)
            for v in range(max(top - 1, 0), min(top + TILE + 1, height)):
                samples.inverse[0, v, first:last] = 0.0


@kernel(error_model="numpy")
def _clear_more(wanted: BoolMatrix, tiles: BoolVector, samples: RaySamples) -> None:
    """Clear the samples of `MORE` rays in the pixels ``wanted``."""
    height, width = wanted.shape
    columns = (width + TILE - 1) // TILE
    for tile in range(len(tiles)):
        if tiles[tile]:
            top, left = tile // columns * TILE, tile % columns * TILE
            for v in range(top, min(top + TILE, height)):
                for u in range(left, min(left + TILE, width)):
                    if wanted[v, u]:
                        for m in range(len(MORE)):
                            samples.inverse[m + 1, v, u] = 0.0
