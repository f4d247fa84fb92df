"""A minute of scripted gestures is recorded, judged, and told rule by rule."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QTimer, QUrl
from PySide6.QtGui import QDesktopServices, QResizeEvent
from PySide6.QtWidgets import QApplication, QDialog, QStackedWidget, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.conformance import Judged, conformance_job
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.conformance import Phase, ScriptRun, finding_row
from app.viewmodels.recording import RecordingPlan
from app.wizards.conformance.lead import ScriptPage
from app.wizards.conformance.result import VerdictPage
from app.wizards.sizing import fit_to_screen
from tracker.clock import monotonic
from tracker.errors import GlovetrackError

TICK_MS = 33
SMALLEST_PX = 20
TASK = "conformance"


class ConformanceDialog(QDialog):
    """Not modal. Its take is a recording like any other, with a note where each step begins."""

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        store: SettingsStore,
        tasks: TaskOwner,
        background: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._setup, self._store, self._tasks = host, setup, store, tasks
        self._take: Path | None = None
        self._page: Path | None = None
        self._beat = 0
        self.run = ScriptRun(setup.hand.side, host.notes.add)
        self.lead, self.outcome = ScriptPage(setup, background), VerdictPage()
        self.lead.sound.setChecked(store.value.guided_sound)
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._lay_out()
        self._connect()
        self._timer.start()
        self._tick()

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Conformance"))
        self.setObjectName("conformance")
        fit_to_screen(self, 1280, 760)
        self.pages = QStackedWidget()
        self.pages.addWidget(self.lead)
        self.pages.addWidget(self.outcome)
        column = QVBoxLayout(self)
        column.addWidget(self.pages)

    def _connect(self) -> None:
        self.lead.start.clicked.connect(self.start)
        self.lead.stop.clicked.connect(self.reject)
        self.lead.sound.toggled.connect(lambda on: self._store.update(guided_sound=on))
        self.outcome.again.connect(self._again)
        self.outcome.page_wanted.connect(self.open_page)
        self._timer.timeout.connect(self._tick)
        self._host.recording.finished.connect(self._recorded)
        self._host.running_changed.connect(self._running_changed)
        self._host.closed.connect(self.close)

    # --- the script

    def start(self) -> None:
        """Begin a recording and the first step; where another one is under way it says so."""
        if self._host.recording.request is not None:
            self._host.error.emit(self.tr("End the recording that is under way first."))
            return
        try:
            request = RecordingPlan(self._store).request_for(TASK)
        except GlovetrackError as error:
            self._host.error.emit(str(error))
            return
        if self._host.record(request):
            self._take = request.path
            self.run.start(monotonic())
            self._tick()

    def _again(self) -> None:
        self.run = ScriptRun(self._setup.hand.side, self._host.notes.add)
        self.pages.setCurrentWidget(self.lead)

    def _tick(self) -> None:
        if self.pages.currentWidget() is not self.lead:
            return
        self.run.tick(monotonic())
        cue = self.run.cue
        if cue.phase == Phase.DONE:
            self.pages.setCurrentWidget(self.outcome)
            self.outcome.show_waiting()
            self._end_take()  # it may be closed before this returns
            return
        if cue.beat not in (0, self._beat) and self.lead.sound.isChecked():
            QApplication.beep()
        self._beat = cue.beat
        self.lead.show_run(self.run, self._setup.tracked.latest_estimate())

    def _end_take(self) -> None:
        request = self._host.recording.request
        if request is not None and request.path == self._take:
            self._host.recording.end()

    def _running_changed(self, on: bool) -> None:
        if not on:
            self.close()

    # --- the verdict

    def _recorded(self, path: Path) -> None:
        if path != self._take or self.pages.currentWidget() is not self.outcome:
            return
        self._tasks.run(
            self.tr("Judging {}").format(path.name),
            conformance_job(path),
            done=self._judged,
            failed=self.outcome.show_problem,
        )

    def _judged(self, judged: Judged) -> None:
        self._page = judged.page
        rows = [finding_row(f) for f in judged.verdict.findings]
        self.outcome.show_verdict(judged.verdict.ok, rows, judged.verdict.name)

    def open_page(self) -> None:
        """In the browser."""
        if self._page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._page)))

    # --- the window

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Words as large as the window allows: they are read from afar."""
        super().resizeEvent(event)
        px = max(min(self.height() // 17, self.width() // 26), SMALLEST_PX)
        self.setStyleSheet(
            f"QLabel#script_words {{ font-size: {px}px; font-weight: 600; }}"
            f"QLabel#script_beat {{ font-size: {2 * px}px; font-weight: 700; }}"
            f"QLabel#script_notes {{ font-size: {max(round(0.5 * px), 14)}px; }}"
            f"QLabel#script_chips {{ font-size: {max(round(0.45 * px), 13)}px; }}"
        )

    def done(self, result: int) -> None:
        """However it is closed: what was recorded so far is a recording like any other."""
        self._timer.stop()
        self.run.cancel()
        self._end_take()
        self.lead.stage.shut_down()
        super().done(result)
