"""Curves over time with a cursor and a replay position.

Curves are composed by compiled code (`app.widgets.curve_canvas`) over an image of the axes, which
pyqtgraph draws only when they change.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.widgets.curve_canvas import CurveCanvas
from tracker.messages import Array

MARGIN = 0.05  # relative to the range, above and below curves


class CurveLook(NamedTuple):
    """``right``: on the right axis."""

    colour: str
    style: Qt.PenStyle = Qt.PenStyle.SolidLine
    name: str = ""
    right: bool = False


class CurveItem(pg.PlotCurveItem):
    """A curve's data and look; `CurveCanvas` draws it. ``box``: the view of its axis."""

    def __init__(self, look: CurveLook, box: pg.ViewBox) -> None:
        pen = pg.mkPen(look.colour, width=1, style=look.style)  # of the legend
        super().__init__(pen=pen, name=look.name or None)
        self.colour, self.style, self.box = look.colour, look.style, box

    def show_points(self, t: Array, values: Array) -> None:
        """t (n,), values (n,); NaN interrupts the line."""
        self.xData, self.yData = t, values

    def boundingRect(self) -> QRectF:
        return QRectF()

    def paint(self, *_: object) -> None:
        """Nothing."""


def span_of(values: Array) -> tuple[float, float] | None:
    """Axis range of the finite ``values``, with a margin; None without any."""
    known = values[np.isfinite(values)]
    if not len(known):
        return None
    low, high = float(known.min()), float(known.max())
    margin = MARGIN * (high - low) or max(MARGIN * abs(high), 1e-3)
    return low - margin, high + margin


class CurvePlot(QWidget):
    """``pointed``: the instant under the pointer (s); ``left``: the pointer has left the plot;
    ``seek_requested``: a click at an instant while a position is shown."""

    pointed = Signal(float)
    left = Signal()
    seek_requested = Signal(float)

    def __init__(self, title: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.plot = pg.PlotWidget(enableMenu=False)
        self.plot.setMinimumHeight(80)
        self._title = title
        if title:
            self.plot.setLabel("left", title)
        self.plot.setMouseEnabled(x=False, y=False)
        self.plot.hideButtons()
        self.plot.showGrid(y=True, alpha=0.2)
        self.plot.getAxis("bottom").enableAutoSIPrefix(False)
        self.curves: list[CurveItem] = []
        self._looks: Sequence[CurveLook] = ()
        self._canvas = CurveCanvas(self.plot)
        self._drawn: tuple[Sequence[tuple[Array, Array]], float] = (), 0.0
        self._cursor, self.at = (pg.InfiniteLine(angle=90, movable=False) for _ in range(2))
        for line in (self._cursor, self.at):
            line.hide()
            self.plot.addItem(line, ignoreBounds=True)
        self.plot.scene().changed.connect(self._scene_changed)
        self.plot.scene().sigMouseMoved.connect(self._moved)
        self.plot.scene().sigMouseClicked.connect(self._clicked)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.plot)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Elide the title in the middle if the axis is shorter; the unit is at its end."""
        super().resizeEvent(event)
        if self._title:
            axis = self.plot.getAxis("left")
            room = max(self.height() - self.plot.getAxis("bottom").height(), 1)
            metrics = QFontMetricsF(axis.label.font())
            axis.setLabel(metrics.elidedText(self._title, Qt.TextElideMode.ElideMiddle, room))

    def set_colours(self, background: str, text: str) -> None:
        """Set the colours; pyqtgraph does not follow the palette."""
        self.plot.setBackground(background)
        for line in (self._cursor, self.at):
            line.setPen(pg.mkPen(text, width=1))
        for side in ("left", "bottom", "right"):
            self.plot.getAxis(side).setPen(text)
            self.plot.getAxis(side).setTextPen(text)

    def set_looks(self, looks: Sequence[CurveLook]) -> None:
        """Replace all curves by an empty curve for each look."""
        for curve, look in zip(self.curves, self._looks, strict=True):
            self._place(look).removeItem(curve)
        self._looks, self.curves, self._drawn = tuple(looks), [], ((), 0.0)
        self._canvas.hide()
        for look in looks:
            pos = self._place(look)
            curve = CurveItem(look, pos if isinstance(pos, pg.ViewBox) else pos.vb)
            pos.addItem(curve)
            self.curves.append(curve)

    @property
    def looks(self) -> Sequence[CurveLook]:
        """Looks of the curves."""
        return self._looks

    def _place(self, look: CurveLook) -> pg.PlotItem | pg.ViewBox:
        """The item that draws a curve of this look."""
        return self.plot.getPlotItem()

    def draw(self, curves: Sequence[tuple[Array, Array]], now: float = 0.0) -> None:
        """t (n,) s and values (n,) of each curve; NaN interrupts a line. ``now`` (s) is at 0 of the
        axis; only the visible part is drawn."""
        for curve, (t, values) in zip(self.curves, curves, strict=True):
            curve.show_points(t - now if now else t, values)
        self._drawn = curves, now
        self._fit_axes()
        self._compose()

    def _fit_axes(self) -> None:
        """Adapt the axes to the curves before they are drawn."""

    def _spans(self) -> Array:
        """(n, 2): least and greatest value of the visible part of each curve, NaN without any."""
        return self._canvas.spans(self.curves, *self._drawn)

    def _fit(self, box: pg.ViewBox, wanted: tuple[float, float], padding: float = 0.0) -> None:
        """Grow immediately, shrink late: redrawing an axis is the most expensive part."""
        low, high = box.viewRange()[1]
        size = wanted[1] - wanted[0]
        inside = low <= wanted[0] and wanted[1] <= high
        if not inside or high - low > 1.5 * size:
            box.setYRange(*wanted, padding=padding)
            self._canvas.is_stale = True

    def _compose(self) -> None:
        """Draw the curves over the plot's axes."""
        if self._drawn[0]:
            self._canvas.compose(self.curves, *self._drawn)

    def _scene_changed(self) -> None:
        """Axes, grid or a line have changed, or where they are."""
        self._canvas.is_stale = True
        if self.isVisible():
            self._compose()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._compose()

    def show_curve(self, index: int, on: bool) -> None:
        """Show or hide a curve."""
        self.curves[index].setVisible(on)
        self._compose()

    def show_cursor(self, t: float | None) -> None:
        """Show a line at an instant; None hides it."""
        self._cursor.setVisible(t is not None)
        if t is not None:
            self._cursor.setValue(t)

    def show_position(self, position: float | None) -> None:
        """Show a line at a replay position (s); None hides it."""
        self.at.setVisible(position is not None)
        if position is not None:
            self.at.setValue(position)

    def _moved(self, pos: QPointF) -> None:
        if self.plot.plotItem.vb.sceneBoundingRect().contains(pos):
            self.pointed.emit(self.plot.plotItem.vb.mapSceneToView(pos).x())

    def _clicked(self, event: object) -> None:
        at = self.plot.getPlotItem().vb.mapSceneToView(event.scenePos())  # type: ignore[attr-defined]
        if self.at.isVisible():
            self.seek_requested.emit(float(at.x()))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.left.emit()


class ScrollPlot(CurvePlot):
    """Curves over the last ``span`` s, between ``limits`` or scaled to the values."""

    def __init__(
        self,
        title: str,
        span: float,
        limits: tuple[float, float] | None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(title, parent)
        self._limits = limits
        self.plot.setXRange(-span, 0, padding=0)
        if limits is not None:
            self.plot.setYRange(*limits, padding=0)

    def _fit_axes(self) -> None:
        """Without limits the axis follows the visible curves."""
        found = span_of(self._spans()) if self._limits is None and self.curves else None
        if found is not None:
            low, high = found
            room = max(0.0, 1.0 - MARGIN * (high - low))
            self._fit(self.plot.getPlotItem().vb, (low - room, high + room))


class TwoAxisPlot(CurvePlot):
    """A plot with a left and a right axis, which follow their curves until one is zoomed."""

    def __init__(self) -> None:
        super().__init__()
        item = self.plot.getPlotItem()
        self.right = pg.ViewBox(enableMenu=False)
        item.scene().addItem(self.right)
        item.getAxis("right").linkToView(self.right)
        self.right.setXLink(item.vb)
        self.right.setMouseEnabled(x=False, y=True)
        item.vb.sigResized.connect(self._fit_right)
        item.vb.sigRangeChangedManually.connect(lambda _which: self.zoomed_by_user())
        self.right.sigRangeChangedManually.connect(lambda _which: self.zoomed_by_user())
        self.plot.setLabel("bottom", "s")
        self.follows = True  # whether the axes follow the curves
        for axis in ("left", "right"):
            item.getAxis(axis).enableAutoSIPrefix(False)

    def zoomed_by_user(self) -> None:
        """Stop following the curves."""
        self.follows = False

    def _fit_right(self) -> None:
        self.right.setGeometry(self.plot.getPlotItem().vb.sceneBoundingRect())

    def _place(self, look: CurveLook) -> pg.PlotItem | pg.ViewBox:
        return self.right if look.right else super()._place(look)

    def show_axes(self, left: str, right: str) -> None:
        """Set the titles; an empty right one hides that axis."""
        self.plot.setLabel("left", left)
        self.plot.showAxis("right", bool(right))
        if right:
            self.plot.setLabel("right", right)
        self._fit_right()

    def show_time(self, begin: float, end: float) -> None:
        """Show the time axis from ``begin`` to ``end`` (s)."""
        before = self.plot.viewRange()[0]
        if abs(before[0] - begin) > 1e-6 or abs(before[1] - end) > 1e-6:
            self.plot.setXRange(begin, end, padding=0)

    def _fit_axes(self) -> None:
        """Both axes are fitted to the visible part unless they are zoomed."""
        if not self.follows or not self.curves:
            return
        spans = self._spans()
        for box in (self.plot.getPlotItem().vb, self.right):
            found = span_of(spans[[curve.box is box for curve in self.curves]])
            if found is not None:
                self._fit(box, found, padding=0.05)
