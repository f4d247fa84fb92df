"""Graphs of any signals, live and over a whole recording."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import (
    QInputDialog,
    QMenu,
    QPushButton,
    QScrollArea,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.snapshot import Snapshot
from app.panels.graphs.data import GraphsHost, SignalData
from app.panels.graphs.stack import GraphStack
from app.panels.graphs.tree import SignalTree
from app.panels.panel import MessageLabel, Panel, PanelColours
from app.storage.settings import SettingsStore
from app.viewmodels.graphs import Graph, first_graphs, from_setting, to_setting
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine
from app.widgets.question import answer


class GraphLayouts(QObject):
    """A menu on ``button``. ``chosen``: the graphs (list of `Graph`) to show."""

    chosen = Signal(list)

    def __init__(self, panel: QWidget, button: QToolButton, store: SettingsStore) -> None:
        super().__init__(panel)
        self._panel, self._store = panel, store
        self.menu = QMenu(button)
        self.menu.aboutToShow.connect(self._list)
        button.setMenu(self.menu)

    @property
    def names(self) -> list[str]:
        """Names of the stored layouts."""
        return [name for name in self._stored if self._stored[name]]

    @property
    def _stored(self) -> dict[str, object]:
        stored = self._store.value.graphs.get("named")
        return stored if isinstance(stored, dict) else {}

    def _list(self) -> None:
        self.menu.clear()
        for name in self.names:
            self.menu.addAction(name, partial(self.show_layout, name))
        self.menu.addSeparator()
        self.menu.addAction(self.tr("Save these graphs…"), self._ask_name)
        delete = self.menu.addAction(self.tr("Delete a layout…"), self._ask_delete)
        delete.setEnabled(bool(self.names))

    def show_layout(self, name: str) -> None:
        """Show the graphs of that name."""
        graphs = from_setting(self._stored.get(name))
        self._store.update(graphs={**self._store.value.graphs, "shown": to_setting(graphs)})
        self.chosen.emit(graphs)

    def save(self, name: str, graphs: list[Graph]) -> None:
        """Store graphs under a name, replacing those stored before."""
        named = {**self._stored, name: to_setting(graphs)}
        self._store.update(graphs={**self._store.value.graphs, "named": named})

    def delete(self, name: str) -> None:
        """Delete a layout."""
        named = {n: value for n, value in self._stored.items() if n != name}
        self._store.update(graphs={**self._store.value.graphs, "named": named})

    def _ask_name(self) -> None:
        name = answer(self._panel, self.tr("Save these graphs"), self.tr("Name of the layout"))
        if name:
            self.save(name, from_setting(self._store.value.graphs.get("shown")))

    def _ask_delete(self) -> None:
        title, words = self.tr("Delete a layout"), self.tr("Layout")
        name, ok = QInputDialog.getItem(self._panel, title, words, self.names, editable=False)
        if ok:
            self.delete(name)


class GraphsPanel(Panel):
    """Reads and computes nothing while it is hidden."""

    period = 1 / 20

    def __init__(
        self, host: GraphsHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self.data = SignalData(host, self)
        self.tree, self.stack = SignalTree(), GraphStack()
        self._lay_out()
        self.layouts = GraphLayouts(self, self.layout_button, store)
        self._connect()
        self.stack.show_graphs(from_setting(store.value.graphs.get("shown")))

    def _lay_out(self) -> None:
        self.add = QPushButton(self.tr("Add graph"))
        self.pause = QPushButton(self.tr("Pause all"))
        self.pause.setCheckable(True)
        self.show_tree = QPushButton(self.tr("Signals"))
        self.show_tree.setToolTip(self.tr("Show the tree of signals"))
        self.show_tree.setCheckable(True)
        self.show_tree.setChecked(bool(self._store.value.graphs.get("tree", True)))
        self.layout_button = QToolButton()
        self.layout_button.setText(self.tr("Layouts"))
        self.layout_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        head = OneLine()
        for widget in (self.add, self.pause, self.show_tree, self.layout_button):
            head.add(widget)
        self.message = MessageLabel()
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        area.setWidget(self.stack)
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
        column.addWidget(self.message)
        column.addWidget(both, 1)

    def _connect(self) -> None:
        self.add.clicked.connect(lambda: self.stack.add_graph())
        self.pause.toggled.connect(self.stack.pause_all)
        self.show_tree.toggled.connect(self.tree.setVisible)
        self.show_tree.toggled.connect(lambda _on: self._remember())
        self.layouts.chosen.connect(self.stack.show_graphs)
        self.tree.toggled.connect(self.stack.toggle)
        self.stack.changed.connect(self._graphs_changed)
        self.stack.edited.connect(self._remember)
        self.stack.selected.connect(self.tree.tick)
        self.stack.sought.connect(self.data.seek)
        self.data.listed.connect(self._show_signals)
        self.data.opened.connect(self._opened)
        for part in (self.stack, self.data):
            part.message.connect(self.message.show_message)

    def show_theme(self, colours: PanelColours) -> None:
        self.stack.set_colours(colours.base, colours.text)

    def _graphs_changed(self) -> None:
        self.add.setEnabled(not self.stack.is_full)
        self.data.choose(dict.fromkeys(key for graph in self.stack.graphs for key in graph.keys))

    def _show_signals(self) -> None:
        self.tree.show_signals(self.data.signals.values())
        chosen = self.stack.chosen
        self.tree.tick(chosen.graph.keys if chosen is not None else ())
        self.stack.show_signals(self.data.signals)
        self._graphs_changed()

    def _opened(self) -> None:
        """New users get two graphs to start from."""
        if not self.stack.plots and "shown" not in self._store.value.graphs:
            self.stack.show_graphs(first_graphs(self.data.signals.values()))
        self.stack.set_replay(self.data.is_replay)

    def _remember(self) -> None:
        shown = {"shown": to_setting(self.stack.graphs), "tree": self.show_tree.isChecked()}
        self._store.update(graphs={**self._store.value.graphs, **shown})

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            return
        self.data.update(view)
        player = view.setup.player
        for plot in self.stack.plots:
            if not plot.is_in_sight:
                continue
            curves = [self.data.curve(signal) for signal in plot.signals]
            if player is None:
                plot.draw_live(curves, _now(view))
            else:
                plot.draw_recording(curves, player.position, player.duration)

    def shut_down(self) -> None:
        self.data.shut_down()


def _now(view: Snapshot) -> float:
    """The instant (s) at the right edge of live graphs: the newest of all streams."""
    latest = [
        messages[-1].t for hand in view.hands for messages in (hand.imu, hand.estimates) if messages
    ]
    if latest:
        return max(latest)
    return view.status.t if view.status is not None else 0.0
