"""The dialog that records a minute of scripted gestures and shows the result of each rule."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QPushButton, QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.panels.command_kind import CommandContext
from app.platform.tasks import Job, JobProgress, TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.viewmodels.states import BAD, BLUISH_GREEN, GOOD, SKY
from app.window import theme
from app.wizards.leading.dialog import LeadingDialog
from app.wizards.leading.outcome import OutcomePage
from app.wizards.leading.page import LeadingPage
from app.words import error_text, tr
from extensions.conformance.page import page
from extensions.conformance.run import TakeVerdict, judge, read_take
from extensions.conformance.take import labels_path, write_labels
from extensions.conformance.window.extension import can_run
from extensions.conformance.window.view_model import CuePhase, FindingRow, ScriptRun, finding_row
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.files import free_path, write_whole
from tracker.messages import Estimate

TASK = "conformance"


class VerdictPage(OutcomePage):
    page_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        first = self.tr("Verdict"), self.tr("Part"), self.tr("Rule")
        names = (*first, self.tr("Figure"), self.tr("Limit"))
        self.name_columns(self.tr("Rules"), names, wide=3)
        self.page_button = QPushButton(self.tr("Open the &page"))
        self.page_button.setToolTip(self.tr("Report with a plot for each rule"))
        self.page_button.clicked.connect(self.page_wanted)
        self.lay_out(self.page_button)

    def show_waiting(self) -> None:
        """Show that the recording is being judged."""
        self.tell(self.tr("Checking the recording…"), "")
        self.enable(False)

    def show_problem(self, text: str) -> None:
        self.tell(self.tr("The recording cannot be checked"), text)
        self.enable(True)
        self.page_button.setEnabled(False)

    def show_verdict(self, ok: bool, rows: Sequence[FindingRow], take: str) -> None:
        """Show the rules, failed ones first."""
        passed = sum(row.look == GOOD for row in rows)
        order = {BAD: 0, GOOD: 2}
        ordered = sorted(rows, key=lambda row: order.get(row.look, 1))
        self.tell(
            self.tr("All rules passed") if ok else self.tr("Not all rules passed"),
            self.tr("{} of {} rules, on {}").format(passed, len(rows), take),
            [
                (f"{r.look.sign} {tr(r.look.word)}", r.layer, r.rule, r.figure, r.limit)
                for r in ordered
            ],
            [r.look.colour for r in ordered],
        )
        self.enable(True)


class ScriptPage(LeadingPage):
    """Instructions and buttons of the `ConformanceDialog`."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent)
        wearer = setup.live.wearer if setup.live is not None else None
        self._alone = setup.simulated and wearer is None
        self.beat = self.label("beat")
        self.beat.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self.sound.setToolTip(self.tr("A beep at each beat before a step"))
        self.start.setDefault(True)
        self.lay_out((self.words, self.beat, self.notes), (self.stop, self.start))

    def show_run(self, run: ScriptRun, estimate: Estimate | None) -> None:
        """Show the current state of the run."""
        waiting = run.cue.phase == CuePhase.WAITING
        if not waiting and self.stage.pose != run.drawn():
            self.stage.show_pose(run.drawn())
        self.stage.refresh(estimate, again=run.cue.phase == CuePhase.COUNTING)
        holding = run.cue.phase == CuePhase.HOLDING
        self.stage.ring.show_share(run.cue.share, BLUISH_GREEN if holding else SKY)
        if waiting:
            self._show_waiting(run)
        else:
            self.words.setText(run.words())
            self.notes.setText("")
            self.beat.setText(self.tr("Hold it") if holding else str(run.cue.beat))
        self.show_chips(run.chips())
        self.start.setVisible(waiting)

    def _show_waiting(self, run: ScriptRun) -> None:
        self.words.setText(self.tr("Ten gestures, judged by the rules of robot labs"))
        self.beat.setText("")
        if self._alone:
            self.notes.setText(
                self.tr(
                    "The simulated wearers of this demo do not follow the gestures, so the rules "
                    "on gestures will fail. Use the demo of one hand instead."
                )
            )
            return
        self.notes.setText(
            self.tr(
                "First open and close the hand a few times so that its size is known. Then copy "
                "the hand on the left: move into each gesture during three beats and hold it until "
                "the ring is full. The recording takes {} seconds."
            ).format(round(run.duration))
        )


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


class Judged(NamedTuple):
    """The verdict and its page as HTML."""

    verdict: TakeVerdict
    page: Path


def conformance_job(take: Path) -> Job:
    """A job that returns `Judged`. The steps are notes of the session ``take``."""

    def run(progress: JobProgress) -> Judged:
        progress(0.1, take.name)
        takes, steps = read_take(take)
        progress(0.6, take.name)
        verdict = judge(take.name, takes, steps)
        write_labels(labels_path(take), take.name, steps, min(int(t.sample[0]) for t in takes))
        out = free_path(take.with_suffix(".conformance.html"))
        write_whole(out, page(verdict))
        return Judged(verdict, out)

    return run


def open_dialog(on: CommandContext) -> None:
    """Open the dialog."""
    setup = on.host.setup
    if setup is None or not can_run(on):
        return
    scene = theme.colours(on.store.value.theme).scene
    on.show_dialog(
        "conformance",
        lambda: ConformanceDialog(on.host, setup, on.store, on.tasks, scene, on.window),
    )
