"""Measurement of angles and distances, their ranges and speeds, live or over a recording."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import numpy as np
from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QGuiApplication, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QSplitter,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.host_parts import ErrorSignal, HandSwitch
from app.engines.snapshot import Snapshot
from app.jobs.recording_curves import csv_of, read_motion
from app.panels.graphs.looks import curve_looks
from app.panels.hand_choice import HandChoice
from app.panels.panel import MessageLabel, Panel, PanelColours
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsOf
from app.viewmodels.motion import MotionModel, MotionRow, shown_name
from app.viewmodels.names import display_name
from app.viewmodels.states import GREY, VALIDITY
from app.widgets.curve_plot import CurvePlot, span_of
from app.widgets.measures import NEAR
from app.widgets.one_line import OneLine
from app.words import error_text, local, tr
from tracker.base.errors import GlovetrackError
from tracker.messages import Array

FIGURES_EVERY = 10  # refreshes
FIRST_ROWS = ("index_mcp_flexion", "index_pip_flexion")


class MotionHost(ErrorSignal, HandSwitch, Protocol):
    """What the panel uses of the engine host."""


class MotionSettings(Protocol):
    """The settings of this panel."""

    @property
    def angle_unit(self) -> str: ...


class MotionPanel(Panel):
    period = 1 / 10
    removed = Signal(str, object)  # a message, and a function that undoes the removal

    def __init__(
        self, host: MotionHost, store: SettingsOf[MotionSettings], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self.model: MotionModel | None = None
        self._setup: EngineSetup | None = None
        self._reading = LatestJob(self.tr("Measuring the recording"), self)
        self._turn = 0
        self.table, self.plot = MotionTable(), MotionPlot()
        self.controls = MotionControls(store.value.angle_unit)
        both = QSplitter()
        both.addWidget(self.table)
        both.addWidget(self.plot)
        both.setSizes([520, 480])
        self.message = MessageLabel()
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        self.hand_choice = HandChoice(host)
        head = QHBoxLayout()
        head.addWidget(self.hand_choice)
        head.addWidget(self.controls, 1)
        column.addLayout(head)
        column.addWidget(both, 1)
        column.addWidget(self.message)
        self._connect()
        self._clear()

    def _connect(self) -> None:
        self._reading.failed.connect(self.message.show_message)
        row = self.controls
        row.measure.clicked.connect(self._add_distance)
        row.remove.clicked.connect(self._remove_distances)
        row.units.currentIndexChanged.connect(lambda _i: self._choose_units())
        row.copy.clicked.connect(self._copy)
        row.save.clicked.connect(self._ask_file)
        self.table.itemSelectionChanged.connect(self._choose_curves)
        self.plot.seek_requested.connect(self._seek)
        self.host.opened.connect(self._open)
        self.host.hand_changed.connect(self._open)
        self.host.closed.connect(self._clear)

    # --- the engine

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        self._setup, self.model = setup, MotionModel(setup)
        self.model.choose_units(self._store.value.angle_unit)
        self.controls.offer_points(self.model.point_names)
        self._name_rows()
        names = self.model.names
        for name in FIRST_ROWS:
            if name in names:
                self.table.selectRow(names.index(name))
                break
        self.controls.enable(True)
        if setup.player is not None:
            self.message.show_message(self.tr("Reading the whole recording…"))
            side = setup.side if setup.others else ""
            self._reading.run(read_motion(setup.player.path, side), self._use_recording)

    def _use_recording(self, take: object) -> None:
        if self.model is not None and self.model.use_recording(take):
            self.message.show_message("")
            self._show_figures()
            self._show_curves()

    def _clear(self) -> None:
        self._reading.forget()
        self._setup = self.model = None
        self.table.name_rows([])
        self.plot.show_names([])
        self.plot.show_position(None)
        self.controls.offer_points(())
        self.controls.enable(False)
        self.message.show_message("")

    def refresh(self, view: Snapshot | None) -> None:
        if self.model is None or view is None or view.estimate is None:
            return
        self.model.feed(view.estimates)
        self.table.show_rows(self.model.rows(view.estimate))
        player = view.setup.player
        self.plot.show_position(None if player is None else player.position)
        if self.model.take is None:
            self._turn += 1
            self._show_curves()
            if self._turn % FIGURES_EVERY == 1:
                self._show_figures()

    # --- displayed data

    def _name_rows(self) -> None:
        if self.model is not None:
            self.table.name_rows(self.model.names)
            self._show_figures()

    def _show_figures(self) -> None:
        if self.model is not None:
            self.table.show_figures(*self.model.figures())

    def _choose_curves(self) -> None:
        if self.model is not None:
            self.plot.show_names([self.model.names[row] for row in self.table.chosen])
            self._show_curves()

    def _show_curves(self) -> None:
        if self.model is not None:
            self.plot.show_curves([self.model.curve(row) for row in self.table.chosen])

    def _seek(self, position: float) -> None:
        player = self._setup.player if self._setup is not None else None
        if player is not None:
            player.seek(min(max(position, 0.0), player.duration))

    def _choose_units(self) -> None:
        self._store.update(angle_unit=self.controls.units.currentData())
        if self.model is not None:
            self.model.choose_units(self._store.value.angle_unit)
            self._show_figures()
            self._show_curves()

    def _add_distance(self) -> None:
        if self.model is not None and self.model.add_pair(self.controls.pair):
            self._name_rows()
            self.table.selectRow(self.table.rowCount() - 1)

    def _remove_distances(self) -> None:
        model = self.model
        if model is None:
            return
        before = list(model.pairs)
        dropped = [
            model.remove_pair(row) for row in reversed(self.table.chosen) if not model.is_angle(row)
        ]
        self._name_rows()
        if dropped:
            text = self.tr("Distances removed: {}.").format(len(dropped))
            self.removed.emit(text, lambda: self._put_back(model, before))

    def _put_back(self, model: MotionModel, pairs: list[tuple[str, str]]) -> None:
        """Restore removed distances next to those added since, if the same hand is still shown."""
        if model is self.model:
            added = [pair for pair in model.pairs if pair not in pairs]
            model.pairs = [*pairs, *added]
            self._name_rows()

    # --- taking it out

    def _copy(self) -> None:
        if self.model is not None:
            QGuiApplication.clipboard().setText(self.model.table("\t"))

    def _ask_file(self) -> None:
        player = self._setup.player if self._setup is not None else None
        start = player.path.with_suffix(".motion.csv") if player is not None else Path("motion.csv")
        name, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save the table"), str(start), self.tr("CSV (*.csv)")
        )
        if name:
            self.save_table(Path(name))

    def save_table(self, path: Path) -> None:
        """Write the table as CSV."""
        if self.model is None:
            return
        try:
            csv_of(self.model.table(","), path)
        except GlovetrackError as error:
            self.host.error.emit(error_text(error))

    def show_theme(self, colours: PanelColours) -> None:
        self.plot.set_colours(colours.base, colours.text)

    def shut_down(self) -> None:
        self._reading.shut_down()


# ---- table, curves and controls of the Motion panel

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
    """``seek_requested``: a click at an instant (s from the recording's first image)."""

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
                box.addItem(display_name(name), name)
        self.ends[1].setCurrentIndex(self.ends[1].count() - 1)

    @property
    def pair(self) -> tuple[str, str]:
        """The selected points."""
        return self.ends[0].currentData(), self.ends[1].currentData()

    def enable(self, on: bool) -> None:
        for widget in (*self.ends, self.measure, self.remove, self.copy, self.save):
            widget.setEnabled(on)
