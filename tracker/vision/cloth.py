"""The glove's own cloth in an image, around the blobs, from which outlines of the hand are found.

A map of every second pixel, in tiles of 8 by 8 samples that are a 64-bit number each: a few hundred
numbers per image, which can be stored like blobs.
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
NOTHING, OUTSIDE, INSIDE = 0, 1, 2  # classes of a pixel
REACH = 4.0  # times a blob's longer side: the distance from a thumb's last marker to its tip


class ClothMap(NamedTuple):
    """`Cloth` as an image: bits and known (rows, columns), 0 where unknown."""

    bits: IntMatrix
    known: ByteMatrix


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
    return Cloth(columns, rows, tile, bits)


def cloth_map(cloth: Cloth) -> ClothMap:
    """Converts to a form that can be indexed by pixels."""
    bits = np.zeros((cloth.rows, cloth.columns), np.int64)
    known = np.zeros((cloth.rows, cloth.columns), np.uint8)
    bits.reshape(-1)[cloth.tile] = cloth.bits
    known.reshape(-1)[cloth.tile] = 1
    return ClothMap(bits, known)


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
