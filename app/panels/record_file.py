"""The button that says where the Isaac record is written, and chooses another place."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QPushButton, QWidget

from app.jobs.outputs import Outputs

WIDTH = 90
"""px of a file's name."""


class RecordFile(QPushButton):
    """Follows what the outputs have."""

    def __init__(self, outputs: Outputs, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._outputs = outputs
        self.setAccessibleName(self.tr("File of the Isaac record"))
        self.clicked.connect(self._choose)
        outputs.changed.connect(self._show)
        self._show()

    def _choose(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self,
            self.tr("File of the Isaac record"),
            str(self._outputs.isaac_file),
            self.tr("Hand records (*.mcap)"),
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        if path:
            self._outputs.set_file(Path(path).with_suffix(".mcap"))
            self._show()

    def _show(self) -> None:
        path = self._outputs.isaac_file
        middle = Qt.TextElideMode.ElideMiddle
        self.setText(self.fontMetrics().elidedText(path.name, middle, WIDTH))
        told = self.tr("{}; where that is there already a number is added")
        self.setToolTip(told.format(path))
