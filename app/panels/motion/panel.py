"""Measurement of angles and distances, their ranges and speeds, live or over a recording."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from PySide6.QtCore import Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QFileDialog,
    QHBoxLayout,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.host_parts import ErrorSignal, HandSwitch
from app.engines.snapshot import Snapshot
from app.jobs.recording_curves import csv_of, read_motion
from app.panels.hand_choice import HandChoice
from app.panels.motion.table import MotionControls, MotionPlot, MotionTable
from app.panels.panel import MessageLabel, Panel, PanelColours
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsStore
from app.viewmodels.motion import MotionModel
from app.widgets.measures import NEAR
from app.words import error_text
from tracker.base.errors import GlovetrackError

FIGURES_EVERY = 10  # refreshes
FIRST_ROWS = ("index_mcp_flexion", "index_pip_flexion")


class MotionHost(ErrorSignal, HandSwitch, Protocol):
    """What the panel uses of the engine host."""


class MotionPanel(Panel):
    period = 1 / 10
    removed = Signal(str, object)  # a message, and a function that undoes the removal

    def __init__(
        self, host: MotionHost, store: SettingsStore, parent: QWidget | None = None
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
        self.plot.sought.connect(self._seek)
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
        gone = [
            model.remove_pair(row) for row in reversed(self.table.chosen) if not model.is_angle(row)
        ]
        self._name_rows()
        if gone:
            text = self.tr("Distances removed: {}.").format(len(gone))
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
