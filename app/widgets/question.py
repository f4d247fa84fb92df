"""A dialog that asks for one line of text and is wide enough for its title."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication, QInputDialog, QLabel, QWidget

BUTTONS = 190  # px: icon and buttons in the title bar
WIDEST = 720  # px


def question(parent: QWidget, title: str, words: str, text: str = "") -> QInputDialog:
    """A dialog that is not open yet; it deletes itself when it is closed."""
    dialog = QInputDialog(parent)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.setWindowTitle(title)
    dialog.setLabelText(words)
    dialog.setTextValue(text)
    label = dialog.findChild(QLabel)  # the width that the contents need
    if label is not None:
        label.setMinimumWidth(title_width(title))
    return dialog


def choice(parent: QWidget, title: str, words: str, items: Sequence[str]) -> str:
    """The selected one of ``items``; empty if cancelled."""
    dialog = question(parent, title, words)
    dialog.setComboBoxItems(list(items))
    dialog.setComboBoxEditable(False)
    return dialog.textValue() if dialog.exec() == QInputDialog.DialogCode.Accepted else ""


def answer(parent: QWidget, title: str, words: str, text: str = "") -> str:
    """The text entered, without surrounding white space; empty if cancelled."""
    dialog = question(parent, title, words, text)
    answers: list[str] = []
    dialog.textValueSelected.connect(answers.append)
    dialog.exec()
    return answers[0].strip() if answers else ""


def title_width(title: str) -> int:
    """Window width in px for a title, which window frames show in bold and truncate if
    necessary."""
    font = QApplication.font()
    font.setBold(True)
    return min(WIDEST, QFontMetrics(font).horizontalAdvance(title) + BUTTONS)
