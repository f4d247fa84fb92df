"""The page that leads through the poses."""

from __future__ import annotations

from PySide6.QtWidgets import QPushButton, QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.guided import GuidedPhase, GuidedRun
from app.viewmodels.guided_words import POSE_WORDS, chips, colour, word
from app.wizards.leading.page import LeadingPage
from app.words import tr
from tracker.messages import Estimate


class LeadPage(LeadingPage):
    """Buttons and words; `GuidedDialog` does what they ask."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent)
        self.word = self.label("word")
        self.sound.setToolTip(self.tr("A beep when a pose has been held"))
        self.insist = QPushButton(self.tr("I &hold it (Enter)"))
        self.insist.setToolTip(self.tr("Where the pose is held and the ring does not believe it"))
        self.insist.setProperty("role", "primary")
        self.skip = QPushButton(self.tr("Skip (S)"))
        self.repeat = QPushButton(self.tr("Repeat (R)"))
        for button in (self.skip, self.repeat):
            button.setAutoDefault(False)
        buttons = (self.repeat, self.skip, self.stop, self.insist, self.start)
        self.lay_out((self.words, self.word, self.notes), buttons)

    def show_run(self, run: GuidedRun, t: float, estimate: Estimate | None) -> None:
        """As it is at the time ``t`` (s)."""
        waiting = run.phase == GuidedPhase.WAITING
        if not waiting and self.stage.pose != run.pose:
            self.stage.show_pose(run.pose)
        self.stage.refresh(estimate, again=run.phase != GuidedPhase.HOLDING)
        self.stage.ring.show_share(run.share, colour(run))
        if waiting:
            self.words.setText(self.tr("Hold eight poses, each for two seconds"))
            self.notes.setText(
                self.tr(
                    "They show the tracking how your fingers and your thumb bend. It takes half a "
                    "minute. Do with the glove what the hand on the left does."
                )
            )
        else:
            self.words.setText(tr(POSE_WORDS[run.pose]))
            self.notes.setText("")
        text = word(run, t)
        self.word.setVisible(bool(text))
        self.word.setText(text)
        self.word.setStyleSheet(f"background: {colour(run)}")
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
