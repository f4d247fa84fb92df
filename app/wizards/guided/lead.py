"""The page that leads through the poses: the hand that shows them, and large words beside it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.guided import GuidedRun, Phase
from app.viewmodels.guided_words import POSE_WORDS, chips, colour, word
from app.widgets.measures import FAR
from app.wizards.guided.stage import PoseStage
from app.words import tr
from tracker.messages import Estimate


class LeadPage(QWidget):
    """Buttons and words; `GuidedDialog` does what they ask."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage = PoseStage(setup, background)
        self.words = self._label("guided_words")
        self.word = self._label("guided_word")
        self.notes = self._label("guided_notes")
        self.chips = self._label("guided_chips")
        self.chips.setTextFormat(Qt.TextFormat.RichText)
        self.sound = QCheckBox(self.tr("Soun&d"))
        self.sound.setToolTip(self.tr("A beep when a pose has been held"))
        self._make_buttons()
        self._lay_out()

    def _label(self, name: str) -> QLabel:
        label = QLabel()
        label.setObjectName(name)
        label.setWordWrap(True)
        return label

    def _make_buttons(self) -> None:
        self.start = QPushButton(self.tr("&Start"))
        self.insist = QPushButton(self.tr("I &hold it (Enter)"))
        self.insist.setToolTip(self.tr("Where the pose is held and the ring does not believe it"))
        self.skip = QPushButton(self.tr("Skip (S)"))
        self.repeat = QPushButton(self.tr("Repeat (R)"))
        self.stop = QPushButton(self.tr("End (Esc)"))
        for button in (self.start, self.insist):
            button.setProperty("role", "primary")
        for button in (self.insist, self.skip, self.repeat, self.stop, self.start):
            button.setAutoDefault(button in (self.start, self.insist))

    def _lay_out(self) -> None:
        text = QVBoxLayout()
        text.addStretch(1)
        text.addWidget(self.words)
        text.addSpacing(FAR)
        text.addWidget(self.word)
        text.addWidget(self.notes)
        text.addStretch(1)
        upper = QHBoxLayout()
        upper.setSpacing(FAR)
        upper.addWidget(self.stage, 11)
        upper.addLayout(text, 9)
        keys = QHBoxLayout()
        keys.addWidget(self.sound)
        keys.addStretch(1)
        for button in (self.repeat, self.skip, self.stop, self.insist, self.start):
            keys.addWidget(button)
        column = QVBoxLayout(self)
        column.addLayout(upper, 1)
        column.addWidget(self.chips)
        column.addLayout(keys)

    def show_run(self, run: GuidedRun, t: float, estimate: Estimate | None) -> None:
        """As it is at the time ``t`` (s)."""
        waiting = run.phase == Phase.WAITING
        if not waiting and self.stage.pose != run.pose:
            self.stage.show_pose(run.pose)
        self.stage.refresh(estimate, again=run.phase != Phase.HOLDING)
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
        self.chips.setText(" &nbsp; ".join(_chip(sign, name) for sign, name in chips(run)))
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


def _chip(sign: str, name: str) -> str:
    return f"<b>{sign} {name}</b>" if sign == "▶" else f"{sign} {name}"
