"""What the window does besides tracking: notices at start, crashes, bug reports, the About box."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QObject, QPoint, QRect
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QWidget

from app.engines.engine import RecordingRequest
from app.panels.bug_report_dialog import BugReportDialog
from app.platform.bug_report import Choice, Material, machine, write_bundle
from app.platform.crash import CrashWatch
from app.platform.tasks import JobProgress
from app.storage.settings import sessions_folder
from app.window.about import AboutDialog
from tracker.messages import Event

if TYPE_CHECKING:
    from app.window.main_window import MainWindow

PRIVATE_PANELS = ("library", "recording", "log")
"""Panels that show file names, and with them the names of people."""


class Housekeeping(QObject):
    """Serves one window. ``crashes`` is None where nobody watches (tests, screenshots)."""

    def __init__(self, window: MainWindow, crashes: CrashWatch | None = None) -> None:
        super().__init__(window)
        self._window, self._crashes = window, crashes
        if crashes is not None:
            crashes.happened.connect(self.offer_report)
        if window.store.notice:
            window.show_error(window.store.notice)
        if crashes is not None and crashes.found is not None:
            self.offer_report(self.tr("Glovetrack ended unexpectedly the last time."))

    def offer_report(self, sentence: str) -> None:
        """A banner with a button; nothing stands in the way."""
        self._window.show_error(sentence, (self.tr("Save a bug report…"), self.ask_report))

    def show_about(self) -> None:
        AboutDialog(self._window).show()

    # --- bug reports

    def ask_report(self) -> None:
        stamp = datetime.now().strftime("%Y-%m-%d_%H-%M-%S")
        folder = sessions_folder(self._window.store.value)
        folder = folder if folder.is_dir() else Path.home()
        dialog = BugReportDialog(folder / f"glovetrack-bug_{stamp}.zip", self._window)
        dialog.wanted.connect(self.save_report)
        dialog.show()

    def save_report(self, path: Path, choice: Choice) -> None:
        """Gather now, write in the background, say where it is."""
        material = self._material(choice)

        def job(progress: JobProgress) -> list[str]:
            progress(-1.0, path.name)
            return write_bundle(path, material, choice)

        self._window.tasks.run(
            self.tr("Saving the bug report"), job, lambda troubles: self._saved(path, troubles)
        )

    def _saved(self, path: Path, troubles: list[str]) -> None:
        text = self.tr("The bug report is saved: {}.").format(path)
        if troubles:
            text += self.tr(" Not in it: {}.").format("; ".join(troubles))
        self._window.host.happened.emit(Event(0.0, "note", text))
        self._window.show_error(text)

    def _material(self, choice: Choice) -> Material:
        window, host = self._window, self._window.host
        request = host.recording.request
        player = host.setup.player if host.setup is not None else None
        opened = request.path if request is not None else player.path if player else None
        settings = window.store.value
        return Material(
            log="\n".join(entry.line for entry in window.log.model.entries()),
            settings=settings,
            status=self._status(),
            machine=machine(),
            log_folder=self._crashes.folder if self._crashes is not None else None,
            screenshot=self._screenshot(choice.personal) if choice.screenshot else b"",
            session_file=opened,
            write_recent=self._write_recent if host.running else None,
            names=(settings.participant, settings.task, settings.sessions_folder),
        )

    def _status(self) -> dict[str, object]:
        setup = self._window.host.setup
        if setup is None:
            return {"engine": "none is open"}
        status = setup.engine.status()
        return {
            "hand": setup.hand.name,
            "glove": setup.glove.name,
            "simulated": setup.simulated,
            "running": self._window.host.running,
            "tracking": status.tracking.name.lower(),
            "values": dict(status.values),
        }

    def _write_recent(self, path: Path) -> None:
        """The seconds in memory, in a file made like any recording, with nobody's name."""
        host = self._window.host
        setup = host.setup
        if setup is None or setup.make_recorder is None:
            return
        recorder = setup.make_recorder(RecordingRequest(path, "", ""))
        try:
            for message in host.recent():
                recorder.write(message)
        finally:
            recorder.close()

    def _screenshot(self, personal: bool) -> bytes:
        """A PNG of the window; panels that show names are blacked out unless ``personal``."""
        window = self._window
        image = window.grab()
        if not personal:
            painter = QPainter(image)
            for name in PRIVATE_PANELS:
                panel = window.docks[name]
                if not panel.visibleRegion().isEmpty():
                    painter.fillRect(_place(panel, window), QColor("#000000"))
            painter.end()
        data = QByteArray()
        buffer = QBuffer(data)
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        image.save(buffer, "PNG")
        return bytes(data.data())


def _place(widget: QWidget, window: QWidget) -> QRect:
    """Where ``widget`` is in ``window``."""
    return QRect(widget.mapTo(window, QPoint(0, 0)), widget.size())
