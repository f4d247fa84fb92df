"""Guided calibration: half a minute of poses, reported to the engine and the recording."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QPushButton, QWidget

from app.engines.engine import EngineSetup, LivePart
from app.engines.engine_host import EngineHost
from app.jobs.calibration_commands import learning_part
from app.storage.settings import SettingsStore
from app.viewmodels.guided import GuidedPhase, GuidedRun
from app.viewmodels.guided_words import (
    POSE_WORDS,
    LearnedWords,
    LiveJudge,
    WearerNow,
    chips,
    colour,
    learned,
    word,
)
from app.wizards.leading.dialog import LeadingDialog
from app.wizards.leading.outcome import OutcomePage
from app.wizards.leading.page import LeadingPage
from app.words import tr
from tracker.base.clock import monotonic
from tracker.fusion.chain.known import WearerSnapshot
from tracker.fusion.engine import Engine
from tracker.messages import Estimate

THINKING_MS = 1200  # after the last pose: the engine needs some images to evaluate it
MOST_ANSWERS = 5  # number of queries while the engine is still evaluating


class GuidedResultPage(OutcomePage):
    keep = Signal()
    undo = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        names = (self.tr("Measured"), self.tr("Before"), self.tr("After"), self.tr("Change"))
        self.name_columns(self.tr("Result"), names, wide=0)
        self.store_button = QPushButton(self.tr("&Keep"))
        self.store_button.setDefault(True)
        self.store_button.clicked.connect(self.keep)
        self.undo_button = QPushButton(self.tr("&Undo"))
        self.undo_button.setToolTip(self.tr("Discard the result of these poses"))
        self.undo_button.clicked.connect(self.undo)
        self.lay_out(self.undo_button, self.store_button)

    def show_waiting(self) -> None:
        """Show that the engine has not answered yet."""
        self.tell(self.tr("Evaluating the poses…"), "")
        self.enable(False)

    def show_learned(self, learned: LearnedWords, held: int, asked: int) -> None:
        """Show the engine's result, after ``held`` of ``asked`` poses."""
        nothing = self.tr("Your fingers bend as expected.")
        rows = [
            (row.what, row.before, row.after, f"▲ {row.change}" if row.is_clear else row.change)
            for row in learned.rows
        ]
        heading = self.tr("{} of {} poses held").format(held, asked)
        self.tell(heading, "\n".join(learned.words) or nothing, rows)
        self.enable(True)
        self.store_button.setFocus()

    def show_nothing(self, words: str) -> None:
        """Show that there is no result."""
        self.tell(self.tr("The calibration has not changed"), words)
        self.enable(False)
        self.again_button.setEnabled(True)


class LeadPage(LeadingPage):
    """Buttons and texts; `GuidedDialog` executes the requests."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent)
        self.word = self.label("word")
        self.sound.setToolTip(self.tr("Beep when a pose has been held"))
        self.insist = QPushButton(self.tr("Accept &hold (Enter)"))
        self.insist.setToolTip(self.tr("Accept the pose although the ring has not detected it"))
        self.insist.setProperty("role", "primary")
        self.skip = QPushButton(self.tr("Skip (S)"))
        self.repeat = QPushButton(self.tr("Repeat (R)"))
        for button in (self.skip, self.repeat):
            button.setAutoDefault(False)
        buttons = (self.repeat, self.skip, self.stop, self.insist, self.start)
        self.lay_out((self.words, self.word, self.notes), buttons)

    def show_run(self, run: GuidedRun, t: float, estimate: Estimate | None) -> None:
        """Show the state at time ``t`` (s)."""
        waiting = run.phase == GuidedPhase.WAITING
        if not waiting and self.stage.pose != run.pose:
            self.stage.show_pose(run.pose)
        self.stage.refresh(estimate, again=run.phase != GuidedPhase.HOLDING)
        self.stage.ring.show_share(run.share, colour(run))
        if waiting:
            self.words.setText(self.tr("Hold eight poses, each for two seconds"))
            self.notes.setText(
                self.tr(
                    "The poses measure how your fingers and thumb bend. Copy the hand on "
                    "the left. It "
                    "takes half a minute."
                )
            )
        else:
            self.words.setText(tr(POSE_WORDS[run.pose]))
            self.notes.setText("")
        text = word(run, t)
        self.word.setVisible(bool(text))
        self.word.setText(text)
        style = f"background: {colour(run)}"
        if self.word.styleSheet() != style:
            self.word.setStyleSheet(style)
        self.show_chips(chips(run))
        self._show_buttons(waiting)

    def _show_buttons(self, waiting: bool) -> None:
        if self.start.isVisibleTo(self) == waiting and self.insist.isVisibleTo(self) != waiting:
            return
        self.start.setVisible(waiting)
        for button in (self.insist, self.skip, self.repeat):
            button.setVisible(not waiting)
        main = self.start if waiting else self.insist
        main.setDefault(True)
        main.setFocus()


class GuidedDialog(LeadingDialog):
    """``kept``: the user accepted the result."""

    kept = Signal()

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        live: LivePart,
        store: SettingsStore,
        background: str,
        parent: QWidget | None = None,
    ) -> None:
        lead, outcome = LeadPage(setup, background), GuidedResultPage()
        super().__init__(host, store, (lead, outcome), parent)
        self.lead, self.outcome = lead, outcome
        self._host, self._setup = host, setup
        self._before: WearerNow | None = None
        self._taught = False  # a pose has been held since then
        self._outcomes = self._answers = 0
        judge = LiveJudge(setup.tracked.latest_estimate, setup.hand, monotonic)
        self.run = GuidedRun(live, judge)
        self._commands = GuidedCommands(host, setup.side, self)
        self._thinking = QTimer(self)
        self._thinking.setSingleShot(True)
        self._thinking.setInterval(THINKING_MS)
        self.setWindowTitle(self._title())
        self.setObjectName("guided")
        self._connect()
        self.begin()

    def _title(self) -> str:
        """The title, with the side of the hand if there are two."""
        if not self._setup.others:
            return self.tr("Guided calibration")
        if self._setup.side == "left":
            return self.tr("Guided calibration, left hand")
        return self.tr("Guided calibration, right hand")

    def _connect(self) -> None:
        lead, outcome = self.lead, self.outcome
        self.due.connect(self._go_on)
        self._host.engine_changed.connect(
            self.give_up
        )  # the new engine was not notified of any pose
        lead.start.clicked.connect(self.start)
        lead.insist.clicked.connect(lambda: self.run.insist(monotonic()))
        lead.skip.clicked.connect(lambda: self.run.skip(monotonic()))
        lead.repeat.clicked.connect(lambda: self.run.repeat(monotonic()))
        outcome.keep.connect(self._keep)
        outcome.undo.connect(self._undo)
        outcome.again.connect(self.start)
        self._commands.known.connect(self._known)
        self._thinking.timeout.connect(self._commands.ask)

    # --- the poses

    def start(self) -> None:
        """Start with the first pose; the previous calibration can be restored."""
        self._thinking.stop()
        self.pages.setCurrentWidget(self.lead)
        self._outcomes = self._answers = 0
        self.run.start(monotonic())
        if self._before is None:
            self._commands.ask()

    def _go_on(self) -> None:
        now = monotonic()
        self.run.tick(now)
        if self.run.phase == GuidedPhase.DONE:
            self._finish()
            return
        held = sum(self.run.held.values())
        if held > self._outcomes:
            self.beep()
        self._outcomes = held
        self.lead.show_run(self.run, now, self._setup.tracked.latest_estimate())

    def _finish(self) -> None:
        self.pages.setCurrentWidget(self.outcome)
        self._taught |= any(self.run.held.values())
        if self._taught:
            self.outcome.show_waiting()
            self._thinking.start()
        else:
            self.outcome.show_nothing(self.tr("No pose was held."))

    # --- results

    def _known(self, known: WearerNow) -> None:
        if known.frozen:
            self._refuse()
        elif self._before is None:
            self._before = known
        elif not self.leads and known.learning and self._answers < MOST_ANSWERS:
            self._answers += 1
            self._thinking.start()
        elif not self.leads:
            held = sum(self.run.held.values())
            found = learned(self._setup.hand, self._before, known)
            self.outcome.show_learned(found, held, len(self.run.poses))

    def _refuse(self) -> None:
        """Report that poses would have no effect."""
        self._thinking.stop()
        self.run.cancel()
        self.pages.setCurrentWidget(self.outcome)
        self.outcome.show_nothing(
            self.tr("The calibration is frozen: unfreeze it, then hold the poses.")
        )

    def _keep(self) -> None:
        self._host.show_hand(self._setup.side)  # whose profile receives the result
        self.kept.emit()
        self.close()

    def _undo(self) -> None:
        if self._before is not None:
            self._commands.restore_snapshot(self._before)
        self.close()

    # --- the window

    def reject(self) -> None:
        """Esc: show the results so far before closing."""
        if self.run.is_running and any(self.run.held.values()):
            self.run.cancel()
            self._finish()
        else:
            super().reject()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Single keys, for the free hand."""
        lead = self.lead
        button = {Qt.Key.Key_S: lead.skip, Qt.Key.Key_R: lead.repeat}.get(Qt.Key(event.key()))
        if button is not None and button.isVisible():
            button.click()
        else:
            super().keyPressEvent(event)

    def done(self, result: int) -> None:
        """Stop requesting poses."""
        self._thinking.stop()
        if self.run.is_running:
            self.run.cancel()
        super().done(result)


# ---- commands of the guided poses to the engine: query the wearer's calibration, and restore it


class GuidedCommands(QObject):
    """For the hand of one ``side``. Answers arrive in the window's thread."""

    known = Signal(object)  # WearerNow, after `ask`

    def __init__(self, host: EngineHost, side: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host, self._side = host, side

    def ask(self) -> bool:
        """Request the state of the wearer's calibration, delivered by `known`; False if no engine
        accepts commands.

        An engine without a wearer's calibration reports that in the log.
        """
        return self._host.command(_wearer_now, self._side, self.known.emit)

    def restore_snapshot(self, before: WearerNow) -> bool:
        """Restore the calibration from ``before``."""
        return self._host.command(partial(_restore, known=before.remembered), self._side)


def _wearer_now(engine: Engine) -> WearerNow:
    learner = learning_part(engine)
    wearer = learner.wearer
    gains, abduction = wearer.synergies
    ends = {digit: P.copy() for digit, P in wearer.end_joints.items()}
    frozen, learning = wearer.calibration.is_frozen, wearer.is_learning
    known = wearer.remembered()
    return WearerNow(
        gains.copy(), abduction.copy(), ends, learner.calibration(), known, frozen, learning
    )


def _restore(engine: Engine, known: WearerSnapshot) -> None:
    learning_part(engine).wearer.restore_snapshot(known)
