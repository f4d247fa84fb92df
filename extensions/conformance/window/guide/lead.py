"""The page that guides through the script, with instructions and beats before each step."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.states import BLUISH_GREEN, SKY
from app.wizards.leading.page import LeadingPage
from extensions.conformance.window.view_model import CuePhase, ScriptRun
from tracker.messages import Estimate


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
