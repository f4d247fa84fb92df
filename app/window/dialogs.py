"""Dialogs that commands open: the command palette, the guide, the list of keys, About."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QEvent, QObject, Qt, QUrl
from PySide6.QtGui import (
    QAction,
    QDesktopServices,
    QFontDatabase,
    QIcon,
    QKeyEvent,
    QKeySequence,
    QTextCursor,
)
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QMainWindow,
    QMenu,
    QPlainTextEdit,
    QTableWidget,
    QTableWidgetItem,
    QTabWidget,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from app.platform.guide import FIRST, guide_folder, matches, pages, site, title_of
from app.platform.licences import as_text, own_text
from app.widgets.measures import APART, NEAR, WIDE
from app.window.commands import Commands
from tracker import __version__

BELOW_TOP = 90  # px
SIZE = (900, 620)
ICON = 64  # px


class Dialogs:
    """Opens the dialogs of one window and its ``commands``."""

    def __init__(self, window: QMainWindow, commands: Commands) -> None:
        self._window, self._commands = window, commands

    def palette(self) -> None:
        """Search for a command by words of its title."""
        window = self._window
        palette = CommandPalette(list(self._commands.actions.values()), window)
        palette.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        corner = window.geometry().center() - palette.rect().center()
        palette.move(corner.x(), window.geometry().top() + BELOW_TOP)
        palette.open()

    def guide(self) -> None:
        GuideDialog(self._window).show()

    def documentation(self) -> None:
        """Open the documentation in the browser; it needs no network."""
        page = site()
        if page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(page)))

    def keys(self) -> None:
        KeysDialog(self._commands.menus(), self._window).show()

    def about(self) -> None:
        AboutDialog(self._window).show()

    def full_screen(self) -> None:
        """Enter or leave full-screen mode."""
        state = self._window.windowState()
        self._window.setWindowState(state ^ Qt.WindowState.WindowFullScreen)


class GuideDialog(QDialog):
    """Pages on the left, their text on the right; the search lists pages that contain all terms."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Guide"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(*SIZE)
        self._pages = pages()
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search the guide"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._find)
        self.list = QListWidget()
        self.list.setMaximumWidth(240)
        self.list.currentItemChanged.connect(lambda item, _old: self._show_item(item))
        self.view = QTextBrowser()
        self.view.setOpenLinks(False)
        self.view.setSearchPaths([str(guide_folder())])
        self.view.anchorClicked.connect(self._follow)
        left = QVBoxLayout()
        left.addWidget(self.search)
        left.addWidget(self.list, 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(APART, APART, APART, APART)
        row.setSpacing(NEAR)
        row.addLayout(left)
        row.addWidget(self.view, 1)
        self._find("")

    def _find(self, terms: str) -> None:
        self.list.clear()
        for name in matches(self._pages, terms):
            item = QListWidgetItem(title_of(self._pages[name]))
            item.setData(Qt.ItemDataRole.UserRole, name)
            self.list.addItem(item)
        self.list.setCurrentRow(0)

    def _show_item(self, item: QListWidgetItem | None) -> None:
        if item is None:
            self.view.clear()
            return
        self.view.setMarkdown(self._pages[item.data(Qt.ItemDataRole.UserRole)])
        terms = self.search.text().split()
        if terms and self.view.find(terms[0]):
            self.view.ensureCursorVisible()
        else:
            self.view.moveCursor(QTextCursor.MoveOperation.Start)

    def show_page(self, name: str) -> None:
        """A page by its file's name."""
        self.search.clear()
        names = list(self._pages)
        self.list.setCurrentRow(names.index(name) if name in names else names.index(FIRST))

    def _follow(self, url: QUrl) -> None:
        """Pages open here, addresses in the browser."""
        if url.isRelative() and url.path() in self._pages:
            self.show_page(url.path())
        elif not url.isRelative():
            QDesktopServices.openUrl(url)


class KeysDialog(QDialog):
    """Every command that has a key, as the menus have it now."""

    def __init__(self, menus: Iterable[QMenu], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(560, 620)
        rows = [(m.title(), a) for m in menus for a in m.actions() if not a.shortcut().isEmpty()]
        self.table = QTableWidget(len(rows), 3)
        self.table.setHorizontalHeaderLabels([self.tr("Key"), self.tr("Command"), self.tr("Menu")])
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.verticalHeader().hide()
        for i, (menu, action) in enumerate(rows):
            for k, text in enumerate((key_of(action), plain(action.text()), plain(menu))):
                self.table.setItem(i, k, QTableWidgetItem(text))
        self.table.resizeColumnsToContents()
        self.table.horizontalHeader().setStretchLastSection(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(APART, APART, APART, APART)
        column.addWidget(self.table)


def key_of(action: QAction) -> str:
    """The shortcut as this system writes it."""
    return action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)


def plain(text: str) -> str:
    """The text without the mark of its Alt key."""
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&")


class AboutDialog(QDialog):
    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("About Glovetrack"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(720, 520)
        self.tabs = QTabWidget()
        self.tabs.addTab(_text(as_text()), self.tr("Components and licences"))
        self.tabs.addTab(_text(own_text()), self.tr("Apache-2.0"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addLayout(self._heading())
        column.addWidget(self.tabs, 1)
        column.addWidget(buttons)

    def _heading(self) -> QHBoxLayout:
        icon = QLabel()
        app = QApplication.instance()
        window_icon = app.windowIcon() if isinstance(app, QApplication) else QIcon()
        icon.setPixmap(window_icon.pixmap(ICON, ICON))
        title = QLabel(self.tr("Glovetrack {}").format(__version__))
        title.setProperty("role", "heading")
        about = QLabel(
            self.tr(
                "Hand tracking with a sensor glove and a stereo camera. Free software under the "
                "Apache License 2.0, without any warranty."
            )
        )
        about.setWordWrap(True)
        texts = QVBoxLayout()
        texts.addWidget(title)
        texts.addWidget(about)
        row = QHBoxLayout()
        row.setSpacing(WIDE)
        row.addWidget(icon)
        row.addLayout(texts, 1)
        return row


def _text(text: str) -> QPlainTextEdit:
    view = QPlainTextEdit(text)
    view.setReadOnly(True)
    view.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
    view.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
    return view


# ---- the command palette (Ctrl+K)

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
