"""From a BGR pixel to its hue class, exactly as OpenCV's HSV intervals decide.

A table of 6 bits a channel (256 kB, so that it stays in the second-level cache) answers where all
64 colours of a bin agree; the few bins on an interval's border are decided by OpenCV's own integer
arithmetic.
"""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from numpy.typing import NDArray

from tracker.errors import ConfigError
from tracker.vision.colours import HUES, LEVELS, ColourProfile

BITS = 6
DROP = 8 - BITS
MIXED = -1  # the bin's colours disagree
MAX_HUES = 30  # bits of a mask

_Bytes = NDArray[np.uint8]
_Masks = NDArray[np.int64]
_Table = NDArray[np.int8]


def _division_table(numerator: float) -> NDArray[np.int64]:
    """OpenCV's reciprocals in 12-bit fixed point, entry 0 unused."""
    out = np.zeros(LEVELS, np.int64)
    out[1:] = np.rint(numerator * (1 << 12) / np.arange(1, LEVELS))
    return out


_SATURATION = _division_table(255.0)
_HUE = _division_table(180.0 / 6.0)


@dataclass(frozen=True, eq=False)
class HueTable:
    """table (2^18,) classes 0 = none, k + 1 = hue k, MIXED; masks (3, 256) of hue, sat., value.

    Bit k of masks[channel, level] says whether hue k takes that level.
    """

    table: _Table
    masks: _Masks

    @staticmethod
    def of(profile: ColourProfile) -> HueTable:
        if len(profile.hues) > MAX_HUES:
            raise ConfigError(
                f"The colour profile {profile.name!r} has {len(profile.hues)} hues; "
                f"at most {MAX_HUES} can be told apart."
            )
        masks = _masks(profile)
        return HueTable(_coarse_table(masks), masks)


def _masks(profile: ColourProfile) -> _Masks:
    out = np.zeros((3, LEVELS), np.int64)
    hue, level = np.arange(HUES), np.arange(LEVELS)
    for k, h in enumerate(profile.hues):
        bit = 1 << k
        out[0, :HUES] |= np.where((hue - h.hue[0]) % HUES <= h.width, bit, 0)
        for channel, (low, high) in ((1, h.saturation), (2, h.value)):
            out[channel] |= np.where((level >= low) & (level <= high), bit, 0)
    return out


@numba.njit(cache=True, nogil=True)
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


@numba.njit(cache=True, nogil=True)
def pixel_class(image: _Bytes, y: int, x: int, table: _Table, masks: _Masks) -> int:
    """Class of one pixel of a BGR image."""
    b, g, r = image[y, x, 0], image[y, x, 1], image[y, x, 2]
    key = ((b >> DROP) << (2 * BITS)) | ((g >> DROP) << BITS) | (r >> DROP)
    found = table[key]
    if found != MIXED:
        return int(found)
    return exact_class(np.int64(b), np.int64(g), np.int64(r), masks)


@numba.njit(cache=True, nogil=True)
def _coarse_table(masks: _Masks) -> _Table:
    n, step = 1 << BITS, 1 << DROP
    out = np.empty(n * n * n, np.int8)
    key = 0
    for b in range(0, LEVELS, step):
        for g in range(0, LEVELS, step):
            for r in range(0, LEVELS, step):
                out[key] = _bin_class(b, g, r, step, masks)
                key += 1
    return out


@numba.njit(cache=True, nogil=True)
def _bin_class(b0: int, g0: int, r0: int, step: int, masks: _Masks) -> int:
    """The class that all colours of a bin share, or MIXED."""
    first = exact_class(b0, g0, r0, masks)
    for b in range(b0, b0 + step):
        for g in range(g0, g0 + step):
            for r in range(r0, r0 + step):
                if exact_class(b, g, r, masks) != first:
                    return MIXED
    return first
