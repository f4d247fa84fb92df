"""A page that leads: the hand that shows what to do, and large words beside it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.widgets.measures import FAR
from app.wizards.leading.stage import PoseStage

NOW = "▶"  # sign of the step that is under way


def foot_row(first: QWidget, rest: Iterable[QWidget]) -> QHBoxLayout:
    """``first`` on the left of a page's foot, ``rest`` on its right."""
    row = QHBoxLayout()
    row.addWidget(first)
    row.addStretch(1)
    for widget in rest:
        row.addWidget(widget)
    return row


class LeadingPage(QWidget):
    """Buttons and words; the dialog does what they ask."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage = PoseStage(setup, background)
        self.words, self.notes = self.label("words"), self.label("notes")
        self.chips = self.label("chips")
        self.chips.setTextFormat(Qt.TextFormat.RichText)
        self.sound = QCheckBox(self.tr("Soun&d"))
        self.start = QPushButton(self.tr("&Start"))
        self.start.setProperty("role", "primary")
        self.stop = QPushButton(self.tr("End (Esc)"))
        self.stop.setAutoDefault(False)

    def label(self, role: str) -> QLabel:
        """One whose size follows the window's, as `LeadingDialog` says by its role."""
        label = QLabel()
        label.setObjectName(f"leading_{role}")
        label.setWordWrap(True)
        return label

    def lay_out(self, said: Sequence[QWidget], buttons: Sequence[QWidget]) -> None:
        """``said`` stands beside the hand, ``buttons`` below, each in this order."""
        text = QVBoxLayout()
        text.addStretch(1)
        for widget in said:
            text.addWidget(widget)
        text.addStretch(1)
        text.setSpacing(FAR)
        upper = QHBoxLayout()
        upper.setSpacing(FAR)
        upper.addWidget(self.stage, 11)
        upper.addLayout(text, 9)
        column = QVBoxLayout(self)
        column.addLayout(upper, 1)
        column.addWidget(self.chips)
        column.addLayout(foot_row(self.sound, buttons))

    def show_chips(self, chips: Iterable[tuple[str, str]]) -> None:
        """Signs and names of all steps; that which is under way stands out."""
        told = (f"<b>{s} {n}</b>" if s == NOW else f"{s} {n}" for s, n in chips)
        self.chips.setText(" &nbsp; ".join(told))
