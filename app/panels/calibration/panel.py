"""The current calibration of the wearer and the sensors, with its uncertainty."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QProgressBar,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandSwitch, RunState
from app.engines.snapshot import Snapshot
from app.panels.calibration.profiles import ProfileSettings, WearerHost, WearerProfiles
from app.panels.calibration.wearer_row import WearerRow
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel
from app.storage.settings import SettingsFileOf
from app.viewmodels.calibration import CalibrationCell, CalibrationRow, camera_time, has_one_camera
from app.viewmodels.status import images_alone
from app.widgets.elided_label import ElidedLabel
from app.widgets.measures import APART, NEAR

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
        """Make room for all headings and values. Columns never shrink, so that they do not
        jitter."""
        header = self.horizontalHeader()
        wanted = (max(header.sectionSizeHint(j), self.sizeHintForColumn(j)) for j in range(1, 5))
        header.setMinimumSectionSize(max(header.minimumSectionSize(), *wanted))

    def _item(self, row: int, column: int) -> QTableWidgetItem:
        """The item of a cell, created on first use."""
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
    item.setData(SHARE_ROLE, round(cell.convergence, 2))  # a pixel of the bar


class CalibrationHost(WearerHost, HandSwitch, RunState, Protocol):
    """What the panel uses of the engine host."""


class CalibrationPanel(Panel):
    period = 0.5
    guided_requested = Signal()

    def __init__(
        self,
        host: CalibrationHost,
        store: SettingsFileOf[ProfileSettings],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._drawn_frozen = False
        self._alone = False  # one camera shows the hand
        self._make_widgets()
        self.profiles = WearerProfiles(host, store, self.wearer)
        self._lay_out()
        self._connect()

    # --- widgets

    def _make_widgets(self) -> None:
        self.length = QLabel()
        self.length.setProperty("role", "figure")
        self.camera_time = ElidedLabel()
        self.camera_time.setToolTip(
            self.tr(
                "Delay of the image time stamps, estimated from the motion of the hand and its "
                "gyroscope"
            )
        )
        self.overall = QProgressBar()
        self.overall.setRange(0, 100)
        self.overall.setFormat(self.tr("settled: %p %"))
        self.advice = QLabel()
        self.advice.setWordWrap(True)
        self.wearer = WearerRow()
        self.table = CalibrationTable()
        self._show_nothing()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(APART)
        self.camera_time.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        name = ElidedLabel(self.tr("Hand length"))
        name.firm = True
        head.addWidget(name)
        head.addWidget(self.length)
        head.addWidget(ElidedLabel(self.tr("Camera delay")))
        head.addWidget(self.camera_time, 1)
        head.addWidget(self.overall)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        self.hand_choice = HandChoice(self.host)
        column.addWidget(self.hand_choice, 0, Qt.AlignmentFlag.AlignLeft)
        column.addLayout(head)
        column.addWidget(self.wearer)
        column.addWidget(self.advice)
        column.addWidget(self.table, 1)

    def _connect(self) -> None:
        self.wearer.guided.connect(self.guided_requested)
        self.wearer.compare.connect(lambda _on: self._draw())
        self.profiles.kept.connect(self._draw)
        self.host.opened.connect(self._open)
        self.host.hand_changed.connect(self._show_hand)
        self.host.running_changed.connect(lambda _on: self._enable())
        self.host.closed.connect(self._enable)
        self._enable()

    def _enable(self) -> None:
        setup = self.host.setup
        guided = setup is not None and setup.live is not None
        self.wearer.set_available(self.profiles.link.available, guided)

    def _open(self, setup: EngineSetup) -> None:
        self.profiles.open(setup)
        self._draw()

    def _show_hand(self, setup: EngineSetup) -> None:
        """Show the wearer of this glove and the calibration of the hand."""
        self.profiles.show_hand(setup)
        self._draw()

    # --- displayed data

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            self.profiles.current.latest = None
            self._draw()
        if view is None or view.calibration is None:
            return
        if view.status is not None and images_alone(view.status):
            return  # from a single camera no sizes are estimated
        self.camera_time.setText(camera_time(view.status))
        frozen = self.wearer.frozen.isChecked()
        if view.calibration is self.profiles.current.latest and frozen == self._drawn_frozen:
            return  # it changes once a second, and writing all its values takes 10 ms
        self.profiles.current.latest = view.calibration
        self._alone = has_one_camera(view)
        self.wearer.set_segments(view.calibration.segments)
        self._draw()

    def _show_nothing(self) -> None:
        """Show that there is no calibration."""
        self.length.setText("–")
        self.camera_time.setText("–")
        self.overall.setValue(0)
        self.advice.setText(self.tr("Start tracking to see the estimated parameters."))
        self.table.show_rows(())

    def _draw(self) -> None:
        comparing, frozen = self.wearer.comparing.isChecked(), self.wearer.frozen.isChecked()
        self._drawn_frozen = frozen
        shown = self.profiles.current.shown(comparing, frozen, self._alone)
        if shown is None:
            self._show_nothing()
            return
        self.length.setText(shown.hand_length)
        share = shown.convergence
        self.overall.setValue(0 if share != share else round(100 * share))
        self.advice.setText(shown.advice)
        self.table.show_rows(shown.rows)
