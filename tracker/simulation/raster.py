"""The visible solid at each pixel: a depth buffer filled by ray casting, one solid at a time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    Float32Matrix,
    Float32Stack,
    Float32Vector,
    Int16Matrix,
    Int16Vector,
    IntMatrix,
    IntVector,
    Matrix,
    Vector,
    Written,
)
from tracker.messages import Array
from tracker.simulation.solids import Solids

FAR = 1e6
TILE = 8  # px
SPREAD = 0.75  # of a tile's width: from its centre to its corners, with a margin
NEAR = 0.05  # m from the camera, within which nothing is culled
NEAREST = 0.02  # m from the camera, within which nothing is drawn
TIE = 1e-4  # m: of solids this close to each other, as two that share an end, the first is visible
CORNERS = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T  # (8, 3) of a box
BALL = 1e-12  # m²: a capsule's squared length below which it has no axis


class PixelRays(NamedTuple):
    """From ``eye`` (3,) in C: x/z and y/z (H, W, 2) of each pixel of the whole image, their maximum
    difference between neighbours, and the offset (2,) added to them; the corner (v0, u0) of the
    region that is drawn."""

    slope: Float32Stack
    pitch: float
    jitter: Vector
    eye: Vector
    corner: IntVector


class Capsule(NamedTuple):
    """From one end to the other ``e``, from that end to the eye ``w``, m; their products e e and e
    w, ``per`` 1 / (e e) or 0 for a ball; w w minus the squared radius at that end and at the other,
    and its part perpendicular to the axis, times e e."""

    e0: np.float32
    e1: np.float32
    e2: np.float32
    w0: np.float32
    w1: np.float32
    w2: np.float32
    ee: np.float32
    ew: np.float32
    per: np.float32
    outside: np.float32
    outside_b: np.float32
    beside: np.float32


class Slab(NamedTuple):
    """Between two faces of a box: their normal, the position of the eye along it from the box's
    centre, and half the distance of the faces, m."""

    n0: np.float32
    n1: np.float32
    n2: np.float32
    start: np.float32
    half: np.float32


class Tile(NamedTuple):
    """Rows v0 to v1 and columns u0 to u1 of the whole image, upper limits excluded."""

    v0: int
    u0: int
    v1: int
    u1: int


class Buffer(NamedTuple):
    """The visible surface of a region (h, w): depth m, and the solid's row, capsules first, -1:
    none."""

    depth: Written[Float32Matrix]
    solid: Written[Int16Matrix]


Row = tuple[Float32Vector, Int16Vector]
"""Depth and solid for a part of a row of a `Buffer`."""


def bounds(solids: Solids, eye: Array, K: Array) -> Array:
    """(P + Q, 4) u0, v0, u1, v1 px around each solid in the rectified image; NaN if not in front.

    A ball of radius r at depth z spans at most r / (z - r) to each side of its centre.
    """
    box = solids.centre[:, None] + np.einsum(
        "qij,qkj->qki", solids.box_R, CORNERS * solids.half[:, None]
    )
    ends = np.stack([solids.a, solids.b], axis=1)
    capsule = ball_bounds(ends - eye, solids.radius[:, None], K)
    return np.concatenate([capsule, ball_bounds(box - eye, np.zeros((len(box), 1)), K)])


def ball_bounds(points: Array, radius: Array, K: Array) -> Array:
    """(n, 4) px around balls (n, k, 3) of radius (n, 1) m, seen from the origin; NaN if not in
    front."""
    z = points[..., 2] - radius
    z = np.where(z < 0.02, np.nan, z)
    centre = points[..., :2] / points[..., 2:]
    # the centre's offset enlarges the span: (1 + |x/z|) covers the ellipse of a ball off the axis
    reach = (radius / z)[..., None] * (1 + np.abs(centre))
    low, high = (centre - reach).min(axis=1), (centre + reach).max(axis=1)
    return np.concatenate([low * K[:2] + K[2:], high * K[:2] + K[2:]], axis=1)


@kernel(fastmath=True, error_model="numpy", wide=True)
def draw(view: PixelRays, pixels: IntMatrix, solids: Solids, buffer: Written[Buffer]) -> None:
    """Fill ``buffer``. pixels (P + Q, 4): u0, v0, u1, v1 of each solid, upper limits excluded.

    An oblique capsule fills a small part of its bounds: of each band of rows only the span between
    the first and the last tile with rays that may hit it is drawn. Rows are processed without a
    branch and in single precision (errors of some µm), so that they can be vectorised.
    """
    jitter, corner, width = view.jitter, view.corner, view.slope.shape[1]
    rays = view.slope.reshape(-1)  # lets the compiler know that it is contiguous
    depth, ident, capsules = buffer.depth, buffer.solid, len(solids.radius)
    jx, jy = np.float32(jitter[0]), np.float32(jitter[1])
    depth[:] = FAR
    ident[:] = -1
    for i in range(capsules):
        capsule = _seen(view.eye, solids.a, solids.b, solids.radius[i], i)
        thicker = _thicker(view, solids, i)
        thick = _seen(view.eye, solids.a, solids.b, solids.radius[i] + thicker, i)
        for v0 in range(pixels[i, 1], pixels[i, 3], TILE):
            v1 = min(v0 + TILE, pixels[i, 3])
            u0, u1 = pixels[i, 0], pixels[i, 2]
            if thicker >= 0.0:
                u0, u1 = _span(view, thick, Tile(v0, u0, v1, u1))
            u1 = min(u0 + (u1 - u0 + TILE - 1) // TILE * TILE, corner[1] + depth.shape[1])
            begin, end = u0 - corner[1], u1 - corner[1]
            for v in range(v0, v1):
                row = v - corner[0]
                z, shown = depth[row, begin:end], ident[row, begin:end]
                seen = rays[2 * (v * width + u0) : 2 * (v * width + u1)]
                _draw_capsule(seen, jx, jy, capsule, i, z, shown)
    for i in range(capsules, len(pixels)):
        j = i - capsules
        box = (
            _slab(view.eye, solids, j, 0),
            _slab(view.eye, solids, j, 1),
            _slab(view.eye, solids, j, 2),
        )
        u0, u1 = pixels[i, 0], pixels[i, 2]
        begin, end = u0 - corner[1], u1 - corner[1]
        for v in range(pixels[i, 1], pixels[i, 3]):
            row = v - corner[0]
            z, shown = depth[row, begin:end], ident[row, begin:end]
            seen = rays[2 * (v * width + u0) : 2 * (v * width + u1)]
            _draw_box(seen, jx, jy, box, i, z, shown)


@kernel(fastmath=True, error_model="numpy", inline="always")
def _draw_capsule(
    slope: Float32Vector,
    jx: np.float32,
    jy: np.float32,
    capsule: Capsule,
    i: int,
    depth: Written[Float32Vector],
    ident: Written[Int16Vector],
) -> None:
    """Draws capsule i in part of a row."""
    solid = np.int16(i)
    for k in range(len(depth)):
        z = _depth(capsule, slope[2 * k] + jx, slope[2 * k + 1] + jy)
        before, shown = depth[k], ident[k]
        is_nearer = z < before - np.float32(TIE)
        depth[k] = z if is_nearer else before
        ident[k] = solid if is_nearer else shown


@kernel(fastmath=True, error_model="numpy", inline="always")
def _draw_box(
    slope: Float32Vector,
    jx: np.float32,
    jy: np.float32,
    box: tuple[Slab, Slab, Slab],
    i: int,
    depth: Written[Float32Vector],
    ident: Written[Int16Vector],
) -> None:
    """Draws a box, solid i, in part of a row."""
    solid = np.int16(i)
    for k in range(len(depth)):
        z = _box(box, slope[2 * k] + jx, slope[2 * k + 1] + jy)
        before, shown = depth[k], ident[k]
        is_nearer = z < before - np.float32(TIE)
        depth[k] = z if is_nearer else before
        ident[k] = solid if is_nearer else shown


@kernel(fastmath=True, error_model="numpy", inline="always")
def _thicker(view: PixelRays, solids: Solids, i: int) -> float:
    """Maximum distance (m) of the ray in a tile's centre from capsule i if any ray of the tile hits
    it: at depth z each is within half a tile's diagonal of pixels, times z, of the central one.
    Negative where this bound is invalid, close to the camera."""
    a, b, r, eye = solids.a, solids.b, solids.radius[i], view.eye
    far = max(a[i, 2], b[i, 2]) - eye[2] + r
    thicker = SPREAD * view.pitch * TILE * far
    return thicker if min(a[i, 2], b[i, 2]) - eye[2] - r - thicker > NEAR else -1.0


@kernel(fastmath=True, error_model="numpy", inline="always")
def _span(view: PixelRays, thick: Capsule, band: Tile) -> tuple[int, int]:
    """Columns of a band of rows, the upper limit excluded, that contain all tiles whose central ray
    hits a capsule.

    The image of a capsule is convex, so tiles between two that it touches are not tested.
    """
    u0, u1 = band.u0, band.u1
    while u0 < u1 and _misses_tile(view, thick, Tile(band.v0, u0, band.v1, min(u0 + TILE, u1))):
        u0 += TILE
    u0 = min(u0, u1)
    while u0 < u1 and _misses_tile(view, thick, Tile(band.v0, max(u1 - TILE, u0), band.v1, u1)):
        u1 = max(u1 - TILE, u0)
    return u0, u1


@kernel(fastmath=True, error_model="numpy", inline="always")
def _misses_tile(view: PixelRays, thick: Capsule, tile: Tile) -> bool:
    """Whether the central ray of a tile misses a capsule."""
    v, u = (tile.v0 + tile.v1) // 2, (tile.u0 + tile.u1) // 2
    x, y = view.slope[v, u, 0] + view.jitter[0], view.slope[v, u, 1] + view.jitter[1]
    return bool(_depth(thick, np.float32(x), np.float32(y)) >= FAR)


@kernel(fastmath=True, error_model="numpy", inline="always")
def _seen(eye: Vector, a: Matrix, b: Matrix, r: float, i: int) -> Capsule:
    """Capsule i, of radius r m, for `_depth`: values common to all rays are computed once."""
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = eye[0] - a[i, 0], eye[1] - a[i, 1], eye[2] - a[i, 2]
    ee = e0 * e0 + e1 * e1 + e2 * e2
    ew = e0 * w0 + e1 * w1 + e2 * w2
    outside = w0 * w0 + w1 * w1 + w2 * w2 - r * r
    return Capsule(
        np.float32(e0), np.float32(e1), np.float32(e2),
        np.float32(w0), np.float32(w1), np.float32(w2),
        np.float32(ee), np.float32(ew), np.float32(1.0 / ee if ee > BALL else 0.0),
        np.float32(outside), np.float32(outside + ee - 2 * ew), np.float32(ee * outside - ew * ew),
    )  # fmt: skip


@kernel(fastmath=True, error_model="numpy", inline="always")
def _depth(capsule: Capsule, x: np.float32, y: np.float32) -> np.float32:
    """Depth z at which the ray eye + z (x, y, 1) enters a capsule, FAR if it misses.

    Separate from `tracker.geometry.solids.capsule_depth`, which requires the ray in the capsule's
    frame: for a million rays and a capsule given by its ends, the transformation takes longer.
    """
    e0, e1, e2, w0, w1, w2, ee, ew, per, outside, outside_b, beside = capsule
    zero, one = np.float32(0.0), np.float32(1.0)
    dd = x * x + y * y + one
    ed = e0 * x + e1 * y + e2
    dw = x * w0 + y * w1 + w2
    k2 = max(ee * dd - ed * ed, np.float32(1e-30))
    k1 = ee * dw - ew * ed
    h = k1 * k1 - k2 * beside  # of the infinite cylinder, which contains the capsule
    z = (-k1 - _root(max(h, zero))) / k2
    share = (ew + z * ed) * per
    is_far_end = share >= one
    is_side = (share > zero) & (share < one)
    dw = dw - ed if is_far_end else dw
    g = dw * dw - dd * (outside_b if is_far_end else outside)
    end = (-dw - _root(max(g, zero))) / dd
    z = z if is_side else end
    meets = (h >= zero) & (is_side | (g >= zero)) & (z > np.float32(NEAREST))
    return z if meets else np.float32(FAR)


@kernel(fastmath=True, error_model="numpy", inline="always")
def _root(x: np.float32) -> np.float32:
    """Square root with a relative error of 5e-6 by Newton's method, starting from half the
    logarithm in the float's exponent bits: LLVM does not vectorise its own."""
    bits = np.int32(0x5F3759DF) - (np.float32(x).view(np.int32) >> np.int32(1))
    y, half = np.int32(bits).view(np.float32), np.float32(0.5) * x
    y *= np.float32(1.5) - half * y * y
    y *= np.float32(1.5) - half * y * y
    return x * y


@kernel(fastmath=True, error_model="numpy", inline="always")
def _slab(eye: Vector, solids: Solids, i: int, k: int) -> Slab:
    """Box i along its axis k, for `_box`."""
    R, centre = solids.box_R, solids.centre
    n0, n1, n2 = R[i, 0, k], R[i, 1, k], R[i, 2, k]
    w0, w1, w2 = eye[0] - centre[i, 0], eye[1] - centre[i, 1], eye[2] - centre[i, 2]
    start, half = n0 * w0 + n1 * w1 + n2 * w2, solids.half[i, k]
    return Slab(np.float32(n0), np.float32(n1), np.float32(n2), np.float32(start), np.float32(half))


@kernel(fastmath=True, error_model="numpy", inline="always")
def _box(slabs: tuple[Slab, Slab, Slab], x: np.float32, y: np.float32) -> np.float32:
    """Depth z at which the ray eye + z (x, y, 1) enters a box, FAR if it misses (slab method).

    As `tracker.geometry.solids.box_span`, but only beyond the first centimetres.
    """
    low, high = np.float32(NEAREST), np.float32(FAR)
    low, high = _between(slabs[0], x, y, low, high)
    low, high = _between(slabs[1], x, y, low, high)
    low, high = _between(slabs[2], x, y, low, high)
    return low if low <= high else np.float32(FAR)


@kernel(fastmath=True, error_model="numpy", inline="always")
def _between(
    slab: Slab, x: np.float32, y: np.float32, low: np.float32, high: np.float32
) -> tuple[np.float32, np.float32]:
    """Restricts a ray's depths ``low`` to ``high`` to a slab."""
    step, least = slab.n0 * x + slab.n1 * y + slab.n2, np.float32(1e-9)
    step = least if abs(step) < least else step
    t0, t1 = (-slab.half - slab.start) / step, (slab.half - slab.start) / step
    return max(low, min(t0, t1)), min(high, max(t0, t1))
