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
    """Of each ray (H, W, 4): 1/z of the nearest triangle, 1/m, 0 for none, and its row."""

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
    _touch(surfaces, seen, samples, touched)
    _clear(samples, touched)
    for f in range(len(surfaces.faces)):
        box = _box(surfaces, f, seen, samples)
        if box[0] < box[1]:
            i, j, k = surfaces.faces[f, 0], surfaces.faces[f, 1], surfaces.faces[f, 2]
            _fill(f, seen, (i, j, k), box, samples)


@kernel(error_model="numpy")
def _box(surfaces: Surfaces, f: int, seen: Matrix, samples: Samples) -> tuple[int, int, int, int]:
    """Pixels that a triangle may show in: left, right, top, bottom; none where it is not drawn, not
    ahead, seen from behind or beside the image."""
    nowhere = 0, 0, 0, 0
    if surfaces.part[f] < 0:
        return nowhere
    height, width = samples.inverse.shape[0], samples.inverse.shape[1]
    i, j, k = surfaces.faces[f, 0], surfaces.faces[f, 1], surfaces.faces[f, 2]
    if seen[i, 2] <= 0.0 or seen[j, 2] <= 0.0 or seen[k, 2] <= 0.0:
        return nowhere
    # v points down: counter-clockwise from outside is clockwise in these numbers
    double = (seen[k, 0] - seen[i, 0]) * (seen[j, 1] - seen[i, 1])
    double -= (seen[j, 0] - seen[i, 0]) * (seen[k, 1] - seen[i, 1])
    if not double > 1e-9:
        return nowhere
    left = min(seen[i, 0], seen[j, 0], seen[k, 0]) - FARTHEST
    right = max(seen[i, 0], seen[j, 0], seen[k, 0]) + FARTHEST
    top = min(seen[i, 1], seen[j, 1], seen[k, 1]) - FARTHEST
    bottom = max(seen[i, 1], seen[j, 1], seen[k, 1]) + FARTHEST
    if not (right >= 0.0 and left <= width and bottom >= 0.0 and top <= height):
        return nowhere
    across = int(max(left, 0.0)), min(int(right) + 1, width)
    return across[0], across[1], int(max(top, 0.0)), min(int(bottom) + 1, height)


@kernel(error_model="numpy")
def _touch(
    surfaces: Surfaces, seen: Matrix, samples: Samples, touched: Written[BoolVector]
) -> None:
    """Tiles that any triangle may show in."""
    columns = (samples.inverse.shape[1] + TILE - 1) // TILE
    for f in range(len(surfaces.faces)):
        left, right, top, bottom = _box(surfaces, f, seen, samples)
        if left >= right or top >= bottom:
            continue
        for row in range(top // TILE, (bottom - 1) // TILE + 1):
            for column in range(left // TILE, (right - 1) // TILE + 1):
                touched[row * columns + column] = True


@kernel(error_model="numpy")
def _clear(samples: Samples, touched: BoolVector) -> None:
    """Forget what was nearest in these tiles and in the pixels around them: all samples of a large
    image take longer to write than a hand to draw."""
    height, width = samples.inverse.shape[0], samples.inverse.shape[1]
    columns = (width + TILE - 1) // TILE
    for tile in range(len(touched)):
        if touched[tile]:
            top, left = tile // columns * TILE, tile % columns * TILE
            for v in range(max(top - 1, 0), min(top + TILE + 1, height)):
                for u in range(max(left - 1, 0), min(left + TILE + 1, width)):
                    for m in range(4):
                        samples.inverse[v, u, m] = 0.0


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
    # what each of `MORE` adds to shares and 1/z, so that no ray is computed from its start
    (x1, y1), (x2, y2), (x3, y3) = MORE
    p1, q1, r1 = a0 * x1 + b0 * y1, a1 * x1 + b1 * y1, a * x1 + b * y1
    p2, q2, r2 = a0 * x2 + b0 * y2, a1 * x2 + b1 * y2, a * x2 + b * y2
    p3, q3, r3 = a0 * x3 + b0 * y3, a1 * x3 + b1 * y3, a * x3 + b * y3
    for v in range(box[2], box[3]):
        p0 = 0.5 * a0 + b0 * (v + 0.5) + c0
        q0 = 0.5 * a1 + b1 * (v + 0.5) + c1
        r0 = 0.5 * a + b * (v + 0.5) + c
        for u in range(box[0], box[1]):
            s, t = p0 + a0 * u, q0 + a1 * u
            if s < low0 or t < low1 or 1.0 - s - t < low2:
                continue
            z = r0 + a * u
            _keep_nearer(samples, v, u, 0, f, s, t, z)
            _keep_nearer(samples, v, u, 1, f, s + p1, t + q1, z + r1)
            _keep_nearer(samples, v, u, 2, f, s + p2, t + q2, z + r2)
            _keep_nearer(samples, v, u, 3, f, s + p3, t + q3, z + r3)


@kernel(error_model="numpy", inline="always")
def _keep_nearer(
    samples: Samples, v: int, u: int, m: int, f: int, s: float, t: float, inverse: float
) -> None:
    """Triangle f at ray m of a pixel, whose shares of its first two corners are s and t."""
    near = np.float32(inverse)
    if s >= 0.0 and t >= 0.0 and s + t <= 1.0 and near > samples.inverse[v, u, m]:
        samples.inverse[v, u, m], samples.face[v, u, m] = near, f
