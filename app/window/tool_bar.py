"""The tool bar: where data comes from, what is done with them, and the job that is in sight."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QToolBar, QToolButton, QWidget

from app.widgets.icons import beside, dress
from app.widgets.segments import Segments

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


class ToolBar(QToolBar):
    """Words give way to their icons, from the left, where there is no room for all.

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
            action.setIconVisibleInMenu(False)  # there a tick says which one is on
            action.setIconText(beside(action.text()))
        self.segments = Segments(list(jobs.values()))
        self.addWidget(self.segments)
        self._fill()
        self._search = self._button(actions["palette"])

    def _short(self, actions: Mapping[str, QAction]) -> None:
        """Fewer words than in the menu."""
        words = {
            "demo": self.tr("Demo"),
            "hardware": self.tr("Devices"),
            "open": self.tr("Open"),
            "start": self.tr("Start"),
            "stop": self.tr("Stop"),
            "note": self.tr("Note"),
            "palette": self.tr("Find"),
        }
        for key, text in words.items():
            actions[key].setIconText(beside(text))
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
        """Words where ``width`` px have room for them."""
        words, icons = (
            Qt.ToolButtonStyle.ToolButtonTextBesideIcon,
            Qt.ToolButtonStyle.ToolButtonIconOnly,
        )
        groups = [[self._search], self._sources, self._work, self.segments.buttons]
        for group in groups:
            for button in group:
                button.setToolButtonStyle(words)
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
        """px that the longer of the button's two texts takes beyond its present one, so that
        nothing beside it moves when a recording begins."""
        metrics = record.fontMetrics()
        texts = record.text(), beside(self.tr("Record")), beside(self.tr("Stop recording"))
        widths = [metrics.horizontalAdvance(text) for text in texts]
        return max(widths) - widths[0]


def tip_of(action: QAction) -> str:
    """The whole words of the menu, and the key."""
    text = action.text().replace("&", "").rstrip("…")
    keys = action.shortcut().toString()
    return f"{text} ({keys})" if keys else text
