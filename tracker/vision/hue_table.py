"""From a BGR pixel to its hue class, exactly as OpenCV's HSV intervals decide.

One table holds the class of all 2^24 colours (16 MB). The colours of one picture touch little of
it, so that looking up is three times faster than a small table with exceptions, and ten times
faster than the arithmetic. It is filled in 50 ms by OpenCV's own integer arithmetic.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.errors import ConfigError
from tracker.kernels import kernel
from tracker.vision.colours import HUES, LEVELS, ColourProfile

MAX_HUES = 30  # bits of a mask

_Bytes = NDArray[np.uint8]
_Masks = NDArray[np.int64]
Table = NDArray[np.int8]


def _division_table(numerator: float) -> NDArray[np.int64]:
    """OpenCV's reciprocals in 12-bit fixed point, entry 0 unused."""
    out = np.zeros(LEVELS, np.int64)
    out[1:] = np.rint(numerator * (1 << 12) / np.arange(1, LEVELS))
    return out


_SATURATION = _division_table(255.0)
_HUE = _division_table(180.0 / 6.0)


def hue_table(profile: ColourProfile) -> Table:
    """(2^24,) classes by b << 16 | g << 8 | r: 0 for none, k + 1 for the profile's hue k."""
    if len(profile.hues) > MAX_HUES:
        raise ConfigError(
            f"The colour profile {profile.name!r} has {len(profile.hues)} hues; "
            f"at most {MAX_HUES} can be told apart."
        )
    return _full_table(_masks(profile))


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
def pixel_class(image: _Bytes, y: int, x: int, table: Table) -> int:
    """Class of one pixel of a BGR image."""
    b, g, r = np.int64(image[y, x, 0]), np.int64(image[y, x, 1]), np.int64(image[y, x, 2])
    return int(table[(b << 16) | (g << 8) | r])


@kernel
def _full_table(masks: _Masks) -> Table:
    out = np.empty(LEVELS**3, np.int8)
    k = 0
    for b in range(LEVELS):
        for g in range(LEVELS):
            for r in range(LEVELS):
                out[k] = exact_class(b, g, r, masks)
                k += 1
    return out
