"""Guided calibration: half a minute of poses, told to the engine and to the recording."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QApplication, QDialog, QStackedWidget, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.guide import PoseGuide
from app.jobs.guided_poses import GuidedCommands
from app.storage.settings import SettingsStore
from app.viewmodels.guided import GuidedRun, Phase
from app.viewmodels.guided_result import WearerNow, learned
from app.viewmodels.guided_words import LiveJudge
from app.wizards.guided.lead import LeadPage
from app.wizards.guided.result import GuidedResultPage
from app.wizards.sizing import fit_to_screen
from tracker.clock import monotonic

TICK_MS = 33
THINKING_MS = 1200  # after the last pose: the engine learns of it once images have come
SMALLEST_PX = 20
INK = "#101418"  # on a state's colour: contrast 5 or more


class GuidedDialog(QDialog):
    """Not modal. ``kept``: what was learned shall stay."""

    kept = Signal()

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        guide: PoseGuide,
        store: SettingsStore,
        background: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._setup, self._store = host, setup, store
        self._before: WearerNow | None = None
        self._outcomes = 0
        judge = LiveJudge(setup.tracked.latest_estimate, setup.hand, monotonic)
        self.run = GuidedRun(guide, judge)
        self.lead, self.outcome = LeadPage(setup, background), GuidedResultPage()
        self.lead.sound.setChecked(store.value.guided_sound)
        self._commands = GuidedCommands(host, self)
        self._thinking = QTimer(self)
        self._thinking.setSingleShot(True)
        self._thinking.setInterval(THINKING_MS)
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._lay_out()
        self._connect()
        self._timer.start()
        self._tick()

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Guided calibration"))
        self.setObjectName("guided")
        fit_to_screen(self, 1280, 760)
        self.pages = QStackedWidget()
        self.pages.addWidget(self.lead)
        self.pages.addWidget(self.outcome)
        column = QVBoxLayout(self)
        column.addWidget(self.pages)

    def _connect(self) -> None:
        lead, outcome = self.lead, self.outcome
        lead.start.clicked.connect(self.start)
        lead.insist.clicked.connect(lambda: self.run.insist(monotonic()))
        lead.skip.clicked.connect(lambda: self.run.skip(monotonic()))
        lead.repeat.clicked.connect(lambda: self.run.repeat(monotonic()))
        lead.stop.clicked.connect(self.reject)
        lead.sound.toggled.connect(lambda on: self._store.update(guided_sound=on))
        outcome.keep.connect(self._keep)
        outcome.undo.connect(self._undo)
        outcome.again.connect(self.start)
        self._commands.known.connect(self._known)
        self._thinking.timeout.connect(self._commands.ask)
        self._timer.timeout.connect(self._tick)
        self._host.running_changed.connect(self._running_changed)
        self._host.closed.connect(self.close)

    # --- the poses

    def start(self) -> None:
        """From the first pose; what was known before can be had again."""
        self._thinking.stop()
        self.pages.setCurrentWidget(self.lead)
        if self._before is None:
            self._commands.ask()
        self._outcomes = 0
        self.run.start(monotonic())

    def _tick(self) -> None:
        if self.pages.currentWidget() is not self.lead:
            return
        now = monotonic()
        self.run.tick(now)
        if self.run.phase == Phase.DONE:
            self._finish()
            return
        held = sum(self.run.held.values())
        if held > self._outcomes and self.lead.sound.isChecked():
            QApplication.beep()
        self._outcomes = held
        self.lead.show_run(self.run, now, self._setup.tracked.latest_estimate())

    def _finish(self) -> None:
        self.pages.setCurrentWidget(self.outcome)
        if any(self.run.held.values()):
            self.outcome.show_waiting()
            self._thinking.start()
        else:
            self.outcome.show_nothing(self.tr("No pose was held."))

    def _running_changed(self, on: bool) -> None:
        if not on:
            self.close()

    # --- what comes of it

    def _known(self, known: WearerNow) -> None:
        if self._before is None:
            self._before = known
        elif self.pages.currentWidget() is self.outcome:
            held = sum(self.run.held.values())
            found = learned(self._setup.hand, self._before, known)
            self.outcome.show_learned(found, held, len(self.run.poses))

    def _keep(self) -> None:
        self.kept.emit()
        self.close()

    def _undo(self) -> None:
        if self._before is not None:
            self._commands.take_back(self._before)
        self.close()

    # --- the window

    def reject(self) -> None:
        """Esc: what was held so far is shown before the dialog goes."""
        if self.run.is_running and any(self.run.held.values()):
            self.run.cancel()
            self._finish()
        else:
            super().reject()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """One hand is busy with the pose: single keys for the other."""
        lead = self.lead
        button = {Qt.Key.Key_S: lead.skip, Qt.Key.Key_R: lead.repeat}.get(Qt.Key(event.key()))
        if button is not None and button.isVisible():
            button.click()
        else:
            super().keyPressEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Words as large as the window allows: they are read from afar."""
        super().resizeEvent(event)
        px = max(min(self.height() // 17, self.width() // 26), SMALLEST_PX)
        self.setStyleSheet(
            f"QLabel#guided_words {{ font-size: {px}px; font-weight: 600; }}"
            f"QLabel#guided_word {{ font-size: {round(1.15 * px)}px; font-weight: 700;"
            f" color: {INK}; padding: 6px 12px; border-radius: 6px; }}"
            f"QPushButton {{ font-size: {max(round(0.42 * px), 13)}px; }}"
            f"QLabel#guided_notes {{ font-size: {max(round(0.55 * px), 14)}px; }}"
            f"QLabel#guided_chips {{ font-size: {max(round(0.5 * px), 13)}px; }}"
        )

    def done(self, result: int) -> None:
        """However it is closed: no pose is asked for any more."""
        self._timer.stop()
        self._thinking.stop()
        if self.run.is_running:
            self.run.cancel()
        self.lead.stage.shut_down()
        super().done(result)
