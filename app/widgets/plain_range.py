"""A slider with two handles, of superqt's, which takes a fifth of a start to import: it is made
when it is first shown."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QWidget

if TYPE_CHECKING:
    from superqt import QRangeSlider


class PlainRangeSlider(QWidget):
    """``changed`` says the new pair, ``released`` that a handle was let go."""

    changed = Signal(int, int)
    released = Signal()

    def __init__(self, top: int) -> None:
        super().__init__()
        self._top, self._pair = top, (0, top)
        self._slider: QRangeSlider | None = None
        self.setMinimumWidth(80)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)

    @property
    def held(self) -> bool:
        return self._slider is not None and self._slider.isSliderDown()

    def set_values(self, low: int, high: int) -> None:
        self._pair = low, high
        if self._slider is not None:
            self._slider.setValue(self._pair)

    def showEvent(self, event: QShowEvent) -> None:
        if self._slider is None:
            self._make()
        super().showEvent(event)

    def _make(self) -> None:
        from superqt import QRangeSlider

        self._slider = QRangeSlider(Qt.Orientation.Horizontal)
        self._slider.setAccessibleName(self.accessibleName())
        self._slider.setRange(0, self._top)
        self._slider.setValue(self._pair)
        self._slider.valueChanged.connect(lambda pair: self.changed.emit(*map(int, pair)))
        self._slider.sliderReleased.connect(self.released)
        layout = self.layout()
        assert layout is not None
        layout.addWidget(self._slider)
