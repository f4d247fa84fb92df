"""Two trackings of one movement, side by side in figures."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.viewmodels.compare import Comparison, rows, summary


class CompareDialog(QDialog):
    """A window of its own that blocks nothing."""

    def __init__(self, comparison: Comparison, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Two trackings compared"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(680, 520)
        self.summary = QLabel(summary(comparison))
        self.summary.setWordWrap(True)
        self.table = self._table(comparison)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("Copy"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.clicked.connect(self.copy)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addWidget(self.summary)
        column.addWidget(self.table, 1)
        column.addWidget(buttons)

    def _table(self, comparison: Comparison) -> QTableWidget:
        found = rows(comparison)
        table = QTableWidget(len(found), 4)
        table.setHorizontalHeaderLabels(
            [
                "",
                self.tr("Difference"),
                *(self.tr("Error of {}").format(name) for name in comparison.names),
            ]
        )
        for j, stem in enumerate(comparison.stems, start=2):
            heading = table.horizontalHeaderItem(j)
            assert heading is not None
            heading.setToolTip(stem)
        table.verticalHeader().hide()
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for i, row in enumerate(found):
            cells = (row.name, row.difference, row.first_error, row.second_error)
            for j, text in enumerate(cells):
                item = QTableWidgetItem(text)
                if j > 0:
                    item.setTextAlignment(right)
                table.setItem(i, j, item)
        if not any(comparison.errors_mm):
            table.hideColumn(2)
            table.hideColumn(3)
        return table

    def copy(self) -> None:
        """The table as text with tabs, for a spreadsheet."""
        lines = []
        for i in range(self.table.rowCount()):
            items = [self.table.item(i, j) for j in range(self.table.columnCount())]
            lines.append("\t".join(item.text() if item else "" for item in items))
        QGuiApplication.clipboard().setText("\n".join(lines))
