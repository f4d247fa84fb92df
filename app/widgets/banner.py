"""The message line above the docks, used instead of message boxes."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from app.widgets.measures import APART, NEAR

MOST_ACTIONS = 3
Action = tuple[str, Callable[[], object]]
"""The text of a button, and its callback."""


class Banner(QFrame):
    """Shows the latest message until it is dismissed."""

    dismissed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self._sign, self._label = QLabel(), QLabel()
        self._label.setWordWrap(True)
        self._label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.buttons = [QPushButton() for _ in range(MOST_ACTIONS)]
        self._work: list[Callable[[], object]] = []
        self._stays = False
        for i, button in enumerate(self.buttons):
            button.clicked.connect(lambda _on=False, i=i: self._act(i))
        close = QPushButton(self.tr("Dismiss"))
        close.clicked.connect(self.dismissed)
        row = QHBoxLayout(self)
        row.setContentsMargins(APART, NEAR, NEAR, NEAR)
        row.addWidget(self._sign)
        row.addWidget(self._label, 1)
        for button in self.buttons:
            row.addWidget(button)
        row.addWidget(close)

    def show_text(
        self, text: str, *actions: Action, good: bool = False, stays: bool = False
    ) -> None:
        """``actions``: texts and callbacks of buttons, which also close the banner unless it
        ``stays``. ``good``: the message is not a problem."""
        self._stays = stays
        self._sign.setText("✓" if good else "▲")
        self.setProperty("good", good)
        self.style().polish(self)
        self._label.setText(text)
        self.setAccessibleName(text)
        self._work = [work for _, work in actions]
        for i, button in enumerate(self.buttons):
            button.setText(actions[i][0] if i < len(actions) else "")
            button.setVisible(i < len(actions))

    def _act(self, i: int) -> None:
        work = self._work[i]
        if not self._stays:
            self.dismissed.emit()
        work()

    def text(self) -> str:
        return self._label.text()
