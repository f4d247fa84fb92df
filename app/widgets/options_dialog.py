"""The options of a connection as a form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import Field, fields
from typing import Any

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFormLayout,
    QLineEdit,
    QSpinBox,
    QWidget,
)

from app.words import tr
from tracker.streaming.connection import HOST, ConnectionKind

MOST = 1_000_000
DECIMALS = 3
ELSEWHERE = (HOST, "port", "file")
"""Options that the row of a connection has, or all connections share."""


def options_of(kind: ConnectionKind[Any]) -> list[Field[Any]]:
    """Those that a form shows."""
    return [each for each in fields(kind.options) if each.name not in ELSEWHERE]


class OptionsDialog(QDialog):
    """One field for each option; `changed` has those that the user changed."""

    def __init__(
        self, kind: ConnectionKind[Any], options: Any, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Options: {}").format(tr(kind.title)))
        self._before = {each.name: getattr(options, each.name) for each in options_of(kind)}
        self._read: dict[str, Callable[[], Any]] = {}
        self.fields: dict[str, QWidget] = {}
        form = QFormLayout(self)
        for each in options_of(kind):
            widget, self._read[each.name] = _field(self._before[each.name], each)
            self.fields[each.name] = widget
            label = tr(each.metadata["help"])
            widget.setAccessibleName(label)
            is_unit = label[1:2] == " "  # "m up"
            form.addRow(label if is_unit else label[:1].upper() + label[1:], widget)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    def changed(self) -> dict[str, Any]:
        """New values by option."""
        now = {name: read() for name, read in self._read.items()}
        return {name: value for name, value in now.items() if value != self._before[name]}


def _field(value: Any, option: Field[Any]) -> tuple[QWidget, Callable[[], Any]]:
    """A widget with the value, and what reads it."""
    choices = option.metadata.get("choices", ())
    if choices:
        combo = QComboBox()
        for choice in choices:
            combo.addItem(str(choice) or "–", choice)
        combo.setCurrentIndex(max(combo.findData(value), 0))
        return combo, combo.currentData
    if isinstance(value, bool):
        box = QCheckBox()
        box.setChecked(value)
        return box, box.isChecked
    if isinstance(value, int):
        number = QSpinBox()
        number.setRange(-MOST, MOST)
        number.setValue(value)
        return number, number.value
    if isinstance(value, float):
        real = QDoubleSpinBox()
        real.setDecimals(DECIMALS)
        real.setRange(-MOST, MOST)
        real.setSingleStep(0.01)
        real.setValue(value)
        return real, real.value
    text = QLineEdit(str(value))
    return text, text.text
