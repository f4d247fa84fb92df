"""The calibration as a table: a row for each segment, figures over bars of how far they settled."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.viewmodels.calibration import CalibrationCell, CalibrationRow

SHARE_ROLE = Qt.ItemDataRole.UserRole + 1
FULL, PART = QColor("#009E73"), QColor("#E69F00")
ENOUGH = 0.9


class _MeterDelegate(QStyledItemDelegate):
    """Paints `SHARE_ROLE` (0..1) as a thin bar under the text."""

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        super().paint(painter, option, index)
        share = index.data(SHARE_ROLE)
        if share is None or share != share:  # NaN: there is no such parameter
            return
        box = QRectF(option.rect).adjusted(6, option.rect.height() - 5, -6, -2)
        painter.save()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(128, 128, 128, 70))
        painter.drawRoundedRect(box, 1.5, 1.5)
        box.setWidth(max(3.0, box.width() * share))
        painter.setBrush(FULL if share >= ENOUGH else PART)
        painter.drawRoundedRect(box, 1.5, 1.5)
        painter.restore()


class CalibrationTable(QTableWidget):
    """One column for each kind of parameter."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 5, parent)
        self.setHorizontalHeaderLabels(
            [
                self.tr("Segment"),
                self.tr("Scale ± 2σ"),
                self.tr("Mounting"),
                self.tr("Gyro bias"),
                self.tr("Accel. bias"),
            ]
        )
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(27)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        delegate = _MeterDelegate(self)
        for column in range(1, 5):
            self.setItemDelegateForColumn(column, delegate)

    def show_rows(self, rows: Sequence[CalibrationRow]) -> None:
        self.setRowCount(len(rows))
        for i, row in enumerate(rows):
            self._item(i, 0).setText(row.segment)
            for j, cell in enumerate(row.cells, start=1):
                _show_cell(self._item(i, j), cell)
        self._widen()

    def _widen(self) -> None:
        """Make room for all headings and figures; never shrinks, so that columns do not jitter."""
        header = self.horizontalHeader()
        wanted = (max(header.sectionSizeHint(j), self.sizeHintForColumn(j)) for j in range(1, 5))
        header.setMinimumSectionSize(max(header.minimumSectionSize(), *wanted))

    def _item(self, row: int, column: int) -> QTableWidgetItem:
        """The item of a cell, made where there is none yet."""
        there: QTableWidgetItem | None = self.item(row, column)
        if there is not None:
            return there
        made = QTableWidgetItem()
        made.setTextAlignment(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
        self.setItem(row, column, made)
        return made


def _show_cell(item: QTableWidgetItem, cell: CalibrationCell) -> None:
    item.setText(cell.text)
    item.setToolTip(cell.tip)
    item.setData(SHARE_ROLE, cell.convergence)
