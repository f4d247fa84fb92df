"""Shape tests for regions, and the image windows to search; compiled."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Vector
from tracker.vision import search

SIZE, CONVEXITY, CIRCULARITY, EDGE, CONTRAST, CLOTH = range(6)
SQUARE_CIRCULARITY = np.pi / 4


class RegionLimits(NamedTuple):
    """Limits of a marker's region: minimum and maximum long axis, px, and relative to the expected
    size; minimum convexity, circularity, contrast to the surroundings and share of the glove's
    cloth in them."""

    shortest: float
    longest: float
    least_ratio: float
    greatest_ratio: float
    convexity: float
    circularity: float
    contrast: float
    cloth: float


class ExpectedBlobs(NamedTuple):
    """Predicted markers: uv (k, 2) px, radius (k,) px within which one certainly is, hue (k,) and
    size (k,) px."""

    uv: Matrix
    radius: Vector
    hue: IntVector
    size: Vector


class Sorted(NamedTuple):
    """Regions that pass all tests: uv (n, 2), size (n, 2) px, hue (n,) and score (n,) in 0..1; the
    others: uv (m, 2) px, hue (m,) and reason (m,)."""

    uv: Matrix
    size: Matrix
    hue: IntVector
    score: Vector
    other_uv: Matrix
    other_hue: IntVector
    reason: IntVector


@kernel(nogil=False)
def first_failure(rows: Matrix, limits: RegionLimits, expected: ExpectedBlobs) -> IntVector:
    """(n,) the first test that each region of rows (n, COLUMNS) fails, -1 for none.

    Where markers of a region's hue are predicted, it must also match one of their sizes.
    """
    out = np.full(len(rows), -1, np.int64)
    for i in range(len(rows)):
        long_axis = rows[i, search.MAJOR]
        fits = limits.shortest <= long_axis <= limits.longest
        if not fits or not _suits(rows[i], limits, expected):
            out[i] = SIZE
        elif rows[i, search.CONVEXITY] < limits.convexity:
            out[i] = CONVEXITY
        elif rows[i, search.CIRCULARITY] < limits.circularity:
            out[i] = CIRCULARITY
        elif rows[i, search.EDGE] > 0:
            out[i] = EDGE
        elif rows[i, search.CONTRAST] < limits.contrast:
            out[i] = CONTRAST
        elif rows[i, search.CLOTH_SHARE] < limits.cloth:
            out[i] = CLOTH
    return out


@kernel
def _suits(row: Vector, limits: RegionLimits, expected: ExpectedBlobs) -> bool:
    """Whether a marker predicted here has this size, or none is predicted here."""
    near = False
    for k in range(len(expected.size)):
        if expected.hue[k] != row[search.HUE]:
            continue
        du, dv = row[search.U] - expected.uv[k, 0], row[search.V] - expected.uv[k, 1]
        if np.hypot(du, dv) <= expected.radius[k]:
            ratio = row[search.MAJOR] / expected.size[k]
            if limits.least_ratio <= ratio <= limits.greatest_ratio:
                return True
            near = True
    return not near


@kernel(nogil=False)
def parted(
    rows: Matrix, reason: IntVector
) -> tuple[Matrix, Matrix, IntVector, Vector, Matrix, IntVector, IntVector]:
    """The members of `Sorted`: regions (n, COLUMNS) by the result of `first_failure`."""
    n, m = 0, 0
    for i in range(len(rows)):
        n += reason[i] < 0
    uv, size = np.empty((n, 2)), np.empty((n, 2))
    hue, score = np.empty(n, np.int64), np.empty(n)
    other_uv = np.empty((len(rows) - n, 2))
    other_hue = np.empty(len(rows) - n, np.int64)
    why = np.empty(len(rows) - n, np.int64)
    n = 0
    for i in range(len(rows)):
        if reason[i] < 0:
            roundness = min(rows[i, search.CIRCULARITY] / SQUARE_CIRCULARITY, 1.0)
            uv[n, 0], uv[n, 1] = rows[i, search.U], rows[i, search.V]
            size[n, 0], size[n, 1] = rows[i, search.WIDTH], rows[i, search.HEIGHT]
            hue[n] = int(rows[i, search.HUE])
            score[n] = min(rows[i, search.CONVEXITY] * roundness, 1.0)
            n += 1
        else:
            other_uv[m, 0], other_uv[m, 1] = rows[i, search.U], rows[i, search.V]
            other_hue[m], why[m] = int(rows[i, search.HUE]), reason[i]
            m += 1
    return uv, size, hue, score, other_uv, other_hue, why


@kernel(nogil=False)
def windows_around(uv: Matrix, radius: Vector, width: int, height: int, stride: int) -> IntMatrix:
    """(k, 5) first and last column, first and last row, stride: squares clipped to the image.

    Positions that are not finite, or whose square lies outside, have no row. Where the squares
    overlap so much that one rectangle around all is smaller, it replaces them.
    """
    out = np.empty((len(uv), 5), np.int64)
    n, area = 0, 0
    for k in range(len(uv)):
        if not np.isfinite(uv[k, 0] + uv[k, 1] + radius[k]):
            continue
        left, top = np.floor(uv[k, 0] - radius[k]), np.floor(uv[k, 1] - radius[k])
        right, bottom = np.ceil(uv[k, 0] + radius[k]), np.ceil(uv[k, 1] + radius[k])
        if right < 0 or bottom < 0 or left > width - 1 or top > height - 1:
            continue
        out[n, 0], out[n, 1] = max(left, 0.0), min(right, width - 1.0)
        out[n, 2], out[n, 3] = max(top, 0.0), min(bottom, height - 1.0)
        out[n, 4] = stride
        area += (out[n, 1] - out[n, 0] + 1) * (out[n, 3] - out[n, 2] + 1)
        n += 1
    if n == 0:
        return out[:0]
    left, right = out[:n, 0].min(), out[:n, 1].max()
    top, bottom = out[:n, 2].min(), out[:n, 3].max()
    if (right - left + 1) * (bottom - top + 1) <= area:
        out[0, 0], out[0, 1], out[0, 2], out[0, 3] = left, right, top, bottom
        n = 1
    return out[:n]
