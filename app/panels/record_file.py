"""The button that shows which file a stream writes to, and selects another one."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QPushButton, QWidget

from app.jobs.outputs import Outputs
from app.words import tr

WIDTH = 90
"""px of a file's name."""


class RecordFile(QPushButton):
    """Shows the file of the stream ``name``."""

    def __init__(self, outputs: Outputs, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._outputs, self._name = outputs, name
        self._title = self.tr("File of {}").format(tr(outputs.kinds[name].title))
        self._suffix = Path(outputs.kinds[name].default_file).suffix
        self.setAccessibleName(self._title)
        self.clicked.connect(self._choose)
        outputs.changed.connect(self._show)
        self._show()

    def _choose(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self,
            self._title,
            str(self._outputs.file(self._name)),
            self.tr("Hand records (*{})").format(self._suffix),
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        if path:
            chosen = Path(path).with_suffix(self._suffix)
            self._outputs.set_option(self._name, "file", str(chosen))
            self._show()

    def _show(self) -> None:
        path = self._outputs.file(self._name)
        middle = Qt.TextElideMode.ElideMiddle
        self.setText(self.fontMetrics().elidedText(path.name, middle, WIDTH))
        self.setToolTip(self.tr("{}; where that is there already a number is added").format(path))
