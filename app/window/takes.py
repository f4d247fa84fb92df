"""What is said of a recording: what it lacks when it begins, how it went when it has ended."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QElapsedTimer, QObject, QTimer
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.take_check import check_job
from app.panels.library.panel import LibraryPanel
from app.platform.tasks import RunningJob, TaskOwner
from app.viewmodels.takes import HandNow, TakeReport, missing_text, report_text
from app.widgets.question import question
from app.window.message_bar import MessageBar
from app.words import told

ABOUT = "take"
STARTING_MS = 2000  # after its start an engine's rates say nothing yet
AGAIN_MS = 500  # until what was missing comes


class Takes(QObject):
    """Checks each recording in the background and offers what one does with it next."""

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
        self._said = ""
        self._running = QElapsedTimer()
        self._again = QTimer(self)
        self._again.timeout.connect(self._say_what_is_missing)
        host.running_changed.connect(lambda on: self._running.start() if on else None)
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)

    def _begun(self) -> None:
        """What is missing is said once, in nobody's way: it is recorded all the same."""
        self._said = ""
        if self._check is not None:
            self._check.cancel()  # the disk is wanted for the next one
        self._messages.hide()  # what it said of the recording before
        self._again.start(AGAIN_MS)
        if self._running.isValid() and self._running.elapsed() < STARTING_MS:
            return  # devices that have just been opened are not silent
        self._say_what_is_missing()

    def _say_what_is_missing(self) -> None:
        """As long as it is true."""
        setup = self._host.setup
        if setup is None or self._host.recording.request is None:
            self._again.stop()
            self._messages.no_longer(ABOUT)
            return
        if self._running.isValid() and self._running.elapsed() < STARTING_MS:
            return
        rate = setup.image_rate() if setup.image_rate is not None else 0.0
        hands = [_now(hand) for hand in setup.hands]
        text = missing_text(hands, rate if setup.has_camera else None)
        if not text:
            self._again.stop()
            self._messages.no_longer(ABOUT)
        elif not self._said or text.count(";") < self._said.count(";"):  # a part has come
            if not self._said or self._messages.is_about(ABOUT):
                self._messages.say(text, about=ABOUT)
            self._said = text

    def _finished(self, path: Path) -> None:
        title = self.tr("Checking {}").format(path.name)
        self._check = self._tasks.run(title, check_job(path), self._checked, self._ended)

    def _ended(self) -> None:
        self._check = None

    def _checked(self, report: TakeReport) -> None:
        if self._host.recording.request is not None:
            return  # the next one is under way
        path, ended_by = report.path, self._host.recording.ended_by
        self._messages.say(
            " ".join(filter(None, (told(ended_by), report_text(report)))),
            (self.tr("Show it"), partial(self._show, path)),
            (self.tr("Export…"), partial(self._library.ask_export_of, [path])),
            (self.tr("Rename…"), partial(self._ask_name, report)),
            good=not report.problem and not ended_by,
            stays=True,  # a dialog that is cancelled has changed nothing
        )

    def _show(self, path: Path) -> None:
        self._messages.hide()
        self._library.replay.emit(path)

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

    def _ask_name(self, report: TakeReport) -> None:
        title = self.tr("Rename {}").format(report.path.name)
        words = self.tr("Name of the recording")
        dialog = question(self._window, title, words, report.path.stem)
        dialog.textValueSelected.connect(lambda name: self.rename(report, name))
        dialog.open()

    def rename(self, report: TakeReport, name: str) -> None:
        """Give it another name and offer the rest again."""
        path = self._library.files.rename(report.path, name)
        if path is not None:
            self._checked(replace(report, path=path))


def _now(setup: EngineSetup) -> HandNow:
    """Of the hand that it is seen from."""
    hand = setup.tracked
    imus = setup.glove.imu_names
    return HandNow(setup.side, hand.status(), hand.recent_imu(), imus, setup.has_glove)
