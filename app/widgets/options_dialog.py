"""The options of a connection as a form."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

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

MOST = 1_000_000
DECIMALS = 3


class FormField(Protocol):
    """One option: its value, and the values it can have if these are few."""

    @property
    def name(self) -> str: ...

    @property
    def help(self) -> str: ...

    @property
    def value(self) -> Any: ...

    @property
    def choices(self) -> tuple[Any, ...]: ...


class OptionsDialog(QDialog):
    """One field for each option; `changed` has those that the user changed."""

    def __init__(
        self, title: str, options: Sequence[FormField], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Options: {}").format(title))
        self._before = {each.name: each.value for each in options}
        self._read: dict[str, Callable[[], Any]] = {}
        self.fields: dict[str, QWidget] = {}
        form = QFormLayout(self)
        for each in options:
            widget, self._read[each.name] = option_widget(each.value, each.choices)
            self.fields[each.name] = widget
            widget.setAccessibleName(tr(each.help))
            form.addRow(option_label(each.help), widget)
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


def option_label(help: str) -> str:
    """An option's help as the label of its field, in the user's language."""
    label = tr(help)
    is_unit = label[1:2] == " "  # "m up"
    return label if is_unit else label[:1].upper() + label[1:]


def option_widget(value: Any, choices: Sequence[Any]) -> tuple[QWidget, Callable[[], Any]]:
    """A widget with the value, and a function that reads it."""
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
