"""A ring that fills while a pose is held."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

WIDTH = 0.045  # of the ring, of its diameter
INSET = 6  # px to the border
TURN = 360 * 16  # Qt's angles are sixteenths of a degree
TOP = 90 * 16


class HoldRing(QWidget):
    """Lies over another widget, in its middle, and takes no clicks."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.share = 0.0
        self._full, self._empty = QColor("#009E73"), QColor(128, 128, 128, 90)

    def show_share(self, share: float, colour: str) -> None:
        """``share`` 0..1 of the ring in ``colour``."""
        self.share = min(max(share, 0.0), 1.0)
        self._full = QColor(colour)
        self.setAccessibleName(self.tr("held to {} %").format(round(100 * self.share)))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        room = min(self.width(), self.height()) - 2 * INSET
        thick = max(WIDTH * room, 4.0)
        side = room - thick
        box = QRectF((self.width() - side) / 2, (self.height() - side) / 2, side, side)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._empty, thick))
        painter.drawEllipse(box)
        pen = QPen(self._full, thick)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        painter.drawArc(box, TOP, -round(self.share * TURN))
        painter.end()
