"""Composition of all curves of a plot over its axes and grid, at the pixels of the screen.

One compiled call per plot, without the interpreter lock: Qt's painter draws the same curves with
three calls of Python for each, in which the engine waits.
"""

from __future__ import annotations

import numpy as np

from app.widgets.row_span import row_span
from tracker.kernels import kernel
from tracker.kernels.arrays import ByteMatrix, Matrix, UInt32Matrix, Vector, Written

COLUMNS = 17
"""Of a row of curves: its first instant in ``t`` and their number; the instants (s) at the left and
right edge of the view, the values at its lower and upper edge; left, top, width and height of the
view, px; width of the line, px; length of a dash and distance from one to the next, in widths (0: a
solid line); red, green, blue 0..255; 1 for a curve that is drawn."""
(
    FIRST, COUNT, BEGIN, END, LOW, HIGH, LEFT, TOP, WIDE, TALL, WIDTH, DASH, PERIOD, RED, GREEN,
    BLUE, SHOWN,
) = range(COLUMNS)  # fmt: skip
WORTH = 4
"""Points per column from which on a curve is decimated to two points per column."""


@kernel(error_model="numpy")
def visible_spans(t: Vector, values: Vector, curves: Matrix) -> Matrix:
    """(n, 2): least and greatest value of the visible part of each of ``curves`` (n, `COLUMNS`),
    with a neighbour on either side; NaN without any or where it is not drawn."""
    spans = np.full((len(curves), 2), np.nan)
    for c in range(len(curves)):
        if curves[c, SHOWN] == 0.0:
            continue
        first, last = _visible(t, curves, c)
        for i in range(first, last):
            if np.isfinite(values[i]):
                if not spans[c, 0] <= values[i]:
                    spans[c, 0] = values[i]
                if not spans[c, 1] >= values[i]:
                    spans[c, 1] = values[i]
    return spans


@kernel(error_model="numpy", wide=True)
def draw_curves(
    t: Vector,
    values: Vector,
    curves: Matrix,
    backdrop: UInt32Matrix,
    cover: Written[ByteMatrix],
    canvas: Written[UInt32Matrix],
) -> None:
    """Draw ``curves`` (n, `COLUMNS`) over the backdrop (h, w), 0xFFRRGGBB, in order. Their instants
    t (s, increasing) and ``values`` follow each other; NaN interrupts a line. ``cover`` (h, w), all
    0, is used for one curve at a time, so that the joints of its lines are not drawn twice."""
    canvas[:] = backdrop
    for c in range(len(curves)):
        if curves[c, SHOWN] == 0.0:
            continue
        first, last = _visible(t, curves, c)
        xs, ys = thin_curve(t, values, curves, c, first, last)
        for i in range(len(xs)):
            share = (xs[i] - curves[c, BEGIN]) / (curves[c, END] - curves[c, BEGIN])
            xs[i] = curves[c, LEFT] + share * curves[c, WIDE]
            share = (curves[c, HIGH] - ys[i]) / (curves[c, HIGH] - curves[c, LOW])
            ys[i] = curves[c, TOP] + share * curves[c, TALL]
        _trace(xs, ys, curves[c, WIDTH], curves[c, DASH], curves[c, PERIOD], cover)
        _lay(curves[c, RED], curves[c, GREEN], curves[c, BLUE], cover, canvas)


@kernel(error_model="numpy")
def _visible(t: Vector, curves: Matrix, c: int) -> tuple[int, int]:
    """First index of the visible part of a curve, with a neighbour, and one past the last."""
    start = int(curves[c, FIRST])
    stop = start + int(curves[c, COUNT])
    first = start + np.searchsorted(t[start:stop], curves[c, BEGIN]) - 1
    last = start + np.searchsorted(t[start:stop], curves[c, END], side="right") + 1
    return max(first, start), min(last, stop)


@kernel(error_model="numpy")
def thin_curve(
    t: Vector, values: Vector, curves: Matrix, c: int, first: int, last: int
) -> tuple[Vector, Vector]:
    """Copies of t and values from ``first`` to before ``last``; decimated to the minimum and
    maximum in each column of pixels.

    Columns are aligned to multiples of their width, so that a scrolling curve keeps its shape. A
    column with a NaN is NaN, which preserves interruptions.
    """
    columns, begin, end = max(1.0, np.floor(curves[c, WIDE])), curves[c, BEGIN], curves[c, END]
    if last - first <= WORTH * columns or end <= begin:
        return t[first:last].copy(), values[first:last].copy()
    width = (end - begin) / columns
    xs, ys = np.empty(2 * (last - first)), np.empty(2 * (last - first))
    found, i = 0, first
    while i < last:
        column = np.floor(t[i] / width)
        xs[found], xs[found + 1] = t[i], t[i]
        low, high = values[i], values[i]
        i += 1
        while i < last and np.floor(t[i] / width) <= column:
            if not low <= values[i]:
                low = np.nan if np.isnan(low) else values[i]
            if not high >= values[i]:
                high = np.nan if np.isnan(high) else values[i]
            i += 1
        ys[found], ys[found + 1] = low, high
        found += 2
    return xs[:found].copy(), ys[:found].copy()


@kernel(error_model="numpy")
def _trace(
    xs: Vector, ys: Vector, width: float, dash: float, period: float, cover: Written[ByteMatrix]
) -> None:
    """Coverage of the line through points, px, until a NaN and from there on again."""
    along = 0.0
    for i in range(1, len(xs)):
        if np.isfinite(ys[i - 1]) and np.isfinite(ys[i]):
            ends = xs[i - 1], ys[i - 1], xs[i], ys[i]
            _segment(ends, width, along, dash, period, cover)
            along += np.sqrt((xs[i] - xs[i - 1]) ** 2 + (ys[i] - ys[i - 1]) ** 2)
        else:
            along = 0.0


@kernel(error_model="numpy")
def _segment(
    ends: tuple[float, float, float, float],
    width: float,
    along: float,
    dash: float,
    period: float,
    cover: Written[ByteMatrix],
) -> None:
    """Coverage of one line with round ends; ``along`` px of the curve are before it."""
    xa, ya, xb, yb = ends
    reach = 0.5 * width + 0.5
    dx, dy = xb - xa, yb - ya
    square = dx * dx + dy * dy
    length = np.sqrt(square)
    rows, columns = cover.shape
    top = int(max(np.floor(min(ya, yb) - reach), 0.0))
    bottom = int(min(np.floor(max(ya, yb) + reach), rows - 1.0))
    for y in range(top, bottom + 1):
        v = y + 0.5
        low, high = row_span(ends, reach, v)
        left = int(max(np.floor(low - reach), 0.0))
        right = int(min(np.floor(high + reach), columns - 1.0))
        for x in range(left, right + 1):
            u = x + 0.5
            s = ((u - xa) * dx + (v - ya) * dy) / square if square > 0.0 else 0.0
            if 0.0 < s < 1.0:
                away = abs((u - xa) * dy - (v - ya) * dx) / length
            else:
                s = min(max(s, 0.0), 1.0)
                away = np.sqrt((xa + s * dx - u) ** 2 + (ya + s * dy - v) ** 2)
            share = min(max(reach - away, 0.0), 1.0)
            if dash > 0.0:
                share *= _on_dash(along + s * length, width * dash, width * period)
            ink = np.uint8(255.0 * share + 0.5)
            if ink > cover[y, x]:
                cover[y, x] = ink


@kernel(error_model="numpy", inline="always")
def _on_dash(along: float, dash: float, period: float) -> float:
    """Share (0..1) of a pixel at ``along`` px that is within a dash."""
    phase = along - period * np.floor(along / period)
    return float(min(max(dash - phase + 0.5, 0.0), 1.0) + max(phase - period + 0.5, 0.0))


@kernel(error_model="numpy")
def _lay(
    red: float,
    green: float,
    blue: float,
    cover: Written[ByteMatrix],
    canvas: Written[UInt32Matrix],
) -> None:
    """Blend a colour over the canvas where it is covered, and clear ``cover``."""
    rows, columns = cover.shape
    for y in range(rows):
        for x in range(columns):
            if cover[y, x] > 0:
                share, below = cover[y, x] / 255.0, np.int64(canvas[y, x])
                r, g, b = float(below >> 16 & 255), float(below >> 8 & 255), float(below & 255)
                out = np.uint32(0xFF) << np.uint32(8) | np.uint32(r + share * (red - r) + 0.5)
                out = out << np.uint32(8) | np.uint32(g + share * (green - g) + 0.5)
                canvas[y, x] = out << np.uint32(8) | np.uint32(b + share * (blue - b) + 0.5)
                cover[y, x] = 0
