"""The hue circle unrolled: a histogram with intervals below it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

HUES = 180
BAND = 10


class HueStrip(QWidget):
    """``histogram`` (180,) in 0..1; ``intervals`` of (first, last, colour), wrapping allowed."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._histogram: NDArray[np.float64] = np.zeros(HUES)
        self._intervals: Sequence[tuple[int, int, str]] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(self.tr("Histogram of hues"))

    def sizeHint(self) -> QSize:
        return QSize(240, 58)

    def show_hues(
        self, histogram: NDArray[np.float64], intervals: Sequence[tuple[int, int, str]]
    ) -> None:
        self._histogram, self._intervals = histogram, intervals
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        plot = QRectF(0, 0, self.width(), self.height() - 2 * BAND - 4)
        self._paint_histogram(painter, plot)
        self._paint_hues(painter, plot.bottom() + 2)
        self._paint_intervals(painter, plot.bottom() + BAND + 4)
        painter.end()

    def _x(self, hue: float) -> float:
        return hue / HUES * self.width()

    def _paint_histogram(self, painter: QPainter, box: QRectF) -> None:
        points = [QPointF(0, box.bottom())]
        heights = np.sqrt(self._histogram)  # makes small counts visible next to the largest
        points += [
            QPointF(self._x(h + 0.5), box.bottom() - y * box.height())
            for h, y in enumerate(heights)
        ]
        points.append(QPointF(self.width(), box.bottom()))
        colour = QColor(self.palette().color(QPalette.ColorRole.Text))
        colour.setAlpha(110)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawPolygon(QPolygonF(points))

    def _paint_hues(self, painter: QPainter, top: float) -> None:
        for hue in range(0, HUES, 2):
            box = QRectF(self._x(hue), top, self._x(2) + 1, BAND)
            painter.fillRect(box, QColor.fromHsv(hue * 2, 210, 235))

    def _paint_intervals(self, painter: QPainter, top: float) -> None:
        for first, last, colour in self._intervals:
            parts = [(first, last)] if first <= last else [(first, HUES - 1), (0, last)]
            painter.setBrush(QColor(colour))
            painter.setPen(QColor(0, 0, 0, 120))
            for low, high in parts:
                box = QRectF(self._x(low), top, self._x(high + 1 - low), BAND - 2)
                painter.drawRoundedRect(box, 3, 3)
