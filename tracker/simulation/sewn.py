"""Patches sewn to cloth: the patch that covers a point, and the pixels that a patch covers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    Float32Vector,
    Int32Vector,
    IntMatrix,
    IntVector,
    Matrix,
    Stack,
    Vector,
    Written,
)

T1, T2, T3, T4, T5, T6 = (np.float32(1.0 / (2 * n * (2 * n - 1))) for n in range(1, 7))
"""Ratios of successive terms of the cosine's series in the squared angle."""
ON_PLANE = 0.004  # m: within this distance of its plane the cloth is covered by a flat patch


class SewnPatches(NamedTuple):
    """Markers sorted by segment; those of segment s are rows first[s] to first[s + 1].

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


class SeenPatches(NamedTuple):
    """`SewnPatches` at one instant, for one camera: first; box (M, 4) u0, v0, u1, v1 px around
    each; axes (M, 3, 3) rows along, across and out of it in C; origin (M, 3) in C, its centre if
    flat, else the bone's axis below it; reach (M,) half its size, m; ``around`` (M,) m from that
    origin to its centre, 0 for a flat one; shape and fabric."""

    first: IntVector
    box: IntMatrix
    axes: Stack
    origin: Matrix
    reach: Vector
    around: Vector
    shape: IntVector
    fabric: Matrix


class PixelRun(NamedTuple):
    """Adjacent pixels of a row that show one solid: slope (2 n,) and jitter of their rays from
    ``eye`` (3,) in C, and depth (n,) m."""

    slope: Float32Vector
    depth: Float32Vector
    jx: np.float32
    jy: np.float32
    eye: Vector


class Place(NamedTuple):
    """Row and first column of a run in the whole image, and the visible segment or -1."""

    v: int
    u0: int
    segment: int


class SeenPatch(NamedTuple):
    """A patch's axes along (a), across (b) and out of it (c) in C, their products with the vector
    from its origin to the eye, half its size squared, 1 if round or 0, and 1 / ``around``² or 0."""

    a0: np.float32
    a1: np.float32
    a2: np.float32
    b0: np.float32
    b1: np.float32
    b2: np.float32
    c0: np.float32
    c1: np.float32
    c2: np.float32
    s: np.float32
    w: np.float32
    out: np.float32
    reach2: np.float32
    is_round: np.float32
    per: np.float32


@kernel(fastmath=True, error_model="numpy", inline="always")
def find_patches(
    run: PixelRun, at: Place, patches: SeenPatches, covered: Written[Int32Vector]
) -> bool:
    """Whether a run of pixels has patches; ``covered`` (n,) is set to each pixel's patch, or -1."""
    found = False
    if at.segment < 0:
        return found
    box = patches.box
    for m in range(patches.first[at.segment], patches.first[at.segment + 1]):
        begin, end = max(box[m, 0] - at.u0, 0), min(box[m, 2] - at.u0, len(covered))
        if at.v < box[m, 1] or at.v >= box[m, 3] or begin >= end:
            continue
        if not found:
            covered[:] = -1
            found = True
        patch = _patch(run.eye, patches, m)
        slope, depth = run.slope[2 * begin : 2 * end], run.depth[begin:end]
        _cover(slope, depth, run.jx, run.jy, patch, m, covered[begin:end])
    return found


@kernel(fastmath=True, error_model="numpy", inline="always")
def _patch(eye: Vector, patches: SeenPatches, m: int) -> SeenPatch:
    """Patch m, for `_cover`."""
    axes, origin, around = patches.axes, patches.origin, patches.around[m]
    w0, w1, w2 = eye[0] - origin[m, 0], eye[1] - origin[m, 1], eye[2] - origin[m, 2]
    s = axes[m, 0, 0] * w0 + axes[m, 0, 1] * w1 + axes[m, 0, 2] * w2
    w = axes[m, 1, 0] * w0 + axes[m, 1, 1] * w1 + axes[m, 1, 2] * w2
    out = axes[m, 2, 0] * w0 + axes[m, 2, 1] * w1 + axes[m, 2, 2] * w2
    return SeenPatch(
        np.float32(axes[m, 0, 0]), np.float32(axes[m, 0, 1]), np.float32(axes[m, 0, 2]),
        np.float32(axes[m, 1, 0]), np.float32(axes[m, 1, 1]), np.float32(axes[m, 1, 2]),
        np.float32(axes[m, 2, 0]), np.float32(axes[m, 2, 1]), np.float32(axes[m, 2, 2]),
        np.float32(s), np.float32(w), np.float32(out),
        np.float32(patches.reach[m] * patches.reach[m]),
        np.float32(0.0 if patches.shape[m] == 1 else 1.0),
        np.float32(1.0 / (around * around) if around > 0.0 else 0.0),
    )  # fmt: skip


@kernel(fastmath=True, error_model="numpy", inline="always")
def _cover(
    slope: Float32Vector,
    depth: Float32Vector,
    jx: np.float32,
    jy: np.float32,
    patch: SeenPatch,
    m: int,
    covered: Written[Int32Vector],
) -> None:
    """Set m where patch m covers a part of a run not covered yet, as `patch_at` does.

    A wrapped one extends around the bone by the angle of its width there: both angles' cosines are
    compared, the second by its series, which is accurate to 1e-7 up to 100 degrees.
    """
    a0, a1, a2, b0, b1, b2, c0, c1, c2, s0, w0, out0, reach2, is_round, per = patch
    one, none, own = np.float32(1.0), np.int32(-1), np.int32(m)
    for k in range(len(covered)):
        x, y, z, before = slope[2 * k] + jx, slope[2 * k + 1] + jy, depth[k], covered[k]
        s = s0 + z * (a0 * x + a1 * y + a2)
        w = w0 + z * (b0 * x + b1 * y + b2)
        out = out0 + z * (c0 * x + c1 * y + c2)
        left = reach2 - is_round * s * s  # of the width, squared
        t = left * per
        series = one - t * T5 * (one - t * T6)
        for step in (T4, T3, T2, T1):
            series = one - t * step * series
        is_around = out * abs(out) >= series * abs(series) * (w * w + out * out)
        is_flat = (w * w <= left) & (abs(out) <= np.float32(ON_PLANE))
        is_on = is_around if per > np.float32(0.0) else is_flat
        is_on = is_on & (s * s <= reach2) & (before == none)
        covered[k] = own if is_on else before


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
            if abs(d0 * axes[m, 2, 0] + d1 * axes[m, 2, 1] + d2 * axes[m, 2, 2]) > ON_PLANE:
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
    """Arc from the marker's centre to the point, both at the marker's distance from the bone."""
    rho = np.sqrt(my * my + mz * mz)
    angle = np.arctan2(my * z - mz * y, my * y + mz * z)
    return rho * angle
