"""The bar above the docks that says what went wrong; hidden while nothing has."""

from __future__ import annotations

from PySide6.QtWidgets import QToolBar, QWidget

from app.widgets.banner import Action, Banner


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

    def say(self, text: str, *actions: Action, good: bool = False) -> None:
        """Say it in the one place for it, with a button for each thing that can be done.

        ``good``: there is nothing wrong.
        """
        self.banner.show_text(text, *actions, good=good)
        self.show()
