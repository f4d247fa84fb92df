"""Base class of dialogs that select a device: its port or name, its properties, and one action."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QLayout,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.widgets.measures import APART, WIDE
from app.wizards.sizing import fit_to_screen


class FormDialog(QDialog):
    """Not modal. ``again`` searches for devices again."""

    def __init__(self, name: str, size: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        fit_to_screen(self, *size)
        self.again = QPushButton(self.tr("&Search again"))

    def lay_out(self, parts: Sequence[QWidget | QLayout], main: QPushButton) -> None:
        """Stack the parts; ``main`` is the default button."""
        main.setProperty("role", "primary")
        main.setDefault(True)
        close = QPushButton(self.tr("Close"))
        close.clicked.connect(self.close)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(close)
        buttons.addWidget(main)
        column = QVBoxLayout(self)
        column.setContentsMargins(WIDE, APART, WIDE, APART)
        column.setSpacing(APART)
        for part in (*parts, buttons):
            if isinstance(part, QLayout):
                column.addLayout(part)
            else:
                column.addWidget(part)


def labelled(text: str, field: QWidget) -> QLabel:
    """A label whose mnemonic focuses the field."""
    label = QLabel(text)
    label.setBuddy(field)
    return label


def row_of(wide: QWidget, button: QWidget) -> QHBoxLayout:
    """A field that takes the available width, followed by its button."""
    row = QHBoxLayout()
    row.addWidget(wide, 1)
    row.addWidget(button)
    return row


def filler() -> QWidget:
    """A spacer that takes the remaining height."""
    widget = QWidget()
    widget.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
    return widget
