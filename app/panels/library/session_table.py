"""The table of recorded sessions: image, name, length, integrity and quality."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon, QImage, QKeyEvent, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.viewmodels.library import THUMBNAIL_WIDTH, Details, SessionRow

ROW_HEIGHT = 44
QUALITY = 5


class SessionTable(QTableWidget):
    """Rows are replaced as a whole by `show_rows`; `show_details` fills in what comes later."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 6, parent)
        self._rows: list[SessionRow] = []
        self._no_image = QIcon(_empty())
        self.setHorizontalHeaderLabels(
            [
                self.tr("Session"),
                self.tr("Recorded"),
                self.tr("Length"),
                self.tr("Size"),
                self.tr("File"),
                self.tr("Quality"),
            ]
        )
        vertical = self.verticalHeader()
        vertical.hide()
        vertical.setDefaultSectionSize(ROW_HEIGHT)
        self.setIconSize(QSize(THUMBNAIL_WIDTH, ROW_HEIGHT - 4))
        self.setShowGrid(False)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.setAccessibleName(self.tr("Recorded sessions"))

    def show_rows(self, rows: Sequence[SessionRow], known: dict[Path, Details]) -> None:
        """``known``: what was found inside files earlier. The selection stays where it can."""
        before = {row.path for row in self.selected()}
        self._rows = list(rows)
        self.clearSelection()
        self.setRowCount(len(rows))
        for i, row in enumerate(rows):
            integrity = f"{row.look.sign} {row.integrity}"
            for j, text in enumerate((row.name, row.when, row.duration, row.size, integrity, "")):
                item = QTableWidgetItem(text)
                item.setToolTip(row.problem or str(row.path))
                if j == 0:
                    item.setIcon(self._no_image)
                self.setItem(i, j, item)
            if row.path in known:
                self.show_details(row.path, known[row.path])
        again = [i for i, row in enumerate(rows) if row.path in before]
        for i in again or ([0] if rows else []):
            self.selectRow(i)

    def show_details(self, path: Path, details: Details) -> None:
        row = next((i for i, r in enumerate(self._rows) if r.path == path), None)
        if row is None:
            return
        quality, name = self.item(row, QUALITY), self.item(row, 0)
        if quality is None or name is None:
            return
        sign = f"{details.look.sign} " if details.look else ""
        quality.setText(sign + details.quality)
        quality.setToolTip(details.quality)
        if details.image is not None:
            name.setIcon(QIcon(_pixmap(details.image)))

    def selected(self) -> list[SessionRow]:
        """The selected rows from top to bottom."""
        chosen = sorted({index.row() for index in self.selectedIndexes()})
        return [self._rows[i] for i in chosen if i < len(self._rows)]

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter replays, as a double click does."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentRow() >= 0:
            self.cellDoubleClicked.emit(self.currentRow(), 0)
        else:
            super().keyPressEvent(event)


def _empty() -> QPixmap:
    """What stands where there is no image, so that all names begin at one place."""
    pixmap = QPixmap(THUMBNAIL_WIDTH, ROW_HEIGHT - 4)
    pixmap.fill(Qt.GlobalColor.transparent)
    return pixmap


def _pixmap(image: NDArray[np.uint8]) -> QPixmap:
    """Of (h, w, 3) BGR."""
    height, width = image.shape[:2]
    pixels = np.ascontiguousarray(image)
    shown = QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_BGR888)
    return QPixmap.fromImage(shown.copy())
