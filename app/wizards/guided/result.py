"""What the guided poses have taught: in words, and in figures before and after."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from app.viewmodels.guided_result import LearnedWords
from app.wizards.leading.outcome import OutcomePage


class GuidedResultPage(OutcomePage):
    keep = Signal()
    undo = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        names = (self.tr("Measured"), self.tr("Before"), self.tr("After"), self.tr("Change"))
        self.name_columns(self.tr("What was learned"), names, wide=0)
        self.keep_button = QPushButton(self.tr("&Keep"))
        self.keep_button.setDefault(True)
        self.keep_button.clicked.connect(self.keep)
        self.undo_button = QPushButton(self.tr("&Undo"))
        self.undo_button.setToolTip(self.tr("Forget what these poses have taught"))
        self.undo_button.clicked.connect(self.undo)
        self.lay_out(self.undo_button, self.keep_button)

    def show_waiting(self) -> None:
        """Before the engine has answered."""
        self.tell(self.tr("Evaluating the poses…"), "")
        self.enable(False)

    def show_learned(self, learned: LearnedWords, held: int, asked: int) -> None:
        """The engine's answer, after ``held`` of ``asked`` poses."""
        nothing = self.tr("Your fingers bend as expected.")
        rows = [
            (row.what, row.before, row.after, f"▲ {row.change}" if row.is_clear else row.change)
            for row in learned.rows
        ]
        heading = self.tr("{} of {} poses held").format(held, asked)
        self.tell(heading, "\n".join(learned.words) or nothing, rows)
        self.enable(True)
        self.keep_button.setFocus()

    def show_nothing(self, words: str) -> None:
        """There is nothing to be kept."""
        self.tell(self.tr("Nothing was learned"), words)
        self.enable(False)
        self.again_button.setEnabled(True)
