"""A named slider with two handles and two number fields, for hues or plain numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QShowEvent,
)
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QWidget

from app.widgets.measures import TIGHT
from app.widgets.number_box import NumberBox

if TYPE_CHECKING:
    from superqt import QRangeSlider

HANDLE = 12.0
GROOVE = 12.0
LOW, HIGH, BOTH = "low", "high", "both"


class PlainRangeSlider(QWidget):
    """``changed``: the new pair; ``released``: a handle was released."""

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
        from superqt import QRangeSlider  # deferred: 50 modules

        self._slider = QRangeSlider(Qt.Orientation.Horizontal)
        self._slider.setAccessibleName(self.accessibleName())
        self._slider.setRange(0, self._top)
        self._slider.setValue(self._pair)
        self._slider.valueChanged.connect(lambda pair: self.changed.emit(*map(int, pair)))
        self._slider.sliderReleased.connect(self.released)
        layout = self.layout()
        assert layout is not None
        layout.addWidget(self._slider)


class HueRangeSlider(QWidget):
    """Two handles on hues 0..``top``; the interval extends from the first one upward to the last
    one.

    A handle or the bar between them can be dragged. Keys: left and right move the selected handle,
    down selects the first and up the last one.
    """

    changed = Signal(int, int)  # low, high; low > high if the interval contains 0
    released = Signal()

    def __init__(self, top: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._hues = top + 1
        self._low, self._high = 0, top
        self._held: str | None = None
        self._marked = LOW
        self._at = 0
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setToolTip(
            self.tr("Drag a handle, or the bar. Keys: ↓ ↑ choose a handle, ← → move it.")
        )

    def sizeHint(self) -> QSize:
        return QSize(160, 24)

    def minimumSizeHint(self) -> QSize:
        return QSize(80, 24)

    def values(self) -> tuple[int, int]:
        return self._low, self._high

    def set_values(self, low: int, high: int) -> None:
        """Show an interval without emitting a signal."""
        self._low, self._high = low, high
        self.update()

    @property
    def held(self) -> bool:
        return self._held is not None

    # --- geometry

    def _x(self, hue: float) -> float:
        return HANDLE / 2 + (hue + 0.5) / self._hues * (self.width() - HANDLE)

    def _hue(self, x: float) -> int:
        share = (x - HANDLE / 2) / max(1.0, self.width() - HANDLE)
        return min(max(int(share * self._hues), 0), self._hues - 1)

    def bars(self) -> list[tuple[float, float]]:
        """Left and right end (px) of each part of the bar: two parts if it contains 0."""
        a, b = self._x(self._low), self._x(self._high)
        if self._low <= self._high:
            return [(a, b)]
        return [(a, self._x(self._hues - 0.5)), (self._x(-0.5), b)]

    def _grip(self, x: float) -> str | None:
        """The part that a press at ``x`` drags."""
        to_low, to_high = abs(x - self._x(self._low)), abs(x - self._x(self._high))
        if min(to_low, to_high) <= HANDLE:
            return LOW if to_low <= to_high else HIGH
        return BOTH if any(a <= x <= b for a, b in self.bars()) else None

    # --- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        x = event.position().x()
        self._held = self._grip(x)
        self._at = self._hue(x)
        if self._held in (LOW, HIGH):
            self._marked = self._held
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is None:
            return
        hue = self._hue(event.position().x())
        if self._held == BOTH:
            step, self._at = hue - self._at, hue
            self._change((self._low + step), (self._high + step))
        elif self._held == LOW:
            self._change(hue, self._high)
        else:
            self._change(self._low, hue)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._held is not None:
            self._held = None
            self.released.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()), 0)
        marked = {Qt.Key.Key_Down: LOW, Qt.Key.Key_Up: HIGH}.get(Qt.Key(event.key()))
        if marked is not None:
            self._marked = marked
            self.update()
        elif step and self._marked == LOW:
            self._change(self._low + step, self._high)
        elif step:
            self._change(self._low, self._high + step)
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.update()

    def _change(self, low: int, high: int) -> None:
        pair = low % self._hues, high % self._hues
        if pair != (self._low, self._high):
            self._low, self._high = pair
            self.update()
            self.changed.emit(*pair)

    # --- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        top = (self.height() - GROOVE) / 2
        self._paint_groove(painter, top)
        palette = self.palette()
        painter.setPen(QPen(palette.text().color(), 1.2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for a, b in self.bars():
            painter.drawRect(QRectF(a, top - 1.5, b - a, GROOVE + 3))
        for name, hue in ((LOW, self._low), (HIGH, self._high)):
            self._paint_handle(painter, self._x(hue), self.hasFocus() and name == self._marked)
        painter.end()

    def _paint_groove(self, painter: QPainter, top: float) -> None:
        """Draw all hues, fainter outside the interval."""
        step = 2
        for hue in range(0, self._hues, step):
            inside = (hue - self._low) % self._hues <= (self._high - self._low) % self._hues
            colour = QColor.fromHsv(hue * 2, 210 if inside else 60, 235 if inside else 150)
            a = self._x(hue - 0.5)
            painter.fillRect(QRectF(a, top, self._x(hue + step - 0.5) - a + 0.5, GROOVE), colour)

    def _paint_handle(self, painter: QPainter, x: float, marked: bool) -> None:
        palette = self.palette()
        ring = palette.highlight().color() if marked else palette.text().color()
        painter.setPen(QPen(ring, 2.5 if marked else 1.2))
        painter.setBrush(palette.button())
        painter.drawEllipse(QPointF(x, self.height() / 2), HANDLE / 2 - 1, HANDLE / 2 + 2)


class RangeRow(QWidget):
    """``changed``: the new pair, and whether a handle is still held.

    With ``wraps`` the first number may exceed the second: the interval contains 0.
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
        box.setButtonSymbols(NumberBox.ButtonSymbols.NoButtons)  # the arrow keys change the number
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
        """Show a pair without emitting a signal; with ``spare_focused`` a focused field is updated
        after it was edited."""
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
