"""The table of recorded sessions: image, name, length, integrity, quality and tags."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QItemSelection, QItemSelectionModel, QSize, Qt
from PySide6.QtGui import QIcon, QImage, QKeyEvent, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.viewmodels.library import THUMBNAIL_WIDTH, Details, SessionRow

ROW_HEIGHT = 40
QUALITY, TAGS = 5, 6
WIDTHS = (260, 130, 70, 80, 110, 200, 140)  # px, until the user changes them
NARROWEST = 48  # px
LEAST_HEIGHT = 72  # px: heading and one session


class SessionTable(QTableWidget):
    """`show_rows` replaces all rows; `show_details` adds details as they become available."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, len(WIDTHS), parent)
        self._rows: list[SessionRow] = []
        self._pending_selection: set[Path] = set()  # to be selected once they are listed
        self._no_image = QIcon(no_image())
        self.setHorizontalHeaderLabels(
            [
                self.tr("Session"),
                self.tr("Recorded"),
                self.tr("Length"),
                self.tr("Size"),
                self.tr("File"),
                self.tr("Quality"),
                self.tr("Tags"),
            ]
        )
        vertical = self.verticalHeader()
        vertical.hide()
        vertical.setDefaultSectionSize(ROW_HEIGHT)
        self.setIconSize(QSize(THUMBNAIL_WIDTH, ROW_HEIGHT - 4))
        self.setShowGrid(False)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)  # names often differ only at their ends
        self.setMinimumHeight(LEAST_HEIGHT)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setMinimumSectionSize(NARROWEST)
        header.setStretchLastSection(True)
        self._wanted = ""
        self.set_widths(WIDTHS)
        self.setAccessibleName(self.tr("Recorded sessions"))

    def set_widths(self, widths: Sequence[int]) -> None:
        """Set the column widths, px; use the defaults if the number of columns differs. The last
        column takes the remaining width, so that the table does not scroll sideways in a narrower
        window."""
        good = len(widths) == len(WIDTHS) and all(NARROWEST <= w <= 2000 for w in widths)
        for column, width in enumerate((widths if good else WIDTHS)[:-1]):
            self.setColumnWidth(column, width)
        self.setColumnWidth(len(WIDTHS) - 1, NARROWEST)

    def widths(self) -> list[int]:
        return [self.columnWidth(column) for column in range(self.columnCount())]

    def show_only(self, words: str) -> None:
        """Hide sessions that do not contain all these words."""
        self._wanted = words
        for i in range(len(self._rows)):
            self._show_or_hide(i)

    def _show_or_hide(self, i: int) -> None:
        quality = self.item(i, QUALITY)
        is_match = self._rows[i].matches(self._wanted, quality.text() if quality else "")
        self.setRowHidden(i, not is_match)

    def show_rows(self, rows: Sequence[SessionRow], known: dict[Path, Details]) -> None:
        """``known``: details found earlier. The selection is preserved where possible.

        If all selected sessions are gone, nothing is selected: the next key would otherwise act on
        a session that the user has not selected. The first listing selects the newest.
        """
        first = not self._rows
        before = self._pending_selection or {row.path for row in self.selected()}
        self._rows = list(rows)
        self.clearSelection()
        self.setRowCount(len(rows))
        for i, row in enumerate(rows):
            integrity = f"{row.look.sign} {row.integrity}"
            cells = (row.name, row.when, row.duration, row.size, integrity, "")
            for j, text in enumerate((*cells, ", ".join(row.tags))):
                item = QTableWidgetItem(text)
                item.setToolTip(row.problem or str(row.path))
                if j == 0:
                    item.setIcon(self._no_image)
                self.setItem(i, j, item)
            if row.path in known:
                self.show_details(row.path, known[row.path])
            self._show_or_hide(i)
        again = [i for i, row in enumerate(rows) if row.path in before]
        is_requested = bool(self._pending_selection)
        if again:
            self._pending_selection = set()
        seen = [i for i in range(len(rows)) if not self.isRowHidden(i)]
        self._select(again if before or not first else seen[:1])
        if is_requested and again:
            self._scroll_to(again[0])

    def choose(self, path: Path) -> None:
        """Select this session, now or when `show_rows` lists it."""
        self.choose_all([path])

    def choose_all(self, paths: Collection[Path]) -> None:
        """Select these sessions, now or when `show_rows` lists them."""
        rows = [i for i, row in enumerate(self._rows) if row.path in paths]
        self._pending_selection = set() if len(rows) == len(paths) else set(paths)
        if rows and not self._pending_selection:
            self._select(rows)
            self._scroll_to(rows[0])

    def _select(self, rows: Sequence[int]) -> None:
        """Select all of them; `selectRow` would select only the last one."""
        model, chosen = self.selectionModel(), QItemSelection()
        for i in rows:
            index = self.model().index(i, 0)
            chosen.select(index, index)
        flags = QItemSelectionModel.SelectionFlag
        model.select(chosen, flags.ClearAndSelect | flags.Rows)
        if rows:
            model.setCurrentIndex(self.model().index(rows[0], 0), flags.NoUpdate)

    def _scroll_to(self, row: int) -> None:
        """Scroll to a session that was requested; otherwise the newest stays on top."""
        self.scrollTo(self.model().index(row, 0))

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
            name.setIcon(QIcon(pixmap(details.image)))

    def selected(self) -> list[SessionRow]:
        """The selected rows from top to bottom, without those hidden by the search."""
        chosen = sorted({index.row() for index in self.selectedIndexes()})
        chosen = [i for i in chosen if not self.isRowHidden(i)]
        return [self._rows[i] for i in chosen if i < len(self._rows)]

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Replay on Enter, as on a double-click."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentRow() >= 0:
            self.cellDoubleClicked.emit(self.currentRow(), 0)
        else:
            super().keyPressEvent(event)


def no_image() -> QPixmap:
    """Placeholder without an image, so that all names are aligned."""
    pixmap = QPixmap(THUMBNAIL_WIDTH, ROW_HEIGHT - 4)
    pixmap.fill(Qt.GlobalColor.transparent)
    return pixmap


def pixmap(image: NDArray[np.uint8]) -> QPixmap:
    """A pixmap of a BGR image (h, w, 3)."""
    height, width = image.shape[:2]
    pixels = np.ascontiguousarray(image)
    shown = QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_BGR888)
    return QPixmap.fromImage(shown.copy())
