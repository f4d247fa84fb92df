"""A small question: one line of text is asked for, in a dialog whose title can be read."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication, QInputDialog, QLabel, QWidget

BUTTONS = 190  # px: icon and buttons that a window's frame keeps beside its title
WIDEST = 720  # px


def question(parent: QWidget, title: str, words: str, text: str = "") -> QInputDialog:
    """Not yet open; it deletes itself once it is closed."""
    dialog = QInputDialog(parent)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.setWindowTitle(title)
    dialog.setLabelText(words)
    dialog.setTextValue(text)
    label = dialog.findChild(QLabel)  # the dialog's own width is what its parts need
    if label is not None:
        label.setMinimumWidth(title_width(title))
    return dialog


def choice(parent: QWidget, title: str, words: str, items: Sequence[str]) -> str:
    """Which of ``items`` is chosen; empty where none is."""
    dialog = question(parent, title, words)
    dialog.setComboBoxItems(list(items))
    dialog.setComboBoxEditable(False)
    return dialog.textValue() if dialog.exec() == QInputDialog.DialogCode.Accepted else ""


def answer(parent: QWidget, title: str, words: str, text: str = "") -> str:
    """What is answered, without space around it; empty where nothing is, or not now."""
    dialog = question(parent, title, words, text)
    said: list[str] = []
    dialog.textValueSelected.connect(said.append)
    dialog.exec()
    return said[0].strip() if said else ""


def title_width(title: str) -> int:
    """px that a window needs for it: frames write it in bold, and cut what is longer."""
    font = QApplication.font()
    font.setBold(True)
    return min(WIDEST, QFontMetrics(font).horizontalAdvance(title) + BUTTONS)
