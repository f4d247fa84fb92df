"""Which solid each pixel shows: a depth buffer filled by rays, one solid after another."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    Float32Matrix,
    Float32Stack,
    Int16Matrix,
    IntMatrix,
    IntVector,
    Matrix,
    Stack,
    Vector,
    Written,
)
from tracker.messages import Array
from tracker.simulation.solids import Solids

FAR = 1e6
TILE = 8  # px
SPREAD = 1.1  # of a tile's corners: a lens may bend what is between them
NEAR = 0.05  # m from the camera, within which nothing is left out


class PixelRays(NamedTuple):
    """From ``eye`` (3,) in C: x/z and y/z (H, W, 2) of each pixel of the whole image, and what is
    added to them (2,); the corner (v0, u0) of the region that is drawn."""

    slope: Float32Stack
    jitter: Vector
    eye: Vector
    corner: IntVector


class Capsule(NamedTuple):
    """From one end to the other ``e``, from that end to the eye ``w``, m; their products e e, e w
    and w w; and the radius."""

    e0: float
    e1: float
    e2: float
    w0: float
    w1: float
    w2: float
    ee: float
    ew: float
    ww: float
    r: float


class Tile(NamedTuple):
    """Rows v0 to v1 and columns u0 to u1 of the whole image, the upper ones excluded."""

    v0: int
    u0: int
    v1: int
    u1: int


class Buffer(NamedTuple):
    """What a region (h, w) shows: depth m, and the solid's row, capsules first, -1: nothing."""

    depth: Written[Float32Matrix]
    solid: Written[Int16Matrix]


def bounds(solids: Solids, eye: Array, K: Array) -> Array:
    """(P + Q, 4) u0, v0, u1, v1 px around each solid in the rectified image; NaN if not in front.

    A ball of radius r at depth z spans at most r / (z - r) to each side of its middle.
    """
    corners = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
    box = solids.centre[:, None] + np.einsum(
        "qij,qkj->qki", solids.box_R, corners * solids.half[:, None]
    )
    ends = np.stack([solids.a, solids.b], axis=1)
    capsule = _box_of(ends - eye, solids.radius[:, None], K)
    return np.concatenate([capsule, _box_of(box - eye, np.zeros((len(box), 1)), K)])


def _box_of(points: Array, radius: Array, K: Array) -> Array:
    """(n, 4) px around balls (n, k, 3) of radius (n, 1) m, seen from the origin."""
    z = points[..., 2] - radius
    z = np.where(z < 0.02, np.nan, z)
    centre = points[..., :2] / points[..., 2:]
    # the middle's offset grows the span: (1 + |x/z|) covers the ellipse of a ball off the axis
    reach = (radius / z)[..., None] * (1 + np.abs(centre))
    low, high = (centre - reach).min(axis=1), (centre + reach).max(axis=1)
    return np.concatenate([low * K[:2] + K[2:], high * K[:2] + K[2:]], axis=1)


@kernel(fastmath=True)
def draw(view: PixelRays, pixels: IntMatrix, solids: Solids, buffer: Buffer) -> None:
    """Fill ``buffer``. pixels (P + Q, 4): u0, v0, u1, v1 of each solid, the upper ones excluded.

    A capsule that lies aslant fills a small part of its bounds: tiles that none of its rays can
    meet are left out.
    """
    rays, jitter, eye, corner = view.slope, view.jitter, view.eye, view.corner
    depth, ident, capsules = buffer.depth, buffer.solid, len(solids.radius)
    depth[:] = FAR
    ident[:] = -1
    for i in range(capsules):
        capsule = _seen(eye, solids.a, solids.b, solids.radius[i], i)
        for v0 in range(pixels[i, 1], pixels[i, 3], TILE):
            for u0 in range(pixels[i, 0], pixels[i, 2], TILE):
                tile = Tile(v0, u0, min(v0 + TILE, pixels[i, 3]), min(u0 + TILE, pixels[i, 2]))
                if not _is_beside(view, solids, i, tile):
                    _draw_capsule(view, buffer, capsule, i, tile)
    for i in range(capsules, len(pixels)):
        for v in range(pixels[i, 1], pixels[i, 3]):
            for u in range(pixels[i, 0], pixels[i, 2]):
                x, y = rays[v, u, 0] + jitter[0], rays[v, u, 1] + jitter[1]
                z = _box(eye, x, y, solids.box_R, solids.centre, solids.half, i - capsules)
                row, column = v - corner[0], u - corner[1]
                if z < depth[row, column]:
                    depth[row, column] = z
                    ident[row, column] = i


@kernel(fastmath=True, inline="always")
def _draw_capsule(view: PixelRays, buffer: Buffer, capsule: Capsule, i: int, tile: Tile) -> None:
    """Capsule i in a tile."""
    rays, depth, ident = view.slope, buffer.depth, buffer.solid
    jx, jy, dv, du = view.jitter[0], view.jitter[1], view.corner[0], view.corner[1]
    for v in range(tile.v0, tile.v1):
        for u in range(tile.u0, tile.u1):
            z = _depth(capsule, rays[v, u, 0] + jx, rays[v, u, 1] + jy)
            if z < depth[v - dv, u - du]:
                depth[v - dv, u - du] = z
                ident[v - dv, u - du] = i


@kernel(fastmath=True, inline="always")
def _is_beside(view: PixelRays, solids: Solids, i: int, tile: Tile) -> bool:
    """Whether no ray of a tile can meet capsule i.

    At depth z each of them is within ``spread`` z of the middle one, so the middle one misses a
    capsule that is so much thicker.
    """
    rays, jitter, a, b = view.slope, view.jitter, solids.a, solids.b
    vm, um = (tile.v0 + tile.v1) // 2, (tile.u0 + tile.u1) // 2
    x, y = rays[vm, um, 0], rays[vm, um, 1]
    spread = 0.0
    for v in (tile.v0, tile.v1 - 1):
        for u in (tile.u0, tile.u1 - 1):
            spread = max(spread, (rays[v, u, 0] - x) ** 2 + (rays[v, u, 1] - y) ** 2)
    near = min(a[i, 2], b[i, 2]) - view.eye[2] - solids.radius[i]
    far = max(a[i, 2], b[i, 2]) - view.eye[2] + solids.radius[i]
    thicker = SPREAD * np.sqrt(spread) * far
    if near - thicker < NEAR:
        return False
    thick = _seen(view.eye, a, b, solids.radius[i] + thicker, i)
    return _depth(thick, x + jitter[0], y + jitter[1]) == FAR


@kernel(fastmath=True, inline="always")
def _seen(eye: Vector, a: Matrix, b: Matrix, r: float, i: int) -> Capsule:
    """Capsule i, of radius r m, for `_depth`: what all of its rays share is computed once."""
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = eye[0] - a[i, 0], eye[1] - a[i, 1], eye[2] - a[i, 2]
    ee = e0 * e0 + e1 * e1 + e2 * e2
    ew = e0 * w0 + e1 * w1 + e2 * w2
    ww = w0 * w0 + w1 * w1 + w2 * w2
    return Capsule(e0, e1, e2, w0, w1, w2, ee, ew, ww, r)


@kernel(fastmath=True, inline="always")
def _depth(capsule: Capsule, x: float, y: float) -> float:
    """Depth z at which the ray eye + z (x, y, 1) enters a capsule, FAR if it misses.

    Apart from `tracker.geometry.solids.capsule_depth`, which wants the ray in the capsule's frame:
    a million rays meet a capsule given by its ends, and to find and enter a frame takes longer.
    """
    e0, e1, e2, w0, w1, w2, ee, ew, ww, r = capsule
    dd = x * x + y * y + 1.0
    ed = e0 * x + e1 * y + e2
    dw = x * w0 + y * w1 + w2
    share = 0.0
    k2 = ee * dd - ed * ed
    if k2 > 1e-12 * ee * dd and ee > 1e-12:
        k1 = ee * dw - ew * ed
        k0 = ee * (ww - r * r) - ew * ew
        h = k1 * k1 - k2 * k0
        if h < 0.0:
            return FAR
        z = (-k1 - np.sqrt(h)) / k2
        share = (ew + z * ed) / ee
        if 0.0 < share < 1.0:
            return z if z > 0.02 else FAR
    if share >= 1.0:
        dw -= ed
        ww += ee - 2 * ew
    h = dw * dw - dd * (ww - r * r)
    if h < 0.0:
        return FAR
    z = (-dw - np.sqrt(h)) / dd
    return z if z > 0.02 else FAR


@kernel(fastmath=True, inline="always")
def _box(eye: Vector, x: float, y: float, R: Stack, centre: Matrix, half: Matrix, i: int) -> float:
    """Depth z at which the ray eye + z (x, y, 1) enters box i, FAR if it misses (slab method).

    As `tracker.geometry.solids.box_span`, but seen from the first centimetres on.
    """
    low, high = 0.02, FAR
    w0, w1, w2 = eye[0] - centre[i, 0], eye[1] - centre[i, 1], eye[2] - centre[i, 2]
    for k in range(3):
        start = R[i, 0, k] * w0 + R[i, 1, k] * w1 + R[i, 2, k] * w2
        step = R[i, 0, k] * x + R[i, 1, k] * y + R[i, 2, k]
        if abs(step) < 1e-9:
            step = 1e-9
        t0, t1 = (-half[i, k] - start) / step, (half[i, k] - start) / step
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low if low <= high else FAR
