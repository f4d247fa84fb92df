"""Maps of the image areas that the board has covered."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QWidget

FULL = QColor("#009E73")
ENOUGH = 3
"""Number of views at which a cell is filled."""
GAP = 14


class CoverageMap(QWidget):
    """Shows the number of views with corners in each cell, as a number and a fill."""

    def __init__(self, titles: tuple[str, str], alone: str, parent: QWidget | None = None) -> None:
        """``titles`` of left and right, ``alone`` of a single camera."""
        super().__init__(parent)
        self._titles, self._alone = titles, alone
        self._counts: tuple[NDArray[np.int64], ...] = ()
        self.setMinimumSize(220, 90)

    def sizeHint(self) -> QSize:
        return QSize(300, 118)

    def show_counts(self, maps: tuple[NDArray[np.int64], ...]) -> None:
        """Show one or two arrays (rows, columns)."""
        self._counts = maps
        empty = sum(int((counts == 0).sum()) for counts in maps)
        self.setAccessibleName(self.tr("{} empty cells").format(empty))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        width = (self.width() - GAP) / 2
        head = painter.fontMetrics().height() + 4
        for k, title in enumerate(self._titles if len(self._counts) != 1 else (self._alone,)):
            x = k * (width + GAP)
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            where = QRectF(x, 0, width, head)
            painter.drawText(where, Qt.AlignmentFlag.AlignLeft, title)
            if self._counts:
                box = QRectF(x, head, width, self.height() - head)
                self._paint_cells(painter, box, self._counts[k])
        painter.end()

    def _paint_cells(self, painter: QPainter, box: QRectF, counts: NDArray[np.int64]) -> None:
        rows, columns = counts.shape
        w, h = box.width() / columns, box.height() / rows
        text = self.palette().color(QPalette.ColorRole.WindowText)
        for (i, j), count in np.ndenumerate(counts):
            cell = QRectF(box.x() + j * w, box.y() + i * h, w - 2, h - 2)
            fill = QColor(FULL)
            fill.setAlphaF(0.75 * min(1.0, int(count) / ENOUGH))
            painter.setPen(self.palette().color(QPalette.ColorRole.Mid))
            painter.setBrush(fill)
            painter.drawRect(cell)
            if count:
                painter.setPen(text)
                painter.drawText(cell, Qt.AlignmentFlag.AlignCenter, str(int(count)))
