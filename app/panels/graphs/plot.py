"""One graph: its curves, a legend that reads them, and its own pause, zoom and span."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from app.panels.graphs.controls import GraphControls
from app.panels.graphs.looks import curve_looks
from app.panels.graphs.tree import keys_in
from app.viewmodels.graphs import WHOLE, Graph, axis_title, number, units_of, value_at
from app.viewmodels.signal_curves import Curve, no_curve
from app.viewmodels.signals import Signal as Figure
from app.widgets.curve_plot import CurveLook, CurvePlot, keep_axes, span_of
from app.widgets.measures import TIGHT
from app.words import local
from tracker.messages import Array

SIGNS = {Qt.PenStyle.SolidLine: "━", Qt.PenStyle.DashLine: "╍", Qt.PenStyle.DotLine: "┅"}
HEIGHT = 130  # px that a graph has at least
TRAIL = 0.5
"""Share of a replay graph's span that is before the position."""


class TwoAxisPlot(CurvePlot):
    """A plot whose curves may belong to an axis at the right; both follow their curves until one
    is zoomed."""

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
        """The axes stay as the user has put them."""
        self.follows = False

    def _fit_right(self) -> None:
        self.right.setGeometry(self.plot.getPlotItem().vb.sceneBoundingRect())

    def _place(self, look: CurveLook) -> pg.PlotItem | pg.ViewBox:
        return self.right if look.right else super()._place(look)

    def show_axes(self, left: str, right: str) -> None:
        """Titles; an empty right one takes that axis away."""
        self.plot.setLabel("left", left)
        self.plot.showAxis("right", bool(right))
        if right:
            self.plot.setLabel("right", right)
            keep_axes(self.plot, ("right",))
        self._fit_right()

    def draw(self, curves: Sequence[tuple[Array, Array]], now: float = 0.0) -> None:
        """As of every plot; both axes are fitted to what is in sight, unless they are zoomed."""
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
    """Grow at once, shrink late: an axis that changes is drawn again, which costs the most."""
    low, high = box.viewRange()[1]
    size = wanted[1] - wanted[0]
    inside = low <= wanted[0] and wanted[1] <= high
    if not inside or high - low > 1.5 * size:
        box.setYRange(wanted[0], wanted[1], padding=0.05)


class GraphPlot(QFrame):
    """Widgets; `GraphsPanel` gives the curves. ``changed``: another span was chosen; ``picked``:
    it was clicked; ``dropped``: signals were dropped on it."""

    changed = Signal()
    picked = Signal()
    closed = Signal()
    copied = Signal()
    dropped = Signal(list)

    def __init__(self, graph: Graph, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.graph = graph
        self.signals: list[Figure] = []  # in the order of the curves
        self.curves: list[Curve] = []  # as they are drawn
        self.now = 0.0  # s at 0 of the axis
        self._is_replay = False
        self._missing: list[str] = []
        self.plot = TwoAxisPlot()
        self.plot.setMinimumHeight(HEIGHT)
        ignored = QSizePolicy.Policy.Ignored  # pyqtgraph asks for 480 px
        self.plot.setSizePolicy(ignored, ignored)
        self.controls = GraphControls()
        self.legend = QLabel()
        self.legend.setWordWrap(True)
        self.legend.setTextFormat(Qt.TextFormat.RichText)
        self.legend.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.mark = QFrame()
        self.mark.setFixedWidth(TIGHT)
        self._lay_out()
        self._connect()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(TIGHT)
        head.addWidget(self.legend, 1)
        head.addWidget(self.controls, 0, Qt.AlignmentFlag.AlignTop)
        column = QVBoxLayout()
        column.setSpacing(0)
        column.addLayout(head)
        column.addWidget(self.plot, 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(TIGHT)
        row.addWidget(self.mark)
        row.addLayout(column, 1)
        self.setAcceptDrops(True)
        for widget in (self.plot.plot, self.plot.plot.viewport()):
            widget.setAcceptDrops(False)  # they are the graph's
        self.plot.plot.viewport().installEventFilter(self)

    def _connect(self) -> None:
        self.controls.span.activated.connect(self._choose_span)
        self.controls.pause.toggled.connect(lambda _on: self._free_time())
        self.controls.fit.clicked.connect(self.fit)
        self.controls.copy.clicked.connect(self.copied)
        self.controls.close_button.clicked.connect(self.closed)

    # --- what it shows

    def show_signals(self, signals: Sequence[Figure], missing: Sequence[str]) -> None:
        """Its curves; ``missing`` are keys of what is not there now."""
        self.signals, self._missing = list(signals), list(missing)
        units = units_of(signals)
        looks = curve_looks([""] * len(signals))
        self.plot.set_looks(
            [
                look._replace(right=units.index(signal.unit) > 0)
                for look, signal in zip(looks, signals, strict=True)
            ]
        )
        of_axis = [[s for s in signals if s.unit == unit] for unit in units]
        titles = [axis_title(each) for each in (*of_axis, [], [])]
        self.plot.show_axes(titles[0], titles[1])
        self.curves = []
        self.fit()
        self.read(None)

    def choose(self, on: bool) -> None:
        """Mark it as the graph that the tree belongs to."""
        self.mark.setStyleSheet("background: palette(highlight);" if on else "")

    def set_replay(self, on: bool) -> None:
        """Offer the spans of a recording, or of a live hand."""
        self._is_replay = on
        self.controls.offer_spans(on, self.graph.replay_span if on else self.graph.span)
        self._free_time()
        self.fit()

    @property
    def span(self) -> float:
        """s, or `WHOLE`."""
        return self.graph.replay_span if self._is_replay else self.graph.span

    @property
    def paused(self) -> bool:
        return self.controls.pause.isChecked()

    @property
    def is_in_sight(self) -> bool:
        """Whether anything of its curves can be seen."""
        return not self.plot.plot.viewport().visibleRegion().isEmpty()

    def draw_live(self, curves: Sequence[Curve], now: float) -> None:
        """Curves that end at ``now`` (s)."""
        if self.paused:
            return
        self.curves, self.now = list(curves), now
        self.redraw()

    def hold(self) -> None:
        """Keep what is shown: the buffers of the curves go on."""
        self.curves = [(t.copy(), values.copy()) for t, values in self.curves]

    def draw_take(self, curves: Sequence[Curve], position: float, duration: float) -> None:
        """Curves of a recording of ``duration`` s that is shown at ``position`` (s)."""
        if not self.paused:
            self.plot.show_position(position)
        if self.plot.follows and not self.paused:
            span = self.span
            begin = 0.0 if span == WHOLE else position - TRAIL * span
            end = duration if span == WHOLE else begin + span
            self._show_time(begin, end)
        self.curves, self.now = list(curves), 0.0
        self.redraw()

    def redraw(self) -> None:
        """After a zoom, too, while no new curves come."""
        if self.curves:
            self.plot.draw(self.curves, self.now)

    def _show_time(self, begin: float, end: float) -> None:
        before = self.plot.plot.viewRange()[0]
        if abs(before[0] - begin) > 1e-6 or abs(before[1] - end) > 1e-6:
            self.plot.plot.setXRange(begin, end, padding=0)

    # --- zoom

    def _free_time(self) -> None:
        """Of a curve that scrolls time cannot be zoomed, only values."""
        if self.paused:
            self.hold()
        self.plot.plot.setMouseEnabled(x=self.paused or self._is_replay, y=True)
        if not self.paused:
            self.fit()

    def fit(self) -> None:
        """Both axes follow the curves again."""
        self.plot.follows = True
        if not self._is_replay:
            self._show_time(-self.span, 0.0)
        self.redraw()

    def _choose_span(self) -> None:
        span = self.controls.chosen_span
        graph = self.graph
        self.graph = (
            Graph(graph.keys, graph.span, span)
            if self._is_replay
            else Graph(graph.keys, span, graph.replay_span)
        )
        self.fit()
        self.changed.emit()

    # --- reading

    def read(self, t: float | None) -> None:
        """Show the cursor at an instant of the axis, and the values there in the legend."""
        self.plot.show_cursor(t)
        entries = []
        curves = self.curves or [no_curve()] * len(self.signals)
        for signal, curve, look in zip(self.signals, curves, self.plot.looks, strict=True):
            text = escape(signal.label).replace(" ", "&nbsp;")  # lines break between entries
            if t is not None:
                value = number(value_at(curve, self.now + t))
                text += f"&nbsp;<b>{value}</b>&nbsp;{escape(signal.unit)}"
            entries.append(
                f'<span style="color:{look.colour}">{SIGNS[look.style]}</span>&nbsp;{text}'
            )
        gone = self.tr("not available")
        entries += [f"<i>{escape(key)}: {escape(gone)}</i>" for key in self._missing]
        if not entries:
            entries = [escape(self.tr("Tick signals in the tree, or drag them here."))]
        at = f"{local(t):.2f} s&nbsp;&nbsp; " if t is not None else ""
        self.legend.setText(at + "&nbsp; ".join(entries))

    # --- mouse

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseButtonPress:
            self.picked.emit()
        elif kind == QEvent.Type.MouseButtonDblClick:
            self.fit()
        elif kind in (QEvent.Type.Wheel, QEvent.Type.MouseMove) and self.paused:
            QTimer.singleShot(0, self, self.redraw)
        return super().eventFilter(watched, event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if keys_in(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.dropped.emit(keys_in(event.mimeData()))
