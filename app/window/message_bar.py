"""The bar over the docks that says what went wrong; hidden while nothing has. It shifts nothing."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import QMainWindow, QTabBar, QVBoxLayout, QWidget

from app.widgets.banner import Action, Banner
from app.widgets.measures import NEAR
from app.words import told


class MessageBar(QWidget):
    """One sentence at a time, until it is dismissed or no longer true. It lies over the
    lowest panels, above their tabs and the status bar, so that nothing moves under the pointer."""

    said = Signal(str, bool)  # a sentence, and whether there is nothing wrong

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.setObjectName("messages")
        self._window, self._about = window, ""
        self.banner = Banner()
        self.banner.dismissed.connect(self.hide)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.addWidget(self.banner)
        window.installEventFilter(self)
        self.hide()

    def say(self, text: str, *actions: Action, good: bool = False, about: str = "") -> None:
        """Say it in the one place for it, with a button for each thing that can be done.

        ``good``: there is nothing wrong. ``about`` names what it is about, for `no_longer`.
        """
        text = told(text)
        again = self.isVisible() and text == self.banner.text()
        self._about = about
        self.banner.show_text(text, *actions, good=good)
        self.show()
        self._place()
        self.raise_()
        if not again:
            self.said.emit(text, good)

    def no_longer(self, about: str) -> None:
        """What was said about this is not true any more."""
        if self._about == about:
            self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest):
            self._place()
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        """As wide as the window, as high as the sentence needs."""
        window = self._window
        tabs = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
        foot = window.statusBar().height() + max(
            (t.height() for t in tabs if t.isVisible()), default=0
        )
        height = self.heightForWidth(window.width())
        self.setGeometry(0, window.height() - foot - height, window.width(), height)
