"""Two widgets beside each other where there is width for both, else one above the other."""

from __future__ import annotations

from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QWidget

from app.widgets.measures import NEAR


class TwoHalves(QWidget):
    """``least`` px of width are needed for two columns; ``shares`` are those of the width."""

    def __init__(self, first: QWidget, second: QWidget, least: int, shares: tuple[int, int]):
        super().__init__()
        self._least = least
        self._halves = QBoxLayout(QBoxLayout.Direction.LeftToRight, self)
        self._halves.setContentsMargins(0, 0, 0, 0)
        self._halves.setSpacing(NEAR)
        for widget, share in zip((first, second), shares, strict=True):
            self._halves.addWidget(widget, share)

    def resizeEvent(self, event: QResizeEvent) -> None:
        wide = event.size().width() >= self._least
        direction = QBoxLayout.Direction
        self._halves.setDirection(direction.LeftToRight if wide else direction.TopToBottom)
