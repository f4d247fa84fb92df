"""The dialog that leads through the touch test, records it and opens the report."""

from __future__ import annotations

from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt, QTimer, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QDialog,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.protocols import SimulatedWearer
from app.panels.command_kind import CommandContext
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.viewmodels.recording import RecordingPlan
from app.words import error_text
from extensions.touch.pose import SheetPose, find_sheet
from extensions.touch.protocol import TouchCue
from extensions.touch.window.extension import can_run
from extensions.touch.window.view_model import TouchPhase, TouchRun, cue_words
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.files import whole_file
from tracker.messages import Array, Validity

if TYPE_CHECKING:
    from extensions.touch.simulated.session import Follower
from collections.abc import Callable
from typing import NamedTuple

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from extensions.touch.analyse import analyse
from extensions.touch.report import write_report

TASK = "touch-test"
PRINTING = __name__.partition(".touch.")[0] + ".sheets"  # the extension that writes PDF
TICK_MS = 33
RULER_MM = 260.0


class TouchDialog(QDialog):
    """Records a session with a note at the beginning and the end of each cue."""

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._setup, self._store, self._tasks = host, setup, store, tasks
        self._take: Path | None = None
        self._clock = 0.0  # s, of the last estimate that was judged
        self._follower: Follower | None = None  # of a simulated wearer
        self._followed: TouchCue | None = None
        self.run = TouchRun(host.notes.add)
        self.setWindowTitle(self.tr("Touch test"))
        self.setObjectName("touch_test")
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self.tick)
        host.recording.finished.connect(self._recorded)
        host.running_changed.connect(self._running_changed)
        host.closed.connect(self.reject)
        self.show_run()
        self._lead_away()

    def _lay_out(self) -> None:
        self.words, self.how = QLabel(), QLabel()
        for label, points in ((self.words, 26), (self.how, 15)):
            label.setWordWrap(True)
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
            label.setStyleSheet(f"font-size: {points}pt")
        self.ruler = QDoubleSpinBox()
        self.ruler.setRange(RULER_MM - 20, RULER_MM + 20)
        self.ruler.setDecimals(1)
        self.ruler.setSingleStep(0.1)
        self.ruler.setValue(RULER_MM)
        self.ruler.setSuffix(" mm")
        form = QFormLayout()
        form.addRow(self.tr("Printed line of 260 mm, measured with a ruler:"), self.ruler)
        self.held, self.progress = QProgressBar(), QProgressBar()
        self.held.setTextVisible(False)
        self.held.setAccessibleName(self.tr("Time on the cross"))
        self.progress.setFormat("%v / %m")
        self.progress.setAccessibleName(self.tr("Cues carried out"))
        column = QVBoxLayout(self)
        for widget in (self.words, self.how):
            column.addWidget(widget, 1)
        column.addLayout(form)
        for bar in (self.held, self.progress):
            column.addWidget(bar)
        column.addLayout(self._buttons())
        self.resize(760, 420)

    def _buttons(self) -> QHBoxLayout:
        self.sheet_button = QPushButton(self.tr("S&ave the sheet…"))
        self.sheet_button.setToolTip(self.tr("The sheet and its ridge as PDF, to be printed"))
        self.sheet_button.clicked.connect(self._ask_where_to_save)
        self.sheet_button.setEnabled(find_spec(PRINTING) is not None)
        self.start_button = QPushButton(self.tr("&Start"))
        self.start_button.setDefault(True)
        self.start_button.clicked.connect(self.start)
        self.accept_button = QPushButton(self.tr("&Touched"))
        self.accept_button.setToolTip(self.tr("Accept the touch although it was not detected"))
        self.accept_button.clicked.connect(lambda: self.run.accept(self._now()))
        self.skip_button = QPushButton(self.tr("S&kip"))
        self.skip_button.clicked.connect(lambda: self.run.skip(self._now()))
        self.repeat_button = QPushButton(self.tr("&Repeat the last one"))
        self.repeat_button.clicked.connect(lambda: self.run.repeat(self._now()))
        row = QHBoxLayout()
        for button in (
            *(self.repeat_button, self.skip_button, self.accept_button),
            *(self.sheet_button, self.start_button),
        ):
            row.addWidget(button)
        return row

    # --- the sheet

    def _ask_where_to_save(self) -> None:
        folder = sessions_folder(self._store.value)
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save the sheet"), str(folder / "touch-test.pdf"), "*.pdf"
        )
        if path:
            self.save_sheet(Path(path))

    def save_sheet(self, path: Path) -> None:
        """Write the sheet as PDF; a message reports where, or why this failed."""
        from extensions.sheets.page import save_pages  # deferred: loads Matplotlib
        from extensions.touch.page import touch_pages

        try:
            with whole_file(path, force=True) as part:
                save_pages(touch_pages(), part, self.tr("Sheet of the touch test"))
        except GlovetrackError as error:
            self.how.setText(error_text(error))
        else:
            self.how.setText(self.tr("Sheet saved: {}. Print it at 100 %.").format(path))

    # --- the cues

    def start(self) -> None:
        """Find the sheet, start a recording and the first cue; reports why that is impossible."""
        if self._host.recording.request is not None:
            self._host.error.emit(self.tr("Stop the current recording first."))
            return
        try:
            pose = self._find_sheet()
            request = RecordingPlan(self._store).request_for(TASK)
        except GlovetrackError as error:
            self.how.setText(error_text(error))
            return
        if self._host.recording.begin(request):
            self._take = request.path
            self.run = TouchRun(self._host.notes.add)
            self.run.start(self._now(), pose, self.ruler.value() / 1000)
            self._timer.start()
            self.tick()

    def _find_sheet(self) -> SheetPose:
        latest = self._setup.tracked.latest_frame()
        frames = [] if latest is None else [latest[0]]
        return find_sheet(frames, self._setup.camera.rig, self.ruler.value() / 1000)

    def tick(self) -> None:
        """Refresh; called by the timer."""
        self.run.tick(self._now(), self._tip())
        self._lead()
        self.show_run()
        if self.run.phase == TouchPhase.DONE:
            self._timer.stop()
            self._end_take()

    # --- a simulated wearer

    def _lead_away(self) -> None:
        """Let a simulated wearer uncover the sheet."""
        wearer = self._wearer()
        if wearer is not None:
            from extensions.touch.simulated.session import Follower  # deferred: the simulator

            self._follower = Follower()
            wearer.follow(self._follower.away, "away")

    def _lead(self) -> None:
        """Let a simulated wearer carry out the current cue."""
        wearer, cue = self._wearer(), self.run.cue
        if wearer is None or self._follower is None or cue == self._followed:
            return
        self._followed = cue
        if self.run.phase == TouchPhase.RUNNING:
            wearer.follow(partial(self._follower.cue, cue), f"{cue.what} {cue.number}")

    def _wearer(self) -> SimulatedWearer | None:
        return self._setup.live.wearer if self._setup.live is not None else None

    def _now(self) -> float:
        """s: the instant of the tip that is judged, which is in the past on a loaded computer. The
        cues are recorded with it, so that each one is around its touch."""
        estimate = self._setup.tracked.latest_estimate()
        self._clock = max(self._clock, estimate.t) if estimate is not None else monotonic()
        return self._clock

    def _tip(self) -> Array | None:
        """(3,) m in G of the finger asked for."""
        estimate, cue = self._setup.tracked.latest_estimate(), self.run.cue
        if estimate is None or not cue.finger:
            return None
        names = self._setup.glove.keypoint_names(self._setup.hand)
        row = names.index(f"{cue.finger}_tip")
        p_G = estimate.keypoints[row]
        lost = estimate.keypoint_state[row] == Validity.LOST or not np.isfinite(p_G).all()
        return None if lost else p_G

    def show_run(self) -> None:
        """Show the current cue."""
        phase = self.run.phase
        running = phase == TouchPhase.RUNNING
        if running:
            words, how = cue_words(self.run.cue)
            self.words.setText(words)
            self.how.setText(how)
        elif phase == TouchPhase.WAITING:
            self.words.setText(self.tr("Touch the crosses of the printed sheet"))
            self.how.setText(
                self.tr("Lay the sheet in front of the camera, and keep your hand out of its view. "
                        "The test takes about five minutes.")
            )  # fmt: skip
        self.held.setValue(round(100 * min(max(self.run.share, 0.0), 1.0)))
        self.progress.setMaximum(len(self.run.cues))
        self.progress.setValue(len(self.run.done))
        for button in (self.sheet_button, self.start_button):
            button.setVisible(not running)
        self.ruler.setEnabled(not running)
        for button in (self.accept_button, self.skip_button, self.repeat_button):
            button.setVisible(running)

    # --- the report

    def _end_take(self) -> None:
        request = self._host.recording.request
        if request is not None and request.path == self._take:
            self.words.setText(self.tr("Writing the report…"))
            self.how.setText("")
            self._host.recording.end()

    def _recorded(self, path: Path) -> None:
        if path == self._take and self.run.done:
            title = self.tr("Report of {}").format(path.name)
            self._tasks.run(title, touch_job(path), done=self._written, failed=self._failed)

    def _written(self, written: Written) -> None:
        self.words.setText(self.tr("The report is ready"))
        self.how.setText(written.line)
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(written.page)))

    def _failed(self, why: str) -> None:
        self.words.setText(self.tr("No report was written"))
        self.how.setText(why)

    # --- the window

    def _running_changed(self, on: bool) -> None:
        if not on:
            self.reject()

    def done(self, result: int) -> None:
        """Close; what was recorded so far is an ordinary recording."""
        self._timer.stop()
        self.run.cancel(self._now())
        self._end_take()
        wearer = self._wearer()
        if wearer is not None:
            wearer.show("")
        super().done(result)


def open_dialog(on: CommandContext) -> None:
    """Open the dialog."""
    setup = on.host.setup
    if setup is None or not can_run(on):
        return
    on.show_dialog("touch_test", lambda: TouchDialog(on.host, setup, on.store, on.tasks, on.window))


# ---- writes the report of a touch test in a background job


class Written(NamedTuple):
    """The page, and the line to quote."""

    page: Path
    line: str


def touch_job(session: Path) -> Job:
    """A job that returns the report `Written` next to ``session``."""

    def run(progress: JobProgress) -> Written:
        out: Written = run_in_subprocess("touch-test", partial(_write, session), progress)
        return out

    return run


def _write(session: Path, progress: Callable[..., None]) -> Written:

    result = analyse(session, watch=progress)
    page, n = session.with_name(f"{session.stem}-touch-test.html"), 1
    while page.exists() or page.with_suffix(".pdf").exists():
        n += 1
        page = session.with_name(f"{session.stem}-touch-test-{n}.html")
    write_report(result, page)
    return Written(page, result.line)
