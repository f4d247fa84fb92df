"""Exports: asked for in a dialog, done one after the other, shown in a list."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.jobs.export import ExportQueue, ExportRequest
from app.panels.library.export_dialog import ExportDialog
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore


class Exporting(QObject):
    """``begun`` when an export was put in the queue."""

    begun = Signal()

    def __init__(self, tasks: TaskOwner, store: SettingsStore, parent: QWidget) -> None:
        super().__init__(parent)
        self._store, self._window = store, parent
        self.queue = ExportQueue(tasks, self)

    def ask(self, paths: list[Path], part: tuple[float, float] | None) -> None:
        """Ask how; ``part`` of the one session that is replayed is offered."""
        dialog = ExportDialog(paths, part, self._store, self._window)
        dialog.wanted.connect(self.add)
        dialog.open()

    def add(self, request: ExportRequest) -> None:
        self.queue.add(request)
        self.begun.emit()
