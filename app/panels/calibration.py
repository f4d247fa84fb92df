"""What the tracker has learnt of the wearer and of the sensors."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QProgressBar,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.jobs.calibration_commands import CalibrationCommands
from app.panels.panel import Panel
from app.panels.wearer_row import WearerRow
from app.storage.settings import SettingsStore
from app.storage.wearers import WearerStore
from app.viewmodels.calibration import CalibrationCell, CalibrationView, calibration_view
from app.viewmodels.camera_time import camera_time
from app.widgets.flow_layout import FlowLayout
from app.widgets.meter import SHARE_ROLE, MeterDelegate
from tracker.errors import GlovetrackError
from tracker.fusion.chain.calibration.profile_file import WearerFile
from tracker.messages import Calibration

PROFILE_ENGINE = "chain"


class CalibrationPanel(Panel):
    name = "calibration"
    period = 0.5

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(host, parent)
        self._store = store
        self._wearers = WearerStore(store.path.parent / "wearers")
        self._link = CalibrationCommands(host, self)
        self._link.learned.connect(self._learned)
        self._saving = ""  # the name that an answer of the engine is to be saved under
        self._worn: WearerFile | None = None
        self._last_fit: Calibration | None = None
        self._latest: Calibration | None = None
        self._make_widgets()
        self._lay_out()
        self._connect()

    def title(self) -> str:
        return self.tr("Calibration")

    # --- widgets

    def _make_widgets(self) -> None:
        self.length = QLabel("–")
        self.length.setProperty("role", "figure")
        self.camera_time = QLabel("–")
        self.camera_time.setToolTip(
            self.tr("How late images are stamped, from the motion of the hand and its gyroscope")
        )
        self.overall = QProgressBar()
        self.overall.setRange(0, 100)
        self.overall.setFormat(self.tr("settled: %p %"))
        self.advice = QLabel(self.tr("Start tracking to see what is estimated."))
        self.advice.setWordWrap(True)
        self.wearer = WearerRow()
        self.table = self._table()

    def _lay_out(self) -> None:
        head = FlowLayout(spacing=12)
        head.addWidget(QLabel(self.tr("Hand length")))
        head.addWidget(self.length)
        head.addWidget(QLabel(self.tr("Images")))
        head.addWidget(self.camera_time)
        head.addWidget(self.overall)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(6)
        column.addLayout(head)
        column.addWidget(self.wearer)
        column.addWidget(self.advice)
        column.addWidget(self.table, 1)

    def _connect(self) -> None:
        row = self.wearer
        row.chosen.connect(self.wear)
        row.save.connect(self.save)
        row.remove.connect(self.remove)
        row.reset.connect(self.reset)
        row.freeze.connect(self._link.freeze)
        row.compare.connect(lambda _on: self._draw())
        self.host.opened.connect(self._open)
        self.host.engine_changed.connect(self._engine_changed)
        self.host.running_changed.connect(lambda _on: self._enable())
        self.host.closed.connect(self._enable)
        self._enable()

    def _enable(self) -> None:
        self.wearer.set_available(self._link.available)

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
        table.verticalHeader().setDefaultSectionSize(27)
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

    # --- the wearer

    def _open(self, setup: EngineSetup) -> None:
        """Put on what was worn last, before the engine starts."""
        self._worn = self._latest = self._last_fit = None
        self.wearer.frozen.setChecked(False)
        last = self._store.value.wearer
        self.wearer.set_names(self._wearers.names(), last)
        if self.wearer.name and setup.command is not None:
            self._put_on(last)

    def _put_on(self, name: str) -> None:
        layout = self._link.layout()
        if layout is None:
            return
        try:
            self._worn = self._wearers.load(name, layout)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            self.wearer.set_names(self._wearers.names(), "")
            return
        self._last_fit = self._worn.calibration
        if self._store.value.engine == PROFILE_ENGINE:
            self._link.put_on(self._worn.profile)

    def _engine_changed(self, name: str) -> None:
        """A new engine knows nobody."""
        self.wearer.frozen.setChecked(False)
        if name == PROFILE_ENGINE and self._worn is not None:
            self._link.put_on(self._worn.profile)

    def wear(self, name: str) -> None:
        """Put on a kept profile; without a name somebody new wears the glove."""
        self._store.update(wearer=name)
        self._worn = None
        if name:
            self._put_on(name)
        else:
            self.reset(None)
        self.wearer.set_names(self._wearers.names(), self.wearer.name)

    def save(self, name: str) -> None:
        """Keep what has been learned under a name; the engine is asked for it first."""
        self._saving = name
        self._link.ask()

    def _learned(self, wearer: WearerFile) -> None:
        name, self._saving = self._saving, ""
        if not name:
            return
        try:
            kept = self._wearers.save(name, wearer)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        self._worn, self._last_fit = wearer, wearer.calibration
        self._store.update(wearer=kept)
        self.wearer.set_names(self._wearers.names(), kept)
        self._draw()

    def remove(self, name: str) -> None:
        """Remove a profile; what the engine has learned stays."""
        try:
            self._wearers.remove(name)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
        self._store.update(wearer="")
        self.wearer.set_names(self._wearers.names(), "")

    def reset(self, segments: list[str] | None) -> None:
        """Forget; what was there can be compared with."""
        if self._link.reset(segments):
            self._last_fit = self._latest or self._last_fit

    # --- what it shows

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or view.calibration is None:
            return
        self.camera_time.setText(camera_time(view.status))
        self._latest = view.calibration
        self.wearer.set_segments(view.calibration.segments)
        self._draw()

    def _draw(self) -> None:
        if self._latest is None:
            return
        comparing = self.wearer.comparing.isChecked()
        shown = calibration_view(self._latest, self._last_fit if comparing else None)
        self.length.setText(shown.hand_length)
        share = shown.convergence
        self.overall.setValue(0 if share != share else round(100 * share))
        self.advice.setText(self._advice(shown, comparing))
        self._fill(shown)

    def _advice(self, shown: CalibrationView, comparing: bool) -> str:
        if comparing and self._last_fit is None:
            return self.tr("There is nothing to compare with yet: save a profile, or reset.")
        if self.wearer.frozen.isChecked():
            return self.tr("Frozen: nothing is learned until you unfreeze it.")
        return shown.advice

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
    def _show_cell(item: QTableWidgetItem, cell: CalibrationCell) -> None:
        item.setText(cell.text)
        item.setToolTip(cell.tip)
        item.setData(SHARE_ROLE, cell.convergence)
