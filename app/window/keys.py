"""Keys without a modifier are the window's only where the widget in focus has no use for them."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QTextEdit,
    QWidget,
)

from app.widgets.number_box import NumberBox

TYPED = (QLineEdit, QPlainTextEdit, QTextEdit, QAbstractSpinBox, QAbstractItemView, QComboBox)
"""Widgets that take any key: text, or the first letters of an item."""
TICKED = (QAbstractButton,)
"""Widgets that take the space bar."""
SPACE = "Space"


class FocusKeys(QObject):
    """Turns the shortcuts of ``actions`` off and on as the focus moves; menus show them all along.

    Those with Ctrl or Alt, and function keys, are left alone, but Undo and Redo, which are a
    text's own while it is typed.
    """

    def __init__(self, actions: Iterable[QAction], parent: QObject) -> None:
        super().__init__(parent)
        self._actions = list(actions)  # a key may be another one later
        self._of_text = [
            a for a in self._actions if a.shortcut().toString() in ("Ctrl+Z", "Ctrl+Y")
        ]
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        app.focusChanged.connect(self._moved)

    def _moved(self, _old: QWidget | None, new: QWidget | None) -> None:
        typed, ticked = isinstance(new, TYPED), isinstance(new, TICKED)
        for action in filter(is_single, self._actions):
            _give(action, not typed and not (ticked and action.shortcut().toString() == SPACE))
        for action in self._of_text:
            _give(action, not is_text(new))


def is_single(action: QAction) -> bool:
    """Whether its shortcut is one key that prints something."""
    keys = action.shortcut().toString()
    return len(keys) == 1 or keys == SPACE


def is_text(widget: QWidget | None) -> bool:
    """Whether text is typed into it; a `NumberBox` says itself whose the keys are."""
    if isinstance(widget, NumberBox):
        return False
    return isinstance(widget, QLineEdit | QPlainTextEdit | QTextEdit | QAbstractSpinBox)


def _give(action: QAction, on: bool) -> None:
    """To the window, or (off) to the menu it stands in, which never has the focus."""
    context = Qt.ShortcutContext.WindowShortcut if on else Qt.ShortcutContext.WidgetShortcut
    if action.shortcutContext() != context:
        action.setShortcutContext(context)
