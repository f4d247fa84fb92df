"""Colour of each pixel: cloth, marker patches wrapped on it, light from one side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.messages import Array, IntArray
from tracker.simulation.raster import Float32, Int16


@kernel(fastmath=True)
def shade(
    rays: Float32,
    jitter: Array,
    eye: Array,
    corner: IntArray,
    depth: Float32,
    ident: Int16,
    a: Array,
    b: Array,
    radius: Array,
    box_R: Array,
    centre: Array,
    half: Array,
    owner: IntArray,
    colour: Array,
    R_CB: Array,
    p_CB: Array,
    first: IntArray,
    marker: Array,
    axes: Array,
    size: Array,
    shape: IntArray,
    flat: IntArray,
    fabric: Array,
    light: Array,
    ambient: float,
    ground: NDArray[np.uint8],
    total: Float32,
) -> None:
    """Add one exposure to ``total`` (h, w, 3) BGR; ``ground`` (h, w, 3) shows where nothing is.

    Solids' arrays as in `Solids`; owner and colour are those of the capsules, then of the boxes.
    Arrays are handed on whole with a row's number: a view of a row costs more than the arithmetic.
    Markers are sorted by segment, those of segment s being first[s] to first[s + 1]; axes (M, 3, 3)
    rows: along, across and out of a flat patch in B; fabric (M, 3) BGR. light (3,) is a
    unit vector in C towards the light.
    """
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
            q[0] = eye[0] + z * (rays[v, u, 0] + jitter[0])
            q[1] = eye[1] + z * (rays[v, u, 1] + jitter[1])
            q[2] = eye[2] + z
            if i < len(radius):
                _capsule_normal(q, a, b, radius, i, n)
            else:
                _box_normal(q, box_R, centre, half, i - len(radius), n)
            bright = ambient + (1 - ambient) * max(
                n[0] * light[0] + n[1] * light[1] + n[2] * light[2], 0.0
            )
            m = -1
            s = owner[i]
            if s >= 0:
                m = _patch_at(q, R_CB, p_CB, s, first, marker, axes, size, shape, flat)
            for c in range(3):
                base = fabric[m, c] if m >= 0 else colour[i, c]
                total[row, column, c] += base * bright


@kernel(fastmath=True, inline="always")
def _capsule_normal(q: Array, a: Array, b: Array, radius: Array, i: int, n: Array) -> None:
    """Outward normal at the point q of capsule i."""
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = q[0] - a[i, 0], q[1] - a[i, 1], q[2] - a[i, 2]
    ee = max(e0 * e0 + e1 * e1 + e2 * e2, 1e-12)
    share = min(max((e0 * w0 + e1 * w1 + e2 * w2) / ee, 0.0), 1.0)
    n[0] = (w0 - share * e0) / radius[i]
    n[1] = (w1 - share * e1) / radius[i]
    n[2] = (w2 - share * e2) / radius[i]


@kernel(fastmath=True, inline="always")
def _box_normal(q: Array, R: Array, centre: Array, half: Array, i: int, n: Array) -> None:
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
def _patch_at(
    q: Array,
    R: Array,
    p: Array,
    i: int,
    first: IntArray,
    marker: Array,
    axes: Array,
    size: Array,
    shape: IntArray,
    flat: IntArray,
) -> int:
    """The marker whose patch covers the surface point q of segment i, -1 if none."""
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
    total: Float32,
    exposures: int,
    noise: Float32,
    shift: IntArray,
    out: NDArray[np.uint8],
) -> None:
    """Mean of the exposures plus sensor noise, rounded into ``out`` (h, w, 3) uint8.

    noise (n, m, 3) is a tile of unit scale already multiplied; shift (2,) is where in it to begin.
    """
    rows, columns = noise.shape[0], noise.shape[1]
    share = np.float32(1.0 / exposures)
    for v in range(out.shape[0]):
        row = (v + shift[0]) % rows
        column = shift[1] % columns
        for u in range(out.shape[1]):
            for c in range(3):
                value = total[v, u, c] * share + noise[row, column, c] + np.float32(0.5)
                out[v, u, c] = np.uint8(min(max(value, np.float32(0.0)), np.float32(255.0)))
            column += 1
            if column == columns:
                column = 0
