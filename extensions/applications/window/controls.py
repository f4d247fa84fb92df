"""The Applications panel's line of controls."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox, QPushButton, QToolButton, QWidget

from app.widgets.one_line import OneLine


class ApplicationControls(OneLine):
    """Widgets; `ApplicationsPanel` does what they ask."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Application"))
        self.again = QPushButton(self.tr("Restart"))
        self.fit = QPushButton(self.tr("Show all"))
        self.fit.setToolTip(self.tr("Move the eye until all that is drawn is in sight"))
        self.settings, self.page = QToolButton(), QToolButton()
        self.settings.setText(self.tr("Settings"))
        self.page.setText(self.tr("Page"))
        self.page.setToolTip(self.tr("Show it in browsers of this machine, a headset's too"))
        for button in (self.settings, self.page):
            button.setCheckable(True)
        for widget in (self.choice, self.again, self.fit, self.settings, self.page):
            self.add(widget)

    @property
    def chosen(self) -> str:
        """The application's name; empty for none."""
        return str(self.choice.currentData() or "")

    def choose(self, name: str) -> None:
        """Show this one as chosen, without asking for it."""
        with QSignalBlocker(self.choice):
            self.choice.setCurrentIndex(max(0, self.choice.findData(name)))

    def offer(self, titles: Mapping[str, str], has_page: bool) -> None:
        """Applications by name."""
        with QSignalBlocker(self.choice):
            self.choice.addItem(self.tr("No application"), "")
            for name, title in titles.items():
                self.choice.addItem(title, name)
        self.choice.setEnabled(True)
        self.page.setEnabled(has_page)

    def clear(self) -> None:
        """There is nothing to choose from."""
        with QSignalBlocker(self.choice), QSignalBlocker(self.page):
            self.choice.clear()
            self.page.setChecked(False)
        for widget in (self.choice, self.again, self.settings, self.page):
            widget.setEnabled(False)
