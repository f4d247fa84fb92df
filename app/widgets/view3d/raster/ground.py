"""The background: a plain colour and thin lines that fade towards their ends."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, UInt32Matrix, Vector, Written


class Ground(NamedTuple):
    """Lines in the background: ends (M, 6) m in G, start and end of each; strength (M,) at their
    centres; colours (3,) of the background and of the lines, 0..1."""

    ends: Matrix
    strength: Vector
    background: Vector
    ink: Vector


@kernel(error_model="numpy")
def rule(lines: Matrix, ground: Ground, image: Written[UInt32Matrix]) -> None:
    """Fill ``image`` with the background and draw the lines (M, 6), see `placing.project_line`."""
    strength, background, ink = ground.strength, ground.background, ground.ink
    plain = _mixed(background, ink, 0.0)
    image[:] = plain
    for m in range(len(lines)):
        if lines[m, 2] > 0.0 and lines[m, 5] > 0.0:
            _line(lines[m], strength[m], background, ink, image)


@kernel(error_model="numpy")
def _line(
    line: Vector, strength: float, background: Vector, ink: Vector, image: Written[UInt32Matrix]
) -> None:
    """Draw one line, a pixel wide: column by column, or row by row if it is steep."""
    height, width = image.shape
    steep = abs(line[4] - line[1]) > abs(line[3] - line[0])
    a0, b0, a1, b1 = line[0], line[1], line[3], line[4]
    if steep:
        a0, b0, a1, b1 = b0, a0, b1, a1
    span, most = a1 - a0, height if steep else width
    if abs(span) < 0.5:
        return
    first, last = int(max(min(a0, a1), 0.0)), int(min(max(a0, a1), most - 1.0))
    for a in range(first, last + 1):
        share = (a + 0.5 - a0) / span
        fade = 4.0 * share * (1.0 - share) * strength
        if fade <= 0.0:
            continue
        b = b0 + share * (b1 - b0) - 0.5
        low = int(np.floor(b))
        for step in range(2):
            row, column = (a, low + step) if steep else (low + step, a)
            if 0 <= row < height and 0 <= column < width:
                cover = fade * (1.0 - abs(low + step - b))
                image[row, column] = _mixed(background, ink, cover)


@kernel(error_model="numpy", inline="always")
def _mixed(background: Vector, ink: Vector, share: float) -> np.uint32:
    """0xFFRRGGBB interpolated between two colours (3,), 0..1."""
    out = np.uint32(0xFF)
    for k in range(3):
        part = min(max(background[k] + share * (ink[k] - background[k]), 0.0), 1.0)
        out = out << np.uint32(8) | np.uint32(part * 255.0 + 0.5)
    return np.uint32(out)
