"""What is plugged in while the window is open: a glove or a camera that comes late is noticed."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from app.engines.camera_choice import told_count
from app.engines.engine_host import EngineHost
from app.platform.tasks import JobProgress, LatestJob
from app.storage.settings import AppSettings, SettingsStore
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.discovery import serial_ports

LOOK_MS = 2000
Names = frozenset[str]


def plugged_in(settings: AppSettings) -> Names:
    """Paths of serial ports and names of cameras, and what the settings name where it is there."""
    cameras = (c.name for c in all_cameras())
    chosen = (settings.port, told_count(settings.camera)[1])
    return frozenset([*serial_ports(), *cameras, *(p for p in chosen if p and Path(p).exists())])


class Newcomers:
    """Tells what has come since the first look; once each, and anew where it had gone."""

    def __init__(self) -> None:
        self._known: Names | None = None
        self._before: Names = frozenset()

    def forget(self) -> None:
        """The next look is the first one."""
        self._known = None

    def look(self, present: Iterable[str]) -> list[str]:
        """Names that were not there before, and are there at the second look: a port that has just
        come cannot always be opened yet."""
        now = frozenset(present)
        if self._known is None:
            self._known = now
        settled = (now & self._before) - self._known
        self._before = now
        self._known = (self._known & now) | settled
        return sorted(settled)


class PlugWatch(QObject):
    """Looks every `LOOK_MS` while something of the rig is missing, and rests otherwise.

    ``came`` has the names of what is there now and was not at the last search.
    """

    came = Signal(list)

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        parent: QObject | None = None,
        look: Callable[[AppSettings], Names] = plugged_in,
    ) -> None:
        super().__init__(parent)
        self._host, self._store, self._look = host, store, look
        self._newcomers = Newcomers()
        self._job = LatestJob(self.tr("Looking for devices"), self)
        self._timer = QTimer(self)
        self._timer.setInterval(LOOK_MS)
        self._timer.timeout.connect(self._ask)

    def begin(self) -> None:
        """A search has not found all: what comes from now on is new."""
        self._newcomers.forget()
        self._timer.start()
        self._ask()

    def rest(self) -> None:
        """Something else is shown, or nothing is missing."""
        self._timer.stop()
        self._job.forget()

    def _ask(self) -> None:
        if not self._host.opening:
            settings = self._store.value

            def job(_progress: JobProgress) -> Names:
                return self._look(settings)

            self._job.run(job, self._seen)

    def _seen(self, present: Names) -> None:
        found = self._newcomers.look(present)
        if found and self._timer.isActive() and not self._host.opening:
            self.came.emit(found)

    def shut_down(self) -> None:
        self.rest()
        self._job.shut_down()
