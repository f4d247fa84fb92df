"""Recordings, from their start to later sessions: gaps, checks, names, recovery, recent files."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.derived_sessions import recover_job
from app.jobs.recording_check import check_job
from app.panels.library.panel import LibraryPanel
from app.panels.start_page import StartPage
from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.storage.system_bin import Binned
from app.viewmodels.recent import (
    Earlier,
    is_complete,
    look_back,
    newest,
    recovered,
    renamed,
    with_recent,
)
from app.viewmodels.recording_report import (
    HandNow,
    Missing,
    MissingWatch,
    RecordingReport,
    missing_now,
    missing_text,
    report_text,
)
from app.widgets.banner import Action
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


class RecentSessions(QObject):
    """Remembers what is opened and recorded; looks back when the window starts."""

    def __init__(
        self,
        page: StartPage,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        messages: MessageBar,
        library: LibraryPanel,
    ) -> None:
        super().__init__(page)
        self._page, self._store, self._tasks = page, store, tasks
        self._messages, self._library = messages, library
        host.opened.connect(self._opened)
        self._host = host
        self._interrupted = store.value.recording  # by the end of the last run
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)
        page.recover.connect(self.recover)
        page.recent_asked.connect(library.replay)
        library.files.made.connect(self.offer)
        library.files.renamed.connect(self._renamed)
        library.files.changed.connect(self._changed)
        self.look()

    def look(self) -> None:
        """Anew, in the background; a first start has nothing to look at."""
        known, folder = tuple(self._store.value.recent), sessions_folder(self._store.value)
        if not known and not newest(folder):
            return

        def job(progress: JobProgress) -> Earlier:
            return look_back(known, folder, datetime.now(), progress)

        self._tasks.run(self.tr("Looking for earlier sessions"), job, self._page.show_earlier)

    def _opened(self, setup: EngineSetup) -> None:
        if setup.player is None:
            return
        path = setup.player.path
        self._remember(path)
        if setup.player.cut_off:
            self._offer_recovery(path)

    def _begun(self) -> None:
        """A start after a crash asks for the file that was being written."""
        request = self._host.recording.request
        if request is not None:
            self._store.update(recording=str(request.path.absolute()))

    def _finished(self, path: Path) -> None:
        if self._host.recording.request is None:
            self._store.update(recording="")
        self._remember(path)

    def explain_crash(self, sentence: str, report: Action) -> None:
        """After ``sentence``, say what became of the recording that the crash interrupted."""
        path, self._interrupted = Path(self._interrupted), ""
        if not path.is_file():
            return
        self._store.update(recording="")

        def job(progress: JobProgress) -> bool:
            return is_complete(path, progress)

        def done(complete: bool) -> None:
            if not complete:
                self._offer_recovery(path, sentence, report)
                return
            self._remember(path)
            text = self.tr("{} Your recording {} is complete.").format(sentence, path.stem)
            show = (self.tr("Show it"), partial(self._library.replay.emit, path))
            self._messages.say(text, show, report)

        title = self.tr("Checking {}").format(path.name)
        self._tasks.run(title, job, done, self.look)

    def _offer_recovery(self, path: Path, before: str = "", *others: Action) -> None:
        """Of one that was recovered before, the recovered one; ``before``: the sentence before."""
        whole = recovered(path)
        if whole.exists():
            text = self.tr("The recording {} was cut off. What it holds is whole in {}.")
            show = (self.tr("Show it"), partial(self._library.replay.emit, whole))
            text = f"{before} {text.format(path.name, whole.name)}".strip()
            self._messages.say(text, show, *others)
        else:
            text = self.tr("The recording {} was cut off. What it holds can be recovered.")
            help_it = (self.tr("Recover"), partial(self.recover, path))
            self._messages.say(f"{before} {text.format(path.name)}".strip(), help_it, *others)

    def _remember(self, path: Path) -> None:
        self._store.update(recent=with_recent(self._store.value.recent, path))

    def _renamed(self, before: Path, path: Path) -> None:
        self._store.update(recent=renamed(self._store.value.recent, before, path))

    def _changed(self) -> None:
        """The library can stand beside the start page."""
        if not self._page.isHidden():
            self.look()

    def recover(self, path: Path) -> None:
        """Make a whole file of it, in the background; the original stays."""
        title = self.tr("Recovering {}").format(path.name)
        self._tasks.run(title, recover_job(path), self._recovered, self.look)

    def _recovered(self, path: Path) -> None:
        text = self.tr("What could be read of the recording is in {}.").format(path.name)
        self._library.rescan()
        self.offer(path, text)

    def offer(self, path: Path, text: str) -> None:
        """A new session has come to be: what one does with it next."""
        show = (self.tr("Show it"), partial(self._library.replay.emit, path))
        export = (self.tr("Export…"), partial(self._library.ask_export_of, [path]))
        self._messages.say(text, show, export, good=True)
