"""The signals of the open engine and their curves: a live buffer, or a whole recording."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandChanges, Snapshots
from app.engines.snapshot import Snapshot
from app.jobs.recording_curves import read_signals
from app.platform.tasks import LatestJob
from app.viewmodels.graphs import SPANS
from app.viewmodels.signal_curves import Curve, LiveCurves, RecordingCurves
from app.viewmodels.signals import Signal as Figure
from app.viewmodels.signals import signals

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
