"""A dialog that asks for a device: its port or name, what is known of it, and one thing to do."""

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
    """Not modal. ``again`` looks for devices anew."""

    def __init__(self, name: str, size: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        fit_to_screen(self, *size)
        self.again = QPushButton(self.tr("&Search again"))

    def lay_out(self, parts: Sequence[QWidget | QLayout], main: QPushButton) -> None:
        """The parts below one another; ``main`` is what the dialog is for."""
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
    """A label whose key leads to the field."""
    label = QLabel(text)
    label.setBuddy(field)
    return label


def beside(wide: QWidget, button: QWidget) -> QHBoxLayout:
    """A field that takes the room, and its button."""
    row = QHBoxLayout()
    row.addWidget(wide, 1)
    row.addWidget(button)
    return row


def filler() -> QWidget:
    """Takes the height that is left."""
    widget = QWidget()
    widget.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
    return widget
