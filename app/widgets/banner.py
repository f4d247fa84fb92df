"""The one place where an error stands: a line above the docks, never a stack of dialogs."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget


class Banner(QFrame):
    """Shows the latest sentence until it is dismissed."""

    dismissed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self._label = QLabel()
        self._label.setWordWrap(True)
        self._label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.action = QPushButton()
        self.action.clicked.connect(self._act)
        self._do: Callable[[], object] | None = None
        close = QPushButton(self.tr("Dismiss"))
        close.clicked.connect(self.dismissed)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 6, 6)
        row.addWidget(QLabel("▲"))
        row.addWidget(self._label, 1)
        row.addWidget(self.action)
        row.addWidget(close)

    def show_text(self, text: str, action: tuple[str, Callable[[], object]] | None = None) -> None:
        """``action``: the words of a button and what it does; it takes the banner away too."""
        self._label.setText(text)
        self.setAccessibleName(text)
        self._do = action[1] if action is not None else None
        self.action.setText(action[0] if action is not None else "")
        self.action.setVisible(action is not None)

    def _act(self) -> None:
        self.dismissed.emit()
        if self._do is not None:
            self._do()

    def text(self) -> str:
        return self._label.text()
