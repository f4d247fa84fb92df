"""Recordings from start to later use: missing data, checks, names, recovery, recent files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.derived_sessions import recover_job
from app.panels.library.panel import LibraryPanel
from app.panels.start_page import StartPage
from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress, RunningJob, TaskOwner
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
    HandReport,
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
from app.words import error_text, notice_text
from tracker.base.errors import GlovetrackError
from tracker.session.overview import HandShare, quality
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery
from tracker.session.verify import verify

ABOUT = "take"  # the topic of messages about missing data
STARTING_MS = 2000  # after the start of an engine its rates are not meaningful yet
POLL_MS = 500  # between two checks for missing data


class RecordingChecks(QObject):
    """Checks each recording in the background and offers the next steps."""

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
        self._reported: Missing = {}  # missing devices at the last check
        self._running = QElapsedTimer()
        self._looks = QTimer(self)
        self._looks.timeout.connect(self._look)
        messages.dismissed.connect(self._note_dismissed)
        library.files.binned.connect(self._binned)
        host.running_changed.connect(lambda on: self._running.start() if on else None)
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)

    def _begun(self) -> None:
        """Report missing data from now on; the recording continues."""
        self._missing, self._reported, self._dismissed = MissingWatch(), {}, False
        if self._check is not None:
            self._check.cancel()  # the next recording needs the disk
        self._messages.hide()  # a message about the previous recording
        self._looks.start(POLL_MS)
        self._look()

    def _look(self) -> None:
        """Name the data that are missing, as long as they are."""
        setup = self._host.setup
        if setup is None or self._host.recording.request is None:
            self._looks.stop()
            self._messages.no_longer(ABOUT)
            return
        if self._running.isValid() and self._running.elapsed() < STARTING_MS:
            return  # devices that were just opened do not send yet
        rate = setup.camera.device.fps if setup.camera.device is not None else 0.0
        hands = [_now(hand) for hand in setup.hands]
        self._report(self._missing.look(missing_now(hands, rate if setup.camera.present else None)))

    def _report(self, missing: Missing) -> None:
        """Show it again where something else is missing, or another message has closed."""
        changed, added = (
            missing.keys() != self._reported.keys(),
            missing.keys() - self._reported.keys(),
        )
        self._reported = missing
        self._dismissed = self._dismissed and not added
        if not missing:
            self._messages.no_longer(ABOUT)
        elif not self._dismissed and (changed or not self._messages.isVisible()):
            self._messages.show_message(missing_text(missing), about=ABOUT)

    def _note_dismissed(self, about: str) -> None:
        """The user has read it: do not show it again."""
        self._dismissed = self._dismissed or about == ABOUT

    def _finished(self, path: Path) -> None:
        title = self.tr("Checking {}").format(path.name)
        self._check = self._tasks.run(title, check_job(path), self._checked, self._ended)

    def _ended(self) -> None:
        self._check = None

    def _checked(self, report: RecordingReport) -> None:
        if self._host.recording.request is not None:
            return  # the next one is in progress
        path, ended_by = report.path, self._host.recording.ended_by
        recover = (self.tr("Recover"), partial(self.recover.emit, path))
        self._messages.show_message(
            " ".join(filter(None, (ended_by, report_text(report)))),
            *([recover] if report.cut_off else []),
            (self.tr("Show"), partial(self._show, path)),
            (self.tr("Export…"), partial(self._library.ask_export_of, [path])),
            (self.tr("Rename…"), partial(self._ask_name, report)),
            good=not report.problem and not ended_by,
            stays=True,  # a cancelled dialog changes nothing
        )

    def _show(self, path: Path) -> None:
        self._messages.hide()
        self._library.replay.emit(path)

    def _binned(self, sessions: tuple[Binned, ...]) -> None:
        """Offer to undo the deletion, which was not confirmed."""
        text = self.tr("{} moved to the trash.").format(sessions[0].path.stem)
        if len(sessions) > 1:
            text = self.tr("{} recordings moved to the trash.").format(len(sessions))
        undo = (self.tr("Undo"), partial(self._library.files.restore, sessions))
        able = all(session.can_be_restored for session in sessions)
        self._messages.show_message(text, *([undo] if able else []), good=True)

    # --- notes

    def ask_note(self) -> None:
        """Ask for a note; its time is the instant of this call, not of the end of typing."""
        t = self._host.notes.now()
        dialog = question(self._window, self.tr("Note"), self.tr("Text of the note"))
        dialog.textValueSelected.connect(lambda text: self._note(text.strip(), t))
        dialog.open()

    def _note(self, text: str, t: float) -> None:
        if text:
            self._host.notes.add(text, t)

    # --- renaming

    def _ask_name(self, report: RecordingReport) -> None:
        title = self.tr("Rename {}").format(report.path.name)
        prompt = self.tr("Name of the recording")
        dialog = question(self._window, title, prompt, report.path.stem)
        dialog.textValueSelected.connect(lambda name: self.rename(report, name))
        dialog.open()

    def rename(self, report: RecordingReport, name: str) -> None:
        """Rename the recording and offer the other steps again."""
        path = self._library.files.rename(report.path, name)
        if path is not None:
            self._checked(replace(report, path=path))


def _now(setup: EngineSetup) -> HandNow:
    """The state of the hand that the setup is seen from."""
    hand = setup.tracked
    imus = setup.glove.imu_names
    return HandNow(setup.side, hand.status(), hand.recent_imu(), imus, setup.connection.present)


class RecentSessions(QObject):
    """Stores which sessions were opened and recorded; lists them when the window starts."""

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
        self._interrupted = store.value.recording  # by the end of the previous run
        host.recording.begun.connect(self._begun)
        host.recording.finished.connect(self._finished)
        page.recover.connect(self.recover)
        page.recent_requested.connect(library.replay)
        library.files.made.connect(self.offer)
        library.files.renamed.connect(self._renamed)
        library.files.changed.connect(self._changed)
        self.look()

    def look(self) -> None:
        """List earlier sessions in the background; at a first start there are none."""
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
        """Store the path of the file, for the start after a crash."""
        request = self._host.recording.request
        if request is not None:
            self._store.update(recording=str(request.path.absolute()))

    def _finished(self, path: Path) -> None:
        if self._host.recording.request is None:
            self._store.update(recording="")
        self._remember(path)

    def explain_crash(self, sentence: str, report: Action) -> None:
        """Show ``sentence``, and the state of the recording that the crash interrupted."""
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
            show = (self.tr("Show"), partial(self._library.replay.emit, path))
            self._messages.show_message(text, show, report)

        title = self.tr("Checking {}").format(path.name)
        self._tasks.run(title, job, done, self.look)

    def _offer_recovery(self, path: Path, before: str = "", *others: Action) -> None:
        """Offer to recover, or to open the recovered file; ``before`` is the first sentence."""
        whole = recovered(path)
        if whole.exists():
            text = self.tr("Recording {} was cut off. Its contents were recovered to {}.")
            show = (self.tr("Show"), partial(self._library.replay.emit, whole))
            text = f"{before} {text.format(path.name, whole.name)}".strip()
            self._messages.show_message(text, show, *others)
        else:
            text = self.tr("Recording {} was cut off. Its contents can be recovered.")
            recover = (self.tr("Recover"), partial(self.recover, path))
            self._messages.show_message(
                f"{before} {text.format(path.name)}".strip(), recover, *others
            )

    def _remember(self, path: Path) -> None:
        self._store.update(recent=with_recent(self._store.value.recent, path))

    def _renamed(self, before: Path, path: Path) -> None:
        self._store.update(recent=renamed(self._store.value.recent, before, path))

    def _changed(self) -> None:
        """The library can be shown next to the start page."""
        if not self._page.isHidden():
            self.look()

    def recover(self, path: Path) -> None:
        """Recover its contents to a new file, in the background; the original is not changed."""
        title = self.tr("Recovering {}").format(path.name)
        self._tasks.run(title, recover_job(path), self._recovered, self.look)

    def _recovered(self, path: Path) -> None:
        text = self.tr("Recovered the recording to {}.").format(path.name)
        self._library.rescan()
        self.offer(path, text)

    def offer(self, path: Path, text: str) -> None:
        """Offer the next steps with a new session."""
        show = (self.tr("Show"), partial(self._library.replay.emit, path))
        export = (self.tr("Export…"), partial(self._library.ask_export_of, [path]))
        self._messages.show_message(text, show, export, good=True)


# ---- checks a finished recording: whether it is complete, and how well it was tracked


def check_job(path: Path) -> Job:
    """A job that reads the whole file and returns its `RecordingReport`; in a subprocess, since the
    hand is tracked at the same time."""

    def run(progress: JobProgress) -> RecordingReport:
        try:
            report: RecordingReport = run_in_subprocess("check", partial(_report, path), progress)
        except GlovetrackError as error:
            return RecordingReport(path, error_text(error))
        return report

    return run


def _report(path: Path, progress: Callable[..., None]) -> RecordingReport:
    """Raises FileError if it cannot be read."""

    findings = verify(path, progress)
    errors = [f"{f.where}: {notice_text(f.what)}" for f in findings if f.severity == "error"]
    with SessionReader(path) as reader:
        q, duration = quality(reader), reader.duration
        shares = q.hands or (HandShare(reader.info.side, q.tracked),)
    problem = errors[0] if errors else ""
    silent = {f.where: f.silence for f in findings}
    camera = silent.get("/camera", 0.0)
    hands = tuple(
        HandReport(hand.side, hand.tracked, silent.get(f"/glove/{hand.side}", 0.0))
        for hand in shares
    )
    cut_off = needs_recovery(path)
    return RecordingReport(
        path, problem, duration, q.packets_lost, q.by_imus, camera, hands, cut_off
    )
