"""The detector's inner loop: seeds on a grid, regions, and the measurements of each region."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    Int8Vector,
    Int32Matrix,
    IntMatrix,
    IntVector,
    Matrix,
    UInt16Vector,
    Vector,
    Written,
)
from tracker.vision.components import Scan, axes, bounds, cut, fill, hull, moments, waist
from tracker.vision.hue_table import CLOTH, colour_class, is_vivid

# Columns of a measurement row.
HUE, U, V, AREA, MAJOR, MINOR, CONVEXITY, CIRCULARITY, WIDTH, HEIGHT, EDGE = range(11)
CONTRAST, CLOTH_SHARE = 11, 12
COLUMNS = 13
RIM_PX = 2  # from a region to the sampled surroundings

WORD = 8  # bytes

SPLIT_ELONGATION = 1.45  # long over short axis, above which a region may be two blobs
SPLIT_WAIST = 0.70  # width of the waist over that of the narrower half
SPLIT_THICKNESS = 5.0  # px; pixel noise creates waists in thinner regions
NO_WAIST = 0.98  # convexity above which there is no waist; two discs with one have 0.956
SPLIT_CONVEXITY = 0.88  # of each half


@kernel(wide=True)
def find_regions(scan: Scan, windows: IntMatrix, min_area: float) -> Matrix:
    """Measurements (n, COLUMNS) of all regions that contain a seed, in the order of the seeds.

    windows (k, 5): first and last column, first and last row, and the grid's stride. Regions below
    ``min_area`` px², and background as classified by `fill`, give no row. A seed must lie in a
    square of 2 x 2 px of its hue: noise on a colour at the limit of a hue produces specks and
    threads by the hundred, and filling each would take as long as all markers. Every other row of
    the grid is shifted by half a stride.
    """
    image, visited, mark, runs = scan.image, scan.visited, scan.mark, scan.runs
    cells, patterns, vivid = scan.table.cells, scan.table.patterns, scan.table.vivid
    out = np.empty((64, COLUMNS))
    line = np.zeros(image.shape[1] // WORD + 1, np.int64)
    flags = np.zeros(3 * (len(line) + 1), np.int64)
    n = 0
    for k in range(len(windows)):
        stride = windows[k, 4]
        for y in range(windows[k, 2], windows[k, 3] + 1, stride):
            # 1. the class of each seed of the row
            first = windows[k, 0] + (y // stride % 2) * (stride // 2)
            if vivid and stride == 1:
                seeds = _classify_vivid(
                    image, y, first, windows[k, 1], cells, patterns, flags, line
                )
            else:
                seeds = _classify(image, y, first, windows[k, 1], stride, cells, patterns, line)
            for word in range((seeds + WORD - 1) // WORD):
                # 2. words of eight seeds of which at least one has a hue
                if line[word] == 0:
                    continue
                for seed in range(word * WORD, min((word + 1) * WORD, seeds)):
                    x = first + seed * stride
                    hue = int(line.view(np.int8)[seed])
                    if hue <= 0 or visited[y, x] >= mark:
                        continue
                    # 3. the region, unless it is a thread or background
                    if not _is_broad(image, y, x, hue, cells, patterns):
                        continue
                    used, whole = fill(scan, y, x, hue)
                    if not whole:
                        continue
                    # 4. its measurements, as one blob or two
                    if n + 2 > len(out):
                        out = np.concatenate((out, np.empty_like(out)))
                    n += _measure_parts(scan, runs[:used], hue, min_area, out[n : n + 2])
    return out[:n]


@kernel
def _is_broad(
    image: ByteStack, y: int, x: int, hue: int, cells: UInt16Vector, patterns: Int8Vector
) -> np.bool_:
    """Whether (x, y) is in a square of 2 x 2 px of ``hue``, or at the image's edge.

    The neighbours are tested without a branch, which noise would make unpredictable.
    """
    if y < 1 or x < 1 or y > image.shape[0] - 2 or x > image.shape[1] - 2:
        return np.bool_(True)
    square: np.bool_ = np.bool_(False)
    for v in (y - 1, y + 1):
        middle = colour_class(image, v, x, cells, patterns) == hue
        for u in (x - 1, x + 1):
            beside = colour_class(image, y, u, cells, patterns) == hue
            square |= middle & beside & (colour_class(image, v, u, cells, patterns) == hue)
    return square


@kernel
def _classify(
    image: ByteStack,
    y: int,
    first: int,
    last: int,
    stride: int,
    cells: UInt16Vector,
    patterns: Int8Vector,
    line: Written[IntVector],
) -> int:
    """Writes `colour_class` of every ``stride``-th pixel of a row, a byte each, to ``line``.

    Bytes are written without a branch and tested eight at a time, since most are zero; the
    remainder of the last word is zero. Returns the number of pixels.
    """
    count = (last - first) // stride + 1
    if count <= 0:
        return 0
    line[(count - 1) // WORD] = 0
    classes = line.view(np.int8)
    for k in range(count):
        classes[np.uintp(k)] = colour_class(image, y, first + k * stride, cells, patterns)
    return count


@kernel
def _classify_vivid(
    image: ByteStack,
    y: int,
    first: int,
    last: int,
    cells: UInt16Vector,
    patterns: Int8Vector,
    flags: Written[IntVector],
    line: Written[IntVector],
) -> int:
    """The same for every pixel; greys are rejected first, since most pixels are grey.

    For vector instructions, every byte of the row is treated as the first byte of a pixel;
    ``flags`` receives one flag per byte, three words for eight pixels. If any flag is set, all
    eight pixels are looked up: testing each would cause too many branch mispredictions on coloured
    backgrounds.
    """
    count = last - first + 1
    if count <= 0:
        return 0
    row = image[y].ravel()[3 * first : 3 * last + 3]
    vivid, classes = flags.view(np.uint8), line.view(np.int8)
    flags[3 * ((count - 1) // WORD) : 3 * ((count - 1) // WORD) + 3] = 0
    for i in range(len(row) - 2):
        vivid[i] = is_vivid(row[i], row[i + 1], row[i + 2])
    for word in range((count + WORD - 1) // WORD):
        line[word] = 0
        if flags[3 * word] | flags[3 * word + 1] | flags[3 * word + 2]:
            for k in range(word * WORD, min((word + 1) * WORD, count)):
                classes[k] = colour_class(image, y, first + k, cells, patterns)
    return count


@kernel
def _measure_parts(
    scan: Scan, runs: Int32Matrix, hue: int, min_area: float, rows: Written[Matrix]
) -> int:
    """Measure a region as one blob, or as two if it has a waist; returns the number of blobs."""
    if not _measure(scan, runs, hue, min_area, rows[0]):
        return 0
    if rows[0, MAJOR] < SPLIT_ELONGATION * rows[0, MINOR] or rows[0, MINOR] < SPLIT_THICKNESS:
        return 1
    if rows[0, CONVEXITY] > NO_WAIST:
        return 1
    _, u, v, uu, uv, vv = moments(runs)
    angle = axes(uu, uv, vv)[2]
    position, ratio = waist(runs, u, v, angle)
    if ratio > SPLIT_WAIST:
        return 1
    parts, before = cut(runs, u, v, angle, position)
    halves = np.empty((2, COLUMNS))
    for i, part in enumerate((parts[:before], parts[before:])):
        if len(part) == 0 or not _measure(scan, part, hue, min_area, halves[i]):
            return 1
        if halves[i, CONVEXITY] < SPLIT_CONVEXITY:
            return 1
    rows[:] = halves
    return 2


@kernel
def _measure(
    scan: Scan, runs: Int32Matrix, hue: int, min_area: float, row: Written[Vector]
) -> bool:
    """Fill one row; False where the region is too small."""
    area, u, v, uu, uv, vv = moments(runs)
    if area < min_area:
        return False
    shape = scan.image.shape
    left, right, top, bottom = bounds(runs)
    pixels, girth = hull(runs, top, bottom)
    major, minor, _ = axes(uu, uv, vv)
    row[HUE], row[U], row[V], row[AREA] = hue - 1, u, v, area
    row[MAJOR], row[MINOR] = major, minor
    row[CONVEXITY] = area / pixels
    row[CIRCULARITY] = min(4.0 * np.pi * area / (girth * girth), 1.0)
    row[WIDTH], row[HEIGHT] = right - left + 1, bottom - top + 1
    edge = left == 0 or top == 0 or right == shape[1] - 1 or bottom == shape[0] - 1
    row[EDGE] = 1.0 if edge else 0.0
    row[CONTRAST], row[CLOTH_SHARE] = _surroundings(scan, runs, top, bottom)
    return True


@kernel
def _surroundings(scan: Scan, runs: Int32Matrix, top: int, bottom: int) -> tuple[float, float]:
    """Contrast of a region's mean colour to its surroundings (largest difference of a channel over
    the region's brightest channel), and the share of the glove's cloth in them.

    The surroundings are the pixels `RIM_PX` left and right of each of its rows, above and below it.
    """
    image, cells, patterns = scan.image, scan.table.cells, scan.table.patterns
    rows = bottom - top + 1
    first, last = np.full(rows, image.shape[1]), np.full(rows, -1)
    inside, rim = np.zeros(3), np.zeros(3)
    area, around, cloth = 0, 0, 0
    for k in range(len(runs)):
        y, a, b = int(runs[k, 0]), int(runs[k, 1]), int(runs[k, 2])
        first[y - top], last[y - top] = min(first[y - top], a), max(last[y - top], b)
        area += b - a + 1
        for x in range(a, b + 1):
            for c in range(3):
                inside[c] += image[y, x, c]
    for row in range(-RIM_PX, rows + RIM_PX):
        near = min(max(row, 0), rows - 1)
        y, a, b = top + row, first[near] - RIM_PX, last[near] + RIM_PX
        if y < 0 or y >= image.shape[0]:
            continue
        step = max(b - a, 1) if 0 <= row < rows else 1
        for x in range(a, b + 1, step):
            if 0 <= x < image.shape[1] and (0 <= row < rows or row in (-RIM_PX, rows + RIM_PX - 1)):
                around += 1
                cloth += colour_class(image, y, x, cells, patterns) == CLOTH
                for c in range(3):
                    rim[c] += image[y, x, c]
    if around == 0:
        return 0.0, 0.0
    inside /= area
    rim /= around
    return np.abs(inside - rim).max() / max(inside.max(), 1.0), cloth / around
