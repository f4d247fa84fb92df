"""Bug reports: offered after a crash, gathered from the window, saved in the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine_host import EngineHost
from app.engines.protocols import RecordingRequest
from app.platform.bug_report import Choice, Material, contents, machine, write_bundle
from app.platform.crash import CrashWatch
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.viewmodels.log import EventLog
from app.widgets.banner import Action
from app.window.doctor import DoctorDialog, devices_in_use
from app.window.message_bar import MessageBar
from app.words import event_text
from tracker.doctor.machine import Machine
from tracker.messages import Event


class BugReportDialog(QDialog):
    """``wanted(path, choice)`` is emitted when the user saves the report; nothing is sent."""

    wanted = Signal(object, object)  # Path, Choice

    def __init__(self, path: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Save a bug report"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(560)
        self.boxes = {
            "screenshot": QCheckBox(self.tr("An image of the window")),
            "session": QCheckBox(self.tr("The last seconds of the session")),
            "images": QCheckBox(self.tr("Camera images of these seconds")),
            "personal": QCheckBox(self.tr("Participant, task, notes and folder names")),
        }
        self.path = QLineEdit(str(path))
        self.inside = QLabel()
        self.inside.setWordWrap(True)
        column = QVBoxLayout(self)
        for name, box in self.boxes.items():
            box.setChecked(getattr(Choice(), name))
            box.toggled.connect(self._describe)
            column.addWidget(box)
        column.addWidget(self.inside)
        column.addLayout(self._file_row())
        column.addWidget(self._buttons())
        self._describe()

    def _file_row(self) -> QHBoxLayout:
        choose = QPushButton(self.tr("Change…"))
        choose.clicked.connect(self._choose)
        row = QHBoxLayout()
        row.addWidget(QLabel(self.tr("File")))
        row.addWidget(self.path, 1)
        row.addWidget(choose)
        return row

    def _buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        save = buttons.addButton(self.tr("Save"), QDialogButtonBox.ButtonRole.AcceptRole)
        save.setProperty("role", "primary")
        buttons.accepted.connect(self._save)
        buttons.rejected.connect(self.close)
        return buttons

    def choice(self) -> Choice:
        return Choice(**{name: box.isChecked() for name, box in self.boxes.items()})

    def _describe(self) -> None:
        self.boxes["images"].setEnabled(self.boxes["session"].isChecked())
        lines = "".join(f"<li>{line}</li>" for line in contents(self.choice()))
        about = self.tr("The file stays on this computer until you send it. It will contain:")
        self.inside.setText(f"{about}<ul>{lines}</ul>")

    def _choose(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save a bug report"), self.path.text(), "*.zip"
        )
        if path:
            self.path.setText(path)

    def _save(self) -> None:
        self.wanted.emit(Path(self.path.text()), self.choice())
        self.close()


@dataclass(frozen=True, eq=False)
class ReportSources:
    """The contents of a report. ``private``: widgets that show names of files or persons."""

    host: EngineHost
    store: SettingsStore
    log: EventLog
    private: Sequence[QWidget]


class BugReports(QObject):
    """Offers and saves bug reports of one window. ``crashes`` is None in tests and screenshots."""

    def __init__(
        self,
        sources: ReportSources,
        tasks: TaskOwner,
        messages: MessageBar,
        window: QWidget,
        crashes: CrashWatch | None = None,
    ) -> None:
        super().__init__(window)
        self._sources, self._tasks, self._messages = sources, tasks, messages
        self._window, self._crashes = window, crashes
        sources.host.happened.connect(self._offer_for)
        if crashes is not None:
            crashes.happened.connect(self.offer)
        self._doctor = ""  # the report of the last check of computer and devices
        self.crashed = ""  # a sentence about the previous run, if it crashed
        if crashes is not None and crashes.found is not None:
            self.crashed = self.tr("Glovetrack ended unexpectedly the last time.")
            self.offer(self.crashed)

    def _offer_for(self, event: Event) -> None:
        """Show errors of the engine in the message bar too; the log contains all events."""
        if event.kind == "error":
            self.offer(event_text(event))

    def offer(self, sentence: str) -> None:
        """Show the sentence in the message bar, with a button that begins a report."""
        self._messages.show_message(sentence, self.action)

    @property
    def action(self) -> Action:
        """The button that begins a report."""
        return self.tr("Save a bug report…"), self.ask

    def ask(self) -> None:
        """Ask in a dialog what to include and where to save it."""
        stamp = datetime.now().strftime("%Y-%m-%d_%H-%M-%S")
        folder = sessions_folder(self._sources.store.value)
        folder = folder if folder.is_dir() else Path.home()
        dialog = BugReportDialog(folder / f"glovetrack-bug_{stamp}.zip", self._window)
        dialog.wanted.connect(self.save)
        dialog.show()

    def examine(self) -> None:
        """Check the computer and the devices in a dialog; later bug reports include the result."""
        dialog = DoctorDialog(self._machine, self._tasks, self._window)
        dialog.finished_checks.connect(self._remember)
        dialog.show()

    def _remember(self, report: str) -> None:
        self._doctor = report

    def _machine(self) -> Machine:
        folder = sessions_folder(self._sources.store.value)
        folder = folder if folder.is_dir() else Path.home()
        return Machine(folder, in_use=devices_in_use(self._sources.host.setup))

    def save(self, path: Path, choice: Choice) -> None:
        """Collect the material now, write the file in the background, then show its path."""
        material = self._material(choice)

        def job(progress: JobProgress) -> list[str]:
            progress(-1.0, path.name)
            return write_bundle(path, material, choice)

        self._tasks.run(
            self.tr("Saving the bug report"), job, lambda problems: self._saved(path, problems)
        )

    def _saved(self, path: Path, problems: list[str]) -> None:
        text = self.tr("Bug report saved: {}.").format(path)
        if problems:
            text += self.tr(" Not included: {}.").format("; ".join(problems))
        self._sources.host.happened.emit(Event(0.0, "note", text))
        self._messages.show_message(text, good=not problems)

    def _material(self, choice: Choice) -> Material:
        sources, host = self._sources, self._sources.host
        request = host.recording.request
        player = host.setup.player if host.setup is not None else None
        opened = request.path if request is not None else player.path if player else None
        settings = sources.store.value
        return Material(
            log="\n".join(entry.line for entry in sources.log.entries()),
            settings=settings,
            status=self._status(),
            machine=machine(),
            log_folder=self._crashes.folder if self._crashes is not None else None,
            screenshot=self._screenshot(choice.personal) if choice.screenshot else b"",
            session_file=opened,
            write_recent=self._write_recent if host.running else lambda _path: False,
            names=(settings.participant, settings.task, settings.sessions_folder),
            doctor=self._doctor,
        )

    def _status(self) -> dict[str, object]:
        host = self._sources.host
        setup = host.setup
        if setup is None:
            return {"engine": "none is open"}
        status = setup.tracked.status()
        return {
            "hand": setup.hand.name,
            "glove": setup.glove.name,
            "simulated": setup.simulated,
            "running": host.running,
            "tracking": status.tracking.name.lower(),
            "values": dict(status.values),
        }

    def _write_recent(self, path: Path) -> bool:
        """Write the seconds in memory to a file like any recording, without names of persons;
        returns False without a live engine."""
        host = self._sources.host
        setup = host.setup
        if setup is None or setup.live is None:
            return False
        recorder = setup.live.make_recorder(RecordingRequest(path, "", ""))
        try:
            for message in host.recent():
                recorder.write(message)
        finally:
            recorder.close()
        return True

    def _screenshot(self, personal: bool) -> bytes:
        """A PNG of the window; panels that show names are blacked out unless ``personal``."""
        window = self._window
        image = window.grab()
        if not personal:
            painter = QPainter(image)
            for panel in self._sources.private:
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
