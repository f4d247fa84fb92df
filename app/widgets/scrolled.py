"""A panel that scrolls if its dock is too small for it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

SMALLEST = QSize(220, 60)  # px; two of these above each other fit on a screen at 200 %


class Scrolled(QScrollArea):
    """Gives the panel all available space and scrolls only below its minimum size.

    Qt's own behaviour (``widgetResizable``) already scrolls below the preferred size of a panel
    with wrapped text, although its images and tables could shrink.
    """

    def __init__(self, panel: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self._panel = panel
        self.setWidget(panel)
        panel.installEventFilter(self)

    def minimumSizeHint(self) -> QSize:
        return SMALLEST

    def sizeHint(self) -> QSize:
        return self._panel.sizeHint()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._panel and event.type() == QEvent.Type.LayoutRequest:
            self._fit()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        panel, available = self._panel, self.viewport().size()
        layout = panel.layout()
        if layout is None:
            return
        least = layout.totalMinimumSize()
        width = max(available.width(), least.width())
        height = least.height()
        if layout.hasHeightForWidth():
            height = layout.totalMinimumHeightForWidth(width)
        panel.resize(width, max(available.height(), height))
