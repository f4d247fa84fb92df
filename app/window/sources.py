"""Where an engine comes from: the demo, the devices, a file. Each gives a job that builds one.

What builds it is imported inside the job: it compiles kernels and loads codecs, and the window is
to open at once.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from app.engines.demo_camera import DemoChoice
from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost, SetupFactory
from app.platform.tasks import JobProgress
from app.storage.settings import AppSettings, SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.window.message_bar import MessageBar

if TYPE_CHECKING:
    from tracker.simulation.camera_device import DemoCamera


def demo_factory(
    choice: DemoChoice | None = None, seed: int = 1, camera: DemoCamera | None = None
) -> SetupFactory:
    """Simulated wearers, gloves and camera; ``camera`` may have been started for it before."""
    wanted = choice or DemoChoice()
    started = [camera] if camera is not None else []

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.demo import demo_setup

        return demo_setup(progress, seed, wanted, started.pop() if started else None)

    return build


def hardware_factory(settings: AppSettings) -> SetupFactory:
    """The glove on a serial port and the stereo camera."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.hardware import hardware_setup

        return hardware_setup(progress, settings)

    return build


def replay_factory(path: Path) -> SetupFactory:
    """A recorded session."""

    def build(progress: JobProgress) -> EngineSetup:
        from app.engines.replay.engine import open_replay

        return open_replay(path, progress)

    return build


DEVICES = "devices"
"""What a banner's sentence is about."""


class Sources(QObject):
    """Opens what the user asks for; ``messages`` is taken away by what is opened next."""

    devices_asked = Signal()
    set_up_asked = Signal()

    def __init__(
        self, host: EngineHost, store: SettingsStore, messages: MessageBar, window: QWidget
    ) -> None:
        super().__init__(window)
        self._host, self._store, self._messages, self._window = host, store, messages, window
        self.baud: int | None = None  # of the glove's line in this run; None: as the settings say
        self.looking_for_devices = False
        host.opened.connect(self._choose_engine)

    def open_demo(self, choice: DemoChoice | None = None, camera: DemoCamera | None = None) -> None:
        self._open(self.tr("Starting the demo"), demo_factory(choice, camera=camera))

    def open_devices(self) -> None:
        """Glove and camera, as the settings name them."""
        settings = self._store.value
        if self.baud is not None:
            settings = replace(settings, baud=self.baud)
        self._open(self.tr("Looking for glove and camera"), hardware_factory(settings))
        self.looking_for_devices = True
        self.devices_asked.emit()

    def open_session(self, path: Path) -> None:
        """Replay a file through the same panels."""
        self._open(self.tr("Opening {}").format(path.name), replay_factory(path))

    def choose_session(self, plan: RecordingPlan) -> None:
        """Ask for a file, where recordings go to."""
        path, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open a session"), str(plan.folder), "*.mcap"
        )
        if path:
            self.open_session(Path(path))

    def take_over(self, path: str) -> None:
        """What a second start of the program was given: a session, or "" to be seen."""
        window = self._window
        window.setWindowState(window.windowState() & ~Qt.WindowState.WindowMinimized)
        window.raise_()
        window.activateWindow()
        if path and self._host.recording.request is not None:
            text = self.tr("{} waits: a recording is under way.").format(Path(path).name)
            open_now = (self.tr("Open it now"), lambda: self.open_session(Path(path)))
            self._messages.say(text, open_now)
        elif path:
            self.open_session(Path(path))

    def _choose_engine(self, setup: EngineSetup) -> None:
        """The one used last; half a rig has the one that can do with it."""
        self.looking_for_devices = False
        if setup.other is not None and setup.glove_id is not None:
            self._store.update(both_hands=True)  # one that is unplugged is expected from now on
        if setup.whole:
            setup.engine.set_engine(self._store.value.engine)
        elif setup.missing:
            self.tell_of_devices(setup.missing)

    def toggle_both_hands(self) -> None:
        """Whether the other hand's glove is expected where it is not there; at the next opening."""
        self._store.update(both_hands=not self._store.value.both_hands)

    def tell_of_devices(self, text: str) -> None:
        """What is missing, with the way to the list that helps; until devices are chosen anew."""
        self.looking_for_devices = False
        show = (self.tr("Show the set-up"), self.set_up_asked.emit)
        self._messages.say(text, show, about=DEVICES)

    def set_engine(self, name: str) -> None:
        """Track with another engine, now and after the next start."""
        self._store.update(engine=name)
        self._host.set_engine(name)

    def _open(self, title: str, factory: SetupFactory) -> None:
        self._messages.hide()
        self.looking_for_devices = False
        self._host.open(title, factory)
