"""A button with a pop-up that contains further controls."""

from __future__ import annotations

from PySide6.QtWidgets import QMenu, QToolButton, QVBoxLayout, QWidget, QWidgetAction

from app.widgets.icons import dress, text_by_icon
from app.widgets.measures import NEAR


class MoreButton(QToolButton):
    """Widgets passed to `add` form a column; the pop-up stays open while it is used."""

    def __init__(self, text: str, icon: str = "ellipsis", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText(text_by_icon(text))
        self.setToolButtonStyle(self.toolButtonStyle().ToolButtonTextBesideIcon)
        dress(self, icon)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        leaf = QWidget()
        self._column = QVBoxLayout(leaf)
        self._column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        self._action = QWidgetAction(menu)
        self._action.setDefaultWidget(leaf)
        menu.addAction(self._action)
        menu.aboutToShow.connect(self._fit)
        self.setMenu(menu)

    def add(self, widget: QWidget) -> None:
        self._column.addWidget(widget)

    def _fit(self) -> None:
        """Let the menu query the size of the pop-up again."""
        leaf = self._action.defaultWidget()
        self._column.activate()
        leaf.adjustSize()
        self._action.setData(leaf.sizeHint())
