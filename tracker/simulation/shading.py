"""Colour of each pixel: cloth, marker patches wrapped on it, light from one side."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    Float32Stack,
    IntVector,
    Matrix,
    Stack,
    Vector,
    Written,
)
from tracker.simulation.raster import Buffer, PixelRays
from tracker.simulation.solids import Instant


class Cloth(NamedTuple):
    """Of all solids, capsules first: owner (n,) and colour (n, 3) BGR."""

    owner: IntVector
    colour: Matrix


class SewnPatches(NamedTuple):
    """Markers sorted by segment, those of segment s being first[s] to first[s + 1].

    position (M, 3) in B; axes (M, 3, 3) rows: along, across and out of a flat patch in B; size (M,)
    m; shape (M,) 1 for a square; flat (M,) 1 on a plane; fabric (M, 3) BGR.
    """

    first: IntVector
    position: Matrix
    axes: Stack
    size: Vector
    shape: IntVector
    flat: IntVector
    fabric: Matrix


class Light(NamedTuple):
    """A unit vector (3,) in C towards the light, and the share of light from everywhere."""

    direction: Vector
    ambient: float


@kernel(fastmath=True)
def shade(
    rays: PixelRays,
    buffer: Buffer,
    now: Instant,
    cloth: Cloth,
    patches: SewnPatches,
    lamp: Light,
    ground: ByteStack,
    total: Written[Float32Stack],
) -> None:
    """Add one exposure to ``total`` (h, w, 3) BGR; ``ground`` (h, w, 3) shows where nothing is.

    Arrays are handed on whole with a row's number: a view of a row costs more than the arithmetic.
    """
    slope, jitter, eye, corner = rays.slope, rays.jitter, rays.eye, rays.corner
    depth, ident, light, ambient = buffer.depth, buffer.solid, lamp.direction, lamp.ambient
    a, b, radius = now.solids.a, now.solids.b, now.solids.radius
    box_R, centre, half = now.solids.box_R, now.solids.centre, now.solids.half
    owner, colour, fabric = cloth.owner, cloth.colour, patches.fabric
    R_CB, p_CB = now.R_CB, now.p_CB
    n, q = np.empty(3), np.empty(3)
    for row in range(depth.shape[0]):
        for column in range(depth.shape[1]):
            i = ident[row, column]
            if i < 0:
                for c in range(3):
                    total[row, column, c] += ground[row, column, c]
                continue
            z = depth[row, column]
            v, u = row + corner[0], column + corner[1]
            q[0] = eye[0] + z * (slope[v, u, 0] + jitter[0])
            q[1] = eye[1] + z * (slope[v, u, 1] + jitter[1])
            q[2] = eye[2] + z
            if i < len(radius):
                capsule_normal(q, a, b, radius, i, n)
            else:
                box_normal(q, box_R, centre, half, i - len(radius), n)
            bright = ambient + (1 - ambient) * max(
                n[0] * light[0] + n[1] * light[1] + n[2] * light[2], 0.0
            )
            m = -1
            s = owner[i]
            if s >= 0:
                m = patch_at((q[0], q[1], q[2]), R_CB, p_CB, s, patches)
            for c in range(3):
                base = fabric[m, c] if m >= 0 else colour[i, c]
                total[row, column, c] += base * bright


@kernel(fastmath=True, inline="always")
def capsule_normal(
    q: Vector, a: Matrix, b: Matrix, radius: Vector, i: int, n: Written[Vector]
) -> None:
    """Outward normal at the point q of capsule i."""
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = q[0] - a[i, 0], q[1] - a[i, 1], q[2] - a[i, 2]
    ee = max(e0 * e0 + e1 * e1 + e2 * e2, 1e-12)
    share = min(max((e0 * w0 + e1 * w1 + e2 * w2) / ee, 0.0), 1.0)
    n[0] = (w0 - share * e0) / radius[i]
    n[1] = (w1 - share * e1) / radius[i]
    n[2] = (w2 - share * e2) / radius[i]


@kernel(fastmath=True, inline="always")
def box_normal(
    q: Vector, R: Stack, centre: Matrix, half: Matrix, i: int, n: Written[Vector]
) -> None:
    """Outward normal of the face of box i that the point q lies on."""
    best, face, sign = -1e9, 0, 1.0
    for k in range(3):
        x = 0.0
        for c in range(3):
            x += R[i, c, k] * (q[c] - centre[i, c])
        if abs(x) - half[i, k] > best:
            best, face, sign = abs(x) - half[i, k], k, (1.0 if x > 0 else -1.0)
    for c in range(3):
        n[c] = sign * R[i, c, face]


@kernel(fastmath=True, inline="always")
def patch_at(q: Vector3, R: Stack, p: Matrix, i: int, patches: SewnPatches) -> int:
    """The marker whose patch covers the surface point q of segment i, -1 if none."""
    first, marker, axes = patches.first, patches.position, patches.axes
    size, shape, flat = patches.size, patches.shape, patches.flat
    d0, d1, d2 = q[0] - p[i, 0], q[1] - p[i, 1], q[2] - p[i, 2]
    x = R[i, 0, 0] * d0 + R[i, 1, 0] * d1 + R[i, 2, 0] * d2
    y = R[i, 0, 1] * d0 + R[i, 1, 1] * d1 + R[i, 2, 1] * d2
    z = R[i, 0, 2] * d0 + R[i, 1, 2] * d1 + R[i, 2, 2] * d2
    for m in range(first[i], first[i + 1]):
        reach = size[m] / 2
        if flat[m] == 0 and abs(x - marker[m, 0]) > reach:
            continue
        if flat[m] == 1:
            d0, d1, d2 = x - marker[m, 0], y - marker[m, 1], z - marker[m, 2]
            if abs(d0 * axes[m, 2, 0] + d1 * axes[m, 2, 1] + d2 * axes[m, 2, 2]) > 0.004:
                continue
            s = d0 * axes[m, 0, 0] + d1 * axes[m, 0, 1] + d2 * axes[m, 0, 2]
            w = d0 * axes[m, 1, 0] + d1 * axes[m, 1, 1] + d2 * axes[m, 1, 2]
        else:
            s, w = x - marker[m, 0], _around(y, z, marker[m, 1], marker[m, 2])
        if shape[m] == 1:
            if abs(s) <= reach and abs(w) <= reach:
                return m
        elif s * s + w * w <= reach * reach:
            return m
    return -1


@kernel(fastmath=True, inline="always")
def _around(y: float, z: float, my: float, mz: float) -> float:
    """Arc from the marker's middle to the point, both at the marker's distance from the bone."""
    rho = np.sqrt(my * my + mz * mz)
    angle = np.arctan2(my * z - mz * y, my * y + mz * z)
    return rho * angle


@kernel
def develop(
    total: Float32Stack,
    exposures: int,
    noise: Float32Stack,
    shift: IntVector,
    corner: IntVector,
    out: Written[ByteStack],
) -> None:
    """Mean of the exposures plus sensor noise, rounded into the part of ``out`` (H, W, 3) uint8
    that begins at the corner (v0, u0).

    noise (n, m, 3) is a tile of unit scale already multiplied; shift (2,) is where in it to begin.
    """
    rows, columns = noise.shape[0], noise.shape[1]
    share = np.float32(1.0 / exposures)
    for v in range(total.shape[0]):
        row = (v + shift[0]) % rows
        column = shift[1] % columns
        for u in range(total.shape[1]):
            for c in range(3):
                value = total[v, u, c] * share + noise[row, column, c] + np.float32(0.5)
                value = min(max(value, np.float32(0.0)), np.float32(255.0))
                out[v + corner[0], u + corner[1], c] = np.uint8(value)
            column += 1
            if column == columns:
                column = 0
