"""Curves over the last seconds, or over a whole take with a cursor that a click moves."""

from __future__ import annotations

from collections.abc import Sequence

import pyqtgraph as pg
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.viewmodels.motion import shown_name
from app.viewmodels.states import BLUISH_GREEN, ORANGE, PURPLE, SKY, VERMILLION, YELLOW
from app.widgets.scroll_plot import keep_axes
from tracker.messages import Array

COLOURS = (ORANGE, SKY, BLUISH_GREEN, PURPLE, VERMILLION, YELLOW)
STYLES = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine)


class MotionPlot(QWidget):
    """``sought``: a click at an instant (s from the take's first image)."""

    sought = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.plot = pg.PlotWidget(enableMenu=False)
        self.plot.setMinimumHeight(90)
        self.plot.hideButtons()
        self.plot.setMouseEnabled(x=False, y=False)
        self.plot.showGrid(y=True, alpha=0.2)
        keep_axes(self.plot)
        self.plot.setLabel("bottom", "s")
        self.plot.getAxis("bottom").enableAutoSIPrefix(False)
        self.plot.addLegend(offset=(1, 1))
        self.at = pg.InfiniteLine(angle=90, movable=False)
        self.plot.addItem(self.at, ignoreBounds=True)
        self.at.hide()
        self.curves: list[pg.PlotDataItem] = []
        self.plot.scene().sigMouseClicked.connect(self._clicked)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.plot)

    def set_colours(self, background: str, text: str) -> None:
        """Dress the plot; pyqtgraph does not follow the palette by itself."""
        self.plot.setBackground(background)
        self.at.setPen(pg.mkPen(text, width=1))
        for side in ("left", "bottom"):
            self.plot.getAxis(side).setPen(text)
            self.plot.getAxis(side).setTextPen(text)

    def show_names(self, names: Sequence[str]) -> None:
        """A curve for each, empty."""
        self.plot.getPlotItem().clearPlots()
        legend = self.plot.getPlotItem().legend
        legend.clear()
        self.curves = []
        for k, name in enumerate(names):
            style = STYLES[k // len(COLOURS) % len(STYLES)]
            pen = pg.mkPen(COLOURS[k % len(COLOURS)], width=1, style=style)
            self.curves.append(self.plot.plot(name=shown_name(name), pen=pen))

    def show_curves(self, curves: Sequence[tuple[Array, Array]]) -> None:
        for curve, (t, values) in zip(self.curves, curves, strict=True):
            curve.setData(t, values, connect="finite", autoDownsample=True)

    def show_position(self, position: float | None) -> None:
        self.at.setVisible(position is not None)
        if position is not None:
            self.at.setValue(position)

    def _clicked(self, event: object) -> None:
        at = self.plot.getPlotItem().vb.mapSceneToView(event.scenePos())  # type: ignore[attr-defined]
        if self.at.isVisible():
            self.sought.emit(float(at.x()))
