"""The docks that hold the panels, and the window's size and position."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QByteArray, QCoreApplication, QEvent, QObject, QSize, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow

from app.panels.panel import Panel
from app.widgets.scrolled import Scrolled
from app.window.commands import Commands, MenuCommand
from app.window.layouts import LEFT, Docks, Shares, resize, shares_of

SMALLEST = (800, 500)
FRAME = (16, 48)  # px: the largest frame and title bar of a window manager
SETTLE_MS = 250  # after the last change of the window's size


def make_docks(window: QMainWindow, panels: Mapping[str, Panel]) -> dict[str, QDockWidget]:
    """A dock for each panel, by the panel's name; none is shown yet."""
    docks = {}
    for name, panel in panels.items():
        dock = QDockWidget(panel.windowTitle(), window)
        dock.setObjectName(f"dock_{name}")
        dock.setWidget(Scrolled(panel, dock))  # a later parent would restyle it
        docks[name] = dock
        window.addDockWidget(LEFT, dock)
        dock.hide()
    return docks


def list_docks(
    docks: dict[str, QDockWidget],
    numbers: Mapping[str, int],
    commands: Commands,
    show: Callable[[str], None],
) -> None:
    """Add a command for each dock that brings it to the front; its own button hides it.

    ``numbers`` are those of the panels' kinds; of two equal ones the first has the shortcut.
    """
    menu = QCoreApplication.translate("MainWindow", "&View")
    first = True
    taken = {""}
    for name, dock in docks.items():
        keys = keys_of(numbers[name])
        keys = "" if keys in taken else keys
        taken.add(keys)
        run = partial(show, name)
        commands.add(
            MenuCommand(f"dock_{name}", menu, dock.windowTitle(), run, keys, separator=first)
        )
        first = False


def keys_of(number: int) -> str:
    """The key that shows the panel of this ``number``; empty for none."""
    if not 1 <= number <= 18:
        return ""
    return f"Ctrl+{number}" if number < 10 else f"Ctrl+Alt+{number - 9}"


def geometry_of(window: QMainWindow) -> str:
    """The window's position and size, for the settings file."""
    return bytes(window.saveGeometry().toBase64().data()).decode()


def restore_geometry(window: QMainWindow, text: str) -> None:
    if text:
        window.restoreGeometry(QByteArray.fromBase64(text.encode()))


def fit_to_screen(window: QMainWindow, usual: tuple[int, int]) -> None:
    """Use the ``usual`` size, or the largest one that fits; reduce the minimum if needed."""
    room = window.screen().availableSize() - QSize(*FRAME)
    window.setMinimumSize(QSize(*SMALLEST).boundedTo(room))
    window.resize(QSize(*usual).boundedTo(room))


class DockShares(QObject):
    """Preserves each dock's share of the window when the window is resized.

    A panel that was floating gets its previous share; by default, Qt gives it half of that.
    ``is_shown`` returns whether docks are shown at all, instead of the start page.
    """

    def __init__(self, window: QMainWindow, docks: Docks, is_shown: Callable[[], bool]) -> None:
        super().__init__(window)
        self._window, self._docks, self._is_shown = window, docks, is_shown
        self._shares: Shares = {}  # as long as the window has one size
        self._before_floating: dict[str, Shares] = {}  # by the panel that floats
        self._measuring = False  # in the next turn of the event loop
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self._apply)  # whatever was laid out since
        for watched in (window, *docks.values()):
            watched.installEventFilter(self)
        for name, dock in docks.items():
            dock.topLevelChanged.connect(partial(self._floated, name))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and self._is_shown():
            if watched is self._window:
                QTimer.singleShot(0, self, self._apply)
                self._rest.start(SETTLE_MS)
            elif not self._measuring:  # once for all docks that change together
                self._measuring = True
                QTimer.singleShot(0, self, self._measure)
        return super().eventFilter(watched, event)

    def _measure(self) -> None:
        """A dock was resized on its own, not with the window (Qt reports that later)."""
        self._measuring = False
        if not self._rest.isActive():
            self._shares = shares_of(self._window, self._docks)

    def _apply(self) -> None:
        resize(self._window, self._docks, self._shares)

    def _floated(self, name: str, floating: bool) -> None:
        if floating:
            self._before_floating[name] = dict(self._shares)
            return
        before = self._before_floating.pop(name, {})
        if name in before:
            QTimer.singleShot(0, self, lambda: resize(self._window, self._docks, before))
