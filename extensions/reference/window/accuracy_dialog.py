"""The dialog that reports the accuracy of sessions and shows their largest errors in the replay."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
)

from app.panels.command_kind import CommandContext
from app.platform.tasks import RunningJob
from app.storage.settings import sessions_folder
from app.widgets.measures import APART, WIDE
from app.wizards.sizing import fit_to_screen
from extensions.reference.window.jobs import AccuracyReport, WorstInstant, accuracy_job
from extensions.reference.window.row_table import RowTable
from extensions.reference.window.view_model import worst_row

SIZE = 760, 640
STEPS, TABLE_STRETCH = 1000, 100
LIST_HEIGHT = 96  # px: four recordings
HAND, RECORDING = 5, 6  # columns


class AccuracyDialog(QDialog):
    """``worst`` are the instants that the table shows."""

    def __init__(self, on: CommandContext, sessions: Sequence[Path]) -> None:
        super().__init__(on.window)
        self._on = on
        self._job: RunningJob | None = None
        self.worst: tuple[WorstInstant, ...] = ()
        self._page: Path | None = None
        self._is_answered = False
        self.setObjectName("reference_accuracy")
        self.setWindowTitle(self.tr("Accuracy report"))
        self._make_list()
        self._make_table()
        self._lay_out()
        fit_to_screen(self, *SIZE)
        self.add(sessions)
        self._show_running(False)

    def _make_list(self) -> None:
        self.sessions = QListWidget()
        self.sessions.setAccessibleName(self.tr("Recordings"))
        self.sessions.setMaximumHeight(LIST_HEIGHT)
        self.sessions.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.sessions.itemSelectionChanged.connect(lambda: self._enable())
        self.add_button = QPushButton(self.tr("&Add…"))
        self.add_button.clicked.connect(self._ask_sessions)
        self.remove_button = QPushButton(self.tr("&Remove"))
        self.remove_button.clicked.connect(self._remove)
        self.offsets = QCheckBox(self.tr("Correct the markers' &positions (marker offsets)"))
        self.offsets.setChecked(True)
        self.anonymous = QCheckBox(self.tr("Without &names of recordings and participants"))

    def _make_table(self) -> None:
        self.words, self.hint = QLabel(), QLabel()
        for label in (self.words, self.hint):
            label.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.hint.setText(
            self.tr("The largest errors. Double-click or Enter pauses the replay at the instant.")
        )
        self.table = RowTable(
            [
                self.tr("Time"), self.tr("Keypoint"), self.tr("Error (mm)"), self.tr("State"),
                self.tr("Claimed sd (mm)"), self.tr("Hand"), self.tr("Recording"),
            ],
            self.tr("Largest errors"),
        )  # fmt: skip
        self.table.chosen.connect(self.show_instant)

    def _lay_out(self) -> None:
        side = QVBoxLayout()
        side.addWidget(self.add_button)
        side.addWidget(self.remove_button)
        side.addStretch(1)
        top = QHBoxLayout()
        top.addWidget(self.sessions, 1)
        top.addLayout(side)
        self.progress = QProgressBar()
        self.progress.setMaximum(STEPS)
        self.progress.setAccessibleName(self.tr("Progress of the report"))
        column = QVBoxLayout(self)
        column.setContentsMargins(WIDE, APART, WIDE, APART)
        column.setSpacing(APART)
        column.addLayout(top)
        for part in (self.offsets, self.anonymous, self.words, self.hint):
            column.addWidget(part)
        column.addWidget(self.table, TABLE_STRETCH)
        column.addStretch(1)  # while the table is hidden
        column.addWidget(self.progress)
        column.addLayout(self._buttons())
        for widget in (self.hint, self.table):
            widget.hide()

    def _buttons(self) -> QHBoxLayout:
        self.page_button = QPushButton(self.tr("&Open the report"))
        self.page_button.clicked.connect(self.open_page)
        self.cancel_button = QPushButton(self.tr("&Cancel"))
        self.cancel_button.clicked.connect(self._cancel)
        self.write_button = QPushButton(self.tr("&Write report"))
        self.write_button.setProperty("role", "primary")
        self.write_button.setDefault(True)
        self.write_button.clicked.connect(self.start)
        close = QPushButton(self.tr("Close"))
        close.clicked.connect(self.close)
        row = QHBoxLayout()
        row.addWidget(self.page_button)
        row.addStretch(1)
        for button in (close, self.cancel_button, self.write_button):
            row.addWidget(button)
        for button in (self.page_button, close, self.cancel_button):
            button.setAutoDefault(False)
        return row

    # --- the recordings

    @property
    def paths(self) -> list[Path]:
        """The listed recordings."""
        items = (self.sessions.item(i) for i in range(self.sessions.count()))
        return [Path(item.data(Qt.ItemDataRole.UserRole)) for item in items]

    def add(self, sessions: Sequence[Path]) -> None:
        """List further recordings."""
        for path in sessions:
            if path not in self.paths:
                item = QListWidgetItem(path.name, self.sessions)
                item.setData(Qt.ItemDataRole.UserRole, str(path))
                item.setToolTip(str(path))
        self._enable()

    def _ask_sessions(self) -> None:
        listed = self.paths
        folder = listed[0].parent if listed else sessions_folder(self._on.store.value)
        paths, _ = QFileDialog.getOpenFileNames(
            self, self.tr("Add recordings"), str(folder), "*.mcap"
        )
        self.add([Path(path) for path in paths])

    def _remove(self) -> None:
        for item in self.sessions.selectedItems():
            self.sessions.takeItem(self.sessions.row(item))
        self._enable()

    def _enable(self) -> None:
        idle = self._job is None
        self.write_button.setEnabled(idle and self.sessions.count() > 0)
        self.remove_button.setEnabled(idle and bool(self.sessions.selectedItems()))
        self.add_button.setEnabled(idle)
        self.page_button.setEnabled(self._page is not None)

    # --- the report

    def start(self) -> None:
        """Write the report in the background."""
        if self._job is not None or not self.paths:
            return
        self._is_answered = False
        self.words.setText(self.tr("Writing the report…"))
        offsets, anonymous = self.offsets.isChecked(), self.anonymous.isChecked()
        self._job = self._on.tasks.run(
            self.tr("Accuracy report"),
            accuracy_job(self.paths, offsets, anonymous),
            self._done,
            self._ended,
            self._progressed,
            self._show_problem,
        )
        self._show_running(True)

    def _progressed(self, share: float, _text: str) -> None:
        self.progress.setValue(round(STEPS * share))

    def _done(self, report: AccuracyReport) -> None:
        self._is_answered = True
        self._page, self.worst = report.page, report.worst
        self.words.setText(report.line)
        self.table.show_rows([worst_row(worst) for worst in report.worst])
        self.table.setColumnHidden(HAND, len({w.side for w in report.worst}) < 2)
        self.table.setColumnHidden(RECORDING, len(self.paths) < 2)
        for widget in (self.hint, self.table):
            widget.show()
        self.open_page()

    def _show_problem(self, text: str) -> None:
        self._is_answered = True
        self.words.setText(text)

    def _ended(self) -> None:
        self._job = None
        self._show_running(False)
        if not self._is_answered:
            self.words.setText(self.tr("Cancelled. No report was written."))

    def _show_running(self, on: bool) -> None:
        self.progress.setValue(0)
        self.progress.setVisible(on)
        self.cancel_button.setVisible(on)
        for widget in (self.sessions, self.offsets, self.anonymous):
            widget.setEnabled(not on)
        self._enable()

    def _cancel(self) -> None:
        if self._job is not None:
            self._job.cancel()

    def open_page(self) -> None:
        """Open the report in the browser."""
        if self._page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._page)))

    def show_instant(self, row: int) -> None:
        """Pause the replay at the instant of a row; another recording is opened first."""
        worst = self.worst[row]
        self._on.open_session(worst.session, worst.t)

    def done(self, result: int) -> None:
        """Close; a report that is being written is cancelled."""
        self._cancel()
        super().done(result)
