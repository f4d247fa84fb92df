"""The dialog that leads a participant through a study: cues, countdown, verdict."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, QTimer, QUrl
from PySide6.QtGui import QDesktopServices, QPixmap
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
)

from app.engines.engine_host import EngineHost
from app.engines.protocols import RecordingRequest
from app.panels.command_kind import CommandContext
from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from app.window.contributions import COMMANDS
from app.words import error_text
from extensions.study.conductor import Conductor, TrialPhase
from extensions.study.folder import STORED, Study, open_study
from extensions.study.progress import FINISHED, locked
from extensions.study.protocol import TrialLimits, is_picture
from extensions.study.results import write_report
from extensions.study.schedule import ScheduleStep
from extensions.study.verdict import TrialVerdict, judge, stored
from extensions.study.window.view_model import ShownStep, shown
from tracker.base.clock import monotonic
from tracker.base.errors import DeviceError, FileError, GlovetrackError
from tracker.base.notices import failure

TICK_MS = 33
CUE_PT, TITLE_PT, DETAIL_PT = 34, 16, 13
PICTURE = 320  # px
SIZE, MARGIN = (720, 420), 60  # px
GOOD, BAD = "#1e7d34", "#b3261e"


class StudyDialog(QDialog):
    """Not modal: the window below shows the hand. Trials are recorded by its engine."""

    def __init__(self, context: CommandContext, study: Study, participant: str = "") -> None:
        super().__init__(context.window)
        self._context, self._study = context, study
        self._host = context.host
        self._locks = ExitStack()
        self._checked = ""  # name and try of the recording that is being judged
        self._problem = ""
        self.conductor: Conductor | None = None
        self.setObjectName("study")
        self.setWindowTitle(self.tr("Study: {}").format(study.protocol.title))
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self.tick)
        self._host.recording.finished.connect(self._recorded)
        self._host.running_changed.connect(self._running_changed)
        first = participant or study.next_participant() or study.protocol.participants[0]
        self.participants.setCurrentText(first)
        self._choose(first)
        self.participants.currentTextChanged.connect(self._choose)
        self._timer.start()

    # --- layout

    def _lay_out(self) -> None:
        self.participants = QComboBox()
        self.participants.addItems(self._study.protocol.participants)
        self.participants.setAccessibleName(self.tr("Participant"))
        self.where, self.title, self.cue, self.detail = QLabel(), QLabel(), QLabel(), QLabel()
        for label, points in ((self.title, TITLE_PT), (self.cue, CUE_PT), (self.detail, DETAIL_PT)):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
            label.setWordWrap(True)
            label.setStyleSheet(f"font-size: {points}pt")
        self.time, self.progress = QProgressBar(), QProgressBar()
        self.time.setTextVisible(False)
        self.time.setRange(0, 1000)
        self.time.setAccessibleName(self.tr("Time until the next cue"))
        self.progress.setFormat("%v / %m")
        self.progress.setAccessibleName(self.tr("Steps that are done"))
        top = QHBoxLayout()
        top.addWidget(self.participants)
        top.addWidget(self.where, 1)
        column = QVBoxLayout(self)
        column.addLayout(top)
        column.addWidget(self.title)
        column.addWidget(self.cue, 1)
        column.addWidget(self.detail)
        column.addWidget(self.time)
        column.addWidget(self.progress)
        column.addLayout(self._buttons())
        self.resize(*SIZE)
        corner = self._context.window.geometry().bottomRight()  # the images remain visible
        self.move(max(corner.x() - SIZE[0] - MARGIN, 0), max(corner.y() - SIZE[1] - MARGIN, 0))

    def _buttons(self) -> QHBoxLayout:
        self.report_button = QPushButton(self.tr("Repo&rt"))
        self.report_button.clicked.connect(self.write_report)
        self.pause_button = QPushButton()
        self.pause_button.clicked.connect(lambda: self._do("pause"))
        self.exclude_button = QPushButton(self.tr("E&xclude"))
        self.exclude_button.setToolTip(self.tr("Keep the recording, but do not evaluate it"))
        self.exclude_button.clicked.connect(lambda: self._do("give_up"))
        self.repeat_button = QPushButton(self.tr("&Repeat"))
        self.repeat_button.clicked.connect(lambda: self._do("repeat"))
        self.next_button = QPushButton()
        self.next_button.clicked.connect(lambda: self._do("go_on"))
        row = QHBoxLayout()
        row.addWidget(self.report_button)
        row.addStretch(1)
        for button in (
            self.pause_button,
            self.exclude_button,
            self.repeat_button,
            self.next_button,
        ):
            row.addWidget(button)
        return row

    # --- the participant

    def _choose(self, participant: str) -> None:
        """Continue with a participant; reports why that is impossible."""
        self._locks.close()
        self.conductor, self._problem = None, ""
        try:
            progress = self._study.progress(participant)
            self._locks.enter_context(locked(progress))
            progress.resume()
        except GlovetrackError as error:
            self._say(error_text(error))
            return
        self.conductor = Conductor(progress, HostStation(self._host, self._begin_touch))
        self._checked = ""
        self.tick()

    def tick(self) -> None:
        """Let time pass, and show the present phase; called by the timer."""
        conductor = self.conductor
        if conductor is None:
            return
        self._try(lambda: conductor.tick(monotonic()))
        if conductor.phase is TrialPhase.CHECKING and self._host.recording.file is None:
            self._judge()  # of a recording that was completed before the dialog was opened
        self._show(conductor)

    def _do(self, what: str) -> None:
        """A click of the experimenter."""
        conductor, self._problem = self.conductor, ""
        if conductor is None:
            return
        if what == "give_up":
            self._try(conductor.give_up)
        else:
            self._try(lambda: getattr(conductor, what)(monotonic()))
        self._show(conductor)

    def _try(self, work: Callable[[], None]) -> None:
        try:
            work()
        except GlovetrackError as error:
            if self.conductor is not None and self.conductor.phase is TrialPhase.READY:
                self._say(error_text(error))
            else:
                self._host.error.emit(error_text(error))

    # --- recordings

    def _begin_touch(self, step: ScheduleStep) -> bool:
        """Open the touch test for its trial; False for another task."""
        if self._study.protocol.tasks[step.task].kind != "touch":
            return False
        self._context.store.update(participant=step.participant)
        COMMANDS.get("touch_test").run(self._context)
        return True

    def _recorded(self, path: Path) -> None:
        conductor = self.conductor
        step = conductor.step if conductor is not None else None
        if conductor is None or step is None or conductor.progress.task is None:
            return
        own = conductor.progress.path(step)
        touch = conductor.progress.task.kind == "touch" and conductor.phase is TrialPhase.RUNNING
        if touch and path != own:
            _link(path, own)  # the touch test has its own file, next to its own report
            conductor.go_on(monotonic())
        elif path != own:
            return
        self._try(conductor.recorded)
        self._judge()

    def _judge(self) -> None:
        """Judge the trial's recording in the background, once."""
        conductor = self.conductor
        step = conductor.step if conductor is not None else None
        if conductor is None or step is None or conductor.phase is not TrialPhase.CHECKING:
            return
        attempt = f"{step.name} {len(conductor.progress.entry(step).tries)}"
        if self._checked == attempt:
            return
        self._checked = attempt
        job = verdict_job(conductor.progress.path(step), step, self._study.protocol.limits)
        title = self.tr("Verdict on {}").format(step.name)

        def judged(verdict: TrialVerdict) -> None:
            if self.conductor is conductor:
                conductor.judged(verdict)
                self.tick()

        self._context.tasks.run(title, job, done=judged)

    def _running_changed(self, on: bool) -> None:
        if not on and self.conductor is not None:
            self.conductor.interrupt(monotonic())

    # --- the screen

    def _show(self, conductor: Conductor) -> None:
        view = shown(conductor)
        self.where.setText(view.where)
        self.title.setText(view.title)
        self._show_cue(view)
        self.detail.setText(self._problem or view.detail)
        self.time.setValue(round(1000 * min(max(view.share, 0.0), 1.0)))
        steps = conductor.progress.steps
        self.progress.setMaximum(len(steps))
        done = sum(conductor.progress.entry(s).state in FINISHED for s in steps)
        self.progress.setValue(done)
        self.next_button.setText(view.next_text)
        self.next_button.setVisible(bool(view.next_text))
        self.repeat_button.setVisible(view.can_repeat)
        _emphasize(self.repeat_button, view.is_good is False)
        _emphasize(self.next_button, view.is_good is not False)
        self.exclude_button.setVisible(view.can_exclude)
        self.pause_button.setVisible(view.can_pause)
        self.pause_button.setText(self.tr("&Continue") if conductor.paused else self.tr("&Pause"))
        idle = conductor.phase in (TrialPhase.READY, TrialPhase.REST, TrialPhase.DONE)
        self.participants.setEnabled(idle)
        self.report_button.setEnabled(idle)

    def _show_cue(self, view: ShownStep) -> None:
        colour = {True: f"; color: {GOOD}", False: f"; color: {BAD}", None: ""}[view.is_good]
        style = f"font-size: {CUE_PT}pt{colour}"
        if self.cue.styleSheet() != style:
            self.cue.setStyleSheet(style)
        if not is_picture(view.cue):
            self.cue.setText(view.cue)
            return
        picture = QPixmap(str((self._study.folder / STORED).parent / view.cue))
        if picture.isNull():
            self.cue.setText(view.cue)
            return
        mode = Qt.TransformationMode.SmoothTransformation
        self.cue.setPixmap(picture.scaledToHeight(PICTURE, mode))

    def _say(self, text: str) -> None:
        """Show why something is impossible, until the next click."""
        self._problem = text
        self.detail.setText(text)

    # --- the end

    def write_report(self) -> None:
        """Write the report of the study, and open it in the browser."""
        title = self.tr("Report of the study")
        job = report_job(self._study.folder)
        self._context.tasks.run(title, job, done=self._open_report, failed=self._say)

    def _open_report(self, page: Path) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(page)))

    def done(self, result: int) -> None:
        """Close; a running trial is interrupted, and repeated when the study continues."""
        self._timer.stop()
        if self.conductor is not None:
            self.conductor.interrupt(monotonic())
        self._locks.close()
        super().done(result)


def _emphasize(button: QPushButton, on: bool) -> None:
    """Make a button the main one, or an ordinary one."""
    role = "primary" if on else ""
    if button.property("role") != role:
        button.setProperty("role", role)
        button.style().unpolish(button)
        button.style().polish(button)
        button.setDefault(on)


def _link(path: Path, own: Path) -> None:
    """The same file under the trial's name; a copy on disks without links."""
    try:
        os.link(path, own)
    except OSError:
        shutil.copyfile(path, own)


# ---- background jobs of a study: the verdict on a trial, and the report


def verdict_job(path: Path, step: ScheduleStep, limits: TrialLimits) -> Job:
    """A job that returns the `TrialVerdict` on a recording."""

    def run(progress: JobProgress) -> TrialVerdict:
        work = partial(_judge, path, step, limits)
        return stored(run_in_subprocess("verdict", work, progress))

    return run


def _judge(
    path: Path, step: ScheduleStep, limits: TrialLimits, _: Callable[..., None]
) -> dict[str, Any]:
    return judge(path, step, limits).as_json()


def report_job(folder: Path) -> Job:
    """A job that writes the report of a study, and returns its path."""

    def run(progress: JobProgress) -> Path:
        out: Path = run_in_subprocess("study-report", partial(_report, folder), progress)
        return out

    return run


def _report(folder: Path, _: Callable[..., None]) -> Path:
    return write_report(open_study(folder), folder / "report")


# ---- records trials with the window's engine


class HostStation:
    """A `Station`. ``touch`` begins a touch test, which records itself."""

    def __init__(self, host: EngineHost, touch: Callable[[ScheduleStep], bool]) -> None:
        self._host, self._touch = host, touch

    def begin(self, path: Path, step: ScheduleStep) -> None:
        """Begin a file. Raises DeviceError without a running engine, FileError."""
        if self._touch(step):
            return
        if not self._host.running or not self._host.recording.is_possible:
            raise DeviceError(failure("study.no_engine"))
        request = RecordingRequest(path, step.participant, step.task)
        if not self._host.recording.begin(request):
            raise FileError(self._host.recording.refusal or failure("study.no_recording"))

    def note(self, text: str, data: Mapping[str, object]) -> None:
        """Write a note."""
        self._host.notes.add(text, data=data)

    def end(self) -> None:
        """End the file; ``host.recording.finished`` is emitted when it is complete."""
        if self._host.recording.request is not None:
            self._host.recording.end()

    def stamp(self) -> str:
        """The present date and time, UTC."""
        return datetime.now(UTC).isoformat(timespec="seconds")
