"""The dialog that records a minute of scripted gestures and shows the result of each rule."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.wizards.leading.dialog import LeadingDialog
from app.words import error_text
from extensions.conformance.window.guide.lead import ScriptPage
from extensions.conformance.window.guide.result import VerdictPage
from extensions.conformance.window.job import Judged, conformance_job
from extensions.conformance.window.view_model import CuePhase, ScriptRun, finding_row
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError

TASK = "conformance"


class ConformanceDialog(LeadingDialog):
    """Records a session with a note at the beginning of each step."""

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        store: SettingsStore,
        tasks: TaskOwner,
        background: str,
        parent: QWidget | None = None,
    ) -> None:
        lead, outcome = ScriptPage(setup, background), VerdictPage()
        super().__init__(host, store, (lead, outcome), parent)
        self.lead, self.outcome = lead, outcome
        self._host, self._setup, self._store, self._tasks = host, setup, store, tasks
        self._take: Path | None = None
        self._page: Path | None = None
        self._beat = 0
        self._shown = ""  # by a simulated wearer
        self.run = ScriptRun(setup.hand.side, host.notes.add)
        self.setWindowTitle(self.tr("Conformance"))
        self.setObjectName("conformance")
        self.due.connect(self._go_on)
        self.lead.start.clicked.connect(self.start)
        self.outcome.again.connect(self._again)
        self.outcome.page_wanted.connect(self.open_page)
        host.recording.finished.connect(self._recorded)
        self.begin()

    # --- the script

    def start(self) -> None:
        """Start a recording and the first step; reports an error during another recording."""
        if self._host.recording.request is not None:
            self._host.error.emit(self.tr("Stop the current recording first."))
            return
        try:
            request = RecordingPlan(self._store).request_for(TASK)
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            return
        if self._host.recording.begin(request):
            self._take = request.path
            self.run.start(monotonic())
            self.tick()

    def _again(self) -> None:
        self.run = ScriptRun(self._setup.hand.side, self._host.notes.add)
        self.pages.setCurrentWidget(self.lead)

    def _go_on(self) -> None:
        self.run.tick(monotonic())
        self._lead_wearer()
        cue = self.run.cue
        if cue.phase == CuePhase.DONE:
            self.pages.setCurrentWidget(self.outcome)
            self.outcome.show_waiting()
            self._end_take()  # it may be closed before this returns
            return
        if cue.beat not in (0, self._beat):
            self.beep()
        self._beat = cue.beat
        self.lead.show_run(self.run, self._setup.tracked.latest_estimate())

    def _lead_wearer(self) -> None:
        """Let a simulated wearer perform the gesture on screen."""
        gesture, live = self.run.gesture(), self._setup.live
        if gesture != self._shown and live is not None and live.wearer is not None:
            self._shown = gesture
            live.wearer.show_gesture(gesture)

    def _end_take(self) -> None:
        request = self._host.recording.request
        if request is not None and request.path == self._take:
            self._host.recording.end()

    # --- the verdict

    def _recorded(self, path: Path) -> None:
        if path != self._take or self.leads:
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
        """Open the page in the browser."""
        if self._page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._page)))

    # --- the window

    def done(self, result: int) -> None:
        """Close the dialog; what was recorded so far is an ordinary recording."""
        self.run.cancel()
        self._lead_wearer()
        self._end_take()
        super().done(result)
