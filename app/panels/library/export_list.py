"""The export queue: a row for each export with its progress and a button to cancel it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QProgressBar,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.jobs.export import ExportQueue, ExportRequest, QueueItem
from app.panels.library.export_dialog import ExportDialog, ExportSettings
from app.panels.library.session_files import open_folder
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsOf
from app.widgets.measures import TIGHT
from app.widgets.one_line import OneLine
from app.words import tr


class ExportList(QWidget):
    """Shows an `ExportQueue`. ``head``: its buttons, which the caller places."""

    def __init__(self, queue: ExportQueue, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._queue = queue
        self._shown: list[QueueItem] = []
        self.table = QTableWidget(0, 3)
        self.table.setHorizontalHeaderLabels(
            [self.tr("File"), self.tr("State"), self.tr("Progress")]
        )
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.cancel_button = QPushButton(self.tr("Cancel the export"))
        self.cancel_button.clicked.connect(self.cancel_selected)
        clear = QPushButton(self.tr("Clear finished"))
        clear.clicked.connect(queue.forget_ended)
        self.folder_button = QPushButton(self.tr("Open folder"))
        self.folder_button.clicked.connect(self.show_folder)
        self.head = OneLine()
        for button in (self.cancel_button, clear, self.folder_button):
            self.head.add(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, TIGHT, 0, 0)
        column.addWidget(self.table)
        queue.changed.connect(self._show)
        self.table.itemSelectionChanged.connect(self._enable)
        self._enable()

    def _show(self) -> None:
        if self._shown != self._queue.items:
            self._shown = list(self._queue.items)
            self._rebuild()
        for i, item in enumerate(self._shown):
            state, bar = self.table.item(i, 1), self.table.cellWidget(i, 2)
            if state is not None and isinstance(bar, QProgressBar):
                state.setText(f"{item.look.sign} {tr(item.look.word)}")
                state.setToolTip(item.problem)
                bar.setValue(round(100 * (1.0 if item.look.word == "done" else item.share)))
        self._enable()

    def _rebuild(self) -> None:
        self.table.setRowCount(len(self._shown))
        for i, item in enumerate(self._shown):
            name = QTableWidgetItem(item.request.target.name)
            name.setToolTip(str(item.request.target))
            self.table.setItem(i, 0, name)
            self.table.setItem(i, 1, QTableWidgetItem())
            bar = QProgressBar()
            bar.setRange(0, 100)
            bar.setFixedWidth(140)
            self.table.setCellWidget(i, 2, bar)
        if self._shown and self.table.currentRow() < 0:
            self.table.selectRow(len(self._shown) - 1)

    def _selected(self) -> QueueItem | None:
        row = self.table.currentRow()
        return self._shown[row] if 0 <= row < len(self._shown) else None

    def _enable(self) -> None:
        item = self._selected()
        self.cancel_button.setEnabled(item is not None and item.open)
        self.folder_button.setEnabled(item is not None)

    def show_folder(self) -> None:
        """Open the folder of the file in the file manager."""
        item = self._selected()
        if item is not None:
            open_folder(item.request.target.parent)

    def cancel_selected(self) -> None:
        item = self._selected()
        if item is not None:
            self._queue.cancel(item)


class Exporting(QObject):
    """``begun``: an export was added to the queue."""

    begun = Signal()

    def __init__(
        self, tasks: TaskOwner, store: SettingsOf[ExportSettings], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._store, self._window = store, parent
        self.queue = ExportQueue(tasks, self)

    def ask(self, paths: list[Path], part: tuple[float, float] | None) -> None:
        """Ask for the options; ``part`` of the session that is being replayed is offered."""
        dialog = ExportDialog(paths, part, self._store, self._window)
        dialog.wanted.connect(self.add)
        dialog.open()

    def add(self, request: ExportRequest) -> None:
        self.queue.add(request)
        self.begun.emit()
