"""What is said of a recording: what it lacks when it begins, how it went when it has ended."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.recording_check import check_job
from app.panels.library.panel import LibraryPanel
from app.platform.tasks import RunningJob, TaskOwner
from app.storage.system_bin import Binned
from app.viewmodels.recording_report import (
    HandNow,
    Missing,
    MissingWatch,
    RecordingReport,
    missing_now,
    missing_text,
    report_text,
)
from app.widgets.question import question
from app.window.message_bar import MessageBar

ABOUT = "take"
STARTING_MS = 2000  # after its start an engine's rates say nothing yet
LOOK_MS = 500  # between two looks at what arrives


class Takes(QObject):
    """Checks each recording in the background and offers what one does with it next."""

    recover = Signal(object)  # Path of a recording that was cut off

    def __init__(
        self,
        host: EngineHost,
        tasks: TaskOwner,
        messages: MessageBar,
        library: LibraryPanel,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._host, self._tasks, self._messages = host, tasks, messages
        self._library, self._window = library, window
        self._check: RunningJob | None = None
        self._missing, self._dismissed = MissingWatch(), False
        self._said: Missing = {}  # what is missing by the last look
        self._running = QElapsedTimer()
        self._looks = QTimer(self)
        self._looks.timeout.connect(self._look)
        messages.dismissed.connect(self._note_dismissed)
        library.files.binned.connect(self._binned)
        host.running_changed.connect(lambda on: self._running.start() if on else None)
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)

    def _begun(self) -> None:
        """From now on what is missing is reported; the recording goes on nevertheless."""
        self._missing, self._said, self._dismissed = MissingWatch(), {}, False
        if self._check is not None:
            self._check.cancel()  # the disk is wanted for the next one
        self._messages.hide()  # what it said of the recording before
        self._looks.start(LOOK_MS)
        self._look()

    def _look(self) -> None:
        """Name what does not arrive, for as long as it does not."""
        setup = self._host.setup
        if setup is None or self._host.recording.request is None:
            self._looks.stop()
            self._messages.no_longer(ABOUT)
            return
        if self._running.isValid() and self._running.elapsed() < STARTING_MS:
            return  # devices that have just been opened send nothing yet
        rate = setup.camera.device.fps if setup.camera.device is not None else 0.0
        hands = [_now(hand) for hand in setup.hands]
        self._report(self._missing.look(missing_now(hands, rate if setup.camera.present else None)))

    def _report(self, missing: Missing) -> None:
        """Again where something else is missing, or where another message is gone by now."""
        changed, added = missing.keys() != self._said.keys(), missing.keys() - self._said.keys()
        self._said = missing
        self._dismissed = self._dismissed and not added
        if not missing:
            self._messages.no_longer(ABOUT)
        elif not self._dismissed and (changed or not self._messages.isVisible()):
            self._messages.say(missing_text(missing), about=ABOUT)

    def _note_dismissed(self, about: str) -> None:
        """The user has read what is missing: it is not said again."""
        self._dismissed = self._dismissed or about == ABOUT

    def _finished(self, path: Path) -> None:
        title = self.tr("Checking {}").format(path.name)
        self._check = self._tasks.run(title, check_job(path), self._checked, self._ended)

    def _ended(self) -> None:
        self._check = None

    def _checked(self, report: RecordingReport) -> None:
        if self._host.recording.request is not None:
            return  # the next one is under way
        path, ended_by = report.path, self._host.recording.ended_by
        recover = (self.tr("Recover"), partial(self.recover.emit, path))
        self._messages.say(
            " ".join(filter(None, (ended_by, report_text(report)))),
            *([recover] if report.cut_off else []),
            (self.tr("Show it"), partial(self._show, path)),
            (self.tr("Export…"), partial(self._library.ask_export_of, [path])),
            (self.tr("Rename…"), partial(self._ask_name, report)),
            good=not report.problem and not ended_by,
            stays=True,  # a dialog that is cancelled has changed nothing
        )

    def _show(self, path: Path) -> None:
        self._messages.hide()
        self._library.replay.emit(path)

    def _binned(self, sessions: tuple[Binned, ...]) -> None:
        """The bin was not asked about: it can be undone instead."""
        text = self.tr("{} is in the bin.").format(sessions[0].path.stem)
        if len(sessions) > 1:
            text = self.tr("{} recordings are in the bin.").format(len(sessions))
        undo = (self.tr("Undo"), partial(self._library.files.restore, sessions))
        able = all(session.can_be_restored for session in sessions)
        self._messages.say(text, *([undo] if able else []), good=True)

    # --- notes

    def ask_note(self) -> None:
        """The note is of the instant at which it is begun, not of that at which it is written."""
        t = self._host.notes.now()
        dialog = question(self._window, self.tr("Note"), self.tr("What happened?"))
        dialog.textValueSelected.connect(lambda text: self._note(text.strip(), t))
        dialog.open()

    def _note(self, text: str, t: float) -> None:
        if text:
            self._host.notes.add(text, t)

    # --- another name

    def _ask_name(self, report: RecordingReport) -> None:
        title = self.tr("Rename {}").format(report.path.name)
        words = self.tr("Name of the recording")
        dialog = question(self._window, title, words, report.path.stem)
        dialog.textValueSelected.connect(lambda name: self.rename(report, name))
        dialog.open()

    def rename(self, report: RecordingReport, name: str) -> None:
        """Give it another name and offer the rest again."""
        path = self._library.files.rename(report.path, name)
        if path is not None:
            self._checked(replace(report, path=path))


def _now(setup: EngineSetup) -> HandNow:
    """Of the hand that it is seen from."""
    hand = setup.tracked
    imus = setup.glove.imu_names
    return HandNow(setup.side, hand.status(), hand.recent_imu(), imus, setup.connection.present)
