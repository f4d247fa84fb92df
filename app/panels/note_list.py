"""The notes of the recording under way, to be corrected or taken back."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.engines.notes import Notes
from app.engines.recording import Recording
from app.viewmodels.recording import position_text

LEAST_HEIGHT = 110  # px: a heading and two notes


class NoteList(QTableWidget):
    """Double-click changes the text, Delete takes the note back."""

    removed = Signal(str, object)  # a sentence, and what undoes it

    def __init__(self, notes: Notes, recording: Recording, parent: QWidget | None = None) -> None:
        super().__init__(0, 2, parent)
        self._notes, self._recording = notes, recording
        self._numbers: list[int] = []
        self.setHorizontalHeaderLabels([self.tr("At"), self.tr("Note")])
        self.horizontalHeader().setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self.verticalHeader().hide()
        self.setMinimumHeight(LEAST_HEIGHT)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setAccessibleName(self.tr("Notes of this recording"))
        self.setToolTip(self.tr("Double-click to change a note, Delete to take it back"))
        self.itemChanged.connect(self._edited)
        notes.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.blockSignals(True)
        self._numbers = list(self._notes.standing)
        self.setRowCount(len(self._numbers))
        for row, number in enumerate(self._numbers):
            note = self._notes.standing[number]
            at = QTableWidgetItem(position_text(note.t - self._recording.begun_at))
            at.setFlags(at.flags() & ~Qt.ItemFlag.ItemIsEditable)
            self.setItem(row, 0, at)
            self.setItem(row, 1, QTableWidgetItem(note.text))
        self.blockSignals(False)
        self.setVisible(bool(self._numbers))
        self.scrollToBottom()

    def _edited(self, item: QTableWidgetItem) -> None:
        self._notes.change(self._numbers[item.row()], item.text().strip())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        row = self.currentRow()
        if event.key() == Qt.Key.Key_Delete and 0 <= row < len(self._numbers):
            self.delete(row)
        else:
            super().keyPressEvent(event)

    def delete(self, row: int) -> None:
        """Take back the note in a row."""
        number = self._numbers[row]
        text = self._notes.standing[number].text
        undo = self._notes.delete(number)
        if undo is not None:
            self.removed.emit(self.tr("The note “{}” was deleted.").format(text), undo)
