"""The dialog that reports the accuracy of sessions and shows their largest errors in the replay."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
)

from app.panels.command_kind import CommandContext
from app.storage.settings import sessions_folder
from app.widgets.measures import APART, WIDE
from app.wizards.sizing import fit_to_screen
from extensions.reference.window.job_dialog import JobDialog
from extensions.reference.window.jobs import AccuracyReport, WorstInstant, accuracy_job
from extensions.reference.window.row_table import RowTable
from extensions.reference.window.view_model import worst_row

SIZE = 760, 640
TABLE_STRETCH = 100
LIST_HEIGHT = 96  # px: four recordings
HAND, RECORDING = 5, 6  # columns


class AccuracyDialog(JobDialog):
    """``worst`` are the instants that the table shows."""

    def __init__(self, on: CommandContext, sessions: Sequence[Path]) -> None:
        super().__init__(on)
        self.worst: tuple[WorstInstant, ...] = ()
        self._page: Path | None = None
        self.cancelled = self.tr("Cancelled. No report was written.")
        self.setObjectName("reference_accuracy")
        self.setWindowTitle(self.tr("Accuracy report"))
        self._make_list()
        self._make_table()
        self._lay_out()
        self.inputs = (self.sessions, self.offsets, self.anonymous)
        fit_to_screen(self, *SIZE)
        self.add(sessions)
        self.show_running(False)

    def _make_list(self) -> None:
        self.sessions = QListWidget()
        self.sessions.setAccessibleName(self.tr("Recordings"))
        self.sessions.setMaximumHeight(LIST_HEIGHT)
        self.sessions.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.sessions.itemSelectionChanged.connect(lambda: self.enable())
        self.add_button = QPushButton(self.tr("&Add…"))
        self.add_button.clicked.connect(self._ask_sessions)
        self.remove_button = QPushButton(self.tr("&Remove"))
        self.remove_button.clicked.connect(self._remove)
        self.offsets = QCheckBox(self.tr("Correct the markers' &positions (marker offsets)"))
        self.offsets.setChecked(True)
        self.anonymous = QCheckBox(self.tr("Without &names of recordings and participants"))

    def _make_table(self) -> None:
        self.hint = QLabel()
        self.hint.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.hint.setText(
            self.tr("The largest errors. Double-click or Enter pauses the replay at the instant.")
        )
        self.table = RowTable(
            [
                self.tr("Time"), self.tr("Keypoint"), self.tr("Error (mm)"), self.tr("State"),
                self.tr("Reported sd (mm)"), self.tr("Hand"), self.tr("Recording"),
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
        self.cancel_button.setText(self.tr("&Cancel"))
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
        self.enable()

    def _ask_sessions(self) -> None:
        listed = self.paths
        folder = listed[0].parent if listed else sessions_folder(self.context.store.value)
        paths, _ = QFileDialog.getOpenFileNames(
            self, self.tr("Add recordings"), str(folder), "*.mcap"
        )
        self.add([Path(path) for path in paths])

    def _remove(self) -> None:
        for item in self.sessions.selectedItems():
            self.sessions.takeItem(self.sessions.row(item))
        self.enable()

    def enable(self) -> None:
        """Enable the buttons that can be used now."""
        idle = self.job is None
        self.write_button.setEnabled(idle and self.sessions.count() > 0)
        self.remove_button.setEnabled(idle and bool(self.sessions.selectedItems()))
        self.add_button.setEnabled(idle)
        self.page_button.setEnabled(self._page is not None)

    # --- the report

    def start(self) -> None:
        """Write the report in the background."""
        if self.job is not None or not self.paths:
            return
        offsets, anonymous = self.offsets.isChecked(), self.anonymous.isChecked()
        job = accuracy_job(self.paths, offsets, anonymous)
        self.run_job(self.tr("Accuracy report"), job, self._done, self.tr("Writing the report…"))

    def _done(self, report: AccuracyReport) -> None:
        self._page, self.worst = report.page, report.worst
        self.words.setText(report.line)
        self.table.show_rows([worst_row(worst) for worst in report.worst])
        self.table.setColumnHidden(HAND, len({w.side for w in report.worst}) < 2)
        self.table.setColumnHidden(RECORDING, len(self.paths) < 2)
        for widget in (self.hint, self.table):
            widget.show()
        self.open_page()

    def open_page(self) -> None:
        """Open the report in the browser."""
        if self._page is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._page)))

    def show_instant(self, row: int) -> None:
        """Pause the replay at the instant of a row; another recording is opened first."""
        worst = self.worst[row]
        self.context.open_session(worst.session, worst.t)


def open_dialog(on: CommandContext) -> None:
    """Open the dialog for the open session, or for the selected recordings."""
    setup = on.host.setup
    paths = list(on.recordings)
    if not paths and setup is not None and setup.player is not None:
        paths = [setup.player.path]
    on.show_dialog("reference_accuracy", lambda: AccuracyDialog(on, paths))
