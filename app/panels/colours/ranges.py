"""The list of hues, the ranges of the selected hue, and a histogram of the image's hues."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette, QPolygonF
from PySide6.QtWidgets import (
    QButtonGroup,
    QGridLayout,
    QLabel,
    QRadioButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.viewmodels.colour_tuning import CHANNELS, ColourTuning
from app.viewmodels.colours import HueRow
from app.viewmodels.names import display_name
from app.widgets.chip import Chip
from app.widgets.measures import TIGHT
from app.widgets.range_row import RangeRow

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


COLUMNS = 2
LONGEST = "● 19 of about 9 "


class ColoursHues(QWidget):
    """A button and a count for each hue."""

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.chips: list[Chip] = []
        self._group = QButtonGroup(self)
        self._group.idClicked.connect(self.chosen)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(TIGHT)
        self._grid.setVerticalSpacing(TIGHT)

    def fill(self, names: Sequence[str]) -> None:
        """Show these hues."""
        for button in self._group.buttons():
            self._group.removeButton(button)
            button.deleteLater()
        for chip in self.chips:
            chip.deleteLater()
        self.chips = []
        for i, name in enumerate(names):
            button, chip = QRadioButton(display_name(name)), Chip()
            chip.setMinimumWidth(self.fontMetrics().horizontalAdvance(LONGEST) + 12)
            self._group.addButton(button, i)
            self.chips.append(chip)
            row, column = divmod(i, COLUMNS)
            self._grid.addWidget(button, row, 2 * column)
            self._grid.addWidget(chip, row, 2 * column + 1)

    def choose(self, index: int) -> None:
        """Select a hue."""
        self._group.button(index).setChecked(True)

    def show_rows(self, rows: Sequence[HueRow]) -> None:
        """Show the counts, in the order of `fill`."""
        for chip, row in zip(self.chips, rows, strict=True):
            chip.show_state(row.look.colour, row.look.sign, row.count, row.clash or row.tip)


class ColoursRanges(QWidget):
    """The part of the panel with the ranges."""

    moved = Signal(str, int, int, bool)  # channel, first, last, whether a handle is held

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hues = ColoursHues()
        names = (self.tr("Hue"), self.tr("Saturation"), self.tr("Value"))
        self.rows = {
            channel: RangeRow(name, 179 if channel == "hue" else 255, wraps=channel == "hue")
            for channel, name in zip(CHANNELS, names, strict=True)
        }
        for channel, row in self.rows.items():
            row.changed.connect(lambda a, b, held, key=channel: self.moved.emit(key, a, b, held))
        self.strip = HueStrip()
        self.words = QLabel()
        self.words.setWordWrap(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(TIGHT)
        for widget in (self.hues, *self.rows.values(), self.strip, self.words):
            column.addWidget(widget)
        column.addStretch(1)

    def show_range(self, tuning: ColourTuning, followed: bool = False) -> None:
        """Show the selected hue. If the engine ``followed`` the light, leave a field that is being
        edited."""
        self.hues.choose(tuning.hue)
        for channel, row in self.rows.items():
            low, high = getattr(tuning.hue_range, channel)
            row.set_values(low, high, spare_focused=followed)

    def show_rows(self, rows: Sequence[HueRow], words: str) -> None:
        self.hues.show_rows(rows)
        self.words.setText(words)
