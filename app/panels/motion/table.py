"""A line for each angle and distance: its value, a bar in its range, what it did."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
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

from app.viewmodels.motion import MotionRow, shown_name
from app.viewmodels.states import GREY, VALIDITY
from app.words import local, tr

NAME, STATE, VALUE, BAR, LEAST, GREATEST, RANGE, FASTEST = range(8)
SHARE = int(Qt.ItemDataRole.UserRole)


class BarDelegate(QStyledItemDelegate):
    """A bar from the left to a share of the cell, with a tick at the share."""

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        share = index.data(SHARE)
        area = QRectF(option.rect).adjusted(4, 6, -4, -6)
        painter.fillRect(area, QColor(128, 128, 128, 50))
        if share is not None and np.isfinite(share):
            filled = QRectF(area)
            filled.setWidth(area.width() * min(max(float(share), 0.0), 1.0))
            painter.fillRect(filled, QColor(GREY))


class MotionTable(QTableWidget):
    """Rows are named once, and only their numbers change."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 8, parent)
        self.setHorizontalHeaderLabels(
            [
                self.tr("Angle or distance"), "", self.tr("Now"), self.tr("In its range"),
                self.tr("Least"), self.tr("Greatest"), self.tr("Range"), self.tr("Fastest / s"),
            ]
        )  # fmt: skip
        self.verticalHeader().hide()
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setItemDelegateForColumn(BAR, BarDelegate(self))
        self.setAccessibleName(self.tr("Angles and distances"))
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(BAR, QHeaderView.ResizeMode.Stretch)

    def name_rows(self, names: Sequence[str]) -> None:
        self.setRowCount(len(names))
        for row, name in enumerate(names):
            for column in range(self.columnCount()):
                self.setItem(
                    row, column, QTableWidgetItem(shown_name(name) if column == NAME else "")
                )

    def show_rows(self, rows: Sequence[MotionRow]) -> None:
        for k, row in enumerate(rows):
            look = VALIDITY[row.state]
            self._put(k, STATE, look.sign)
            self._item(k, STATE).setToolTip(tr(look.word))
            known = np.isfinite(row.value)
            digits = 2 if row.unit == "rad" else 1
            self._put(k, VALUE, f"{local(row.value):.{digits}f} {row.unit}" if known else "–")
            self._item(k, BAR).setData(SHARE, row.share)

    def show_figures(self, figures: Sequence[Sequence[float]], digits: Sequence[int]) -> None:
        """Least, greatest, range and fastest of each row, as they are written."""
        for k, values in enumerate(figures):
            for column, value in zip((LEAST, GREATEST, RANGE, FASTEST), values, strict=True):
                self._put(k, column, f"{local(value):.{digits[k]}f}" if np.isfinite(value) else "–")

    def _item(self, row: int, column: int) -> QTableWidgetItem:
        item = self.item(row, column)
        assert item is not None  # `name_rows` has made all
        return item

    def _put(self, row: int, column: int, text: str) -> None:
        item = self._item(row, column)
        if item.text() != text:
            item.setText(text)

    @property
    def chosen(self) -> list[int]:
        """Rows that are selected."""
        return sorted({index.row() for index in self.selectedIndexes()})
