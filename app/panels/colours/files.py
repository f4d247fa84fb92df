"""Import and export of a colour profile, with the dialogs that ask for the file."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from app.viewmodels.colour_tuning import ColourTuning
from tracker.base.errors import GlovetrackError


class ColoursFiles(QObject):
    """Reads into ``tuning`` (``loaded`` says so) and writes from it (``saved``)."""

    loaded = Signal()
    saved = Signal()
    failed = Signal(str)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._parent = parent
        self.tuning: ColourTuning | None = None

    def ask_load(self) -> None:
        title = self.tr("Colour profile")
        path, _ = QFileDialog.getOpenFileName(self._parent, title, "", "*.toml")
        if path:
            self.load(Path(path))

    def ask_save(self) -> None:
        title = self.tr("Export the colours")
        path, _ = QFileDialog.getSaveFileName(self._parent, title, "colours.toml", "*.toml")
        if path:
            chosen = Path(path)
            self.save(chosen if chosen.suffix else chosen.with_suffix(".toml"))

    def load(self, path: Path) -> None:
        if self.tuning is None:
            return
        try:
            self.tuning.load(path)
        except GlovetrackError as error:
            self.failed.emit(str(error))
        else:
            self.loaded.emit()

    def save(self, path: Path) -> None:
        if self.tuning is None:
            return
        try:
            self.tuning.save(path)
        except GlovetrackError as error:
            self.failed.emit(str(error))
        else:
            self.saved.emit()
