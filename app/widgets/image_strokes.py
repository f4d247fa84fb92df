"""Composition of an image and the shapes over it, at the pixels of the screen.

One compiled call per image, without the interpreter lock: painting a hundred shapes one by one
through Qt takes 5 ms of Python, in which the engine waits.
"""

from __future__ import annotations

import numpy as np

from app.widgets.row_span import row_span
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    ByteVector,
    IntMatrix,
    Matrix,
    UInt32Matrix,
    Written,
)

LINE, OVAL, LABEL = 0.0, 1.0, 2.0
"""Kinds of strokes."""
COLUMNS = 13
"""Of a row of strokes, px of the screen: kind; x, y of a line's start and end, or of an oval's
centre, its half axes and (column 5) the angle, rad, of the first against x, or x, y of a label's
top-left corner and (column 3) its row in ``glyphs``; width; 1 for dashed; opacity of the line and
of the filling; red, green, blue 0..255."""
KIND, X, Y, X1, Y1, ANGLE, WIDTH, DASHED, OPACITY, FILLING, RED = range(11)
DASH, PERIOD = 4.0, 6.0
"""Length of a dash, and the distance from one to the next, in widths of the line."""
SHADE = 200.0 / 255.0
"""Opacity of the dark outline of a label."""
SMALLEST = 0.25  # px, half axis of an oval


@kernel(error_model="numpy", wide=True)
def show_pixels(
    source: ByteStack, scale: float, x0: float, y0: float, back: int, canvas: Written[UInt32Matrix]
) -> None:
    """Fill the canvas (0xFFRRGGBB) with an image (h, w, 1 or 3; BGR), of which a pixel takes
    ``scale`` px from the corner ``x0``, ``y0``; and with ``back`` around it."""
    height, width, channels = source.shape
    rows, columns = canvas.shape
    at = np.empty(columns, np.int64)
    for x in range(columns):
        at[x] = int(np.floor((x + 0.5 - x0) / scale))
    for y in range(rows):
        v = int(np.floor((y + 0.5 - y0) / scale))
        for x in range(columns):
            u = at[x]
            if v < 0 or v >= height or u < 0 or u >= width:
                canvas[y, x] = np.uint32(back)
                continue
            blue = np.uint32(source[v, u, 0])
            green = np.uint32(source[v, u, channels // 2])
            red = np.uint32(source[v, u, channels - 1])
            canvas[y, x] = (
                np.uint32(0xFF000000) | red << np.uint32(16) | green << np.uint32(8) | blue
            )


@kernel(error_model="numpy")
def draw_strokes(
    strokes: Matrix, masks: ByteVector, glyphs: IntMatrix, canvas: Written[UInt32Matrix]
) -> None:
    """Draw ``strokes`` (n, `COLUMNS`) in order. ``glyphs`` (g, 3): where in ``masks`` the coverage
    of a label's text begins, followed by that of its outline; width and height."""
    for i in range(len(strokes)):
        if strokes[i, KIND] == LINE:
            _draw_line(strokes, i, canvas)
        elif strokes[i, KIND] == OVAL:
            _draw_oval(strokes, i, canvas)
        else:
            _draw_label(strokes, i, masks, glyphs, canvas)


@kernel(error_model="numpy", inline="always")
def _blend(
    canvas: Written[UInt32Matrix], y: int, x: int, colour: tuple[float, float, float], share: float
) -> None:
    """A share (0..1) of a colour over a pixel."""
    below = np.int64(canvas[y, x])
    out = np.uint32(0xFF)
    for k in range(3):
        part = float(below >> (16 - 8 * k) & 255)
        out = out << np.uint32(8) | np.uint32(part + share * (colour[k] - part) + 0.5)
    canvas[y, x] = out


@kernel(error_model="numpy", inline="always")
def _on_dash(along: float, width: float, dashed: float) -> float:
    """Share (0..1) of a line's pixel at ``along`` px from its start that is within a dash."""
    if dashed == 0.0:
        return 1.0
    period = PERIOD * width
    phase = along - period * np.floor(along / period)
    return float(min(max(DASH * width - phase + 0.5, 0.0), 1.0) + max(phase - period + 0.5, 0.0))


@kernel(error_model="numpy")
def _draw_line(strokes: Matrix, i: int, canvas: Written[UInt32Matrix]) -> None:
    """A line with round caps."""
    xa, ya, xb, yb = strokes[i, X], strokes[i, Y], strokes[i, X1], strokes[i, Y1]
    width, dashed, opacity = strokes[i, WIDTH], strokes[i, DASHED], strokes[i, OPACITY]
    colour = strokes[i, RED], strokes[i, RED + 1], strokes[i, RED + 2]
    reach = 0.5 * width + 0.5
    dx, dy = xb - xa, yb - ya
    square = dx * dx + dy * dy
    length = np.sqrt(square)
    rows, columns = canvas.shape
    for y in range(
        max(int(np.floor(min(ya, yb) - reach)), 0),
        min(int(np.floor(max(ya, yb) + reach)) + 1, rows),
    ):
        v = y + 0.5
        low, high = row_span((xa, ya, xb, yb), reach, v)
        first = max(int(np.floor(low - reach)), 0)
        for x in range(first, min(int(np.floor(high + reach)) + 1, columns)):
            u = x + 0.5
            s = 0.0
            if square > 0.0:
                s = min(max(((u - xa) * dx + (v - ya) * dy) / square, 0.0), 1.0)
            away = np.sqrt((xa + s * dx - u) ** 2 + (ya + s * dy - v) ** 2)
            cover = min(max(reach - away, 0.0), min(1.0, width))
            if cover > 0.0:
                share = opacity * cover * _on_dash(s * length, width, dashed)
                _blend(canvas, y, x, colour, share)


@kernel(error_model="numpy")
def _draw_oval(strokes: Matrix, i: int, canvas: Written[UInt32Matrix]) -> None:
    """An ellipse, filled or not."""
    cx, cy = strokes[i, X], strokes[i, Y]
    a, b = max(strokes[i, X1], SMALLEST), max(strokes[i, Y1], SMALLEST)
    cos, sin = np.cos(strokes[i, ANGLE]), np.sin(strokes[i, ANGLE])
    width, dashed, opacity = strokes[i, WIDTH], strokes[i, DASHED], strokes[i, OPACITY]
    filling = strokes[i, FILLING]
    colour = strokes[i, RED], strokes[i, RED + 1], strokes[i, RED + 2]
    reach = 0.5 * width + 0.5
    tall = np.sqrt((a * sin) ** 2 + (b * cos) ** 2) + reach
    rows, columns = canvas.shape
    top = min(max(int(np.floor(max(cy - tall, -1.0))), 0), rows)
    for y in range(top, min(int(np.floor(min(cy + tall, float(rows)))) + 1, rows)):
        v = y + 0.5 - cy
        low, high = _oval_span(a + 2 * reach, b + 2 * reach, cos, sin, v)
        inner_low, inner_high = 1.0, -1.0  # not drawn between them
        if filling == 0.0 and a > 2 * reach and b > 2 * reach:
            inner_low, inner_high = _oval_span(a - 2 * reach, b - 2 * reach, cos, sin, v)
        x = int(np.floor(min(max(cx + low, 0.0), float(columns))))
        last = int(np.floor(min(max(cx + high, -1.0), columns - 1.0)))
        while x <= last:
            u = x + 0.5 - cx
            if inner_low < u < inner_high:
                x = int(np.floor(min(cx + inner_high + 0.5, float(columns))))
                inner_low = inner_high
                continue
            p, q = cos * u + sin * v, cos * v - sin * u
            f = np.sqrt((p / a) ** 2 + (q / b) ** 2)
            slope = np.sqrt((p / (a * a)) ** 2 + (q / (b * b)) ** 2)
            away = f * (f - 1.0) / slope if slope > 0.0 else -min(a, b)
            if filling > 0.0 and away < 0.5:
                _blend(canvas, y, x, colour, opacity * filling * min(0.5 - away, 1.0))
            cover = min(max(reach - abs(away), 0.0), min(1.0, width))
            if cover > 0.0:
                along = np.arctan2(q / b, p / a) * 0.5 * (a + b) if dashed > 0.0 else 0.0
                share = opacity * cover * _on_dash(along, width, dashed)
                _blend(canvas, y, x, colour, share)
            x += 1


@kernel(error_model="numpy")
def _oval_span(a: float, b: float, cos: float, sin: float, v: float) -> tuple[float, float]:
    """Where a row ``v`` px below the centre is inside an ellipse: first and last u px from the
    centre; an empty interval (1, -1) for none."""
    square = (cos / a) ** 2 + (sin / b) ** 2
    half = cos * sin * v * (1.0 / (a * a) - 1.0 / (b * b))
    rest = v * v * ((sin / a) ** 2 + (cos / b) ** 2) - 1.0
    root = half * half - square * rest
    if root < 0.0:
        return 1.0, -1.0
    root = np.sqrt(root)
    return (-half - root) / square, (-half + root) / square


@kernel(error_model="numpy")
def _draw_label(
    strokes: Matrix, i: int, masks: ByteVector, glyphs: IntMatrix, canvas: Written[UInt32Matrix]
) -> None:
    """A text with a dark outline, at whole pixels: legible on any image."""
    start, wide, tall = glyphs[int(strokes[i, X1])]
    left, top = int(np.floor(strokes[i, X] + 0.5)), int(np.floor(strokes[i, Y] + 0.5))
    colour = strokes[i, RED], strokes[i, RED + 1], strokes[i, RED + 2]
    opacity, rows, columns = strokes[i, OPACITY], canvas.shape[0], canvas.shape[1]
    for y in range(max(-top, 0), min(tall, rows - top)):
        for x in range(max(-left, 0), min(wide, columns - left)):
            ink, edge = start + y * wide + x, start + (tall + y) * wide + x
            if masks[edge] > 0:
                share = opacity * SHADE * masks[edge] / 255.0
                _blend(canvas, top + y, left + x, (0.0, 0.0, 0.0), share)
            if masks[ink] > 0:
                _blend(canvas, top + y, left + x, colour, opacity * masks[ink] / 255.0)
