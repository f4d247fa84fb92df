"""Every command of the window, once: menus, tool bar, shortcuts and the palette read this."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu


@dataclass(frozen=True)
class Command:
    """``menu`` is its translated title; ``key`` stable for tests."""

    key: str
    menu: str
    text: str
    run: Callable[[], object]
    shortcut: str = ""
    checkable: bool = False
    separator: bool = False  # before it
    ticked: Callable[[], bool] | None = None  # whether it is what is chosen, asked as menus open


class Commands:
    """Makes and keeps the actions."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window
        self._menus: dict[str, QMenu] = {}
        self.actions: dict[str, QAction] = {}

    def menu(self, title: str) -> QMenu:
        if title not in self._menus:
            self._menus[title] = self._window.menuBar().addMenu(title)
        return self._menus[title]

    def menus(self) -> list[QMenu]:
        """All, in their order."""
        return list(self._menus.values())

    def add(self, command: Command) -> QAction:
        action = QAction(command.text, self._window)
        action.setCheckable(command.checkable or command.ticked is not None)
        if command.shortcut:
            action.setShortcut(QKeySequence(command.shortcut))
            action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        action.triggered.connect(lambda _checked=False: command.run())
        menu = self.menu(command.menu)
        if command.separator:
            menu.addSeparator()
        menu.addAction(action)
        if command.ticked is not None:
            ticked = command.ticked
            menu.aboutToShow.connect(lambda: action.setChecked(ticked()))
        self.actions[command.key] = action
        return action

    def set_shortcut(self, key: str, shortcut: str) -> None:
        """Another key for a command; empty for none."""
        self.actions[key].setShortcut(QKeySequence(shortcut))

    def user_of(self, shortcut: str, but: str) -> str:
        """The text of the command that has this key, other than the command ``but``; or empty."""
        wanted = QKeySequence(shortcut)
        users = (a.text() for k, a in self.actions.items() if k != but and a.shortcut() == wanted)
        return next(users, "").replace("&", "")

    def enable(self, key: str, on: bool) -> None:
        self.actions[key].setEnabled(on)
