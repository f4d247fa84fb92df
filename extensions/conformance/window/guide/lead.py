"""The page that leads through the script: words, and the beats before each step."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.states import BLUISH_GREEN, SKY
from app.wizards.leading.page import LeadingPage
from extensions.conformance.window.view_model import CuePhase, ScriptRun
from tracker.messages import Estimate


class ScriptPage(LeadingPage):
    """Buttons and words; `ConformanceDialog` does what they ask."""

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
        """As it is now."""
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
                    "The simulated wearers of this demo do not follow these gestures, so rules on "
                    "gestures will not be met. The demo of one hand follows them."
                )
            )
            return
        self.notes.setText(
            self.tr(
                "Open the hand and close it a few times first, so that its size is known. Then do "
                "what the hand on the left does: three beats to come to each gesture, and hold it "
                "until the ring is full. It takes {} seconds and is recorded."
            ).format(round(run.duration))
        )
