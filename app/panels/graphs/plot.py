"""One graph with its curves, legend, pause, zoom and time span."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.graphs.looks import curve_looks
from app.panels.graphs.tree import keys_in
from app.viewmodels.graphs import SPANS, WHOLE, Graph, axis_title, number, units_of, value_at
from app.viewmodels.signal_curves import Curve, no_curve
from app.viewmodels.signals import Signal as Figure
from app.widgets.curve_plot import CurveLook, TwoAxisPlot
from app.widgets.icons import dress
from app.widgets.measures import TIGHT
from app.words import local

SIGNS = {Qt.PenStyle.SolidLine: "━", Qt.PenStyle.DashLine: "╍", Qt.PenStyle.DotLine: "┅"}
HEIGHT = 130  # px, minimum height
TRAIL = 0.5
"""Share of the time span of a replay graph that is before the position."""


class GraphControls(QWidget):
    """The row of controls of a graph."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.span = QComboBox()
        self.span.setAccessibleName(self.tr("Time window"))
        self.span.setToolTip(self.tr("Time window"))
        self.pause = self._button("pause", self.tr("Pause this graph; tracking continues"))
        self.pause.setCheckable(True)
        words = self.tr("Fit both axes to the curves (double-click the graph)")
        self.fit = self._button("maximize", words)
        self.copy = self._button("copy", self.tr("Copy the visible data as CSV"))
        self.close_button = self._button("x", self.tr("Remove this graph"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(TIGHT)
        for widget in (self.span, self.pause, self.fit, self.copy, self.close_button):
            row.addWidget(widget)

    def _button(self, icon: str, text: str) -> QToolButton:
        button = QToolButton()
        dress(button, icon)
        button.setToolTip(text)
        button.setAccessibleName(text)
        button.setAutoRaise(True)
        return button

    def offer_spans(self, replay: bool, chosen: float) -> None:
        """Offer the time spans of a recording, or of live data."""
        self.span.clear()
        for span in (WHOLE, *SPANS) if replay else SPANS:
            text = self.tr("Whole recording") if span == WHOLE else f"{span:.0f} s"
            self.span.addItem(text, span)
        self.span.setCurrentIndex(max(0, self.span.findData(chosen)))

    @property
    def chosen_span(self) -> float:
        """Selected time span in s, or `WHOLE`."""
        return float(self.span.currentData())


class GraphLegend(QLabel):
    """The names of the curves in their colours, with the values at the cursor."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)

    def show_entries(
        self,
        entries: Sequence[tuple[Figure, CurveLook, float | None]],
        missing: Sequence[str],
        t: float | None,
    ) -> None:
        """Signals with their looks and values at ``t`` (s; None without a cursor), and the keys of
        unavailable signals."""
        lines = []
        for signal, look, value in entries:
            text = escape(signal.label).replace(" ", "&nbsp;")  # lines break between entries
            if value is not None:
                text += f"&nbsp;<b>{number(value)}</b>&nbsp;{escape(signal.unit)}"
            lines.append(
                f'<span style="color:{look.colour}">{SIGNS[look.style]}</span>&nbsp;{text}'
            )
        unavailable = escape(self.tr("not available"))
        lines += [f"<i>{escape(key)}: {unavailable}</i>" for key in missing]
        if not lines:
            lines = [escape(self.tr("Tick signals in the tree, or drag them here."))]
        at = f"{local(t):.2f} s&nbsp;&nbsp; " if t is not None else ""
        self.setText(at + "&nbsp; ".join(lines))


class GraphPlot(QFrame):
    """Displays curves that it is given. ``changed``: another time span was selected; ``picked``: it
    was clicked; ``dropped``: signals were dropped on it."""

    changed = Signal()
    picked = Signal()
    closed = Signal()
    copied = Signal()
    dropped = Signal(list)

    def __init__(self, graph: Graph, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.graph = graph
        self.signals: list[Figure] = []  # in the order of the curves
        self.curves: list[Curve] = []  # as drawn
        self.now = 0.0  # s at 0 of the axis
        self._is_replay = False
        self._missing: list[str] = []
        self.plot = TwoAxisPlot()
        self.plot.setMinimumHeight(HEIGHT)
        ignored = QSizePolicy.Policy.Ignored  # pyqtgraph requests 480 px
        self.plot.setSizePolicy(ignored, ignored)
        self.controls = GraphControls()
        self.legend = GraphLegend()
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
            widget.setAcceptDrops(False)  # the graph itself accepts drops
        self.plot.plot.viewport().installEventFilter(self)

    def _connect(self) -> None:
        self.controls.span.activated.connect(self._choose_span)
        self.controls.pause.toggled.connect(lambda _on: self._free_time())
        self.controls.fit.clicked.connect(self.fit)
        self.controls.copy.clicked.connect(self.copied)
        self.controls.close_button.clicked.connect(self.closed)

    # --- displayed data

    def show_signals(self, signals: Sequence[Figure], missing: Sequence[str]) -> None:
        """Show these signals; ``missing`` are the keys of unavailable ones."""
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
        """Highlight the graph as the selected one."""
        self.mark.setStyleSheet("background: palette(highlight);" if on else "")

    def set_replay(self, on: bool) -> None:
        """Offer the time spans of a recording, or of live data."""
        self._is_replay = on
        self.controls.offer_spans(on, self.graph.replay_span if on else self.graph.span)
        self._free_time()
        self.fit()

    @property
    def span(self) -> float:
        """Time span in s, or `WHOLE`."""
        return self.graph.replay_span if self._is_replay else self.graph.span

    @property
    def paused(self) -> bool:
        return self.controls.pause.isChecked()

    @property
    def is_in_sight(self) -> bool:
        """Whether any part of the plot is visible."""
        return not self.plot.plot.viewport().visibleRegion().isEmpty()

    def draw_live(self, curves: Sequence[Curve], now: float) -> None:
        """Draw curves that end at ``now`` (s)."""
        if self.paused:
            return
        self.curves, self.now = list(curves), now
        self.redraw()

    def hold(self) -> None:
        """Copy the displayed curves, since their buffers continue to change."""
        self.curves = [(t.copy(), values.copy()) for t, values in self.curves]

    def draw_recording(self, curves: Sequence[Curve], position: float, duration: float) -> None:
        """Draw the curves of a recording of ``duration`` s with the replay at ``position`` (s)."""
        if not self.paused:
            self.plot.show_position(position)
        if self.plot.follows and not self.paused:
            span = self.span
            begin = 0.0 if span == WHOLE else position - TRAIL * span
            end = duration if span == WHOLE else begin + span
            self.plot.show_time(begin, end)
        self.curves, self.now = list(curves), 0.0
        self.redraw()

    def redraw(self) -> None:
        """Draw the curves again, for example after a zoom."""
        if self.curves:
            self.plot.draw(self.curves, self.now)

    # --- zoom

    def _free_time(self) -> None:
        """Allow zooming in time unless the curve scrolls; values can always be zoomed."""
        if self.paused:
            self.hold()
        self.plot.plot.setMouseEnabled(x=self.paused or self._is_replay, y=True)
        if not self.paused:
            self.fit()

    def fit(self) -> None:
        """Let both axes follow the curves again."""
        self.plot.follows = True
        if not self._is_replay:
            self.plot.show_time(-self.span, 0.0)
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
        """Show the cursor at ``t`` (s on the axis), and the values there in the legend; None hides
        the cursor."""
        self.plot.show_cursor(t)
        curves = self.curves or [no_curve()] * len(self.signals)
        values = [None if t is None else value_at(curve, self.now + t) for curve in curves]
        entries = list(zip(self.signals, self.plot.looks, values, strict=True))
        self.legend.show_entries(entries, self._missing, t)

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
