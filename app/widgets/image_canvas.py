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

from app.widgets.image_shapes import Cross, Ellipse, ImageLabel, ImageLine, Ring, Shape
from app.widgets.image_strokes import COLUMNS, LABEL, LINE, OVAL, draw_strokes, show_pixels

FILLING = 110 / 255  # opacity of a filled ring
ARM, ARM_WIDTH = 3.5, 1.5  # px of a cross
BESIDE = (5.0, -4.0)  # px from a point to the start of its label's base line
SHIFTS = ((1, 1), (-1, 1))  # px, of the text that makes its outline
Pixels = NDArray[np.uint8]
Row = tuple[float, ...]
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

    def at(self, u: float, v: float) -> tuple[float, float]:
        return self.x + (u + 0.5) * self.scale, self.y + (v + 0.5) * self.scale


class ImageCanvas:
    """The composed image, in memory that is reused."""

    def __init__(self) -> None:
        self._pixels = np.zeros((0, 0), np.uint32)
        self.image = QImage()

    def compose(
        self,
        size: tuple[int, int],
        source: Pixels,
        shapes: Sequence[Shape],
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


def stroke_rows(shapes: Sequence[Shape], placing: Placing) -> NDArray[np.float64]:
    """The strokes (n, `COLUMNS`) of shapes, see `image_strokes`."""
    rows: list[Row] = []
    for shape in shapes:
        _ROWS[type(shape)](shape, placing, rows)
    return np.array(rows, float).reshape(-1, COLUMNS)


def _line(shape: ImageLine, on: Placing, rows: list[Row]) -> None:
    ends = (*on.at(shape.u0, shape.v0), *on.at(shape.u1, shape.v1))
    width, dashed = shape.width * on.ratio, float(shape.dashed)
    rows.append((LINE, *ends, 0.0, width, dashed, shape.opacity, 0.0, *rgb(shape.colour)))


def _ring(shape: Ring, on: Placing, rows: list[Row]) -> None:
    radius, filling = shape.radius * on.scale, FILLING if shape.filled else 0.0
    rows.append(
        (
            OVAL, *on.at(shape.u, shape.v), radius, radius, 0.0, shape.width * on.ratio,
            float(shape.dashed), shape.opacity, filling, *rgb(shape.colour),
        )
    )  # fmt: skip


def _ellipse(shape: Ellipse, on: Placing, rows: list[Row]) -> None:
    axes = shape.a * on.scale, shape.b * on.scale, shape.angle
    rows.append(
        (
            OVAL, *on.at(shape.u, shape.v), *axes, on.ratio, 0.0, shape.opacity, 0.0,
            *rgb(shape.colour),
        )
    )  # fmt: skip


def _cross(shape: Cross, on: Placing, rows: list[Row]) -> None:
    (x, y), r = on.at(shape.u, shape.v), ARM * on.ratio
    colour = rgb(shape.colour)
    for dx, dy in ((r, r), (r, -r)) if shape.diagonal else ((r, 0.0), (0.0, r)):
        rows.append(
            (
                LINE, x - dx, y - dy, x + dx, y + dy, 0.0, ARM_WIDTH * on.ratio, 0.0,
                shape.opacity, 0.0, *colour,
            )
        )  # fmt: skip


def _label(shape: ImageLabel, on: Placing, rows: list[Row]) -> None:
    if on.scale < shape.least_zoom * on.ratio:
        return
    (x, y), labels = on.at(shape.u, shape.v), on.labels
    corner = x + (BESIDE[0] - 1) * on.ratio, y + (BESIDE[1] - labels.ascent) * on.ratio
    rows.append(
        (
            LABEL, *corner, labels.row(shape.text), 0.0, 0.0, 0.0, 0.0, shape.opacity, 0.0,
            *rgb(shape.colour),
        )
    )  # fmt: skip


_ROWS: dict[type, Callable[[Any, Placing, list[Row]], None]] = {
    ImageLine: _line,
    Ring: _ring,
    Ellipse: _ellipse,
    Cross: _cross,
    ImageLabel: _label,
}


@cache
def rgb(colour: str) -> Colour:
    """Red, green and blue, 0..255, of a name or "#rrggbb"."""
    known = QColor(colour)
    return float(known.red()), float(known.green()), float(known.blue())
