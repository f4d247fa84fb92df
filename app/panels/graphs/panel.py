"""Graphs of any signals, live and over a whole recording."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any, Protocol

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

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandChanges, Snapshots
from app.engines.snapshot import Snapshot
from app.jobs.recording_curves import read_signals
from app.panels.graphs.stack import GraphStack
from app.panels.graphs.tree import SignalTree
from app.panels.panel import MessageLabel, Panel, PanelColours
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsOf
from app.viewmodels.graphs import SPANS, Graph, first_graphs, from_setting, to_setting
from app.viewmodels.signal_curves import Curve, LiveCurves, RecordingCurves
from app.viewmodels.signals import Signal as Figure
from app.viewmodels.signals import signals
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine
from app.widgets.question import answer


class GraphSettings(Protocol):
    """The settings of this panel."""

    @property
    def graphs(self) -> dict[str, Any]: ...


class GraphLayouts(QObject):
    """A menu on ``button``. ``chosen``: the graphs (list of `Graph`) to show."""

    chosen = Signal(list)

    def __init__(
        self, panel: QWidget, button: QToolButton, store: SettingsOf[GraphSettings]
    ) -> None:
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
        self, host: GraphsHost, store: SettingsOf[GraphSettings], parent: QWidget | None = None
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
        self.stack.seek_requested.connect(self.data.seek)
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


# ---- the signals of the open engine and their curves: a live buffer, or a whole recording

STATUS_EVERY = 20  # refreshes between two checks for new status values


class GraphsHost(HandChanges, Snapshots, Protocol):
    """What the graphs use of the engine host."""


class SignalData(QObject):
    """``listed``: the set of signals has changed. ``opened``: it belongs to another engine.
    ``message``: progress or failure of reading a recording; empty to clear it."""

    listed = Signal()
    opened = Signal()
    message = Signal(str)

    def __init__(self, host: GraphsHost, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host = host
        self.signals: dict[str, Figure] = {}
        self.recording: RecordingCurves | None = None
        self._setup: EngineSetup | None = None  # whose signals are listed
        self._status_names: frozenset[str] = frozenset()
        self._live = LiveCurves(SPANS[-1])
        self._reading = LatestJob(self.tr("Reading the recording's signals"), self)
        self._reading.failed.connect(self.message)
        self._turn = 0
        host.opened.connect(lambda _setup: self._forget(new_engine=True))
        host.hand_changed.connect(lambda _setup: self._forget(new_engine=False))
        host.closed.connect(lambda: self._forget(new_engine=True))

    @property
    def is_open(self) -> bool:
        return self._setup is not None

    @property
    def is_replay(self) -> bool:
        return self._setup is not None and self._setup.player is not None

    def _forget(self, new_engine: bool) -> None:
        """The next `update` lists the signals again."""
        self._setup = None
        if new_engine:
            self._reading.forget()
            self.recording = None
            self._live.clear()
            self.message.emit("")

    def update(self, view: Snapshot) -> None:
        """Store the new values of a snapshot, and list its signals if they have changed."""
        if self._setup is None:
            self._open(view)
        self._turn += 1
        if self._turn % STATUS_EVERY == 0 and self._has_new_status(view):
            self._list(view)
        if view.setup.player is None:
            self._live.take(view)

    def _open(self, view: Snapshot) -> None:
        setup = self._setup = view.setup
        self._list(view)
        self.opened.emit()
        if setup.player is not None and self.recording is None:
            self.message.emit(self.tr("Reading the whole recording…"))
            self._reading.run(read_signals(setup.player.path, setup), self._use_recording)

    def _use_recording(self, curves: RecordingCurves) -> None:
        self.recording = curves
        self.message.emit("")
        view = self._host.snapshot()
        if view is not None and self._setup is not None:
            self._list(view)

    def _list(self, view: Snapshot) -> None:
        recording = self.recording
        found = set(recording.figures) if recording is not None else set(self._status_names)
        for hand in view.hands:
            found |= set(hand.status.values) if hand.status is not None else set()
        self._status_names = frozenset(found)
        self.signals = {signal.key: signal for signal in signals(view.setup, found)}
        self.listed.emit()

    def _has_new_status(self, view: Snapshot) -> bool:
        return any(
            h.status is not None and not self._status_names.issuperset(h.status.values)
            for h in view.hands
        )

    def choose(self, keys: Iterable[str]) -> None:
        """Buffer the live values of these signals and of no others."""
        self._live.choose(self.signals[key] for key in keys if key in self.signals)

    def curve(self, signal: Figure) -> Curve:
        """From the recording once it has been read, otherwise from the live buffer."""
        if self.is_replay and self.recording is not None:
            return self.recording.curve(signal)
        return self._live.curve(signal.key)

    def seek(self, position: float) -> None:
        """Move the replay to ``position`` (s), limited to its duration."""
        player = self._setup.player if self._setup is not None else None
        if player is not None:
            player.seek(min(max(position, 0.0), player.duration))

    def shut_down(self) -> None:
        self._reading.shut_down()
