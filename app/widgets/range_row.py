"""A named slider with two handles and its two numbers."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from app.widgets.hue_range import HueRangeSlider
from app.widgets.measures import TIGHT
from app.widgets.number_box import NumberBox
from app.widgets.plain_range import PlainRangeSlider


class RangeRow(QWidget):
    """``changed`` says the new pair and whether a handle is still held.

    With ``wraps`` the first number may be the larger one: the interval runs through 0.
    """

    changed = Signal(int, int, bool)

    def __init__(self, name: str, top: int, wraps: bool = False) -> None:
        super().__init__()
        self._wraps, self._pair = wraps, (0, top)
        self.slider = HueRangeSlider(top) if wraps else PlainRangeSlider(top)
        self.slider.setAccessibleName(name)
        self.low, self.high = self._spin(top), self._spin(top)
        self.low.setAccessibleName(self.tr("{}, first").format(name))
        self.high.setAccessibleName(self.tr("{}, last").format(name))
        label = QLabel(name)
        label.setMinimumWidth(64)
        row = QGridLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setHorizontalSpacing(TIGHT)
        for column, widget in enumerate((label, self.low, self.slider, self.high)):
            row.addWidget(widget, 0, column)
        row.setColumnStretch(2, 1)
        self._connect()

    def _spin(self, top: int) -> NumberBox:
        box = NumberBox()
        box.setRange(0, top)
        box.setWrapping(self._wraps)
        box.setButtonSymbols(NumberBox.ButtonSymbols.NoButtons)  # the arrow keys count
        box.setFixedWidth(42)
        return box

    def _connect(self) -> None:
        self.slider.changed.connect(self._slid)
        self.slider.released.connect(lambda: self._emit(False))
        for box in (self.low, self.high):
            box.valueChanged.connect(self._typed)
            box.editingFinished.connect(lambda: self.set_values(*self._pair))

    def values(self) -> tuple[int, int]:
        return self.low.value(), self.high.value()

    def set_values(self, low: int, high: int, spare_focused: bool = False) -> None:
        """Show a pair without a signal; with ``spare_focused`` a number with the keyboard's focus
        shows it once it was edited."""
        self._pair = low, high
        for box, value in ((self.low, low), (self.high, high)):
            if spare_focused and box.hasFocus():
                continue
            box.blockSignals(True)
            box.setValue(value)
            box.blockSignals(False)
        self.slider.blockSignals(True)
        self.slider.set_values(low, high)
        self.slider.blockSignals(False)

    def _slid(self, low: int, high: int) -> None:
        self.set_values(low, high)
        self._emit(self.slider.held)

    def _typed(self) -> None:
        low, high = self.values()
        if not self._wraps and low > high:
            low, high = high, low
        self.set_values(low, high)
        self._emit(False)

    def _emit(self, held: bool) -> None:
        self.changed.emit(*self.values(), held)
