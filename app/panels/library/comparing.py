"""Comparison of two trackings of one movement, in numbers and side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import ErrorSignal, RunState
from app.engines.protocols import Player
from app.jobs.offline_tracking import compare_job, free_name, track_job
from app.jobs.recording_curves import two_recordings_job
from app.panels.library.two_recordings_dialog import TwoRecordingsDialog
from app.platform.tasks import Job, TaskOwner
from app.viewmodels.compare import Comparison, rows, summary
from app.viewmodels.two_recordings import TwoRecordings
from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.offline.options import TrackOptions


class CompareDialog(QDialog):
    """A non-modal window."""

    def __init__(self, comparison: Comparison, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Comparison of two trackings"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(680, 520)
        self.summary = QLabel(summary(comparison))
        self.summary.setWordWrap(True)
        self.table = self._table(comparison)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("Copy"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.clicked.connect(self.copy)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addWidget(self.summary)
        column.addWidget(self.table, 1)
        column.addWidget(buttons)

    def _table(self, comparison: Comparison) -> QTableWidget:
        found = rows(comparison)
        table = QTableWidget(len(found), 4)
        table.setHorizontalHeaderLabels(
            [
                "",
                self.tr("Difference"),
                *(self.tr("Error of {}").format(name) for name in comparison.names),
            ]
        )
        for j, stem in enumerate(comparison.stems, start=2):
            heading = table.horizontalHeaderItem(j)
            assert heading is not None
            heading.setToolTip(stem)
        table.verticalHeader().hide()
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for i, row in enumerate(found):
            cells = (row.name, row.difference, row.first_error, row.second_error)
            for j, text in enumerate(cells):
                item = QTableWidgetItem(text)
                if j > 0:
                    item.setTextAlignment(right)
                table.setItem(i, j, item)
        if not any(comparison.errors_mm):
            table.hideColumn(2)
            table.hideColumn(3)
        return table

    def copy(self) -> None:
        """Copy the table as tab-separated text, for a spreadsheet."""
        lines = []
        for i in range(self.table.rowCount()):
            items = [self.table.item(i, j) for j in range(self.table.columnCount())]
            lines.append("\t".join(item.text() if item else "" for item in items))
        QGuiApplication.clipboard().setText("\n".join(lines))


class ComparingHost(ErrorSignal, RunState, Protocol):
    """What comparisons use of the engine host."""


class Comparing(QObject):
    """Runs both comparisons as jobs; ``ended`` after each, also after a failure."""

    replay = Signal(object)  # the path to replay
    second_named = Signal(str)  # name of the second hand in the replay
    ended = Signal()

    def __init__(self, host: ComparingHost, tasks: TaskOwner, parent: QWidget) -> None:
        super().__init__(parent)
        self._host, self._tasks, self._window = host, tasks, parent
        self._player: Player | None = None
        self._pair: tuple[Path, Path] | None = None  # a session, and the one to compare it with
        self._second = ""  # name of the second one
        self._shift = 0.0  # s by which the clock of the second is ahead
        self._takes: TwoRecordingsDialog | None = None

    def set_player(self, player: Player | None) -> None:
        """Set the open replay."""
        self._player = player
        self._show_reference()

    def track_again(self, source: Path, wanted: TrackOptions) -> None:
        """Track ``source`` in the background; then show and compare both."""
        try:
            out = free_name(source, wanted.engine)
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            return
        title = self.tr("Tracking {} again").format(source.name)
        self._run(title, track_job(source, out, wanted))

    def compare(self, first: Path, second: Path) -> None:
        self._run(self.tr("Comparing"), compare_job(first, second))

    def side_by_side(self, first: Path, second: Path) -> None:
        """Align two recordings in time and show the second hand in the replay of the first."""
        title = self.tr("Reading two recordings")
        self._tasks.run(title, two_recordings_job(first, second), self._show_takes, self.ended.emit)

    def _show_takes(self, takes: TwoRecordings) -> None:
        dialog = TwoRecordingsDialog(takes, self._window)
        self._takes = dialog
        dialog.destroyed.connect(self._takes_closed)
        self._pair = (takes.first.path, takes.second.path)
        self._second = takes.second.path.stem
        self._move(self._takes.takes.by_clock or 0.0)
        dialog.moved.connect(self._move)
        dialog.seek_requested.connect(self._seek)
        dialog.show()
        if self._player is None or self._player.path != takes.first.path:
            self.replay.emit(takes.first.path)

    def _takes_closed(self) -> None:
        self._takes = None

    def shut_down(self) -> None:
        """Close the dialog, which reads files."""
        if self._takes is not None:
            self._takes.close()

    def _move(self, offset: float) -> None:
        if self._takes is not None:
            self._shift = self._takes.takes.shift(offset)
            self._show_reference()

    def _seek(self, position: float) -> None:
        if self._player is not None and self._shows_pair():
            self._player.seek(position)

    def follow(self) -> None:
        """Move the position line of the dialog with the replay."""
        if self._takes is not None and self._shows_pair() and self._player is not None:
            self._takes.show_position(self._player.position)

    def _shows_pair(self) -> bool:
        """Whether the first of the two is being replayed."""
        pair, player = self._pair, self._player
        return pair is not None and player is not None and player.path == pair[0]

    def _run(self, title: str, job: Job) -> None:
        self._tasks.run(title, job, self._show, self.ended.emit)

    def _show(self, comparison: Comparison | None) -> None:
        """Show the results in a dialog, and the second hand in the replay."""
        if comparison is None:
            return
        CompareDialog(comparison, self._window).show()
        self._pair, self._shift = (comparison.first, comparison.second), 0.0
        self._second = comparison.names[1]
        if self._player is not None and self._player.path == comparison.first:
            self._show_reference()
        elif not self._host.running or self._player is not None:
            self.replay.emit(comparison.first)

    def _show_reference(self) -> None:
        if self._player is None or self._pair is None or self._pair[0] != self._player.path:
            return
        try:
            self._player.set_reference(self._pair[1], self._shift)
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
        else:
            self.second_named.emit(self._second)
