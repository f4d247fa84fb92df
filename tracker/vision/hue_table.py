"""From a BGR pixel to its hue class, exactly as OpenCV's HSV intervals decide.

One table holds the class of all 2^24 colours, ten times faster than the arithmetic that fills it.
Where a picture is scanned a small one goes before it: 64³ cells of 4³ colours each, with the class
of those that have but one. Its 256 KB stay in the processor's second cache, and few pixels need
the large one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.errors import ConfigError
from tracker.kernels import kernel
from tracker.vision.colours import HUES, LEVELS, ColourProfile

MAX_HUES = 30  # bits of a mask

CELL_BITS = 2  # of each channel that a cell leaves open
CELLS = LEVELS >> CELL_BITS  # along each channel
MIXED = -1  # a cell of more than one class
VIVID_SATURATION = 86  # from which max - min is at least a third of max, and so half of min

_Bytes = NDArray[np.uint8]
_Masks = NDArray[np.int64]
Table = NDArray[np.int8]


@dataclass(frozen=True, eq=False)
class HueTable:
    """Classes are 0 for none of a profile's hues and k + 1 for its hue k.

    colours (2^24,) by b << 16 | g << 8 | r; cells (2^18,) the same of the channels' upper six bits,
    MIXED where the cell's colours differ. vivid is 1 where `is_vivid` holds for all colours of a
    hue, else 0.
    """

    colours: Table
    cells: Table
    vivid: int


def _division_table(numerator: float) -> NDArray[np.int64]:
    """OpenCV's reciprocals in 12-bit fixed point, entry 0 unused."""
    out = np.zeros(LEVELS, np.int64)
    out[1:] = np.rint(numerator * (1 << 12) / np.arange(1, LEVELS))
    return out


_SATURATION = _division_table(255.0)
_HUE = _division_table(180.0 / 6.0)


def hue_table(profile: ColourProfile) -> HueTable:
    """The classes of a profile's hues; takes 50 ms."""
    if len(profile.hues) > MAX_HUES:
        raise ConfigError(
            f"The colour profile {profile.name!r} has {len(profile.hues)} hues; "
            f"at most {MAX_HUES} can be told apart."
        )
    both = np.empty(LEVELS**3 + CELLS**3, np.int8)  # as one, both lie in huge pages of memory
    colours, cells = both[: LEVELS**3], both[LEVELS**3 :]
    _fill_colours(_masks(profile), colours)
    _fill_cells(colours, cells)
    vivid = all(h.saturation[0] >= VIVID_SATURATION for h in profile.hues)
    return HueTable(colours, cells, int(vivid))


def _masks(profile: ColourProfile) -> _Masks:
    """(3, 256): bit k of row hue, saturation or value says whether hue k takes that level."""
    out = np.zeros((3, LEVELS), np.int64)
    hue, level = np.arange(HUES), np.arange(LEVELS)
    for k, h in enumerate(profile.hues):
        bit = 1 << k
        out[0, :HUES] |= np.where((hue - h.hue[0]) % HUES <= h.width, bit, 0)
        for channel, (low, high) in ((1, h.saturation), (2, h.value)):
            out[channel] |= np.where((level >= low) & (level <= high), bit, 0)
    return out


@kernel
def exact_class(b: int, g: int, r: int, masks: _Masks) -> int:
    """Class of one colour, with the fixed-point HSV of OpenCV's cvtColor."""
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
    bits = masks[0, h] & masks[1, s] & masks[2, v]
    out = 0
    while bits:
        out += 1
        if bits & 1:
            return out
        bits >>= 1
    return 0


@kernel(inline="always")
def pixel_class(image: _Bytes, y: int, x: int, colours: Table) -> int:
    """Class of one pixel of a BGR image.

    Unsigned indices spare a look at whether they count from the end.
    """
    v, u = np.uintp(y), np.uintp(x)
    b, g, r = np.uintp(image[v, u, 0]), np.uintp(image[v, u, 1]), np.uintp(image[v, u, 2])
    side = np.uintp(LEVELS)
    return int(colours[(b * side + g) * side + r])


@kernel(inline="always")
def cell_class(image: _Bytes, y: int, x: int, cells: Table) -> int:
    """Class of one pixel of a BGR image, or MIXED where its cell cannot tell."""
    v, u, shift = np.uintp(y), np.uintp(x), np.uintp(CELL_BITS)
    b, g, r = np.uintp(image[v, u, 0]), np.uintp(image[v, u, 1]), np.uintp(image[v, u, 2])
    side = np.uintp(CELLS)
    return int(cells[((b >> shift) * side + (g >> shift)) * side + (r >> shift)])


@kernel(inline="always")
def colour_class(image: _Bytes, y: int, x: int, colours: Table, cells: Table) -> int:
    """The same as `pixel_class`, mostly out of the table that stays in the cache."""
    found = cell_class(image, y, x, cells)
    return pixel_class(image, y, x, colours) if found == MIXED else found


@kernel(inline="always")
def is_vivid(b: int, g: int, r: int) -> np.bool_:
    """Whether the channels (uint8) differ by half the least: cheaper than any table for greys."""
    least = min(min(b, g), r)
    return np.uint8(max(max(b, g), r) - least) >= np.uint8(least >> 1)


@kernel
def _fill_colours(masks: _Masks, colours: Table) -> None:
    k = 0
    for b in range(LEVELS):
        for g in range(LEVELS):
            for r in range(LEVELS):
                colours[k] = exact_class(b, g, r, masks)
                k += 1


@kernel
def _fill_cells(colours: Table, cells: Table) -> None:
    side, k = 1 << CELL_BITS, 0
    for b in range(0, LEVELS, side):
        for g in range(0, LEVELS, side):
            for r in range(0, LEVELS, side):
                cells[k] = _class_of_cell(b, g, r, colours)
                k += 1


@kernel
def _class_of_cell(b: int, g: int, r: int, colours: Table) -> int:
    """The class that all colours of the cell with this darkest corner have, else MIXED."""
    side = 1 << CELL_BITS
    hue = int(colours[(b * LEVELS + g) * LEVELS + r])
    for i in range(b, b + side):
        for j in range(g, g + side):
            row = (i * LEVELS + j) * LEVELS + r
            for k in range(row, row + side):
                if colours[k] != hue:
                    return MIXED
    return hue
