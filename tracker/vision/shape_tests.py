"""Which regions have the shape of a marker, and where to look for one; compiled."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.messages import Array, IntArray
from tracker.vision import search

SIZE, CONVEXITY, CIRCULARITY, EDGE = range(4)
SQUARE_CIRCULARITY = np.pi / 4


@kernel
def first_failure(
    rows: Array,
    extent: tuple[float, float],
    size: tuple[float, float],
    convexity: float,
    circularity: float,
    hint_uv: Array,
    hint_radius: Array,
    hint_hue: IntArray,
    hint_size: Array,
) -> IntArray:
    """(n,) the first requirement that each region of rows (n, COLUMNS) fails, -1 for none.

    extent: long axis (px) of a marker at the farthest and the nearest place; size: limits of the
    ratio to it. Where hints (k,) expect markers of that hue within a radius (px), one of their
    sizes must suit as well.
    """
    out = np.full(len(rows), -1, np.int64)
    for i in range(len(rows)):
        long_axis = rows[i, search.MAJOR]
        low, high = size[0] * extent[0], size[1] * extent[1]
        if not low <= long_axis <= high or not _suits(
            rows[i], size, hint_uv, hint_radius, hint_hue, hint_size
        ):
            out[i] = SIZE
        elif rows[i, search.CONVEXITY] < convexity:
            out[i] = CONVEXITY
        elif rows[i, search.CIRCULARITY] < circularity:
            out[i] = CIRCULARITY
        elif rows[i, search.EDGE] > 0:
            out[i] = EDGE
    return out


@kernel
def _suits(
    row: Array,
    size: tuple[float, float],
    hint_uv: Array,
    hint_radius: Array,
    hint_hue: IntArray,
    hint_size: Array,
) -> bool:
    """Whether a marker expected here has this size, or none is expected here."""
    expected = False
    for k in range(len(hint_size)):
        if hint_hue[k] != row[search.HUE]:
            continue
        du, dv = row[search.U] - hint_uv[k, 0], row[search.V] - hint_uv[k, 1]
        if np.hypot(du, dv) <= hint_radius[k]:
            if size[0] <= row[search.MAJOR] / hint_size[k] <= size[1]:
                return True
            expected = True
    return not expected


@kernel
def parted(  # type: ignore[no-untyped-def]
    rows: Array, reason: IntArray
):
    """Of the regions that failed nothing: uv (n, 2), size (n, 2), hue (n,) and score (n,) in 0..1;
    of the others uv (m, 2), hue (m,) and reason (m,)."""
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


@kernel
def windows_around(uv: Array, radius: Array, width: int, height: int, stride: int) -> IntArray:
    """(k, 5) first and last column, first and last row, stride: squares cut to the image.

    Places that are not finite, or whose square lies outside, have no row. Where the squares overlap
    so much that one rectangle around all is smaller, it takes their place.
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
