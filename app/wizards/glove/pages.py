"""The pages of the glove set-up that check its IMUs."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QProgressBar,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.viewmodels.glove_setup import (
    GloveRow,
    SetUpPhase,
    StillRun,
    WiggleRun,
    motion_rows,
    still_rows,
    wiggle_rows,
)
from app.viewmodels.names import display_name
from tracker.calibration.still import StillPose
from tracker.calibration.wiggle import WiggleTest
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample


class CheckTable(QTableWidget):
    """A table of `GloveRow`s; the column before the texts also shows a sign."""

    def __init__(self, heads: Sequence[str], signed: int) -> None:
        super().__init__(0, len(heads))
        self._signed = signed
        self.setHorizontalHeaderLabels(list(heads))
        self.verticalHeader().hide()
        self.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(len(heads) - 1, QHeaderView.ResizeMode.Stretch)
        self.setWordWrap(True)

    def show_rows(self, rows: Sequence[GloveRow]) -> None:
        self.setRowCount(len(rows))
        for i, row in enumerate(rows):
            for j, text in enumerate(row.texts):
                item = QTableWidgetItem(f"{row.look.sign} {text}" if j == self._signed else text)
                if j == self._signed:
                    item.setForeground(QColor(row.look.colour))
                self.setItem(i, j, item)
        self.resizeRowsToContents()


class StillPage(QWidget):
    """Measurement of biases and noise while the hand rests."""

    requested = Signal(str)
    measured = Signal(object)  # StillPose

    def __init__(self) -> None:
        super().__init__()
        self._run: StillRun | None = None
        self._names: tuple[str, ...] = ()
        self.words = QLabel(self.tr("Lay the hand flat on the table, palm down."))
        self.words.setProperty("role", "figure")
        self.words.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 100)
        self.start = QPushButton(self.tr("&Measure"))
        self.start.setProperty("role", "primary")
        self.start.clicked.connect(self.begin)
        self.table = CheckTable(
            (
                self.tr("IMU"),
                self.tr("Gyro bias x y z, °/s"),
                self.tr("± °/s"),
                self.tr("Noise, m°/s/√Hz"),
                self.tr("Gravity, m/s²"),
                self.tr("State"),
            ),
            5,
        )
        row = QHBoxLayout()
        row.addWidget(self.bar, 1)
        row.addWidget(self.start)
        column = QVBoxLayout(self)
        column.addWidget(self.words)
        column.addLayout(row)
        column.addWidget(self.table, 1)

    def set_glove(self, hand: HandModel, glove: GloveModel) -> None:
        self._names = glove.imu_names
        self._run = None
        self.table.show_rows([])

    def begin(self) -> None:
        self._run = StillRun(self._names)
        self.requested.emit("rest")

    def look(self, recent: Sequence[ImuSample]) -> None:
        run = self._run
        self.start.setEnabled(run is None and len(recent) > 0)
        if run is None:
            return
        run.look(recent)
        self.words.setText(run.words)
        self.bar.setValue(round(100 * run.share))
        if run.done and run.pose is not None:
            self._run = None
            self._show(run.pose)

    def _show(self, pose: StillPose) -> None:
        self.table.show_rows(still_rows(pose))
        if pose.ok:
            self.measured.emit(pose)


class WigglePage(QWidget):
    """Wiggle test: the wearer moves one finger after the other to locate the IMUs."""

    requested = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._models: tuple[HandModel, GloveModel] | None = None
        self._run: WiggleRun | None = None
        self._asked = ""
        self.words = QLabel()
        self.words.setProperty("role", "figure")
        self.words.setWordWrap(True)
        self.now = QLabel()
        self.now.setWordWrap(True)
        self.now.setMinimumHeight(2 * self.fontMetrics().lineSpacing())  # the page must not jump
        self.now.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.bar = QProgressBar()
        self.bar.setRange(0, 100)
        self.start = QPushButton(self.tr("&Start the test"))
        self.start.setProperty("role", "primary")
        self.start.clicked.connect(self.begin)
        self._grid = QGridLayout()
        self._grid.setColumnStretch(1, 1)
        self._bars: list[QProgressBar] = []
        self.table = CheckTable((self.tr("IMU"), self.tr("State"), self.tr("Result")), 1)
        self._lay_out()

    def _lay_out(self) -> None:
        row = QHBoxLayout()
        row.addWidget(self.bar, 1)
        row.addWidget(self.start)
        column = QVBoxLayout(self)
        column.addWidget(self.words)
        column.addLayout(row)
        column.addLayout(self._grid)
        column.addWidget(self.now)
        column.addWidget(self.table, 1)

    def set_glove(self, hand: HandModel, glove: GloveModel) -> None:
        self._models, self._run = (hand, glove), None
        while (item := self._grid.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        self._bars = []
        for i, name in enumerate(glove.imu_names):
            bar = QProgressBar()
            bar.setTextVisible(False)
            bar.setMaximumHeight(10)
            bar.setAccessibleName(display_name(name))
            self._bars.append(bar)
            self._grid.addWidget(QLabel(display_name(name)), i, 0)
            self._grid.addWidget(bar, i, 1)
        self.words.setText(self.tr("Press Start, then move each part as asked."))
        self.table.show_rows([])

    @property
    def phase(self) -> SetUpPhase | None:
        """State of the test; None before the first."""
        return self._run.phase if self._run is not None else None

    def begin(self) -> None:
        if self._models is not None:
            self._run, self._asked = WiggleRun(WiggleTest(*self._models)), ""
            self.table.show_rows([])

    def look(self, recent: Sequence[ImuSample]) -> None:
        self._show_motion(recent)
        run = self._run
        self.start.setEnabled(len(recent) > 0 and (run is None or run.phase == SetUpPhase.DONE))
        if run is None or run.phase == SetUpPhase.DONE:
            return
        run.look(recent)
        if run.part != self._asked:
            self._asked = run.part
            self.requested.emit(run.part)
        self.words.setText(run.words)
        self.bar.setValue(round(100 * run.share))
        if run.phase == SetUpPhase.DONE:
            self.bar.setValue(100)
            self.table.show_rows(wiggle_rows(run.test.result()))

    def _show_motion(self, recent: Sequence[ImuSample]) -> None:
        if self._models is None or not recent:
            self.now.setText(self.tr("No data received."))
            return
        shares, rows = motion_rows(recent)
        for bar, share in zip(self._bars, shares, strict=False):
            bar.setValue(round(100 * float(share)))
        names = [display_name(self._models[1].imu_names[i]) for i in rows]
        moves = ", ".join(names) or self.tr("nothing")
        self.now.setText(self.tr("Moving: {}").format(moves))
