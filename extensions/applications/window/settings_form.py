"""An application's settings as a form: one line for each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QDoubleSpinBox, QFormLayout, QLineEdit, QWidget

from extensions.applications.window.view_model import SettingRow, parsed, written

DECIMALS = 4
LARGEST = 1e6


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
