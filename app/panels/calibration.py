"""What the tracker has learnt of the wearer and of the sensors."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QProgressBar,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.panels.panel import Panel
from app.session import Session
from app.viewmodels.calibration import CalibrationView, Cell, calibration_view
from app.viewmodels.snapshot import Snapshot
from app.widgets.meter import SHARE_ROLE, MeterDelegate


class CalibrationPanel(Panel):
    name = "calibration"
    period = 0.5

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, parent)
        self.length = QLabel("–")
        self.length.setProperty("role", "figure")
        self.overall = QProgressBar()
        self.overall.setRange(0, 100)
        self.overall.setFormat(self.tr("settled: %p %"))
        self.advice = QLabel(self.tr("Start tracking to see what is estimated."))
        self.advice.setWordWrap(True)
        self.table = self._table()
        head = QHBoxLayout()
        head.setSpacing(12)
        head.addWidget(QLabel(self.tr("Hand length")))
        head.addWidget(self.length)
        head.addStretch(1)
        head.addWidget(self.overall)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(8)
        column.addLayout(head)
        column.addWidget(self.advice)
        column.addWidget(self.table, 1)

    def title(self) -> str:
        return self.tr("Calibration")

    def _table(self) -> QTableWidget:
        table = QTableWidget(0, 5)
        table.setHorizontalHeaderLabels(
            [
                self.tr("Segment"),
                self.tr("Scale ± 2σ"),
                self.tr("Mounting"),
                self.tr("Gyro bias"),
                self.tr("Accel. bias"),
            ]
        )
        table.verticalHeader().hide()
        table.verticalHeader().setDefaultSectionSize(30)
        table.setShowGrid(False)
        table.setAlternatingRowColors(True)
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        delegate = MeterDelegate(table)
        for column in range(1, 5):
            table.setItemDelegateForColumn(column, delegate)
        return table

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or view.calibration is None:
            return
        shown = calibration_view(view.calibration)
        self.length.setText(shown.hand_length)
        share = shown.convergence
        self.overall.setValue(0 if share != share else round(100 * share))
        self.advice.setText(shown.advice)
        self._fill(shown)

    def _fill(self, shown: CalibrationView) -> None:
        self.table.setRowCount(len(shown.rows))
        for i, row in enumerate(shown.rows):
            self._item(i, 0).setText(row.segment)
            for j, cell in enumerate(row.cells, start=1):
                self._show_cell(self._item(i, j), cell)

    def _item(self, row: int, column: int) -> QTableWidgetItem:
        item = self.table.item(row, column)
        if item is None:
            item = QTableWidgetItem()
            item.setTextAlignment(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
            self.table.setItem(row, column, item)
        return item

    @staticmethod
    def _show_cell(item: QTableWidgetItem, cell: Cell) -> None:
        item.setText(cell.text)
        item.setToolTip(cell.tip)
        item.setData(SHARE_ROLE, cell.convergence)
