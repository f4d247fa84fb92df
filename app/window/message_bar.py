"""The bar above the docks that says what went wrong; hidden while nothing has."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QToolBar, QWidget

from app.widgets.banner import Banner

Action = tuple[str, Callable[[], object]]
"""The words of a button, and what it does."""


class MessageBar(QToolBar):
    """One sentence at a time, until it is dismissed."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Messages"))
        self.setObjectName("messages")
        self.setMovable(False)
        self.toggleViewAction().setVisible(False)
        self.banner = Banner()
        self.banner.dismissed.connect(self.hide)
        self.addWidget(self.banner)
        self.hide()

    def say(self, text: str, action: Action | None = None) -> None:
        """Say it in the one place for it, with a button where something can be done."""
        self.banner.show_text(text, action)
        self.show()
