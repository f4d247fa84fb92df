"""What stands in the window before an engine is open."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QPushButton, QVBoxLayout, QWidget


class StartPage(QWidget):
    """Three ways in, each with a sentence that says what happens."""

    demo = Signal()
    connect_devices = Signal()
    open_session = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        column = QVBoxLayout(self)
        column.setContentsMargins(24, 24, 24, 24)
        column.addStretch(2)
        column.addWidget(self._heading(), 0, Qt.AlignmentFlag.AlignHCenter)
        column.addSpacing(16)
        column.addLayout(self._cards())
        column.addStretch(3)

    def _heading(self) -> QLabel:
        label = QLabel(self.tr("Glovetrack"))
        label.setProperty("role", "heading")
        return label

    def _cards(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(16)
        cards = (
            (
                self.tr("Demo"),
                self.tr("A simulated glove and camera: see everything move, no hardware needed."),
                self.demo,
            ),
            (
                self.tr("Glove and camera"),
                self.tr("Find your devices and go through the set-up, step by step."),
                self.connect_devices,
            ),
            (
                self.tr("Recorded session"),
                self.tr("Replay a session file, look at it frame by frame, export it."),
                self.open_session,
            ),
        )
        grid.setColumnStretch(0, 1)
        for i, (title, text, signal) in enumerate(cards):
            grid.addWidget(_card(title, text, signal), 0, i + 1)
        grid.setColumnStretch(len(cards) + 1, 1)
        return grid


def _card(title: str, text: str, signal: SignalInstance) -> QFrame:
    card = QFrame()
    card.setObjectName("card")
    card.setFixedWidth(250)
    column = QVBoxLayout(card)
    column.setContentsMargins(16, 16, 16, 16)
    column.setSpacing(12)
    about = QLabel(text)
    about.setWordWrap(True)
    about.setAlignment(Qt.AlignmentFlag.AlignTop)
    about.setMinimumHeight(64)
    button = QPushButton(title)
    button.setProperty("role", "primary")
    button.clicked.connect(signal)
    column.addWidget(about, 1)
    column.addWidget(button)
    return card
