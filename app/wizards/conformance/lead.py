"""The page that leads through the script: a hand that shows the step, large words, the beats."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.conformance import Phase, ScriptRun
from app.viewmodels.states import BLUISH_GREEN, SKY
from app.widgets.measures import FAR
from app.wizards.guided.stage import PoseStage
from tracker.messages import Estimate


class ScriptPage(QWidget):
    """Buttons and words; `ConformanceDialog` does what they ask."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage = PoseStage(setup, background)
        self.words, self.beat, self.notes, self.chips = (
            self._label(n) for n in ("script_words", "script_beat", "script_notes", "script_chips")
        )
        self.chips.setTextFormat(Qt.TextFormat.RichText)
        self.beat.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self.sound = QCheckBox(self.tr("Soun&d"))
        self.sound.setToolTip(self.tr("A beep at each beat before a step"))
        self.start = QPushButton(self.tr("&Start"))
        self.start.setProperty("role", "primary")
        self.start.setDefault(True)
        self.stop = QPushButton(self.tr("End (Esc)"))
        self.stop.setAutoDefault(False)
        self._lay_out()

    def _label(self, name: str) -> QLabel:
        label = QLabel()
        label.setObjectName(name)
        label.setWordWrap(True)
        return label

    def _lay_out(self) -> None:
        text = QVBoxLayout()
        text.addStretch(1)
        text.addWidget(self.words)
        text.addWidget(self.beat)
        text.addWidget(self.notes)
        text.addStretch(1)
        upper = QHBoxLayout()
        upper.setSpacing(FAR)
        upper.addWidget(self.stage, 11)
        upper.addLayout(text, 9)
        keys = QHBoxLayout()
        keys.addWidget(self.sound)
        keys.addStretch(1)
        keys.addWidget(self.stop)
        keys.addWidget(self.start)
        column = QVBoxLayout(self)
        column.addLayout(upper, 1)
        column.addWidget(self.chips)
        column.addLayout(keys)

    def show_run(self, run: ScriptRun, estimate: Estimate | None) -> None:
        """As it is now."""
        waiting = run.cue.phase == Phase.WAITING
        if not waiting and self.stage.pose != run.drawn():
            self.stage.show_pose(run.drawn())
        self.stage.refresh(estimate, again=run.cue.phase == Phase.COUNTING)
        holding = run.cue.phase == Phase.HOLDING
        self.stage.ring.show_share(run.cue.share, BLUISH_GREEN if holding else SKY)
        if waiting:
            self._show_waiting(run)
        else:
            self.words.setText(run.words())
            self.notes.setText("")
            self.beat.setText(self.tr("Hold it") if holding else str(run.cue.beat))
        chips = (f"<b>{s} {n}</b>" if s == "▶" else f"{s} {n}" for s, n in run.chips())
        self.chips.setText(" &nbsp; ".join(chips))
        self.start.setVisible(waiting)

    def _show_waiting(self, run: ScriptRun) -> None:
        self.words.setText(self.tr("Ten gestures, judged by the rules of robot labs"))
        self.beat.setText("")
        self.notes.setText(
            self.tr(
                "Open the hand and close it a few times first, so that its size is known. Then do "
                "what the hand on the left does: three beats to come to each gesture, and hold it "
                "until the ring is full. It takes {} seconds and is recorded."
            ).format(round(run.duration))
        )
