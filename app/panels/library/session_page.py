"""The list of recorded sessions, with a search field and commands."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.library.session_table import SessionTable
from app.viewmodels.library import SessionRow
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine

SEARCH = (140, 280)  # px, minimum and maximum
BUTTONS = 3  # width in multiples of the search field


class SessionPage(QWidget):
    """``requested``: the key of one of `buttons` or `actions`.

    ``more``: titles of further actions on recordings, by key.
    """

    requested = Signal(str)
    head: QWidget
    """Buttons and search field; the caller places them next to the tabs, where they need no extra
    line."""

    def __init__(self, more: Mapping[str, str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._further = more
        self.table = SessionTable()
        self.table.cellDoubleClicked.connect(lambda _row, _column: self.requested.emit("replay"))
        self.table.itemSelectionChanged.connect(self.enable)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.table.customContextMenuRequested.connect(self._show_menu)
        self.search = QLineEdit()
        self.search.setMinimumWidth(SEARCH[0])
        self.search.setMaximumWidth(SEARCH[1])
        self.search.setPlaceholderText(self.tr("Search by name, tag, date or quality"))
        self.search.setClearButtonEnabled(True)
        self.search.setAccessibleName(self.tr("Search"))
        self.search.textChanged.connect(self.table.show_only)
        self.head = QWidget()
        line = QHBoxLayout(self.head)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(NEAR)
        line.addWidget(self._buttons(), BUTTONS)
        line.addWidget(self.search, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, TIGHT, 0, 0)
        column.addWidget(self.table)
        self.enable()

    def _buttons(self) -> OneLine:
        line = OneLine()
        self.buttons: dict[str, QPushButton] = {}
        for key, text in (
            ("replay", self.tr("Replay")),
            ("track", self.tr("Track again…")),
            ("compare", self.tr("Compare")),
            ("export", self.tr("Export…")),
            ("recover", self.tr("Recover")),
        ):
            self.buttons[key] = QPushButton(text)
            self.buttons[key].clicked.connect(partial(self._ask, key))
            line.add(self.buttons[key])
        self.buttons["compare"].setToolTip(self.tr("Select two sessions of the same movement"))
        line.add(self._more())
        return line

    def _more(self) -> QToolButton:
        self.menu = QMenu(self)
        self.actions_of: dict[str, QAction] = {}
        for key, text, shortcut in (
            ("beside", self.tr("Two recordings side by side"), ""),
            *((key, title, "") for key, title in self._further.items()),
            ("rename", self.tr("Rename…"), "F2"),
            ("tags", self.tr("Tags…"), "Ctrl+T"),
            ("folder", self.tr("Open folder"), ""),
            ("bin", self.tr("Move to trash"), "Del"),
        ):
            action = self.actions_of[key] = self.menu.addAction(text)
            action.setShortcut(QKeySequence(shortcut))
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            action.triggered.connect(partial(self._ask, key))
            self.table.addAction(action)  # its shortcut works while the table has the focus
        more = QToolButton()
        more.setText(self.tr("More"))
        more.setMenu(self.menu)
        more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return more

    def _ask(self, key: str, _checked: bool = False) -> None:
        self.requested.emit(key)

    def _show_menu(self, position: QPoint) -> None:
        self.menu.popup(self.table.viewport().mapToGlobal(position))

    def enable(self) -> None:
        rows = self.table.selected()
        one = len(rows) == 1
        for key, on in (
            ("replay", one),
            ("track", one),
            ("compare", len(rows) == 2),
            ("export", bool(rows)),
            ("recover", one and rows[0].recoverable),
        ):
            self.buttons[key].setEnabled(on)
        self.buttons["recover"].setVisible(one and rows[0].recoverable)
        for key, on in (
            ("beside", len(rows) == 2),
            *((key, bool(rows)) for key in self._further),
            ("rename", one),
            ("tags", bool(rows)),
            ("bin", bool(rows)),
        ):
            self.actions_of[key].setEnabled(on)

    def selected(self) -> SessionRow | None:
        """The first of the selected sessions."""
        return next(iter(self.table.selected()), None)
