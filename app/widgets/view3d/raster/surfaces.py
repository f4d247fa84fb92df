"""Triangles in the image: for each of a pixel's rays the nearest one that it meets.

The rays are those of `image`: one through a pixel's middle and `MORE`. Each triangle is tried on
all rays of the pixels around it; what is nearest stays. 1/z is linear in the image, so that a
triangle's depth is three numbers.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.placing import NEAR, Pinhole
from app.widgets.view3d.raster.tiles import TILE
from tracker.kernels import kernel
from tracker.kernels.arrays import (
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
"""px from a pixel's middle where more rays go: with the first, no two in one row or column."""
RAYS = ((0.0, 0.0), *MORE)
FARTHEST = 0.4  # px from the middle to the ray farthest from it
NOTHING = -1


class Surfaces(NamedTuple):
    """V points: points, normals (V, 3) in G; dress (V, 7): red, green, blue, cover, ambient, hatch,
    dots, shares of one; along (V,) m, what the hatching follows. F triangles: faces (F, 3),
    counter-clockwise seen from outside; part (F,), -1 for one that is not drawn."""

    points: Matrix
    normals: Matrix
    dress: Matrix
    along: Vector
    faces: IntMatrix
    part: IntVector


class Samples(NamedTuple):
    """Of each ray (H, W, 4): 1/z of the nearest triangle, 1/m, and its row, -1 for none."""

    inverse: Written[Float32Stack]
    face: Written[Int32Stack]


@kernel(error_model="numpy")
def project_surfaces(surfaces: Surfaces, camera: Pinhole) -> Matrix:
    """(V, 6): u, v px, 1/z, and the normal in C; 1/z 0 for what is not ahead."""
    R, p, focal = camera.R_GC, camera.p_GC, camera.focal
    points, normals = surfaces.points, surfaces.normals
    out = np.zeros((len(points), 6))
    for i in range(len(points)):
        x, y, z = points[i, 0] - p[0], points[i, 1] - p[1], points[i, 2] - p[2]
        depth = R[0, 2] * x + R[1, 2] * y + R[2, 2] * z
        if not depth > NEAR:
            continue
        out[i, 0] = camera.middle_u + focal * (R[0, 0] * x + R[1, 0] * y + R[2, 0] * z) / depth
        out[i, 1] = camera.middle_v + focal * (R[0, 1] * x + R[1, 1] * y + R[2, 1] * z) / depth
        out[i, 2] = 1.0 / depth
        a, b, c = normals[i, 0], normals[i, 1], normals[i, 2]
        for k in range(3):
            out[i, 3 + k] = R[0, k] * a + R[1, k] * b + R[2, k] * c
    return out


@kernel(error_model="numpy")
def fill_samples(
    surfaces: Surfaces, seen: Matrix, samples: Samples, touched: Written[BoolVector]
) -> None:
    """The nearest triangle of each ray in the tiles touched (T,), which are those that any may show
    in, and in the pixels beside them; other samples keep what an earlier image left there."""
    height, width = samples.face.shape[0], samples.face.shape[1]
    _clear(surfaces, seen, samples)
    columns = (width + TILE - 1) // TILE
    for f in range(len(surfaces.faces)):
        if surfaces.part[f] < 0:
            continue
        i, j, k = surfaces.faces[f, 0], surfaces.faces[f, 1], surfaces.faces[f, 2]
        if seen[i, 2] <= 0.0 or seen[j, 2] <= 0.0 or seen[k, 2] <= 0.0:
            continue
        # v points down: counter-clockwise from outside is clockwise in these numbers
        double = (seen[k, 0] - seen[i, 0]) * (seen[j, 1] - seen[i, 1])
        double -= (seen[j, 0] - seen[i, 0]) * (seen[k, 1] - seen[i, 1])
        if not double > 1e-9:
            continue  # seen from behind
        left = min(seen[i, 0], seen[j, 0], seen[k, 0]) - FARTHEST
        right = max(seen[i, 0], seen[j, 0], seen[k, 0]) + FARTHEST
        top = min(seen[i, 1], seen[j, 1], seen[k, 1]) - FARTHEST
        bottom = max(seen[i, 1], seen[j, 1], seen[k, 1]) + FARTHEST
        if not (right >= 0.0 and left <= width and bottom >= 0.0 and top <= height):
            continue
        box = (
            int(max(left, 0.0)), min(int(right) + 1, width),
            int(max(top, 0.0)), min(int(bottom) + 1, height),
        )  # fmt: skip
        _fill(f, seen, (i, j, k), box, samples)
        for row in range(box[2] // TILE, (box[3] - 1) // TILE + 1):
            for column in range(box[0] // TILE, (box[1] - 1) // TILE + 1):
                touched[row * columns + column] = True


@kernel(error_model="numpy")
def _clear(surfaces: Surfaces, seen: Matrix, samples: Samples) -> None:
    """Forget what was nearest in the tiles that hold all triangles, and a pixel around them: all
    samples of a large image are 25 MB, which take longer to write than a hand to draw."""
    height, width = samples.face.shape[0], samples.face.shape[1]
    low_u, low_v, high_u, high_v = np.inf, np.inf, -np.inf, -np.inf
    for f in range(len(surfaces.faces)):
        if surfaces.part[f] < 0:
            continue
        for corner in range(3):
            i = surfaces.faces[f, corner]
            if seen[i, 2] > 0.0:
                low_u, high_u = min(low_u, seen[i, 0]), max(high_u, seen[i, 0])
                low_v, high_v = min(low_v, seen[i, 1]), max(high_v, seen[i, 1])
    left, right = _tiles(low_u, high_u, width)
    top, bottom = _tiles(low_v, high_v, height)
    for v in range(top, bottom):
        for u in range(left, right):
            for m in range(4):
                samples.face[v, u, m] = NOTHING
                samples.inverse[v, u, m] = 0.0


@kernel(error_model="numpy")
def _tiles(low: float, high: float, size: int) -> tuple[int, int]:
    """First pixel and the one behind the last, of ``size``, of the tiles between two px and of a
    pixel around them."""
    if not (high + FARTHEST >= 0.0 and low - FARTHEST <= size):
        return 0, 0
    first = int(max(low - FARTHEST, 0.0)) // TILE * TILE - 1
    last = (int(min(high + FARTHEST, 1.0 * size)) // TILE + 1) * TILE + 1
    return max(first, 0), min(last, size)


@kernel(error_model="numpy")
def _fill(
    f: int,
    seen: Matrix,
    corners: tuple[int, int, int],
    box: tuple[int, int, int, int],
    samples: Samples,
) -> None:
    """One triangle, seen from outside, in its box (left, right, top, bottom)."""
    i, j, k = corners
    u0, v0, u1, v1 = seen[i, 0], seen[i, 1], seen[j, 0], seen[j, 1]
    u2, v2 = seen[k, 0], seen[k, 1]
    double = (u2 - u0) * (v1 - v0) - (u1 - u0) * (v2 - v0)
    # shares of the corners, each linear in the image: share = a u + b v + c
    a0, b0 = (v1 - v2) / double, (u2 - u1) / double
    c0 = -a0 * u2 - b0 * v2
    a1, b1 = (v2 - v0) / double, (u0 - u2) / double
    c1 = -a1 * u0 - b1 * v0
    a0, b0, c0 = -a0, -b0, -c0
    a1, b1, c1 = -a1, -b1, -c1
    z0, z1, z2 = seen[i, 2], seen[j, 2], seen[k, 2]
    a = a0 * (z0 - z2) + a1 * (z1 - z2)
    b = b0 * (z0 - z2) + b1 * (z1 - z2)
    c = c0 * (z0 - z2) + c1 * (z1 - z2) + z2
    low0 = -FARTHEST * (abs(a0) + abs(b0))
    low1 = -FARTHEST * (abs(a1) + abs(b1))
    low2 = -FARTHEST * (abs(a0 + a1) + abs(b0 + b1))
    inverse, face = samples.inverse, samples.face
    for v in range(box[2], box[3]):
        for u in range(box[0], box[1]):
            s0 = a0 * (u + 0.5) + b0 * (v + 0.5) + c0
            s1 = a1 * (u + 0.5) + b1 * (v + 0.5) + c1
            if s0 < low0 or s1 < low1 or 1.0 - s0 - s1 < low2:
                continue
            for m in range(4):
                du, dv = RAYS[m]
                t0, t1 = s0 + a0 * du + b0 * dv, s1 + a1 * du + b1 * dv
                if t0 < 0.0 or t1 < 0.0 or t0 + t1 > 1.0:
                    continue
                near = np.float32(a * (u + 0.5 + du) + b * (v + 0.5 + dv) + c)
                if near > inverse[v, u, m]:
                    inverse[v, u, m], face[v, u, m] = near, f
