"""A label that ends in … where it has no room, and says the whole of it to the pointer."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QHelpEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QToolTip

LEAST = 24  # px: a letter and the …
MOST = 130  # px that one which is firm keeps


class ElidedLabel(QLabel):
    """Plain text on one line. One that is ``firm`` is cut last."""

    firm = False

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(min(MOST if self.firm else LEAST, hint.width()), hint.height())

    @property
    def is_elided(self) -> bool:
        return self.fontMetrics().horizontalAdvance(self.text()) > self.width()

    def shown(self) -> str:
        """What of the text is to be read."""
        mode = Qt.TextElideMode.ElideRight
        return self.fontMetrics().elidedText(self.text(), mode, self.width())

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self.is_elided:
            super().paintEvent(event)
            return
        painter = QPainter(self)
        painter.setPen(self.palette().color(self.foregroundRole()))
        painter.drawText(
            self.rect(), self.alignment() | Qt.AlignmentFlag.AlignVCenter, self.shown()
        )
        painter.end()

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and self.is_elided:
            parent = self.parentWidget()
            more = self.toolTip() or (parent.toolTip() if parent is not None else "")
            QToolTip.showText(event.globalPos(), f"{self.text()}\n{more}".strip(), self)
            return True
        return super().event(event)
