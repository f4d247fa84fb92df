"""Scrolling curves with a cursor that reads them.

Pens are one pixel wide and ranges fixed: wider pens cost five times as much to draw.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, Signal
from PySide6.QtWidgets import QGraphicsItem, QVBoxLayout, QWidget

from tracker.messages import Array

MARGIN = 0.05  # of the range, above and below curves whose range follows them


def keep_axes(plot: pg.PlotWidget) -> None:
    """Draw its axes only when they change; they cost more than the curves that move over them."""
    for side in ("left", "bottom"):
        plot.getAxis(side).setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)


class ScrollPlot(QWidget):
    """Curves over the last ``span`` s; ``pointed`` says the instant under the pointer (s, ≤ 0)."""

    pointed = Signal(float)
    left = Signal()

    def __init__(
        self,
        title: str,
        span: float,
        limits: tuple[float, float] | None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._limits = limits
        self.plot = pg.PlotWidget(enableMenu=False)
        self.plot.setMinimumHeight(80)
        self.plot.setLabel("left", title)
        self.plot.setXRange(-span, 0, padding=0)
        self.plot.setMouseEnabled(x=False, y=False)
        self.plot.hideButtons()
        self.plot.showGrid(y=True, alpha=0.2)
        keep_axes(self.plot)
        if limits is not None:
            self.plot.setYRange(*limits, padding=0)
        self.curves: list[pg.PlotDataItem] = []
        self._cursor = pg.InfiniteLine(angle=90, movable=False)
        self._cursor.hide()
        self.plot.addItem(self._cursor, ignoreBounds=True)
        self.plot.scene().sigMouseMoved.connect(self._moved)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.plot)

    def set_colours(self, background: str, text: str) -> None:
        """Dress the plot; pyqtgraph does not follow the palette by itself."""
        self.plot.setBackground(background)
        self._cursor.setPen(pg.mkPen(text, width=1))
        for side in ("left", "bottom"):
            self.plot.getAxis(side).setPen(text)
            self.plot.getAxis(side).setTextPen(text)

    def set_curves(self, colours: Sequence[str]) -> None:
        """Begin anew with one empty curve for each colour."""
        for curve in self.curves:
            self.plot.removeItem(curve)
        self.curves = [self.plot.plot(pen=pg.mkPen(c, width=1)) for c in colours]

    def show_values(self, t: Array, values: Array) -> None:
        """t (n,) s, values (n, k) for the k curves; NaN breaks a line."""
        for k, curve in enumerate(self.curves):
            curve.setData(t, values[:, k], connect="finite")
        seen = values[:, [c.isVisible() for c in self.curves]]
        if self._limits is None and np.isfinite(seen).any():
            low, high = float(np.nanmin(seen)), float(np.nanmax(seen))
            margin = max(MARGIN * (high - low), 1.0)
            self.plot.setYRange(low - margin, high + margin, padding=0)

    def show_cursor(self, t: float | None) -> None:
        """A line at an instant; None takes it away."""
        self._cursor.setVisible(t is not None)
        if t is not None:
            self._cursor.setValue(t)

    def _moved(self, place: QPointF) -> None:
        if self.plot.plotItem.vb.sceneBoundingRect().contains(place):
            self.pointed.emit(self.plot.plotItem.vb.mapSceneToView(place).x())

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.left.emit()
