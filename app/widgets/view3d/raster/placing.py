"""Bodies brought before the camera: their frames S in C, their lines in the image."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.messages import Array

NEAR = 0.01
"""m before the camera within which nothing is drawn."""


@kernel(error_model="numpy")
def place(R_GB: Array, p_GB: Array, R_BS: Array, p_BS: Array, R_GC: Array, p_GC: Array) -> Array:
    """(13,) of a solid: R_CS (9), the camera in S (3), its size; size 0 where it has no pose.

    R_GB (3, 3) is a rotation times a size, which what lies in B and S is to be multiplied with.
    """
    out = np.zeros(13)
    size = np.sqrt(R_GB[0, 0] ** 2 + R_GB[1, 0] ** 2 + R_GB[2, 0] ** 2)
    if not (np.isfinite(R_GB).all() and np.isfinite(p_GB).all() and size > 0.0):
        return out
    for i in range(3):
        for j in range(3):
            for k in range(3):
                for m in range(3):
                    out[3 * i + j] += R_GC[k, i] * R_GB[k, m] * R_BS[m, j] / size
    for k in range(3):
        away = p_GC[k] - p_GB[k]
        for m in range(3):
            away -= R_GB[k, m] * p_BS[m]
        for j in range(3):
            column = R_GB[k, 0] * R_BS[0, j] + R_GB[k, 1] * R_BS[1, j] + R_GB[k, 2] * R_BS[2, j]
            out[9 + j] += column / size * away
    out[12] = size
    return out


@kernel(error_model="numpy")
def project_line(
    a_G: Array, b_G: Array, R_GC: Array, p_GC: Array, focal: float, cx: float, cy: float, out: Array
) -> None:
    """A line's ends into ``out`` (6,): u, v px and 1/z of each; NaN where none of it is ahead."""
    out[:] = np.nan
    a, b = np.zeros(3), np.zeros(3)
    for j in range(3):
        for k in range(3):
            a[j] += R_GC[k, j] * (a_G[k] - p_GC[k])
            b[j] += R_GC[k, j] * (b_G[k] - p_GC[k])
    if not (np.isfinite(a).all() and np.isfinite(b).all()) or max(a[2], b[2]) <= NEAR:
        return
    if a[2] < NEAR:
        a += (b - a) * (NEAR - a[2]) / (b[2] - a[2])
    elif b[2] < NEAR:
        b += (a - b) * (NEAR - b[2]) / (a[2] - b[2])
    out[0], out[1], out[2] = cx + focal * a[0] / a[2], cy + focal * a[1] / a[2], 1 / a[2]
    out[3], out[4], out[5] = cx + focal * b[0] / b[2], cy + focal * b[1] / b[2], 1 / b[2]
