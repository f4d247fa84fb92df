"""Sources of an engine: the demo, the devices, a file. Each has a job that builds the engine.

The builders are imported inside the job: they compile kernels and load codecs, and the window
opens without waiting for them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QMimeData, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QFileDialog, QWidget

from app.engines.apart.demo import DemoSource
from app.engines.apart.process import EngineProcess
from app.engines.apart.setup import apart_factory
from app.engines.apart.source import DeviceSource, Source
from app.engines.demo_camera import DemoChoice
from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost, SetupFactory
from app.jobs.plugged import PlugWatch
from app.platform.tasks import JobProgress
from app.storage.settings import AppSettings, SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.window.message_bar import MessageBar
from tracker.base.callbacks import ignore
from tracker.doctor.permissions import RULES

if TYPE_CHECKING:
    from tracker.simulation.camera_device import DemoCamera
import contextlib
import threading

from app.engines.apart.process import Started, start_process


def demo_factory(
    choice: DemoChoice | None = None, seed: int = 1, camera: DemoCamera | None = None
) -> SetupFactory:
    """Simulated wearers, gloves and camera; ``camera`` may have been started already."""
    wanted = choice or DemoChoice()
    started = [camera] if camera is not None else []

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.demo import demo_setup  # deferred: loads the simulator

        return demo_setup(progress, seed, wanted, started.pop() if started else None)

    return build


def hardware_factory(settings: AppSettings) -> SetupFactory:
    """The glove on a serial port and the stereo camera."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.hardware import hardware_setup  # deferred: loads every engine

        return hardware_setup(progress, settings)

    return build


def replay_factory(path: Path, at: float | None = None) -> SetupFactory:
    """A recorded session, paused at ``at`` s if that is given."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.replay.engine import open_replay  # deferred: loads codecs

        return open_replay(path, progress, at)

    return build


RESERVE_AFTER = 20_000
"""ms after a source is opened, when a second process is loaded, which takes a second of a core."""

DEVICES = "devices"
"""What a banner's sentence is about."""


@dataclass(frozen=True)
class Opening:
    """Something to be opened: its name, and the text that the window shows meanwhile.
    ``keep``: the open one continues until this one is ready."""

    name: str
    title: str
    factory: SetupFactory
    keep: bool = False


class SecondProcess(QObject):
    """A process that is loaded in advance, in case the one that tracks ends unexpectedly."""

    def __init__(self, host: EngineHost, parent: QObject) -> None:
        super().__init__(parent)
        self._host = host
        self.reserve = Reserve()
        self.source: Source | None = None
        """What it would open."""
        self._settled = QTimer(self, singleShot=True, interval=RESERVE_AFTER)
        self._settled.timeout.connect(self._fill)

    def load_later(self) -> None:
        """Load it after `RESERVE_AFTER`, when nothing is recorded."""
        self._settled.start()

    def _fill(self) -> None:
        setup = self._host.setup
        if setup is None or setup.live is None or self.source is None:
            return
        if self._host.recording.request is not None:
            self._settled.start()
            return
        self.reserve.fill(self.source)

    def close(self) -> None:
        self._settled.stop()
        self.reserve.close()


class Sources(QObject):
    """Opens sources that the user selects; ``messages`` is replaced by that of the next source.

    None of these ends a running recording unless the user confirms it.
    """

    devices_requested = Signal()
    set_up_requested = Signal()
    rule_requested = Signal()

    def __init__(
        self, host: EngineHost, store: SettingsStore, messages: MessageBar, window: QWidget
    ) -> None:
        super().__init__(window)
        self._host, self._store, self._messages, self._window = host, store, messages, window
        self.baud: int | None = None  # of the glove's line in this run; None: as the settings say
        self.apart = False
        """Whether demo and devices are tracked in a process of their own."""
        self.looking_for_devices = False
        self._was_live = False
        self._open_live: Callable[[], None] = ignore  # what was live last
        self.plugged = PlugWatch(host, store, self)
        self.plugged.came.connect(self._came)
        self.second = SecondProcess(host, self)
        host.opened.connect(self._choose_engine)
        host.closed.connect(self.plugged.rest)

    def open_demo(
        self,
        choice: DemoChoice | None = None,
        camera: DemoCamera | None = None,
        process: EngineProcess | None = None,
    ) -> None:
        """``camera``, or the ``process`` that tracks, may have been started already."""

        def begun() -> None:
            self._was_live, self._open_live = True, partial(self.open_demo, choice)

        factory = demo_factory(choice, camera=camera)
        if self.apart:
            factory = self._apart(DemoSource(choice or DemoChoice()), process)
        self._open(Opening(self.tr("The demo"), self.tr("Starting the demo"), factory), begun)

    def open_devices(self) -> None:
        """Glove and camera, as the settings name them."""
        settings = self._store.value
        if self.baud is not None:
            settings = replace(settings, baud=self.baud)
        title = self.tr("Looking for glove and camera")
        name = self.tr("The search for glove and camera")
        factory = hardware_factory(settings)
        if self.apart:
            factory = self._apart(DeviceSource(settings))
        self._open(Opening(name, title, factory), self._devices_begun)

    def _apart(self, source: Source, process: EngineProcess | None = None) -> SetupFactory:
        """A job that opens ``source`` in a process of its own."""
        self.second.source = source
        return apart_factory(source, process, self.second.reserve.open)

    def _devices_begun(self) -> None:
        self.looking_for_devices = True
        self._was_live, self._open_live = True, self.open_devices
        self.devices_requested.emit()

    def open_session(self, path: Path, at: float | None = None) -> None:
        """Replay a file in the same panels, paused at ``at`` s if that is given; a file that cannot
        be read changes nothing. One that is open already is only moved to ``at``."""
        setup = self._host.setup
        player = setup.player if setup is not None else None
        if at is not None and player is not None and player.path.absolute() == path.absolute():
            player.pause_at(at)
            return
        title = self.tr("Opening {}").format(path.name)
        self._open(Opening(path.name, title, replay_factory(path, at), keep=True))

    @property
    def can_go_live(self) -> bool:
        """Whether a replay is shown that came after a demo or devices."""
        setup = self._host.setup
        return self._was_live and setup is not None and setup.player is not None

    def go_live(self) -> None:
        """Return from a replay to the demo or the devices that were open before."""
        self._open_live()

    def reopen(self) -> None:
        """Open the demo or the devices again, after a change of their files."""
        setup = self._host.setup
        if setup is not None and setup.live is not None:
            self._open_live()

    def choose_session(self, plan: RecordingPlan) -> None:
        """Ask for a file, beginning with the folder of recordings."""
        path, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open recording"), str(plan.folder), "*.mcap"
        )
        if path:
            self.open_session(Path(path))

    def take_over(self, path: str, at: float | None = None) -> None:
        """Handle a second start of the program: open its session, paused at ``at`` s if that is
        given, or (empty) come to the front."""
        window = self._window
        window.setWindowState(window.windowState() & ~Qt.WindowState.WindowMinimized)
        window.raise_()
        window.activateWindow()
        if path:
            self.open_session(Path(path), at)

    def _choose_engine(self, setup: EngineSetup) -> None:
        """Track with the engine used last; incomplete devices have one that works with them."""
        self.looking_for_devices = False
        if self.apart and setup.live is not None:
            self.second.load_later()
        if setup.missing:
            self.plugged.begin()
        else:
            self.plugged.rest()
        if setup.others and setup.connection.number is not None:
            self._store.update(both_hands=True)  # a glove that is unplugged is expected from now on
        if setup.whole and setup.live is not None:
            setup.live.engine.set_engine(self._store.value.engine)
        elif setup.missing:
            self.show_device_message(setup.missing)

    def toggle_apart(self) -> None:
        """Track in a process of its own, or in the window's, from the next start of tracking on."""
        self._store.update(own_process=not self._store.value.own_process)
        self.apart = self._store.value.own_process
        self.reopen()

    def toggle_both_hands(self) -> None:
        """Expect the other hand's glove, or do not, when devices are opened next."""
        self._store.update(both_hands=not self._store.value.both_hands)

    def show_device_message(self, text: str) -> None:
        """Show what is missing, with a button to the checklist, until devices are chosen again."""
        self.looking_for_devices = False
        actions = [(self.tr("Show checklist"), self.set_up_requested.emit)]
        if RULES in text:  # access was denied, and the sentence names the remedy
            actions.insert(0, (self.tr("Udev rule…"), self.rule_requested.emit))
        self._messages.show_message(text, *actions, about=DEVICES)
        if self._host.setup is None:
            self.plugged.begin()

    def _came(self, names: Sequence[str]) -> None:
        """Open new devices at once if nothing is open; else the user decides."""
        if self._host.setup is None:
            self.open_devices()
            return
        text = self.tr("Plugged in: {}.").format(", ".join(names))
        self._messages.show_message(
            text, (self.tr("Connect"), self.open_devices), about=DEVICES, good=True
        )

    def set_engine(self, name: str) -> None:
        """Track with another engine, now and after the next start."""
        self._store.update(engine=name)
        self._host.set_engine(name)

    def _open(self, what: Opening, begun: Callable[[], None] = ignore) -> None:
        """``begun`` is called if it is opened now."""
        if self._host.recording.request is not None:
            text = self.tr("{} cannot be opened during a recording.").format(what.name)
            open_now = (self.tr("Stop recording and open"), partial(self._open_now, what, begun))
            self._messages.show_message(text, open_now)
        else:
            self._open_now(what, begun)

    def _open_now(self, what: Opening, begun: Callable[[], None]) -> None:
        self._messages.hide()
        self.looking_for_devices = False
        if not what.keep:
            self.plugged.rest()
        self._host.open(what.title, what.factory, keep=what.keep)
        begun()

    def shut_down(self) -> None:
        """Stop looking for devices, and end the waiting process."""
        self.plugged.shut_down()
        self.second.close()


class Drops(QObject):
    """Calls ``take`` with the path of a session that is dropped on the window."""

    def __init__(self, window: QWidget, take: Callable[[str], None]) -> None:
        super().__init__(window)
        self._take = take
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QDropEvent):  # also a drag that enters
            return super().eventFilter(watched, event)
        path = session_in(event.mimeData())
        if path is None:
            event.ignore()
            return True
        event.acceptProposedAction()
        if event.type() == QEvent.Type.Drop:
            self._take(str(path))
        return True


def session_in(data: QMimeData) -> Path | None:
    """The only session among the dragged files; None if there is none or more than one."""
    paths = [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
    sessions = [path for path in paths if path.suffix.lower() == ".mcap"]
    return sessions[0] if len(sessions) == 1 else None


# ---- a process that has loaded what tracking needs, so that tracking continues soon after a
# crash


class Reserve:
    """At most one waiting process. Loading takes a second and about 100 MB; the process then waits
    without using a processor. Methods may be called from any thread."""

    def __init__(self) -> None:
        self._started: Started | None = None
        self._changing = threading.Lock()
        self._closed = False

    def fill(self, source: Source) -> None:
        """Have a process that has loaded what ``source`` needs."""
        with self._changing:
            if self._closed or (self._started is not None and self._started.process.is_alive()):
                return
            _discard(self._started)
            self._started = start_process(source, waits=True)

    def open(self, source: Source) -> EngineProcess:
        """Open ``source`` in the waiting process, or in a new one if there is none."""
        with self._changing:
            started, self._started = self._started, None
        if started is not None:
            with contextlib.suppress(OSError):  # it has ended
                started.pipe.send(source)
                return EngineProcess(source, started)
        _discard(started)
        return EngineProcess(source)

    def close(self) -> None:
        """End the waiting process."""
        with self._changing:
            self._closed = True
            started, self._started = self._started, None
        _discard(started)


def _discard(started: Started | None) -> None:
    """End a process, which has no device open."""
    if started is not None:
        started.process.kill()
        started.pipe.close()
        started.crash.unlink(missing_ok=True)
