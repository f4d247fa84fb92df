"""The hand's shadow: a height map towards the lamp, on a grid that faces the lamp."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np

from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    Float32Matrix,
    Float32Stack,
    Matrix,
    Vector,
    Written,
)
from tracker.messages import Array
from tracker.simulation.raster import PixelRays
from tracker.simulation.solids import Solids

SIDE = 192  # texels
TEXEL = 0.003  # m
NOTHING = -1e3
BIAS = 0.006  # m: surfaces this close below the cloth are the cloth itself


class CastShadow(NamedTuple):
    """A grid around ``origin`` (3,) in C with axes (3, 3): across, across and towards the lamp.

    height (SIDE, SIDE) m of the hand; soft (SIDE, SIDE) 0..1: share of an extended lamp that it
    blocks for the desk below.
    """

    origin: Vector
    axes: Matrix
    height: Float32Matrix
    soft: Float32Matrix


def cast_shadow(solids: Solids, origin: Array, lamp: Array, blur: float) -> CastShadow:
    """The shadow of solids in C by a lamp (3,), blurred by ``blur`` (m) on the desk."""
    towards = lamp - origin
    towards = towards / np.linalg.norm(towards)
    across = np.cross(towards, [0.0, 1.0, 0.0])
    across /= np.linalg.norm(across)
    axes = np.array([across, np.cross(towards, across), towards])
    points, radius = _balls(solids)
    height = np.full((SIDE, SIDE), NOTHING, np.float32)
    _splat(np.ascontiguousarray((points - origin) @ axes.T), radius, height)
    hidden = (height > NOTHING).astype(np.float32)
    soft = np.asarray(cv2.GaussianBlur(hidden, (0, 0), max(blur / TEXEL, 0.6)), np.float32)
    return CastShadow(origin, axes, height, soft)


def _balls(solids: Solids) -> tuple[Array, Array]:
    """Spheres (n, 3), (n,) m that fill the solids."""
    points, radii = [], []
    for a, b, r in zip(solids.a, solids.b, solids.radius, strict=True):
        n = 1 + int(np.ceil(np.linalg.norm(b - a) / (0.5 * r)))
        points.append(a + np.linspace(0, 1, n)[:, None] * (b - a))
        radii.append(np.full(n, r))
    for R, centre, half in zip(solids.box_R, solids.centre, solids.half, strict=True):
        r = max(float(half.min()), 1e-3)
        steps = [np.linspace(-1, 1, max(int(np.ceil(h / r)) + 1, 1)) * max(h - r, 0) for h in half]
        grid = np.array(np.meshgrid(*steps)).reshape(3, -1).T
        points.append(centre + grid @ R.T)
        radii.append(np.full(len(grid), r))
    return np.concatenate(points), np.concatenate(radii)


@kernel(fastmath=True)
def _splat(points: Matrix, radius: Vector, height: Written[Float32Matrix]) -> None:
    """Raise ``height`` to spheres at points (n, 3) given along the grid's axes."""
    n, middle = len(height), len(height) / 2
    for k in range(len(points)):
        r2 = radius[k] * radius[k]
        reach = radius[k] / TEXEL
        x, y = points[k, 0] / TEXEL + middle, points[k, 1] / TEXEL + middle
        for i in range(max(int(np.ceil(x - reach)), 0), min(int(x + reach) + 1, n)):
            for j in range(max(int(np.ceil(y - reach)), 0), min(int(y + reach) + 1, n)):
                gap2 = ((i - x) ** 2 + (j - y) ** 2) * TEXEL * TEXEL
                if gap2 < r2:
                    top = np.float32(points[k, 2] + np.sqrt(r2 - gap2))
                    if top > height[i, j]:
                        height[i, j] = top


@kernel(fastmath=True, inline="always")
def lit_share(q: Vector3, origin: Vector, axes: Matrix, height: Float32Matrix) -> float:
    """Share of the lamp visible from a point q of the hand: mean over four texels of a
    `CastShadow`.

    Its arrays are separate parameters: passing a tuple of arrays costs more than the arithmetic.
    """
    d0, d1, d2 = q[0] - origin[0], q[1] - origin[1], q[2] - origin[2]
    x = (axes[0, 0] * d0 + axes[0, 1] * d1 + axes[0, 2] * d2) / TEXEL + SIDE / 2
    y = (axes[1, 0] * d0 + axes[1, 1] * d1 + axes[1, 2] * d2) / TEXEL + SIDE / 2
    if x < 0.0 or y < 0.0 or x >= SIDE - 1.0 or y >= SIDE - 1.0:
        return 1.0
    up = axes[2, 0] * d0 + axes[2, 1] * d1 + axes[2, 2] * d2 + BIAS
    i, j = int(x), int(y)
    fx, fy = x - i, y - j
    lit = 0.0
    if height[i, j] < up:
        lit += (1 - fx) * (1 - fy)
    if height[i + 1, j] < up:
        lit += fx * (1 - fy)
    if height[i, j + 1] < up:
        lit += (1 - fx) * fy
    if height[i + 1, j + 1] < up:
        lit += fx * fy
    return lit


class GroundLight(NamedTuple):
    """`ground.GroundImages` of one camera: lamp, rest (h, w, 3), depth (h, w)."""

    lamp: Float32Stack
    rest: Float32Stack
    depth: Float32Matrix


@kernel(fastmath=True)
def shaded_ground(
    rays: PixelRays, ground: GroundLight, s: CastShadow, base: Written[Float32Stack]
) -> None:
    """Linear BGR (h, w, 3) of the region of ``rays``: the ground with the hand's shadow."""
    corner, slope, soft, origin, axes = rays.corner, rays.slope, s.soft, s.origin, s.axes
    x0, y0, end = SIDE / 2, SIDE / 2, SIDE - 1.0
    w0, w1, w2 = rays.eye[0] - origin[0], rays.eye[1] - origin[1], rays.eye[2] - origin[2]
    x0 += (axes[0, 0] * w0 + axes[0, 1] * w1 + axes[0, 2] * w2) / TEXEL
    y0 += (axes[1, 0] * w0 + axes[1, 1] * w1 + axes[1, 2] * w2) / TEXEL
    a0, a1, a2 = axes[0, 0] / TEXEL, axes[0, 1] / TEXEL, axes[0, 2] / TEXEL
    b0, b1, b2 = axes[1, 0] / TEXEL, axes[1, 1] / TEXEL, axes[1, 2] / TEXEL
    for row in range(base.shape[0]):
        for column in range(base.shape[1]):
            v, u = row + corner[0], column + corner[1]
            z, sx, sy = ground.depth[v, u], slope[v, u, 0], slope[v, u, 1]
            x, y = x0 + z * (a0 * sx + a1 * sy + a2), y0 + z * (b0 * sx + b1 * sy + b2)
            lit = np.float32(1.0)
            if x >= 0.0 and y >= 0.0 and x < end and y < end:
                i, j = int(x), int(y)
                fx, fy = x - i, y - j
                near = (1 - fy) * soft[i, j] + fy * soft[i, j + 1]
                far = (1 - fy) * soft[i + 1, j] + fy * soft[i + 1, j + 1]
                lit = np.float32(1.0 - (1 - fx) * near - fx * far)
            for c in range(3):
                base[row, column, c] = ground.rest[v, u, c] + lit * ground.lamp[v, u, c]


def shadow_corners(shadow: CastShadow, depth: float) -> Array:
    """(n, 3) points of C around the shadow on the desk, ``depth`` (m) below the hand along the
    lamp's direction; empty without a shadow."""
    rows, columns = np.nonzero(shadow.soft > 0.01)
    if len(rows) == 0:
        return np.zeros((0, 3))
    low = (np.array([rows.min(), columns.min()]) - SIDE / 2) * TEXEL
    high = (np.array([rows.max(), columns.max()]) - SIDE / 2) * TEXEL
    corners = np.array([[x, y, -depth] for x in (low[0], high[0]) for y in (low[1], high[1])])
    return np.asarray(shadow.origin + corners @ shadow.axes)
