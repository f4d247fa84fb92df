"""The hue class of a BGR pixel, identical to OpenCV's HSV intervals.

The lookup has two steps: each of 32³ cells of 8³ colours has the number of a pattern, and a pattern
contains the class of each colour within a cell. All cells of one class share a pattern. The parts
of both that an image needs remain in the processor's caches, and there is no branch: on a coloured
background a misprediction costs more than the second lookup.
"""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    ByteVector,
    Int8Vector,
    IntMatrix,
    UInt16Vector,
    Written,
)
from tracker.vision.colours import (
    HUES,
    LEARNED_BITS,
    LEARNED_CELLS,
    LEVELS,
    ROOM,
    UNKNOWN,
    WORN,
    ColourProfile,
)

MAX_HUES = 30  # limited by the bits of a mask

CELL_BITS = 3  # bits per channel within a cell
CELLS = LEVELS >> CELL_BITS  # along each channel
CELL_SIDE = 1 << CELL_BITS
CELL_COLOURS = CELL_SIDE**3
CLOTH = -1
VIVID_SATURATION = 86  # above which max - min is at least a third of max, and so half of min


class HueTable(NamedTuple):
    """Classes are 0 for none of a profile's hues, k + 1 for its hue k, and `CLOTH` for the glove's
    own cloth, if that was learned.

    cells (2^15,) pattern numbers, indexed by b << 10 | g << 5 | r of the channels' upper five bits;
    patterns (512 n,) classes, indexed by number << 9 | b << 6 | g << 3 | r of their lower three.
    vivid is 1 where `is_vivid` is true for all colours of a hue, else 0.
    """

    cells: UInt16Vector
    patterns: Int8Vector
    vivid: int


def _division_table(numerator: float) -> NDArray[np.int64]:
    """OpenCV's reciprocals in 12-bit fixed point, entry 0 unused."""
    out = np.zeros(LEVELS, np.int64)
    out[1:] = np.rint(numerator * (1 << 12) / np.arange(1, LEVELS))
    return out


_SATURATION = _division_table(255.0)
_HUE = _division_table(180.0 / 6.0)


_recent: deque[tuple[ColourProfile, HueTable]] = deque(maxlen=4)
"""The tables made last: colours that are learned live are tested, and then used, each by a detector
of its own."""


def hue_table(profile: ColourProfile) -> HueTable:
    """The classes of a profile's hues; takes 50 ms, once for each profile."""
    for known, table in tuple(_recent):
        if known is profile:
            return table
    table = _made(profile)
    _recent.append((profile, table))
    return table


def _made(profile: ColourProfile) -> HueTable:
    if len(profile.hues) > MAX_HUES:
        raise ConfigError(
            notice(
                "colours.too_many_hues", profile=profile.name, hues=len(profile.hues), most=MAX_HUES
            )
        )
    cells = np.empty(CELLS**3, np.uint16)
    patterns = np.empty((len(profile.hues) + 1 + len(cells)) * CELL_COLOURS, np.int8)
    learned = profile.learned
    known = np.full(LEARNED_CELLS, UNKNOWN, np.uint8) if learned is None else learned.classes()
    count = _fill_table(_masks(profile), len(profile.hues), known, cells, patterns)
    vivid = all(h.saturation[0] >= VIVID_SATURATION for h in profile.hues)
    return HueTable(cells, patterns[: count * CELL_COLOURS].copy(), int(vivid))


def _masks(profile: ColourProfile) -> IntMatrix:
    """(3, 256): bit k of row hue, saturation or value is set if hue k includes that level."""
    out = np.zeros((3, LEVELS), np.int64)
    hue, level = np.arange(HUES), np.arange(LEVELS)
    for k, h in enumerate(profile.hues):
        bit = 1 << k
        out[0, :HUES] |= np.where((hue - h.hue[0]) % HUES <= h.width, bit, 0)
        for channel, (low, high) in ((1, h.saturation), (2, h.value)):
            out[channel] |= np.where((level >= low) & (level <= high), bit, 0)
    return out


@kernel
def exact_class(b: int, g: int, r: int, masks: IntMatrix) -> int:
    """Class of one colour by the intervals alone."""
    bits = interval_bits(b, g, r, masks)
    out = 0
    while bits:
        out += 1
        if bits & 1:
            return out
        bits >>= 1
    return 0


@kernel
def in_intervals(b: int, g: int, r: int, masks: IntMatrix, hue: int) -> bool:
    """Whether a colour lies within the intervals of the hue with this class."""
    return bool((interval_bits(b, g, r, masks) >> (hue - 1)) & 1)


@kernel
def interval_bits(b: int, g: int, r: int, masks: IntMatrix) -> int:
    """Bit k is set if hue k includes the colour, with the fixed-point HSV of OpenCV's cvtColor."""
    v = max(b, g, r)
    d = v - min(b, g, r)
    s = (d * _SATURATION[v] + 2048) >> 12
    if v == r:
        h = g - b
    elif v == g:
        h = b - r + 2 * d
    else:
        h = r - g + 4 * d
    h = (h * _HUE[d] + 2048) >> 12
    if h < 0:
        h += HUES
    return int(masks[0, h] & masks[1, s] & masks[2, v])


@kernel
def known_class(b: int, g: int, r: int, masks: IntMatrix, known: ByteVector) -> int:
    """Class of one colour, including learned colours: a colour of the background has none even
    within a hue's intervals, one of a hue must lie within that hue's."""
    shift = 8 - LEARNED_BITS
    cell = ((b >> shift) << LEARNED_BITS | g >> shift) << LEARNED_BITS | r >> shift
    learned = int(known[cell])
    if learned == ROOM:
        return 0
    if learned == WORN:
        return CLOTH
    if learned == UNKNOWN:
        return exact_class(b, g, r, masks)
    return learned if in_intervals(b, g, r, masks, learned) else 0


@kernel(inline="always")
def colour_class(
    image: ByteStack, y: int, x: int, cells: UInt16Vector, patterns: Int8Vector
) -> int:
    """Class of one pixel of a BGR image.

    Unsigned indices avoid the test for negative ones.
    """
    v, u, bits, low = np.uintp(y), np.uintp(x), np.uintp(CELL_BITS), np.uintp(CELL_SIDE - 1)
    b, g, r = np.uintp(image[v, u, 0]), np.uintp(image[v, u, 1]), np.uintp(image[v, u, 2])
    side = np.uintp(CELLS)
    cell = ((b >> bits) * side + (g >> bits)) * side + (r >> bits)
    number = np.uintp(cells[cell])
    return int(patterns[((number << bits | b & low) << bits | g & low) << bits | r & low])


@kernel(inline="always")
def is_vivid(b: int, g: int, r: int) -> np.bool_:
    """Whether the channels (uint8) differ by half the smallest: faster than a table for greys."""
    least = min(min(b, g), r)
    return np.uint8(max(max(b, g), r) - least) >= np.uint8(least >> 1)


@kernel
def _fill_table(
    masks: IntMatrix,
    hues: int,
    known: ByteVector,
    cells: Written[UInt16Vector],
    patterns: Written[Int8Vector],
) -> int:
    """Fills both arrays; returns the number of patterns. Those of a single class come first.

    ``known`` are the learned classes, as from `tracker.vision.colours.LearnedColours.classes`.
    """
    for k in range(hues + 1):
        patterns[k * CELL_COLOURS : (k + 1) * CELL_COLOURS] = k
    count, cell = hues + 1, 0
    for b in range(0, LEVELS, CELL_SIDE):
        for g in range(0, LEVELS, CELL_SIDE):
            for r in range(0, LEVELS, CELL_SIDE):
                own = patterns[count * CELL_COLOURS : (count + 1) * CELL_COLOURS]
                _fill_pattern(b, g, r, masks, known, own)
                if own.min() == own.max() and own[0] >= 0:
                    cells[cell] = own[0]
                else:
                    cells[cell] = count
                    count += 1
                cell += 1
    return count


@kernel
def _fill_pattern(
    b: int, g: int, r: int, masks: IntMatrix, known: ByteVector, own: Written[Int8Vector]
) -> None:
    """Fills the classes of the cell with this darkest corner."""
    index = 0
    for i in range(b, b + CELL_SIDE):
        for j in range(g, g + CELL_SIDE):
            for k in range(r, r + CELL_SIDE):
                own[index] = known_class(i, j, k, masks, known)
                index += 1
