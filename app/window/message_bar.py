"""The bar over the docks that says what went wrong; hidden while nothing has. It shifts nothing."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication, QMainWindow, QTabBar, QVBoxLayout, QWidget

from app.widgets.banner import Action, Banner
from app.widgets.measures import NEAR

MOVES = (
    QEvent.Type.Resize,
    QEvent.Type.LayoutRequest,
    QEvent.Type.Move,
    QEvent.Type.Show,
    QEvent.Type.Hide,
)
READ_MS = 8_000
"""After which good news disappears; see `MessageBar.say`."""
CHOOSE_MS = 20_000
"""The same where it has buttons."""


class MessageBar(QWidget):
    """One sentence at a time, until it is dismissed or no longer true. It lies over the
    lowest panels, above their tabs and the status bar, so that nothing moves under the pointer,
    and never over what `keep_clear` names."""

    dismissed = Signal(str)  # by the user: what it was about
    said = Signal(str, bool)  # a sentence, and whether there is nothing wrong

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.setObjectName("messages")
        self._window, self._about = window, ""
        self._clear: list[tuple[QWidget, QWidget]] = []
        self.banner = Banner()
        self.banner.dismissed.connect(self._dismiss)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._leave)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.addWidget(self.banner)
        window.installEventFilter(self)
        self.hide()

    def say(
        self,
        text: str,
        *actions: Action,
        good: bool = False,
        about: str = "",
        stays: bool = False,
    ) -> None:
        """Say it in the one place for it, with a button for each thing that can be done.

        ``good``: there is nothing wrong. ``about`` names what it is about, for `no_longer`. What
        ``stays`` is not taken away by its own buttons. Good news that is about nothing that could
        end disappears after some seconds, unless the pointer or the keyboard is on it.
        """
        again = self.isVisible() and text == self.banner.text()
        self._about = about
        self.banner.show_text(text, *actions, good=good, stays=stays)
        self.show()
        self._place()
        self.raise_()
        self._timer.stop()
        if good and not about:
            self._timer.start(CHOOSE_MS if actions else READ_MS)
        if not again:
            self.said.emit(text, good)

    def _dismiss(self) -> None:
        about = self._about
        self.hide()
        self.dismissed.emit(about)

    def _leave(self) -> None:
        """Time is up; it begins again while the user is at it."""
        focus = QApplication.focusWidget()
        if not self.underMouse() and (focus is None or not self.isAncestorOf(focus)):
            self._timer.stop()
            self.hide()

    def is_about(self, about: str) -> bool:
        """Whether that is what stands here."""
        return self.isVisible() and self._about == about

    def no_longer(self, about: str) -> None:
        """What was said about this is not true any more."""
        if self._about == about:
            self.hide()

    def keep_clear(self, part: QWidget, within: QWidget) -> None:
        """``part``, which moves with ``within``, is used while a sentence stands here."""
        self._clear.append((part, within))
        for watched in (part, within):
            watched.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in MOVES and self.isVisible():
            self._place()
            self.raise_()  # docks that are laid out anew come over it
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        """As wide as the window, as high as the sentence needs."""
        window = self._window
        tabs = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
        foot = window.statusBar().height() + max(
            (t.height() for t in tabs if t.isVisible()), default=0
        )
        height = self.heightForWidth(window.width())
        place = QRect(0, window.height() - foot - height, window.width(), height)
        for part, within in self._clear:
            used = self._rect(part) & self._rect(within)
            if part.isVisible() and used.intersects(place):
                place.moveBottom(used.top() - 1)
        self.setGeometry(place)

    def _rect(self, widget: QWidget) -> QRect:
        """In the window; a panel that floats is a window of its own."""
        if widget.window() is not self._window:
            return QRect()
        return QRect(widget.mapTo(self._window, QPoint(0, 0)), widget.size())
