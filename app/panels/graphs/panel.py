"""Graphs that the user puts together of any signals, live and over a whole recording."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QLabel,
    QPushButton,
    QScrollArea,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.jobs.recording_curves import read_signals
from app.panels.graphs.layouts import GraphLayouts
from app.panels.graphs.plot import GraphPlot
from app.panels.graphs.tree import SignalTree
from app.panels.panel import Panel, PanelColours
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsStore
from app.viewmodels.graphs import (
    MOST_GRAPHS,
    SPANS,
    Graph,
    first_graphs,
    from_setting,
    refusal,
    table,
    to_setting,
)
from app.viewmodels.signal_curves import Curve, LiveCurves, TakeCurves
from app.viewmodels.signals import Signal as Figure
from app.viewmodels.signals import signals
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine

FIGURES_EVERY = 20  # refreshes between two looks for new figures of the status


class GraphsPanel(Panel):
    """Reads and computes nothing while it is out of sight."""

    period = 1 / 20

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(host, parent)
        self._store = store
        self.plots: list[GraphPlot] = []
        self.chosen: GraphPlot | None = None
        self.signals: dict[str, Figure] = {}
        self._setup: EngineSetup | None = None  # of which the signals are
        self._figures: frozenset[str] = frozenset()
        self._live = LiveCurves(SPANS[-1])
        self._take: TakeCurves | None = None
        self._reading = LatestJob(self.tr("Reading the recording's signals"), self)
        self._reading.failed.connect(self._say)
        self._turn = 0
        self._colours: tuple[str, str] | None = None
        self.tree = SignalTree()
        self.tree.toggled.connect(self._toggle)
        self._lay_out()
        self.layouts = GraphLayouts(self, self.layout_button, store)
        self.layouts.chosen.connect(self.show_graphs)
        host.opened.connect(lambda _setup: self._forget(new_engine=True))
        host.hand_changed.connect(lambda _setup: self._forget(new_engine=False))
        host.closed.connect(lambda: self._forget(new_engine=True))
        self.show_graphs(from_setting(store.value.graphs.get("shown")))

    def _lay_out(self) -> None:
        self.add = QPushButton(self.tr("Add graph"))
        self.add.clicked.connect(lambda: self._add_graph())
        self.pause = QPushButton(self.tr("Pause all"))
        self.pause.setCheckable(True)
        self.pause.toggled.connect(self._pause_all)
        self.show_tree = QPushButton(self.tr("Signals"))
        self.show_tree.setToolTip(self.tr("Show the tree of signals"))
        self.show_tree.setCheckable(True)
        self.show_tree.setChecked(bool(self._store.value.graphs.get("tree", True)))
        self.show_tree.toggled.connect(self._show_tree)
        self.layout_button = QToolButton()
        self.layout_button.setText(self.tr("Layouts"))
        self.layout_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        head = OneLine()
        for widget in (self.add, self.pause, self.show_tree, self.layout_button):
            head.add(widget)
        self.said = QLabel()
        self.said.setWordWrap(True)
        self.said.hide()
        stack = QWidget()
        self._column = QVBoxLayout(stack)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(TIGHT)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        area.setWidget(stack)
        both = QSplitter()
        both.addWidget(self.tree)
        both.addWidget(area)
        both.setSizes([220, 620])
        both.setStretchFactor(1, 1)
        self.tree.setVisible(self.show_tree.isChecked())
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(TIGHT)
        column.addWidget(head)
        column.addWidget(self.said)
        column.addWidget(both, 1)

    def show_theme(self, colours: PanelColours) -> None:
        self._colours = colours.base, colours.text
        for plot in self.plots:
            plot.plot.set_colours(*self._colours)

    def _say(self, text: str) -> None:
        self.said.setText(text)
        self.said.setVisible(bool(text))

    # --- the graphs

    @property
    def graphs(self) -> list[Graph]:
        """As the user has put them together."""
        return [plot.graph for plot in self.plots]

    def show_graphs(self, graphs: Sequence[Graph]) -> None:
        """Put these in place of those before."""
        for plot in self.plots:
            plot.setParent(None)
            plot.deleteLater()
        self.plots, self.chosen = [], None
        for graph in graphs:
            self._put(graph)
        self._choose(self.plots[0] if self.plots else None)
        self._collect()

    def _put(self, graph: Graph) -> GraphPlot:
        plot = GraphPlot(graph)
        plot.picked.connect(lambda: self._choose(plot))
        plot.closed.connect(lambda: self._remove(plot))
        plot.copied.connect(lambda: self._copy(plot))
        plot.changed.connect(self._remember)
        plot.dropped.connect(lambda keys: self.add_signals(plot, keys))
        plot.plot.pointed.connect(lambda t: self._point(plot, t))
        plot.plot.left.connect(lambda: self._point(plot, None))
        plot.plot.sought.connect(self._seek)
        if self._colours is not None:
            plot.plot.set_colours(*self._colours)
        plot.set_replay(self._is_replay)
        self.plots.append(plot)
        self._column.addWidget(plot, 1)
        self._show_signals(plot)
        self.add.setEnabled(len(self.plots) < MOST_GRAPHS)
        return plot

    def _add_graph(self) -> None:
        self._choose(self._put(Graph()))
        self._remember()

    def _remove(self, plot: GraphPlot) -> None:
        at = self.plots.index(plot)
        self.plots.remove(plot)
        plot.setParent(None)
        plot.deleteLater()
        self.add.setEnabled(True)
        if plot is self.chosen:
            self._choose(self.plots[min(at, len(self.plots) - 1)] if self.plots else None)
        self._collect()
        self._remember()

    def _choose(self, plot: GraphPlot | None) -> None:
        """The graph whose signals the tree ticks."""
        self.chosen = plot
        for each in self.plots:
            each.choose(each is plot)
        self.tree.tick(plot.graph.keys if plot is not None else ())

    def _show_signals(self, plot: GraphPlot) -> None:
        known = [self.signals[key] for key in plot.graph.keys if key in self.signals]
        missing = [key for key in plot.graph.keys if key not in self.signals]
        plot.show_signals(known, missing if self._setup is not None else ())

    def _toggle(self, key: str, on: bool) -> None:
        """In the tree; without a graph the first one is made."""
        if on:
            self.add_signals(self.chosen or self._put(Graph()), [key])
        elif self.chosen is not None:
            self._set(self.chosen, self.chosen.graph.without(key))

    def add_signals(self, plot: GraphPlot, keys: Sequence[str]) -> None:
        """Those for which the graph has room; the first refusal is said."""
        said = ""
        for key in keys:
            signal, graph = self.signals.get(key), plot.graph
            if signal is None or key in graph.keys:
                continue
            why = refusal([self.signals[k] for k in graph.keys if k in self.signals], signal)
            said = said or why
            if not why:
                plot.graph = Graph((*graph.keys, key), graph.span, graph.replay_span)
        self._set(plot, plot.graph)
        self._say(said)

    def _set(self, plot: GraphPlot, graph: Graph) -> None:
        plot.graph = graph
        self._show_signals(plot)
        self._choose(plot)
        self._collect()
        self._remember()
        self._say("")

    def _remember(self) -> None:
        shown = {"shown": to_setting(self.graphs), "tree": self.show_tree.isChecked()}
        self._store.update(graphs={**self._store.value.graphs, **shown})

    def _show_tree(self, on: bool) -> None:
        self.tree.setVisible(on)
        self._remember()

    def _pause_all(self, on: bool) -> None:
        for plot in self.plots:
            plot.controls.pause.setChecked(on)

    # --- the engine

    @property
    def _is_replay(self) -> bool:
        return self._setup is not None and self._setup.player is not None

    def _forget(self, new_engine: bool) -> None:
        """What was known of the engine; the next refresh in sight asks for it."""
        self._setup = None
        if new_engine:
            self._reading.forget()
            self._take = None
            self._live.clear()
            self._say("")

    def _open(self, view: Snapshot) -> None:
        """The signals of what is open; a recording is read as a whole."""
        setup = self._setup = view.setup
        self._list_signals(view)
        if not self.plots and "shown" not in self._store.value.graphs:
            self.show_graphs(first_graphs(self.signals.values()))
        for plot in self.plots:
            plot.set_replay(self._is_replay)
        if setup.player is not None and self._take is None:
            self._say(self.tr("Reading the whole recording…"))
            self._reading.run(read_signals(setup.player.path, setup), self._use_take)

    def _use_take(self, take: TakeCurves) -> None:
        self._take = take
        self._say("")
        view = self.host.snapshot()
        if view is not None and self._setup is not None:
            self._list_signals(view)

    def _list_signals(self, view: Snapshot) -> None:
        found = set(self._take.figures) if self._take is not None else set(self._figures)
        for hand in view.hands:
            found |= set(hand.status.values) if hand.status is not None else set()
        self._figures = frozenset(found)
        self.signals = {signal.key: signal for signal in signals(view.setup, found)}
        self.tree.show_signals(self.signals.values())
        self.tree.tick(self.chosen.graph.keys if self.chosen is not None else ())
        for plot in self.plots:
            self._show_signals(plot)
        self._collect()

    def _collect(self) -> None:
        """Have values of the signals of all graphs, and of no others."""
        keys = dict.fromkeys(key for plot in self.plots for key in plot.graph.keys)
        self._live.choose(self.signals[key] for key in keys if key in self.signals)

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            return
        if self._setup is None:
            self._open(view)
        self._turn += 1
        if self._turn % FIGURES_EVERY == 0 and self._has_new_figures(view):
            self._list_signals(view)
        player = view.setup.player
        if player is None:
            self._live.take(view)
        for plot in self.plots:
            if not plot.is_in_sight:
                continue
            curves = [self._curve(signal) for signal in plot.signals]
            if player is None:
                plot.draw_live(curves, _now(view))
            else:
                plot.draw_take(curves, player.position, player.duration)

    def _has_new_figures(self, view: Snapshot) -> bool:
        return any(
            h.status is not None and not self._figures.issuperset(h.status.values)
            for h in view.hands
        )

    def _curve(self, signal: Figure) -> Curve:
        if self._is_replay and self._take is not None:
            return self._take.curve(signal)
        return self._live.curve(signal.key)

    # --- reading and taking it out

    def _point(self, plot: GraphPlot, t: float | None) -> None:
        """The cursor stands at one instant in all graphs that show the same time."""
        for each in self.plots:
            each.read(t if t is None else t + plot.now - each.now)

    def _seek(self, position: float) -> None:
        player = self._setup.player if self._setup is not None else None
        if player is not None:
            player.seek(min(max(position, 0.0), player.duration))

    def _copy(self, plot: GraphPlot) -> None:
        begin, end = plot.plot.plot.viewRange()[0]
        curves = dict(zip(plot.signals, plot.curves, strict=False))
        text = table(curves, begin + plot.now, end + plot.now, plot.now)
        QGuiApplication.clipboard().setText(text)
        lines = text.count("\n") - 1
        self._say(self.tr("Copied {} lines of {} curves as CSV.").format(lines, len(curves)))

    def shut_down(self) -> None:
        self._reading.shut_down()


def _now(view: Snapshot) -> float:
    """The instant (s) that stands at the right edge of live graphs: the newest of all streams."""
    latest = [
        messages[-1].t for hand in view.hands for messages in (hand.imu, hand.estimates) if messages
    ]
    if latest:
        return max(latest)
    return view.status.t if view.status is not None else 0.0
