"""The command palette (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QDialog, QLineEdit, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from app.widgets.measures import NEAR

_ROLE = Qt.ItemDataRole.UserRole


def rank(query: str, text: str) -> int | None:
    """How well ``text`` matches ``query``, smaller is better; None if a letter is missing.

    The letters must occur in order; a run at the start of a word ranks before scattered letters.
    """
    query, text = query.lower().strip(), text.lower()
    if query in text:
        at = text.index(query)
        return at if at == 0 or text[at - 1] == " " else 100 + at
    at = -1
    for letter in query.replace(" ", ""):
        at = text.find(letter, at + 1)
        if at < 0:
            return None
    return 1000 + at


class CommandPalette(QDialog):
    """Finds an action by name and triggers it."""

    def __init__(self, actions: Sequence[QAction], parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self._actions = [a for a in actions if a.isEnabled() and a.isVisible()]
        self.setMinimumWidth(460)
        self._query = QLineEdit()
        self._query.setPlaceholderText(self.tr("Type a command"))
        self._query.textChanged.connect(self._filter)
        self._query.installEventFilter(self)
        self._list = QListWidget()
        self._list.itemActivated.connect(self._run)
        self._list.itemClicked.connect(self._run)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.addWidget(self._query)
        column.addWidget(self._list)
        self._filter("")
        self._query.setFocus()

    def _filter(self, query: str) -> None:
        self._list.clear()
        found = [(rank(query, _name(a)), i) for i, a in enumerate(self._actions)]
        for _, i in sorted((r, i) for r, i in found if r is not None):
            action = self._actions[i]
            key = action.shortcut().toString()
            item = QListWidgetItem(_name(action) + (f"    {key}" if key else ""))
            item.setData(_ROLE, action)
            self._list.addItem(item)
        self._list.setCurrentRow(0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Arrow keys move in the list while text goes to the input field."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1}.get(Qt.Key(event.key()))
            if step is not None:
                row = self._list.currentRow() + step
                self._list.setCurrentRow(max(0, min(row, self._list.count() - 1)))
                return True
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._run(self._list.currentItem())
                return True
        return super().eventFilter(watched, event)

    def _run(self, item: QListWidgetItem | None) -> None:
        if item is None:
            return
        self.accept()
        item.data(_ROLE).trigger()

    def names(self) -> list[str]:
        """The listed commands."""
        return [_name(self._list.item(i).data(_ROLE)) for i in range(self._list.count())]


def _name(action: QAction) -> str:
    return action.text().replace("&", "")
