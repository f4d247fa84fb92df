"""Which solid each pixel shows: a depth buffer filled by rays, one solid after another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.messages import Array, IntArray
from tracker.simulation.solids import Solids

Float32 = NDArray[np.float32]
Int16 = NDArray[np.int16]
FAR = 1e6


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
def draw(
    rays: Float32,
    jitter: Array,
    eye: Array,
    pixels: IntArray,
    corner: IntArray,
    a: Array,
    b: Array,
    radius: Array,
    box_R: Array,
    centre: Array,
    half: Array,
    depth: Float32,
    ident: Int16,
) -> None:
    """Fill ``depth`` (h, w) m and ``ident`` (h, w) of a region whose corner is (v0, u0).

    rays (H, W, 2): x/z and y/z of each pixel of the whole image; pixels (P + Q, 4): u0, v0, u1, v1
    of each solid, the upper ones excluded. ident is the solid's row, capsules first, -1: nothing.
    """
    depth[:] = FAR
    ident[:] = -1
    capsules = len(radius)
    for i in range(len(pixels)):
        for v in range(pixels[i, 1], pixels[i, 3]):
            for u in range(pixels[i, 0], pixels[i, 2]):
                x, y = rays[v, u, 0] + jitter[0], rays[v, u, 1] + jitter[1]
                if i < capsules:
                    z = _capsule(eye, x, y, a, b, radius, i)
                else:
                    k = i - capsules
                    z = _box(eye, x, y, box_R, centre, half, k)
                row, column = v - corner[0], u - corner[1]
                if z < depth[row, column]:
                    depth[row, column] = z
                    ident[row, column] = i


@kernel(fastmath=True, inline="always")
def _capsule(eye: Array, x: float, y: float, a: Array, b: Array, radius: Array, i: int) -> float:
    """Depth z at which the ray eye + z (x, y, 1) enters capsule i, FAR if it misses."""
    r = radius[i]
    dd = x * x + y * y + 1.0
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = eye[0] - a[i, 0], eye[1] - a[i, 1], eye[2] - a[i, 2]
    ee = e0 * e0 + e1 * e1 + e2 * e2
    ed = e0 * x + e1 * y + e2
    ew = e0 * w0 + e1 * w1 + e2 * w2
    dw = x * w0 + y * w1 + w2
    ww = w0 * w0 + w1 * w1 + w2 * w2
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
def _box(eye: Array, x: float, y: float, R: Array, centre: Array, half: Array, i: int) -> float:
    """Depth z at which the ray eye + z (x, y, 1) enters box i, FAR if it misses (slab method)."""
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
