"""The verdict: each rule with its figure and its limit, and the way to the page."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor
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

from app.viewmodels.conformance import FindingRow
from app.viewmodels.states import BAD, GOOD
from app.words import tr


class VerdictPage(QWidget):
    """Says what the user decides; the dialog does it."""

    again = Signal()
    page_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading, self.words = QLabel(), QLabel()
        self.heading.setObjectName("script_words")
        for label in (self.heading, self.words):
            label.setWordWrap(True)
        self.table = QTableWidget(0, 5)
        self.table.setAccessibleName(self.tr("Rules"))
        self.table.setHorizontalHeaderLabels(
            (self.tr("Verdict"), self.tr("Part"), self.tr("Rule"), self.tr("Figure"),
             self.tr("Limit"))
        )  # fmt: skip
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(3, QHeaderView.ResizeMode.Stretch)
        column = QVBoxLayout(self)
        column.addWidget(self.heading)
        column.addWidget(self.words)
        column.addWidget(self.table, 1)
        column.addLayout(self._buttons())

    def _buttons(self) -> QHBoxLayout:
        self.again_button = QPushButton(self.tr("&Once more"))
        self.again_button.clicked.connect(self.again)
        self.page_button = QPushButton(self.tr("Open the &page"))
        self.page_button.setToolTip(self.tr("With a plot for each rule, to be kept and sent"))
        self.page_button.setProperty("role", "primary")
        self.page_button.clicked.connect(self.page_wanted)
        row = QHBoxLayout()
        row.addWidget(self.again_button)
        row.addStretch(1)
        row.addWidget(self.page_button)
        return row

    def show_waiting(self) -> None:
        """Before the verdict is there."""
        self.heading.setText(self.tr("The take is judged…"))
        self.words.setText("")
        self.table.setRowCount(0)
        self._enable(False)

    def show_problem(self, text: str) -> None:
        self.heading.setText(self.tr("The take cannot be judged"))
        self.words.setText(text)
        self._enable(True)
        self.page_button.setEnabled(False)

    def show_verdict(self, ok: bool, rows: Sequence[FindingRow], take: str) -> None:
        """What is not kept comes first."""
        kept = sum(row.look == GOOD for row in rows)
        self.heading.setText(
            self.tr("All rules are kept") if ok else self.tr("Not all rules are kept")
        )
        self.words.setText(self.tr("{} of {} rules, on {}").format(kept, len(rows), take))
        order = {BAD: 0, GOOD: 2}
        told = sorted(rows, key=lambda row: order.get(row.look, 1))
        self.table.setRowCount(len(told))
        for i, row in enumerate(told):
            sign = f"{row.look.sign} {tr(row.look.word)}"
            for j, text in enumerate((sign, row.layer, row.rule, row.figure, row.limit)):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                if j == 0:
                    item.setForeground(QColor(row.look.colour))
                self.table.setItem(i, j, item)
        self._enable(True)

    def _enable(self, on: bool) -> None:
        self.again_button.setEnabled(on)
        self.page_button.setEnabled(on)
