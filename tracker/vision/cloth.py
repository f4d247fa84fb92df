"""The glove's own cloth in an image, around the blobs, from which outlines of the hand are found.

A map of every second pixel, in tiles of 8 by 8 samples that are a 64-bit number each: a few hundred
numbers per image, which can be stored like blobs. A second map has one bit of the cloth's texture
per sample, which tells how far away it is (`tracker.vision.cloth_depth`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteMatrix,
    ByteStack,
    Int8Vector,
    Int32Matrix,
    Int32Vector,
    IntMatrix,
    IntVector,
    Matrix,
    UInt16Vector,
    Written,
)
from tracker.messages import Blobs, Cloth
from tracker.vision.hue_table import HueTable, colour_class

SIDE, STEP = 8, 2  # samples along a tile, and px between two samples
TILE = SIDE * STEP  # px
CHANNELS = 3
NOTHING, OUTSIDE, INSIDE = 0, 1, 2  # classes of a pixel
AROUND = 5  # samples on each side of one, whose mean brightness it is compared with
ONE_BITS = 20
ONE = 1 << ONE_BITS  # counts a sample in a sum of up to 121 brightnesses
REACH = 4.0  # times a blob's longer side: the distance from a thumb's last marker to its tip


class ClothMap(NamedTuple):
    """`Cloth` as an image: bits and known (rows, columns), 0 where unknown; bright (rows, columns)
    bits, or (0, columns)."""

    bits: IntMatrix
    known: ByteMatrix
    bright: IntMatrix


@kernel
def brightness_at(cloth: ClothMap, u: float, v: float) -> int:
    """1 where a pixel of the cloth is brighter than the cloth around it, -1 where not; 0 where none
    is known."""
    x, y = int(np.floor(u + 0.5)), int(np.floor(v + 0.5))
    j, i = y // TILE, x // TILE
    if j < 0 or i < 0 or j >= cloth.bright.shape[0] or i >= cloth.bright.shape[1]:
        return 0
    bit = np.int64((y % TILE) // STEP * (TILE // STEP) + (x % TILE) // STEP)
    if ((cloth.bits[j, i] >> bit) & 1) == 0:
        return 0
    return 1 if (cloth.bright[j, i] >> bit) & 1 else -1


@kernel
def cloth_at(cloth: ClothMap, u: float, v: float) -> int:
    """`INSIDE` where the pixel has the glove's colours, `OUTSIDE` where not, `NOTHING` if
    unknown."""
    x, y = int(np.floor(u + 0.5)), int(np.floor(v + 0.5))
    j, i = y // TILE, x // TILE
    if j < 0 or i < 0 or j >= cloth.known.shape[0] or i >= cloth.known.shape[1]:
        return NOTHING
    if cloth.known[j, i] == 0:
        return NOTHING
    bit = (y % TILE) // STEP * (TILE // STEP) + (x % TILE) // STEP
    return INSIDE if (cloth.bits[j, i] >> np.int64(bit)) & 1 else OUTSIDE


def cloth_around(image: NDArray[np.uint8], table: HueTable, blobs: Blobs) -> Cloth:
    """The cloth in a BGR image (h, w, 3), within `REACH` of its blobs."""
    rows, columns = image.shape[0] // TILE, image.shape[1] // TILE
    wanted = np.zeros((rows, columns), np.uint8)
    mark_tiles(wanted, blobs.uv, blobs.size)
    tile, bits = cloth_tiles(image, wanted, table.cells, table.patterns)
    return Cloth(columns, rows, tile, bits, brightness_tiles(image, tile, bits, (rows, columns)))


def cloth_map(cloth: Cloth) -> ClothMap:
    """Converts to a form that can be indexed by pixels."""
    bits = np.zeros((cloth.rows, cloth.columns), np.int64)
    known = np.zeros((cloth.rows, cloth.columns), np.uint8)
    bits.reshape(-1)[cloth.tile] = cloth.bits
    known.reshape(-1)[cloth.tile] = 1
    bright = np.zeros((0 if cloth.bright is None else cloth.rows, cloth.columns), np.int64)
    if cloth.bright is not None:
        bright.reshape(-1)[cloth.tile] = cloth.bright
    return ClothMap(bits, known, bright)


@kernel
def mark_tiles(wanted: Written[ByteMatrix], uv: Matrix, size: Matrix) -> None:
    """Sets 1 for the tiles within `REACH` of blobs uv, size (n, 2) px."""
    rows, columns = wanted.shape
    for k in range(len(uv)):
        reach = REACH * max(size[k, 0], size[k, 1]) / TILE
        x, y = uv[k, 0] / TILE - 0.5, uv[k, 1] / TILE - 0.5  # relative to the tiles' centres
        for j in range(max(int(y - reach), 0), min(int(y + reach) + 2, rows)):
            for i in range(max(int(x - reach), 0), min(int(x + reach) + 2, columns)):
                if (j - y) ** 2 + (i - x) ** 2 <= reach**2:
                    wanted[j, i] = 1


@kernel
def cloth_tiles(
    image: ByteStack, wanted: ByteMatrix, cells: UInt16Vector, patterns: Int8Vector
) -> tuple[IntVector, IntVector]:
    """tile and bits (n,) of a `Cloth`, for the tiles that are 1 in ``wanted`` (rows, columns)."""
    rows, columns = wanted.shape
    tile, bits = np.empty(rows * columns, np.int64), np.empty(rows * columns, np.int64)
    n = 0
    for j in range(rows):
        for i in range(columns):
            if wanted[j, i] == 0:
                continue
            word = np.int64(0)
            for y in range(SIDE):
                for x in range(SIDE):
                    v, u = TILE * j + STEP * y, TILE * i + STEP * x
                    worn = colour_class(image, v, u, cells, patterns) != 0
                    word |= np.int64(worn) << np.int64(SIDE * y + x)
            tile[n], bits[n] = columns * j + i, word
            n += 1
    return tile[:n].copy(), bits[:n].copy()


@kernel(wide=True)
def brightness_tiles(
    image: ByteStack, tile: IntVector, bits: IntVector, size: tuple[int, int]
) -> IntVector:
    """bright (n,) of a `Cloth` with tile and bits (n,), for an image with ``size`` (rows, columns)
    tiles."""
    rows, columns = SIDE * size[0], SIDE * size[1]
    value, pixels = np.zeros((rows, columns), np.int32), image.reshape(len(image), -1)
    first, end, low, high = rows, 0, columns, 0
    for n in range(len(tile)):
        top, left, word = tile[n] // size[1] * SIDE, tile[n] % size[1] * SIDE, bits[n]
        if word == 0:
            continue
        first, end = min(first, top), max(end, top + SIDE)
        low, high = min(low, left), max(high, left + SIDE)
        for k in range(SIDE):
            line = (word >> np.int64(SIDE * k)) & np.int64(2**SIDE - 1)
            if line != 0:
                to = value[top + k, left : left + SIDE]
                _put_brightness(to, pixels, (STEP * (top + k), CHANNELS * STEP * left), line)
    out = np.zeros(len(tile), np.int64)
    if end <= first:
        return out
    part = _brighter(value[first:end, low:high].copy())
    for n in range(len(tile)):
        top, left, word = tile[n] // size[1] * SIDE, tile[n] % size[1] * SIDE, np.int64(0)
        if bits[n] == 0:
            continue
        for k in range(SIDE * SIDE):
            bit = part[np.uint64(top - first + k // SIDE), np.uint64(left - low + k % SIDE)]
            word |= np.int64(bit) << np.int64(k)
        out[n] = word
    return out


@kernel
def _put_brightness(
    out: Written[Int32Vector], pixels: ByteMatrix, start: tuple[int, int], line: int
) -> None:
    """Of four pixels each, less than `ONE` / 121, for one line (SIDE,) of a tile that has the bits
    ``line``; the image (h, 3 w) has its first pixel at ``start``."""
    v, u = np.uint64(start[0]), np.uint64(start[1])
    width = np.uint64(CHANNELS * STEP)
    for x in range(SIDE):
        first, total = u + np.uint64(x) * width, np.int32(0)
        for i in range(CHANNELS * STEP):
            at = first + np.uint64(i)
            both = np.int32(pixels[v, at]) + np.int32(pixels[v + np.uint64(1), at])
            total += both * np.int32(2 if i % CHANNELS == 1 else 1)
        is_worn = np.int32((line >> np.int64(x)) & np.int64(1))
        out[x] = is_worn * (np.int32(ONE) + total)


@kernel(wide=True)
def _brighter(value: Int32Matrix) -> ByteMatrix:
    """1 where samples of the cloth are brighter than the mean of those around them; ``value`` is
    `ONE` more than the brightness, or 0 where there is no cloth. So a sum has the number of samples
    in its upper bits."""
    rows, columns = value.shape
    width = 2 * AROUND + 1
    out = np.zeros((rows, columns), np.uint8)
    sums = np.zeros(columns + 2 * AROUND, np.int32)  # of columns, with borders of 0
    two, four, all_ = np.empty_like(sums), np.empty_like(sums), np.empty_like(sums)
    inside = sums[AROUND : AROUND + columns]
    for y in range(rows + AROUND):
        if y < rows:
            for x in range(columns):
                inside[x] += value[y, x]
        if y >= width:
            for x in range(columns):
                inside[x] -= value[y - width, x]
        to = y - AROUND
        if to < 0:
            continue
        here, brighter = value[to], out[to]
        for x in range(len(sums) - 1):
            two[x] = sums[x] + sums[x + 1]
        for x in range(len(sums) - 3):
            four[x] = two[x] + two[x + 2]
        for x in range(columns):
            all_[x] = four[x] + four[x + 4] + two[x + 8] + sums[x + 10]
        for x in range(columns):
            around, mine = all_[x], here[x]
            count = around >> np.int32(ONE_BITS)
            product = np.int32((mine & np.int32(ONE - 1)) * count)
            is_brighter = product >= (around & np.int32(ONE - 1))
            brighter[x] = (mine > 0) & is_brighter
    return out
