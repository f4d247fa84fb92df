"""A named slider with two handles and its two numbers."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QSpinBox, QWidget
from superqt import QRangeSlider


class RangeRow(QWidget):
    """``changed`` says the new pair and whether a handle is still held.

    With ``wraps`` the first number may be the larger one: the interval runs through 0, and the
    slider then shows its complement's ends.
    """

    changed = Signal(int, int, bool)

    def __init__(self, name: str, top: int, wraps: bool = False) -> None:
        super().__init__()
        self._top, self._wraps = top, wraps
        self._shifted = False
        self.slider = QRangeSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, top)
        self.slider.setAccessibleName(name)
        self.low, self.high = self._spin(top), self._spin(top)
        label = QLabel(name)
        label.setMinimumWidth(72)
        row = QGridLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(label, 0, 0)
        row.addWidget(self.low, 0, 1)
        row.addWidget(self.slider, 0, 2)
        row.addWidget(self.high, 0, 3)
        row.setColumnStretch(2, 1)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(lambda: self._emit(False))
        self.low.valueChanged.connect(self._typed)
        self.high.valueChanged.connect(self._typed)

    @staticmethod
    def _spin(top: int) -> QSpinBox:
        box = QSpinBox()
        box.setRange(0, top)
        box.setMinimumWidth(58)
        return box

    def values(self) -> tuple[int, int]:
        return self.low.value(), self.high.value()

    def set_values(self, low: int, high: int) -> None:
        """Show a pair without a signal."""
        self._shifted = self._wraps and low > high
        for widget in (self.slider, self.low, self.high):
            widget.blockSignals(True)
        self.low.setValue(low)
        self.high.setValue(high)
        self.slider.setValue(tuple(sorted((low, high))))
        self.slider.setToolTip(
            self.tr("The interval runs through 0: it is outside the bar") if self._shifted else ""
        )
        for widget in (self.slider, self.low, self.high):
            widget.blockSignals(False)

    def _slid(self, pair: tuple[int, int]) -> None:
        low, high = (int(x) for x in pair)
        if self._shifted:
            low, high = high, low
        for box, value in ((self.low, low), (self.high, high)):
            box.blockSignals(True)
            box.setValue(value)
            box.blockSignals(False)
        self._emit(self.slider.isSliderDown())

    def _typed(self) -> None:
        low, high = self.values()
        if not self._wraps and low > high:
            low, high = high, low
        self.set_values(low, high)
        self._emit(False)

    def _emit(self, held: bool) -> None:
        self.changed.emit(*self.values(), held)
