"""Connected regions of one hue, grown from seed pixels by horizontal runs.

A seed is a pixel of a hue on a sparse grid; from it the whole 8-connected region is filled at full
resolution. A grid with a stride of 1 px is a full scan; a coarser one finds identical regions,
except for those too small to contain a seed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteMatrix,
    ByteStack,
    Int8Vector,
    Int32Matrix,
    IntVector,
    UInt16Vector,
    Vector,
    Written,
)
from tracker.vision.hue_table import HueTable, colour_class

RUN = 6
"""Columns of a run (n, RUN): row, first and last column, then the same of the run from which it was
reached."""
RAGGED, RAGGED_SPARE = 4, 24  # runs per row, plus a constant: the limit for a region
NO_ROW = -9  # row of the predecessor of a run without one


class Scan(NamedTuple):
    """An image (h, w, 3) being searched, and the pixels visited so far.

    ``visited`` (h, w) is ``mark`` where a region was found, and less elsewhere: a new number for
    each call avoids clearing the array. ``runs``: a `run_buffer` for regions of at most ``extent``
    px.
    """

    image: ByteStack
    table: HueTable
    visited: Written[ByteMatrix]
    mark: int
    runs: Written[Int32Matrix]
    extent: int


def run_buffer(extent: int) -> Int32Matrix:
    """Memory for the runs of one region of at most ``extent`` px, and for those to be tested
    next."""
    return np.empty(((extent + 4) * (extent // 2 + 4), RUN), np.int32)


@kernel(inline="always")
def _run(
    image: ByteStack,
    visited: Written[ByteMatrix],
    mark: int,
    y: int,
    x: int,
    hue: int,
    cells: UInt16Vector,
    patterns: Int8Vector,
) -> tuple[int, int]:
    """The run of ``hue`` around (x, y), marked as visited: first and last column.

    Inlined, as `colour_class` is: a call for each pixel would take six times as long.
    """
    first, last, right = x, x, image.shape[1] - 1
    visited[y, x] = mark
    while first > 0 and colour_class(image, y, first - 1, cells, patterns) == hue:
        first -= 1
        visited[y, first] = mark
    while last < right and colour_class(image, y, last + 1, cells, patterns) == hue:
        last += 1
        visited[y, last] = mark
    return first, last


@kernel
def fill(scan: Scan, y: int, x: int, hue: int) -> tuple[int, bool]:
    """Writes all runs of the 8-connected region around (x, y) to the scan's ``runs``.

    The list of runs also serves as the queue of those whose neighbours are not yet tested. A region
    longer than the extent or full of holes is background (such as a wall whose colour is at the
    limit of a hue, which flickers with the noise): the fill stops as soon as that is known and
    marks it mark + hue, and later regions that touch such a mark are part of it. Returns the number
    of runs, and whether the region is complete.
    """
    image, visited, mark, runs = scan.image, scan.visited, scan.mark, scan.runs
    cells, patterns, extent = scan.table.cells, scan.table.patterns, scan.extent
    height, width = image.shape[0], image.shape[1]
    # 1. the list starts with the seed's own run
    first, last = _run(image, visited, mark, y, x, hue, cells, patterns)
    runs[0, 0], runs[0, 1], runs[0, 2], runs[0, 3] = y, first, last, NO_ROW
    low, high, top, bottom = first, last, y, y
    n, done, whole = 1, 0, last - first <= extent
    while done < n and whole:
        # 2. the next run whose neighbours are not yet tested
        row, first, last = int(runs[done, 0]), int(runs[done, 1]), int(runs[done, 2])
        from_row, skip, after = int(runs[done, 3]), runs[done, 4] - 1, runs[done, 5] + 2
        done += 1
        end = min(last + 1, width - 1)
        for near in (row - 1, row + 1):
            # 3. runs of the hue that touch it in the rows above and below
            if near < 0 or near >= height:
                continue
            k = max(first - 1, 0)
            while k <= end:
                if near == from_row and skip <= k < after:  # known, and bounded by other hues
                    k = after
                    continue
                seen = visited[near, k]
                if seen < mark and colour_class(image, near, k, cells, patterns) == hue:
                    a, b = _run(image, visited, mark, near, k, hue, cells, patterns)
                    runs[n, 0], runs[n, 1], runs[n, 2] = near, a, b
                    runs[n, 3], runs[n, 4], runs[n, 5] = row, first, last
                    n += 1
                    low, high = min(low, a), max(high, b)
                    top, bottom = min(top, near), max(bottom, near)
                    k = b + 2
                elif seen == mark + hue:
                    whole = False
                    break
                else:
                    k += 1
        # 4. stop at background
        ragged = n > RAGGED * (bottom - top + 1) + RAGGED_SPARE
        whole = whole and not ragged and max(high - low, bottom - top) <= extent
    if not whole:
        for i in range(n):
            visited[runs[i, 0], runs[i, 1] : runs[i, 2] + 1] = mark + hue
    return n, whole


@kernel
def moments(runs: Int32Matrix) -> tuple[float, float, float, float, float, float]:
    """Area, centroid u and v, and central second moments uu, uv, vv (px²) of a region.

    Second moments include a pixel's own extent (1/12), so that they are those of the area.
    """
    u0, v0 = runs[0, 1], runs[0, 0]  # offsets to zero preserve precision
    area, su, sv, suu, suv, svv = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(len(runs)):
        a, b, v = float(runs[k, 1] - u0), float(runs[k, 2] - u0), float(runs[k, 0] - v0)
        n = b - a + 1.0
        line = n * (a + b) / 2.0
        area += n
        su += line
        sv += n * v
        suv += line * v
        svv += n * v * v
        # sum of squares from a to b: n mean² + n (n² - 1) / 12
        suu += line * line / n + n * (n * n - 1.0) / 12.0
    u, v = su / area, sv / area
    uu, vv = suu / area - u * u + 1.0 / 12.0, svv / area - v * v + 1.0 / 12.0
    return area, u + u0, v + v0, uu, suv / area - u * v, vv


@kernel
def bounds(runs: Int32Matrix) -> tuple[int, int, int, int]:
    """First and last column, first and last row."""
    top, left, right = runs[0, 0], runs[0, 1], runs[0, 2]
    bottom = top
    for k in range(1, len(runs)):
        top, bottom = min(top, runs[k, 0]), max(bottom, runs[k, 0])
        left, right = min(left, runs[k, 1]), max(right, runs[k, 2])
    return left, right, top, bottom


@kernel
def hull(runs: Int32Matrix, top: int, bottom: int) -> tuple[float, float]:
    """Number of pixels inside the convex hull of a region's pixel centres, and its perimeter (px).

    top and bottom are the region's first and last row.

    By Pick's theorem the hull contains area + boundary / 2 + 1 pixels, so that a digitally convex
    region has convexity 1 at any size. The perimeter is the hull's, plus π for the pixels' own
    extent.
    """
    rows = bottom - top + 1
    side = np.empty((2, rows), np.int64)
    side[0], side[1] = 1 << 30, -(1 << 30)
    for k in range(len(runs)):
        r = runs[k, 0] - top
        side[0, r], side[1, r] = min(side[0, r], runs[k, 1]), max(side[1, r], runs[k, 2])
    chain = np.empty(rows, np.int64)
    pixels = 1.0 + 0.5 * ((side[1, 0] - side[0, 0]) + (side[1, -1] - side[0, -1]))
    girth = float(side[1, 0] - side[0, 0] + side[1, -1] - side[0, -1]) + np.pi
    for s in range(2):
        sign = 2 * s - 1  # the left side is convex towards smaller columns
        n = _chain(side[s], sign, chain)
        for k in range(n - 1):
            r0, r1 = chain[k], chain[k + 1]
            x0, x1 = side[s, r0], side[s, r1]
            pixels += sign * 0.5 * (x0 + x1) * (r1 - r0) + 0.5 * _gcd(abs(x1 - x0), r1 - r0)
            girth += np.hypot(float(x1 - x0), float(r1 - r0))
    return pixels, girth


@kernel
def _chain(x: IntVector, sign: int, chain: Written[IntVector]) -> int:
    """Rows of the hull's vertices along one side, from top to bottom (Andrew's monotone chain)."""
    n = 0
    for r in range(len(x)):
        while n >= 2:
            a, b = chain[n - 2], chain[n - 1]
            if sign * ((x[b] - x[a]) * (r - a) - (x[r] - x[a]) * (b - a)) > 0:
                break
            n -= 1
        chain[n] = r
        n += 1
    return n


@kernel
def _gcd(a: int, b: int) -> int:
    if a == 0 or b == 1:  # most edges of a small hull; divisions are slow
        return b
    while b:
        a, b = b, a % b
    return a


@kernel
def axes(uu: float, uv: float, vv: float) -> tuple[float, float, float]:
    """Full lengths (px) of the ellipse with these second moments, and its long axis' angle."""
    mean, half = 0.5 * (uu + vv), np.hypot(0.5 * (uu - vv), uv)
    return (
        4.0 * np.sqrt(mean + half),
        4.0 * np.sqrt(max(mean - half, 0.0)),
        0.5 * np.arctan2(2.0 * uv, uu - vv),
    )


@kernel
def waist(runs: Int32Matrix, u: float, v: float, angle: float) -> tuple[float, float]:
    """The narrowest cross-section along a region's long axis.

    Returns the position along the axis (px from the centroid) and its width divided by the smaller
    of the maximum widths on either side; 1 where there is no waist.
    """
    c, s = np.cos(angle), np.sin(angle)
    reach = 0.0
    for k in range(len(runs)):
        for x in (runs[k, 1], runs[k, 2]):
            reach = max(reach, abs((x - u) * c + (runs[k, 0] - v) * s))
    half = int(reach) + 2
    width = np.zeros(2 * half + 1)
    for k in range(len(runs)):
        for x in range(runs[k, 1], runs[k, 2] + 1):
            t = (x - u) * c + (runs[k, 0] - v) * s + half
            i = int(t)
            width[i] += 1.0 - (t - i)  # distributed over two bins, or aliasing would create waists
            width[i + 1] += t - i
    return _narrowest(width, half)


@kernel
def _narrowest(width: Vector, half: int) -> tuple[float, float]:
    n = len(width)
    smooth = np.zeros(n)
    for i in range(1, n - 1):
        smooth[i] = 0.25 * width[i - 1] + 0.5 * width[i] + 0.25 * width[i + 1]
    after = np.zeros(n)  # maximum width from the next bin on
    for i in range(n - 2, -1, -1):
        after[i] = max(after[i + 1], smooth[i + 1])
    position, ratio, before = 0.0, 1.0, smooth[0]
    for i in range(1, n - n // 5):
        widest = min(before, after[i])
        if i >= n // 5 and widest > 0.0 and smooth[i] / widest < ratio:
            position, ratio = float(i - half), smooth[i] / widest
        before = max(before, smooth[i])
    return position, ratio


@kernel
def cut(
    runs: Int32Matrix, u: float, v: float, angle: float, position: float
) -> tuple[Int32Matrix, int]:
    """Runs divided by the line across the long axis at ``position``: first those before it.

    Returns the runs and the number of those before the line.
    """
    c, s = np.cos(angle), np.sin(angle)
    out = np.empty((2 * len(runs), RUN), np.int32)
    n, before = 0, 0
    for side in range(2):
        for k in range(len(runs)):
            first = -1
            for x in range(runs[k, 1], runs[k, 2] + 2):
                t = (x - u) * c + (runs[k, 0] - v) * s
                inside = x <= runs[k, 2] and (t < position) == (side == 0)
                if inside and first < 0:
                    first = x
                elif not inside and first >= 0:
                    out[n, 0], out[n, 1], out[n, 2] = runs[k, 0], first, x - 1
                    n += 1
                    break
        if side == 0:
            before = n
    return out[:n], before
