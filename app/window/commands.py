"""All commands of the window: menus, tool bar, shortcuts and the command palette use this list."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QMainWindow,
    QMenu,
    QPlainTextEdit,
    QSizePolicy,
    QTextEdit,
    QToolBar,
    QToolButton,
    QWidget,
)

from app.widgets.icons import dress, text_by_icon
from app.widgets.number_box import NumberBox
from app.widgets.segments import Segments

TYPED = (QLineEdit, QPlainTextEdit, QTextEdit, QAbstractSpinBox, QAbstractItemView, QComboBox)
"""Widgets that take any key: text, or the first letters of an item."""
TICKED = (QAbstractButton,)
"""Widgets that take the space bar."""
SPACE = "Space"
ICONS = {
    "demo": "flask-conical",
    "hardware": "cable",
    "open": "folder-open",
    "start": "play",
    "stop": "square",
    "record": "circle-dot",
    "note": "pencil-line",
    "palette": "search",
}
SOURCES = ("demo", "hardware", "open")
RECORD = 2  # of the work's buttons
ICON = QSize(18, 18)


@dataclass(frozen=True)
class MenuCommand:
    """``menu`` is its translated title; ``key`` stable for tests."""

    key: str
    menu: str
    text: str
    run: Callable[[], object]
    shortcut: str = ""
    checkable: bool = False
    separator: bool = False  # before it


@dataclass(frozen=True, kw_only=True)
class MenuChoice(MenuCommand):
    """A command whose item is ticked while ``ticked`` returns True as the menu opens."""

    ticked: Callable[[], bool]
    checkable: bool = True


class Commands:
    """Creates and stores the actions."""

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

    def add(self, command: MenuCommand) -> QAction:
        action = QAction(command.text, self._window)
        action.setCheckable(command.checkable)
        if command.shortcut:
            action.setShortcut(QKeySequence(command.shortcut))
            action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        action.triggered.connect(lambda _checked=False: command.run())
        menu = self.menu(command.menu)
        if command.separator:
            menu.addSeparator()
        menu.addAction(action)
        if isinstance(command, MenuChoice):
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


class FocusKeys(QObject):
    """Turns the shortcuts of ``actions`` off and on as the focus moves; menus always show them.

    Those with Ctrl or Alt, and function keys, are not changed, except Undo and Redo, which
    belong to a text field while it has the focus.
    """

    def __init__(self, actions: Iterable[QAction], parent: QObject) -> None:
        super().__init__(parent)
        self._actions = list(actions)  # their keys may be changed later
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
    """Whether text is typed into it; a `NumberBox` handles its keys itself."""
    if isinstance(widget, NumberBox):
        return False
    return isinstance(widget, QLineEdit | QPlainTextEdit | QTextEdit | QAbstractSpinBox)


def _give(action: QAction, on: bool) -> None:
    """Give the shortcut to the window, or (off) to its menu, which never has the focus."""
    context = Qt.ShortcutContext.WindowShortcut if on else Qt.ShortcutContext.WidgetShortcut
    if action.shortcutContext() != context:
        action.setShortcutContext(context)


class ToolBar(QToolBar):
    """Shows icons without text, from the left, where there is not enough room.

    ``jobs``: the actions that choose a layout, by the names of their icons.
    """

    def __init__(
        self, actions: Mapping[str, QAction], jobs: Mapping[str, QAction], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Commands"))
        self.setObjectName("commands")
        self.setMovable(False)
        self.setIconSize(ICON)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        for key, name in ICONS.items():
            dress(actions[key], name)
        self._short(actions)
        self._sources = [self._button(actions[key]) for key in SOURCES]
        self.addSeparator()
        self._work = [self._button(actions[key]) for key in ("start", "stop", "record", "note")]
        self._work[RECORD].setObjectName("record_button")
        self._fill()
        for icon, action in jobs.items():
            dress(action, icon)
            action.setIconVisibleInMenu(False)  # there a check mark shows the current one
            action.setIconText(text_by_icon(action.text()))
        self.segments = Segments(list(jobs.values()))
        self.addWidget(self.segments)
        self._fill()
        self._search = self._button(actions["palette"])

    def _short(self, actions: Mapping[str, QAction]) -> None:
        """Shorter texts than in the menu."""
        texts = {
            "demo": self.tr("Demo"),
            "hardware": self.tr("Devices"),
            "open": self.tr("Open"),
            "start": self.tr("Start"),
            "stop": self.tr("Stop"),
            "note": self.tr("Note"),
            "palette": self.tr("Find"),
        }
        for key, text in texts.items():
            actions[key].setIconText(text_by_icon(text))
            actions[key].setToolTip(tip_of(actions[key]))

    def _button(self, action: QAction) -> QToolButton:
        self.addAction(action)
        button = self.widgetForAction(action)
        assert isinstance(button, QToolButton)
        return button

    def _fill(self) -> None:
        room = QWidget()
        room.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.addWidget(room)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.fit(event.size().width())

    def fit(self, width: int) -> None:
        """Show texts where ``width`` px have room for them."""
        with_text, icons = (
            Qt.ToolButtonStyle.ToolButtonTextBesideIcon,
            Qt.ToolButtonStyle.ToolButtonIconOnly,
        )
        groups = [[self._search], self._sources, self._work, self.segments.buttons]
        for group in groups:
            for button in group:
                button.setToolButtonStyle(with_text)
        record = self._work[RECORD]
        record.setMinimumWidth(0)
        record.setMinimumWidth(record.sizeHint().width() + self._longer(record))
        for group in groups:
            if self.sizeHint().width() <= width:
                break
            for button in group:
                button.setToolButtonStyle(icons)
                button.setMinimumWidth(0)

    def _longer(self, record: QToolButton) -> int:
        """px by which the longer of the button's two texts exceeds the present one, so that
        its neighbours do not move when a recording begins."""
        metrics = record.fontMetrics()
        texts = (
            record.text(),
            text_by_icon(self.tr("Record")),
            text_by_icon(self.tr("Stop recording")),
        )
        widths = [metrics.horizontalAdvance(text) for text in texts]
        return max(widths) - widths[0]


def tip_of(action: QAction) -> str:
    """The full text of the menu, and the shortcut."""
    text = action.text().replace("&", "").rstrip("…")
    keys = action.shortcut().toString()
    return f"{text} ({keys})" if keys else text
