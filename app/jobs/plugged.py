"""Detection of gloves and cameras that are connected while the window is open."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from app.engines.camera_choice import stated_count
from app.engines.engine_host import EngineHost
from app.platform.tasks import JobProgress, LatestJob
from app.storage.settings import AppSettings, SettingsStore
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.discovery import serial_ports

POLL_MS = 2000
Names = frozenset[str]


def plugged_in(settings: AppSettings) -> Names:
    """Paths of serial ports and names of cameras, and the devices in the settings that are
    connected."""
    cameras = (c.name for c in all_cameras())
    chosen = (settings.port, stated_count(settings.camera)[1])
    return frozenset([*serial_ports(), *cameras, *(p for p in chosen if p and Path(p).exists())])


class Newcomers:
    """Reports devices that were connected after the first check; once each, and again after they
    were disconnected."""

    def __init__(self) -> None:
        self._known: Names | None = None
        self._before: Names = frozenset()

    def forget(self) -> None:
        """Treat the next check as the first."""
        self._known = None

    def look(self, present: Iterable[str]) -> list[str]:
        """Devices that are new, and present in two checks in a row: a new port cannot always be
        opened immediately."""
        now = frozenset(present)
        if self._known is None:
            self._known = now
        settled = (now & self._before) - self._known
        self._before = now
        self._known = (self._known & now) | settled
        return sorted(settled)


class PlugWatch(QObject):
    """Checks every `POLL_MS` while a device is missing.

    ``came``: names of devices that were not present in the last search.
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
        self._host, self._store, self._discover = host, store, look
        self._newcomers = Newcomers()
        self._job = LatestJob(self.tr("Looking for devices"), self)
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._ask)

    def begin(self) -> None:
        """A search has not found all devices: report new ones from now on."""
        self._newcomers.forget()
        self._timer.start()
        self._ask()

    def rest(self) -> None:
        """Stop checking."""
        self._timer.stop()
        self._job.forget()

    def _ask(self) -> None:
        # a search that is still running would be discarded for a newer one
        if not self._host.opening and not self._job.is_busy:
            settings = self._store.value

            def job(_progress: JobProgress) -> Names:
                return self._discover(settings)

            self._job.run(job, self._seen)

    def _seen(self, present: Names) -> None:
        found = self._newcomers.look(present)
        if found and self._timer.isActive() and not self._host.opening:
            self.came.emit(found)

    def shut_down(self) -> None:
        self.rest()
        self._job.shut_down()
