"""An image with shapes over it, composed at the pixels of the screen: line widths and texts do not
depend on the zoom."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QImage, QPainter

from app.widgets.image_shapes import (
    Cross,
    Crosses,
    Drawn,
    Ellipse,
    Ellipses,
    ImageLabel,
    ImageLabels,
    ImageLine,
    ImageLines,
    Ring,
    Rings,
)
from app.widgets.image_strokes import (
    ANGLE,
    COLUMNS,
    DASHED,
    FILLING,
    KIND,
    LABEL,
    LINE,
    OPACITY,
    OVAL,
    RED,
    WIDTH,
    X1,
    Y1,
    X,
    Y,
    draw_strokes,
    show_pixels,
)

FILLING_OPACITY = 110 / 255  # opacity of a filled ring
ARM, ARM_WIDTH = 3.5, 1.5  # px of a cross
BESIDE = (5.0, -4.0)  # px from a point to the start of its label's base line
SHIFTS = ((1, 1), (-1, 1))  # px, of the text that makes its outline
Pixels = NDArray[np.uint8]
Rows = NDArray[np.float64]
Colour = tuple[float, float, float]


class Labels:
    """Coverage of the texts drawn so far, in one font, ``ratio`` pixels per unit of length."""

    def __init__(self, font: QFont, ratio: float) -> None:
        self.font, self.ratio = font, ratio
        self.masks = np.zeros(0, np.uint8)
        self.glyphs = np.zeros((0, 3), np.int64)
        self._rows: dict[str, int] = {}
        self.ascent = QFontMetrics(font).ascent() + 1  # px from the image's top to the base line

    def row(self, text: str) -> int:
        """Of ``glyphs``, drawn on first use."""
        found = self._rows.get(text)
        if found is None:
            ink, edge = self._mask(text, ((0, 0),)), self._mask(text, SHIFTS)
            found = self._rows[text] = len(self.glyphs)
            size = [len(self.masks), ink.shape[1], ink.shape[0]]
            self.glyphs = np.concatenate([self.glyphs, [size]])
            self.masks = np.concatenate([self.masks, ink.ravel(), edge.ravel()])
        return found

    def _mask(self, text: str, shifts: Sequence[tuple[int, int]]) -> Pixels:
        """Coverage (h, w) of a text."""
        metrics = QFontMetrics(self.font)
        wide = round((metrics.horizontalAdvance(text) + 4) * self.ratio)
        tall = round((metrics.height() + 3) * self.ratio)
        image = QImage(wide, tall, QImage.Format.Format_Grayscale8)
        image.setDevicePixelRatio(self.ratio)
        image.fill(Qt.GlobalColor.black)
        painter = QPainter(image)
        painter.setFont(self.font)
        painter.setPen(Qt.GlobalColor.white)
        for dx, dy in shifts:
            painter.drawText(QPointF(1 + dx, self.ascent + dy), text)
        painter.end()
        data = np.frombuffer(image.constBits(), np.uint8).reshape(tall, image.bytesPerLine())
        return np.ascontiguousarray(data[:, :wide])


class Placing:
    """Positions of image pixels on the canvas; ``scale``, ``x``, ``y`` in canvas pixels."""

    def __init__(self, scale: float, x: float, y: float, labels: Labels) -> None:
        self.scale, self.x, self.y, self.labels = scale, x, y, labels
        self.ratio = labels.ratio

    def all(self, uv: Rows) -> Rows:
        """Positions (n, 2) of image pixels (n, 2)."""
        return (uv + 0.5) * self.scale + (self.x, self.y)


class ImageCanvas:
    """The composed image, in memory that is reused."""

    def __init__(self) -> None:
        self._pixels = np.zeros((0, 0), np.uint32)
        self.image = QImage()

    def compose(
        self,
        size: tuple[int, int],
        source: Pixels,
        shapes: Sequence[Drawn],
        placing: Placing,
        background: QColor,
    ) -> None:
        """``size``: width and height, canvas pixels; ``source`` (h, w) or (h, w, 3), BGR."""
        if self._pixels.shape != size[::-1]:
            self._pixels = np.empty(size[::-1], np.uint32)
            height, width = self._pixels.shape
            self.image = QImage(
                self._pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32
            )
        whole = source if source.ndim == 3 else source[:, :, None]
        back = int(background.rgb())
        show_pixels(whole, placing.scale, placing.x, placing.y, back, self._pixels)
        rows = stroke_rows(shapes, placing)
        if len(rows):
            draw_strokes(rows, placing.labels.masks, placing.labels.glyphs, self._pixels)
        self.image.setDevicePixelRatio(placing.ratio)


def stroke_rows(shapes: Sequence[Drawn], placing: Placing) -> Rows:
    """The strokes (n, `COLUMNS`) of shapes, see `image_strokes`."""
    parts = [_ROWS[type(shape)](shape, placing) for shape in shapes]
    return np.concatenate([np.zeros((0, COLUMNS)), *parts])


def _empty(kind: float, count: int, width: float, opacity: float) -> Rows:
    """(count, `COLUMNS`) strokes without places and colours."""
    out = np.zeros((count, COLUMNS))
    out[:, KIND], out[:, WIDTH], out[:, OPACITY] = kind, width, opacity
    return out


def _colours(colours: Sequence[str]) -> NDArray[np.float64]:
    """(n, 3) red, green and blue."""
    return np.array([rgb(colour) for colour in colours]).reshape(-1, 3)


def _lines(shape: ImageLines, on: Placing) -> Rows:
    out = _empty(LINE, len(shape.ends), shape.width * on.ratio, shape.opacity)
    out[:, X : Y1 + 1] = on.all(shape.ends.reshape(-1, 2)).reshape(-1, 4)
    out[:, DASHED], out[:, RED:] = shape.dashed, _colours(shape.colours)
    return out


def _rings(shape: Rings, on: Placing) -> Rows:
    out = _empty(OVAL, len(shape.uv), shape.width * on.ratio, shape.opacity)
    out[:, X : Y + 1] = on.all(shape.uv)
    out[:, X1] = out[:, Y1] = shape.radius * on.scale
    out[:, DASHED], out[:, FILLING] = shape.dashed, FILLING_OPACITY * shape.filled
    out[:, RED:] = _colours(shape.colours)
    return out


def _ellipses(shape: Ellipses, on: Placing) -> Rows:
    out = _empty(OVAL, len(shape.uv), on.ratio, shape.opacity)
    out[:, X : Y + 1] = on.all(shape.uv)
    out[:, X1 : Y1 + 1], out[:, ANGLE] = shape.axes * on.scale, shape.angle
    out[:, RED:] = rgb(shape.colour)
    return out


def _crosses(shape: Crosses, on: Placing) -> Rows:
    r = ARM * on.ratio
    arms = np.array([[r, r], [r, -r]] if shape.diagonal else [[r, 0.0], [0.0, r]])
    out = _empty(LINE, 2 * len(shape.uv), ARM_WIDTH * on.ratio, shape.opacity)
    each = out.reshape(-1, 2, COLUMNS)
    middle = on.all(shape.uv)[:, None]
    each[:, :, X : Y + 1], each[:, :, X1 : Y1 + 1] = middle - arms, middle + arms
    each[:, :, RED:] = _colours(shape.colours)[:, None]
    return out


def _labels(shape: ImageLabels, on: Placing) -> Rows:
    labels = on.labels
    shown = on.scale >= shape.least_zoom * on.ratio
    out = _empty(LABEL, len(shape.uv) if shown else 0, 0.0, shape.opacity)
    if shown:
        corner = (BESIDE[0] - 1) * on.ratio, (BESIDE[1] - labels.ascent) * on.ratio
        out[:, X : Y + 1] = on.all(shape.uv) + corner
        out[:, X1] = [labels.row(text) for text in shape.texts]
        out[:, RED:] = rgb(shape.colour)
    return out


def _line(shape: ImageLine, on: Placing) -> Rows:
    ends, dashed = np.array([[*shape[:4]]]), np.array([shape.dashed])
    return _lines(ImageLines(ends, [shape.colour], shape.width, dashed, shape.opacity), on)


def _ring(shape: Ring, on: Placing) -> Rows:
    uv, radius = np.array([[shape.u, shape.v]]), np.array([shape.radius])
    dashed, filled = np.array([shape.dashed]), np.array([shape.filled])
    look = ([shape.colour], shape.width, dashed, filled, shape.opacity)
    return _rings(Rings(uv, radius, *look), on)


def _ellipse(shape: Ellipse, on: Placing) -> Rows:
    uv, axes = np.array([[shape.u, shape.v]]), np.array([[shape.a, shape.b]])
    angle = np.array([shape.angle])
    return _ellipses(Ellipses(uv, axes, angle, shape.colour, shape.opacity), on)


def _cross(shape: Cross, on: Placing) -> Rows:
    uv = np.array([[shape.u, shape.v]])
    return _crosses(Crosses(uv, [shape.colour], shape.diagonal, shape.opacity), on)


def _label(shape: ImageLabel, on: Placing) -> Rows:
    uv, look = np.array([[shape.u, shape.v]]), (shape.colour, shape.opacity, shape.least_zoom)
    return _labels(ImageLabels(uv, [shape.text], *look), on)


_ROWS: dict[type, Callable[[Any, Placing], Rows]] = {
    ImageLine: _line,
    Ring: _ring,
    Ellipse: _ellipse,
    Cross: _cross,
    ImageLabel: _label,
    ImageLines: _lines,
    Rings: _rings,
    Ellipses: _ellipses,
    Crosses: _crosses,
    ImageLabels: _labels,
}


@cache
def rgb(colour: str) -> Colour:
    """Red, green and blue, 0..255, of a name or "#rrggbb"."""
    known = QColor(colour)
    return float(known.red()), float(known.green()), float(known.blue())
