"""Table, curves and controls of the Motion panel."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHeaderView,
    QPushButton,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.panels.graphs.looks import curve_looks
from app.viewmodels.motion import MotionRow, shown_name
from app.viewmodels.names import spoken
from app.viewmodels.states import GREY, VALIDITY
from app.widgets.curve_plot import CurvePlot, span_of
from app.widgets.one_line import OneLine
from app.words import local, tr
from tracker.messages import Array

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
    """Rows are created once; then only their values change."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 8, parent)
        self.setHorizontalHeaderLabels(
            [
                self.tr("Angle or distance"), "", self.tr("Now"), self.tr(
                                                                          "Position in range"
),
                self.tr("Minimum"), self.tr("Maximum"), self.tr("Range"), self.tr(
                                                                                 "Peak speed / s"
),
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
        """Show minimum, maximum, range and peak speed of each row."""
        for k, values in enumerate(figures):
            for column, value in zip((LEAST, GREATEST, RANGE, FASTEST), values, strict=True):
                self._put(k, column, f"{local(value):.{digits[k]}f}" if np.isfinite(value) else "–")

    def _item(self, row: int, column: int) -> QTableWidgetItem:
        item = self.item(row, column)
        assert item is not None  # `name_rows` created all items
        return item

    def _put(self, row: int, column: int, text: str) -> None:
        item = self._item(row, column)
        if item.text() != text:
            item.setText(text)

    @property
    def chosen(self) -> list[int]:
        """The selected rows."""
        return sorted({index.row() for index in self.selectedIndexes()})


class MotionPlot(CurvePlot):
    """``sought``: a click at an instant (s from the recording's first image)."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent=parent)
        self.plot.setMinimumHeight(90)
        self.plot.setLabel("bottom", "s")
        self.plot.addLegend(offset=(1, 1))

    def show_names(self, names: Sequence[str]) -> None:
        """Create an empty curve for each name."""
        self.set_looks(curve_looks([shown_name(name) for name in names]))

    def show_curves(self, curves: Sequence[tuple[Array, Array]]) -> None:
        """Draw these curves completely."""
        t = [t for t, _ in curves if len(t)]
        if not t:
            return
        self.plot.setXRange(min(x[0] for x in t), max(x[-1] for x in t), padding=0.02)
        found = span_of(np.concatenate([values for _, values in curves]))
        if found is not None:
            self.plot.setYRange(*found, padding=0)
        self.draw(curves)


class MotionControls(OneLine):
    """The row of controls; `MotionPanel` executes the requests."""

    def __init__(self, unit: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.ends = QComboBox(), QComboBox()
        self.ends[0].setAccessibleName(self.tr("Distance from"))
        self.ends[1].setAccessibleName(self.tr("Distance to"))
        self.measure = QPushButton(self.tr("Add this distance"))
        self.remove = QPushButton(self.tr("Remove"))
        self.remove.setToolTip(self.tr("Remove the selected distances"))
        self.units = QComboBox()
        self.units.setAccessibleName(self.tr("Unit of angles"))
        self.units.addItem(self.tr("Degrees"), "deg")
        self.units.addItem(self.tr("Radians"), "rad")
        self.units.setCurrentIndex(self.units.findData(unit))
        self.copy = QPushButton(self.tr("Copy the table"))
        self.save = QPushButton(self.tr("Save as CSV…"))
        for widget in (self.units, self.copy, self.save, *self.ends, self.measure, self.remove):
            self.add(widget)

    def offer_points(self, names: Sequence[str]) -> None:
        """Offer the points between which distances can be measured; select the first and the
        last."""
        for box in self.ends:
            box.clear()
            for name in names:
                box.addItem(spoken(name), name)
        self.ends[1].setCurrentIndex(self.ends[1].count() - 1)

    @property
    def pair(self) -> tuple[str, str]:
        """The selected points."""
        return self.ends[0].currentData(), self.ends[1].currentData()

    def enable(self, on: bool) -> None:
        for widget in (*self.ends, self.measure, self.remove, self.copy, self.save):
            widget.setEnabled(on)
