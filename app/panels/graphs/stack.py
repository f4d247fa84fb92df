"""The graphs of the Graphs panel, one below the other; one of them is selected."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.panels.graphs.plot import GraphPlot
from app.viewmodels.graphs import MOST_GRAPHS, Graph, refusal, table
from app.viewmodels.signals import Signal as Figure
from app.widgets.measures import TIGHT


class GraphStack(QWidget):
    """``changed``: other graphs or signals are shown. ``edited``: the user changed them.
    ``selected``: the signals (keys) of the selected graph. ``message``: the result of an action.
    ``seek_requested``: a click at an instant of a recording (s)."""

    changed = Signal()
    edited = Signal()
    selected = Signal(tuple)
    message = Signal(str)
    seek_requested = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.plots: list[GraphPlot] = []
        self.chosen: GraphPlot | None = None
        self._signals: Mapping[str, Figure] | None = None  # None until they are known
        self._is_replay = False
        self._colours: tuple[str, str] | None = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(TIGHT)

    @property
    def graphs(self) -> list[Graph]:
        """Descriptions of all graphs, from top to bottom."""
        return [plot.graph for plot in self.plots]

    @property
    def is_full(self) -> bool:
        return len(self.plots) >= MOST_GRAPHS

    def set_colours(self, background: str, text: str) -> None:
        self._colours = background, text
        for plot in self.plots:
            plot.plot.set_colours(background, text)

    def set_replay(self, on: bool) -> None:
        """Show the time axes of a recording, or of live data."""
        self._is_replay = on
        for plot in self.plots:
            plot.set_replay(on)

    def pause_all(self, on: bool) -> None:
        for plot in self.plots:
            plot.controls.pause.setChecked(on)

    # --- which graphs

    def show_graphs(self, graphs: Sequence[Graph]) -> None:
        """Replace all graphs."""
        for plot in self.plots:
            plot.setParent(None)
            plot.deleteLater()
        self.plots, self.chosen = [], None
        for graph in graphs:
            self._put(graph)
        self._select(self.plots[0] if self.plots else None)
        self.changed.emit()

    def add_graph(self) -> None:
        """Add an empty graph and select it."""
        self._select(self._put(Graph()))
        self.changed.emit()
        self.edited.emit()

    def _put(self, graph: Graph) -> GraphPlot:
        plot = GraphPlot(graph)
        plot.picked.connect(lambda: self._select(plot))
        plot.closed.connect(lambda: self._remove(plot))
        plot.copied.connect(lambda: self._copy(plot))
        plot.changed.connect(self.edited)
        plot.dropped.connect(lambda keys: self.add_signals(plot, keys))
        plot.plot.pointed.connect(lambda t: self._point(plot, t))
        plot.plot.left.connect(lambda: self._point(plot, None))
        plot.plot.seek_requested.connect(self.seek_requested)
        if self._colours is not None:
            plot.plot.set_colours(*self._colours)
        plot.set_replay(self._is_replay)
        self.plots.append(plot)
        self._column.addWidget(plot, 1)
        self._show_signals(plot)
        return plot

    def _remove(self, plot: GraphPlot) -> None:
        at = self.plots.index(plot)
        self.plots.remove(plot)
        plot.setParent(None)
        plot.deleteLater()
        if plot is self.chosen:
            self._select(self.plots[min(at, len(self.plots) - 1)] if self.plots else None)
        self.changed.emit()
        self.edited.emit()

    def _select(self, plot: GraphPlot | None) -> None:
        self.chosen = plot
        for each in self.plots:
            each.choose(each is plot)
        self.selected.emit(plot.graph.keys if plot is not None else ())

    # --- their signals

    def show_signals(self, signals: Mapping[str, Figure]) -> None:
        """Label all graphs with these signals, by key."""
        self._signals = signals
        for plot in self.plots:
            self._show_signals(plot)

    def _show_signals(self, plot: GraphPlot) -> None:
        known = self._signals or {}
        missing = [key for key in plot.graph.keys if key not in known]
        shown = [known[key] for key in plot.graph.keys if key in known]
        plot.show_signals(shown, missing if self._signals is not None else ())

    def toggle(self, key: str, on: bool) -> None:
        """Add a signal to the selected graph, or remove it; without a graph, create one."""
        if on:
            self.add_signals(self.chosen or self._put(Graph()), [key])
        elif self.chosen is not None:
            self._set(self.chosen, self.chosen.graph.without(key))

    def add_signals(self, plot: GraphPlot, keys: Sequence[str]) -> None:
        """Add the signals that fit into the graph, and report why the first other one does not."""
        known, problem = self._signals or {}, ""
        for key in keys:
            signal, graph = known.get(key), plot.graph
            if signal is None or key in graph.keys:
                continue
            why = refusal([known[k] for k in graph.keys if k in known], signal)
            problem = problem or why
            if not why:
                plot.graph = Graph((*graph.keys, key), graph.span, graph.replay_span)
        self._set(plot, plot.graph)
        self.message.emit(problem)

    def _set(self, plot: GraphPlot, graph: Graph) -> None:
        plot.graph = graph
        self._show_signals(plot)
        self._select(plot)
        self.changed.emit()
        self.edited.emit()
        self.message.emit("")

    # --- cursor and clipboard

    def _point(self, plot: GraphPlot, t: float | None) -> None:
        """Show the cursor of all graphs at the same instant."""
        for each in self.plots:
            each.read(t if t is None else t + plot.now - each.now)

    def _copy(self, plot: GraphPlot) -> None:
        begin, end = plot.plot.plot.viewRange()[0]
        curves = dict(zip(plot.signals, plot.curves, strict=False))
        text = table(curves, begin + plot.now, end + plot.now, plot.now)
        QGuiApplication.clipboard().setText(text)
        lines = text.count("\n") - 1
        self.message.emit(self.tr("Copied {} rows of {} curves as CSV.").format(lines, len(curves)))
