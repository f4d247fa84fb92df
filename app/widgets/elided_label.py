"""A label that elides text that does not fit and shows all of it in its tool tip."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QHelpEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QToolTip

LEAST = 24  # px: one letter and the ellipsis
MOST = 130  # px, minimum width of a firm label


class ElidedLabel(QLabel):
    """Plain text on one line. A ``firm`` label is elided last."""

    firm = False

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(min(MOST if self.firm else LEAST, hint.width()), hint.height())

    @property
    def is_elided(self) -> bool:
        return self.fontMetrics().horizontalAdvance(self.text()) > self.width()

    def shown(self) -> str:
        """The visible part of the text."""
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
