"""What the guided poses have taught: in words, and in figures before and after."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.viewmodels.guided_result import Learned


class GuidedResultPage(QWidget):
    """Says what the wearer decides; the dialog does it."""

    keep = Signal()
    undo = Signal()
    again = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading = QLabel()
        self.heading.setObjectName("guided_words")
        self.heading.setWordWrap(True)
        self.words = QLabel()
        self.words.setObjectName("guided_notes")
        self.words.setWordWrap(True)
        self.table = QTableWidget(0, 4)
        self.table.setAccessibleName(self.tr("What was learned"))
        names = (self.tr("Of you"), self.tr("Before"), self.tr("After"), self.tr("Change"))
        self.table.setHorizontalHeaderLabels(names)
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        column = QVBoxLayout(self)
        column.addWidget(self.heading)
        column.addWidget(self.words)
        column.addWidget(self.table, 1)
        column.addLayout(self._buttons())

    def _buttons(self) -> QHBoxLayout:
        self.keep_button = QPushButton(self.tr("&Keep"))
        self.keep_button.setProperty("role", "primary")
        self.keep_button.setDefault(True)
        self.undo_button = QPushButton(self.tr("&Undo"))
        self.undo_button.setToolTip(self.tr("Forget what these poses have taught"))
        self.again_button = QPushButton(self.tr("&Once more"))
        self.keep_button.clicked.connect(self.keep)
        self.undo_button.clicked.connect(self.undo)
        self.again_button.clicked.connect(self.again)
        row = QHBoxLayout()
        row.addWidget(self.again_button)
        row.addStretch(1)
        row.addWidget(self.undo_button)
        row.addWidget(self.keep_button)
        return row

    def show_waiting(self) -> None:
        """Before the engine has answered."""
        self.heading.setText(self.tr("The tracking thinks about it…"))
        self.words.setText("")
        self.table.setRowCount(0)
        self._enable(False)

    def show_learned(self, learned: Learned, held: int, asked: int) -> None:
        """The engine's answer, after ``held`` of ``asked`` poses."""
        self.heading.setText(self.tr("{} of {} poses held").format(held, asked))
        nothing = self.tr("The tracking knew you already: nothing has changed that you would see.")
        self.words.setText("\n".join(learned.words) or nothing)
        self.table.setRowCount(len(learned.rows))
        for number, row in enumerate(learned.rows):
            change = f"▲ {row.change}" if row.is_clear else row.change
            for column, text in enumerate((row.what, row.before, row.after, change)):
                self.table.setItem(number, column, QTableWidgetItem(text))
        self._enable(True)
        self.keep_button.setFocus()

    def show_nothing(self, words: str) -> None:
        """There is nothing to be kept."""
        self.heading.setText(self.tr("Nothing was learned"))
        self.words.setText(words)
        self.table.setRowCount(0)
        self._enable(False)
        self.again_button.setEnabled(True)

    def _enable(self, on: bool) -> None:
        for button in (self.keep_button, self.undo_button, self.again_button):
            button.setEnabled(on)
