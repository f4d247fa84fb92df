"""Curves over time with a cursor and a replay position.

For speed, pens are one pixel wide, axes are redrawn only when they change and curves have no more
points than the screen can show: wider pens take five times as long.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QPainter, QPainterPath, QResizeEvent
from PySide6.QtWidgets import QGraphicsItem, QVBoxLayout, QWidget

from tracker.messages import Array

MARGIN = 0.05  # relative to the range, above and below curves
LEAST_COLUMNS = 100
"""px, assumed minimum width of a plot before it has a size."""


WORTH = 4
"""Points per column from which on a curve is decimated to two points per column."""


def thinned(t: Array, values: Array, begin: float, end: float, columns: int) -> tuple[Array, Array]:
    """The part of t (n,), increasing, and values (n,) between ``begin`` and ``end``, with a
    neighbour on either side; decimated to the minimum and maximum in each of ``columns``.

    Columns are aligned to multiples of their width, so that a scrolling curve keeps its shape. A
    column with a NaN is NaN, which preserves interruptions.
    """
    first = max(0, int(np.searchsorted(t, begin)) - 1)
    last = int(np.searchsorted(t, end, side="right")) + 1
    t, values = t[first:last], values[first:last]
    if len(t) <= WORTH * columns or end <= begin:
        return t, values
    width = (end - begin) / columns
    edges = np.arange(np.floor(t[0] / width) + 1, np.floor(t[-1] / width) + 1) * width
    starts = np.concatenate([[0], np.searchsorted(t, edges)])
    starts = starts[np.diff(starts, append=len(t)) > 0]  # non-empty columns
    out = np.empty((len(starts), 2))
    out[:, 0] = np.minimum.reduceat(values, starts)
    out[:, 1] = np.maximum.reduceat(values, starts)
    return np.repeat(t[starts], 2), out.ravel()


class CurveLook(NamedTuple):
    """``right``: on the right axis."""

    colour: str
    style: Qt.PenStyle = Qt.PenStyle.SolidLine
    name: str = ""
    right: bool = False


class CurveItem(pg.PlotCurveItem):
    """A curve with the size of its view. For pyqtgraph's own, the size follows from the data at
    each change, which takes three times as long as drawing."""

    _path: QPainterPath | None = None

    def show_points(self, t: Array, values: Array) -> None:
        """t (n,), values (n,); NaN interrupts the line."""
        self.xData, self.yData, self._path = t, values, None
        self.update()

    def boundingRect(self) -> QRectF:
        view = self.getViewBox()
        return QRectF(view.viewRect()) if view is not None else QRectF()

    def paint(self, painter: QPainter, *_: object) -> None:
        if self.xData is None or len(self.xData) < 2:
            return
        if self._path is None:
            whole = np.isfinite(self.yData).all()
            connect = "all" if whole else "finite"
            self._path = pg.arrayToQPath(self.xData, self.yData, connect, finiteCheck=False)
        painter.setPen(self.opts["pen"])
        painter.drawPath(self._path)


def keep_axes(plot: pg.PlotWidget, sides: Sequence[str] = ("left", "bottom")) -> None:
    """Redraw the axes only when they change; they cost more than the curves."""
    for side in sides:
        plot.getAxis(side).setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)


def span_of(values: Array) -> tuple[float, float] | None:
    """Axis range of the finite ``values``, with a margin; None without any."""
    if not np.isfinite(values).any():
        return None
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    margin = MARGIN * (high - low) or max(MARGIN * abs(high), 1e-3)
    return low - margin, high + margin


class CurvePlot(QWidget):
    """``pointed``: the instant under the pointer (s); ``left``: the pointer has left the plot;
    ``sought``: a click at an instant while a position is shown."""

    pointed = Signal(float)
    left = Signal()
    sought = Signal(float)

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
        keep_axes(self.plot)
        self.plot.getAxis("bottom").enableAutoSIPrefix(False)
        self.curves: list[CurveItem] = []
        self._looks: Sequence[CurveLook] = ()
        self._seen: list[Array] = []  # drawn values of each curve
        self._cursor, self.at = (pg.InfiniteLine(angle=90, movable=False) for _ in range(2))
        for line in (self._cursor, self.at):
            line.hide()
            self.plot.addItem(line, ignoreBounds=True)
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
        self._looks, self.curves = tuple(looks), []
        for look in looks:
            pen = pg.mkPen(look.colour, width=1, style=look.style)
            curve = CurveItem(pen=pen, name=look.name or None)
            self._place(look).addItem(curve)
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
        (begin, end), _ = self.plot.viewRange()
        columns = max(LEAST_COLUMNS, int(self.plot.getPlotItem().vb.width()))
        self._seen = []
        for curve, (t, values) in zip(self.curves, curves, strict=True):
            t, values = thinned(t, values, begin + now, end + now, columns)
            curve.show_points(t - now, values)
            self._seen.append(values)

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

    def _moved(self, place: QPointF) -> None:
        if self.plot.plotItem.vb.sceneBoundingRect().contains(place):
            self.pointed.emit(self.plot.plotItem.vb.mapSceneToView(place).x())

    def _clicked(self, event: object) -> None:
        at = self.plot.getPlotItem().vb.mapSceneToView(event.scenePos())  # type: ignore[attr-defined]
        if self.at.isVisible():
            self.sought.emit(float(at.x()))

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

    def draw(self, curves: Sequence[tuple[Array, Array]], now: float = 0.0) -> None:
        """As for every plot; without limits the axis follows the visible curves."""
        super().draw(curves, now)
        shown = zip(self.curves, self._seen, strict=True)
        seen = [values for curve, values in shown if curve.isVisible()]
        found = span_of(np.concatenate(seen)) if self._limits is None and seen else None
        if found is not None:
            low, high = found
            room = max(0.0, 1.0 - MARGIN * (high - low))
            self.plot.setYRange(low - room, high + room, padding=0)


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
            keep_axes(self.plot, ("right",))
        self._fit_right()

    def show_time(self, begin: float, end: float) -> None:
        """Show the time axis from ``begin`` to ``end`` (s)."""
        before = self.plot.viewRange()[0]
        if abs(before[0] - begin) > 1e-6 or abs(before[1] - end) > 1e-6:
            self.plot.setXRange(begin, end, padding=0)

    def draw(self, curves: Sequence[tuple[Array, Array]], now: float = 0.0) -> None:
        """As for every plot; both axes are fitted to the visible part unless they are zoomed."""
        super().draw(curves, now)
        if not self.follows:
            return
        for box, right in ((self.plot.getPlotItem().vb, False), (self.right, True)):
            shown = zip(self._seen, self._looks, strict=True)
            seen = [values for values, look in shown if look.right == right]
            found = span_of(np.concatenate(seen)) if seen else None
            if found is not None:
                _fit(box, found)


def _fit(box: pg.ViewBox, wanted: tuple[float, float]) -> None:
    """Grow immediately, shrink late: redrawing an axis is the most expensive part."""
    low, high = box.viewRange()[1]
    size = wanted[1] - wanted[0]
    inside = low <= wanted[0] and wanted[1] <= high
    if not inside or high - low > 1.5 * size:
        box.setYRange(wanted[0], wanted[1], padding=0.05)
