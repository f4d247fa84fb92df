"""A page with results: a heading, a sentence, a table, and buttons."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.wizards.leading.page import foot_row


class OutcomePage(QWidget):
    """Emits the user's decision; the dialog executes it."""

    again = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading, self.words = QLabel(), QLabel()
        self.heading.setObjectName("leading_words")
        self.words.setObjectName("leading_notes")
        for label in (self.heading, self.words):
            label.setWordWrap(True)
        self.table = QTableWidget()
        self.again_button = QPushButton(self.tr("Rep&eat"))
        self.again_button.clicked.connect(self.again)
        self.buttons = [self.again_button]

    def name_columns(self, table: str, names: Sequence[str], wide: int) -> None:
        """``table``: accessible name; the column ``wide`` takes the remaining width."""
        self.table.setAccessibleName(table)
        self.table.setColumnCount(len(names))
        self.table.setHorizontalHeaderLabels(list(names))
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(wide, QHeaderView.ResizeMode.Stretch)

    def lay_out(self, *buttons: QPushButton) -> None:
        """Place these buttons next to `again_button`; the last one is the default."""
        buttons[-1].setProperty("role", "primary")
        self.buttons += buttons
        column = QVBoxLayout(self)
        column.addWidget(self.heading)
        column.addWidget(self.words)
        column.addWidget(self.table, 1)
        column.addLayout(foot_row(self.again_button, buttons))

    def tell(
        self,
        heading: str,
        words: str,
        rows: Sequence[Sequence[str]] = (),
        colours: Sequence[str] = (),
    ) -> None:
        """Show one text for each column of each row; ``colours``: of the first column."""
        self.heading.setText(heading)
        self.words.setText(words)
        self.table.setRowCount(len(rows))
        for i, texts in enumerate(rows):
            for j, text in enumerate(texts):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                if j == 0 and colours:
                    item.setForeground(QColor(colours[i]))
                self.table.setItem(i, j, item)

    def enable(self, on: bool) -> None:
        for button in self.buttons:
            button.setEnabled(on)
