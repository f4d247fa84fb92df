"""The Applications panel's line of controls, and the form of an application's settings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QLineEdit,
    QPushButton,
    QToolButton,
    QWidget,
)

from app.widgets.one_line import OneLine
from extensions.applications.window.view_model import SettingRow, parsed, written

DECIMALS = 4
LARGEST = 1e6


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


class SettingsForm(QWidget):
    """Tells of each change that the user makes."""

    changed = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._lines = QFormLayout(self)
        self._lines.setContentsMargins(0, 0, 0, 0)
        self.fields: dict[str, QWidget] = {}

    def show_rows(self, rows: Sequence[SettingRow]) -> None:
        """Offer these in place of what is there."""
        while self._lines.rowCount():
            self._lines.removeRow(0)
        self.fields.clear()
        for row in rows:
            field = self._field(row)
            field.setAccessibleName(row.key)
            self.fields[row.key] = field
            self._lines.addRow(row.key.replace("_", " "), field)

    def _field(self, row: SettingRow) -> QWidget:
        if isinstance(row.value, bool):
            box = QCheckBox()
            box.setChecked(row.value)
            box.toggled.connect(lambda on: self.changed.emit(row.key, bool(on)))
            return box
        if isinstance(row.value, int | float):
            return self._number(row)
        edit = QLineEdit(written(row.value))
        edit.editingFinished.connect(lambda: self._written(row, edit))
        return edit

    def _number(self, row: SettingRow) -> QWidget:
        whole = isinstance(row.value, int)
        number = QDoubleSpinBox()
        number.setDecimals(0 if whole else DECIMALS)
        number.setRange(-LARGEST, LARGEST)
        number.setSingleStep(1.0 if whole else max(abs(row.value) / 10, 10.0**-DECIMALS))
        number.setValue(row.value)
        number.setKeyboardTracking(False)
        kind = int if whole else float
        number.valueChanged.connect(lambda value: self.changed.emit(row.key, kind(value)))
        return number

    def _written(self, row: SettingRow, edit: QLineEdit) -> None:
        try:
            value: Any = parsed(edit.text(), row.value)
        except ValueError:
            edit.setText(written(row.value))
            return
        self.changed.emit(row.key, value)
