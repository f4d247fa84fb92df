"""The Recording panel: names, file, its size and the space left, and the notes."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Protocol

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import EngineChanges, ErrorSignal, NotesPart, RecordingPart, RunState
from app.engines.notes import Notes
from app.engines.recording import Recording
from app.engines.snapshot import Snapshot
from app.jobs.record_key import RecordKey
from app.panels.panel import Panel
from app.viewmodels.recording import (
    COUNTDOWNS,
    RateMeter,
    RecordingPlan,
    disk,
    duration_text,
    free_bytes,
    losses_text,
    position_text,
    size_text,
)
from app.widgets.measures import APART
from app.words import error_text
from tracker.base.errors import ConfigError

LEAST_HEIGHT = 110  # px: heading and two notes


class NoteList(QTableWidget):
    """A double-click edits a note, Delete removes it."""

    removed = Signal(str, object)  # a message, and a function that undoes the removal

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
        self.setToolTip(self.tr("Double-click a note to edit it; press Delete to remove it"))
        self.itemChanged.connect(self._edited)
        notes.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.blockSignals(True)
        self._numbers = list(self._notes.current)
        self.setRowCount(len(self._numbers))
        for row, number in enumerate(self._numbers):
            note = self._notes.current[number]
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
        """Remove the note in a row."""
        number = self._numbers[row]
        text = self._notes.current[number].text
        undo = self._notes.delete(number)
        if undo is not None:
            self.removed.emit(self.tr("The note “{}” was deleted.").format(text), undo)


class RecordingHost(EngineChanges, ErrorSignal, NotesPart, RecordingPart, RunState, Protocol):
    """What the panel uses of the engine host."""


class RecordingPanel(Panel):
    period = 0.5

    def __init__(
        self,
        host: RecordingHost,
        plan: RecordingPlan,
        key: RecordKey,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._plan, self._key = plan, key
        self._rate, self._messages = RateMeter(), RateMeter()
        column = QVBoxLayout(self)
        column.setContentsMargins(APART, APART, APART, APART)
        column.setSpacing(APART)
        column.addLayout(self._buttons())  # on top: visible in the lowest dock
        column.addLayout(self._form())
        self.notes = NoteList(host.notes, host.recording)
        column.addWidget(self.notes)
        column.addLayout(self._figures())
        column.addStretch(1)
        host.recording.changed.connect(self._recording_changed)
        host.running_changed.connect(lambda _on: self._enable())
        host.opened.connect(lambda _setup: self._enable())
        host.closed.connect(self._close)
        key.counted.connect(lambda _left: self._enable())
        self._enable()

    def _form(self) -> QFormLayout:
        plan = self._plan
        self.participant = QLineEdit(plan.participant)
        self.participant.textChanged.connect(self._plan_changed)
        self.participant.setPlaceholderText(self.tr("for example P01"))
        self.task = QLineEdit(plan.task)
        self.task.textChanged.connect(self._plan_changed)
        self.task.setPlaceholderText(self.tr("for example pinch"))
        self.name_template = QLineEdit(plan.template)
        self.name_template.setToolTip(
            self.tr(
                "May contain {participant}, {task}, {date}, {time} and a counter: {n} or {n:03}"
            )
        )
        self.name_template.editingFinished.connect(self._name_edited)
        self.folder = QLineEdit(str(plan.folder))
        self.folder.setReadOnly(True)
        choose = QPushButton(self.tr("Change…"))
        choose.clicked.connect(self._choose_folder)
        row = QHBoxLayout()
        row.addWidget(self.folder, 1)
        row.addWidget(choose)
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
        form.addRow(self.tr("Participant"), self.participant)
        form.addRow(self.tr("Task"), self.task)
        form.addRow(self.tr("File name"), self.name_template)
        form.addRow(self.tr("Folder"), row)
        form.addRow(self.tr("Countdown"), self._countdown())
        return form

    def _countdown(self) -> QHBoxLayout:
        self.countdown = QComboBox()
        for seconds in COUNTDOWNS:
            words = self.tr("{} s").format(seconds) if seconds else self.tr("none")
            self.countdown.addItem(words, seconds)
        self.countdown.setCurrentIndex(self.countdown.findData(self._plan.countdown))
        self.countdown_sound = QCheckBox(self.tr("with a beep"))
        self.countdown_sound.setChecked(self._plan.countdown_sound)
        self.countdown.currentIndexChanged.connect(lambda _i: self._countdown_changed())
        self.countdown_sound.toggled.connect(lambda _on: self._countdown_changed())
        row = QHBoxLayout()
        row.addWidget(self.countdown)
        row.addWidget(self.countdown_sound)
        row.addStretch(1)
        return row

    def _countdown_changed(self) -> None:
        self._plan.set_countdown(self.countdown.currentData(), self.countdown_sound.isChecked())

    def _buttons(self) -> QHBoxLayout:
        self.record_button = QPushButton(self.tr("Record"))
        self.record_button.setProperty("role", "primary")
        self.record_button.clicked.connect(self.toggle)
        self.pause_button = QPushButton(self.tr("Pause"))
        self.pause_button.setCheckable(True)
        self.pause_button.clicked.connect(self.host.recording.pause)
        self.note_text = QLineEdit()
        self.note_text.setPlaceholderText(self.tr("Note (Enter adds it)"))
        self.note_text.returnPressed.connect(self._note)
        self.note_text.textEdited.connect(self._note_begun)
        self._note_t: float | None = None  # time at which its first character was typed
        row = QHBoxLayout()
        row.addWidget(self.record_button)
        row.addWidget(self.pause_button)
        row.addWidget(self.note_text, 1)
        return row

    def _figures(self) -> QFormLayout:
        self.file_label = QLabel("–")
        self.file_label.setWordWrap(True)
        self.time_label = QLabel("–")
        self.size_label = QLabel("–")
        self.messages_label = QLabel("–")
        self.losses_label = QLabel("–")
        self.disk_label = QLabel("–")
        for label in (self.size_label, self.messages_label, self.losses_label, self.disk_label):
            label.setWordWrap(True)
        self.warning = QLabel()
        self.warning.setProperty("role", "warning")
        self.warning.hide()
        form = QFormLayout()
        form.addRow(self.tr("File"), self.file_label)
        form.addRow(self.tr("Time"), self.time_label)
        form.addRow(self.tr("Size"), self.size_label)
        form.addRow(self.tr("Messages"), self.messages_label)
        form.addRow(self.tr("Losses"), self.losses_label)
        form.addRow(self.tr("Disk"), self.disk_label)
        form.addRow(self.warning)
        return form

    # --- actions of the user

    def toggle(self) -> None:
        """Start or stop a recording, as the key does."""
        self._key.press()

    def _plan_changed(self) -> None:
        self._plan.participant, self._plan.task = self.participant.text(), self.task.text()

    def _name_edited(self) -> None:
        try:
            self._plan.set_template(self.name_template.text().strip())
        except ConfigError as error:
            self.host.error.emit(error_text(error))
        self.name_template.setText(self._plan.template)

    def _choose_folder(self) -> None:
        folder = QFileDialog.getExistingDirectory(
            self, self.tr("Folder for recordings"), str(self._plan.folder)
        )
        if folder:
            self.set_folder(Path(folder))

    def set_folder(self, folder: Path) -> None:
        self._plan.set_folder(folder)
        self.folder.setText(str(folder))

    def _note(self) -> None:
        text = self.note_text.text().strip()
        if text:
            self.host.notes.add(text, self._note_t)
        self.note_text.clear()
        self._note_t = None

    def _note_begun(self, text: str) -> None:
        if not text:
            self._note_t = None
        elif self._note_t is None:
            self._note_t = self.host.notes.now()

    # --- displayed data

    def _recording_changed(self, on: bool) -> None:
        if not on:
            self._rate, self._messages = RateMeter(), RateMeter()
        self._enable()

    def _close(self) -> None:
        """Clear the values of the last recording."""
        for label in (
            self.file_label,
            self.time_label,
            self.size_label,
            self.messages_label,
            self.losses_label,
        ):
            label.setText("–")
        self._enable()

    def _enable(self) -> None:
        recording = self.host.recording.request is not None
        words = self.tr("Stop") if recording else self.tr("Record")
        if self._key.left:
            words = self.tr("Not now ({})").format(self._key.left)
        self.record_button.setText(words)
        self.record_button.setEnabled(self.host.running and self.host.recording.is_possible)
        self.note_text.setEnabled(self.host.recording.is_possible)
        self.pause_button.setEnabled(recording)
        self.pause_button.setChecked(self.host.recording.paused and recording)
        for field in (self.participant, self.task, self.name_template):
            field.setEnabled(not recording)

    def refresh(self, view: Snapshot | None) -> None:
        request = self.host.recording.request
        rate = self._show_growth(request.path) if request is not None else 0.0
        if request is not None:
            self.losses_label.setText(losses_text(self.host.recording.figures))
        folder = request.path.parent if request is not None else self._plan.folder
        room = disk(free_bytes(folder), rate)
        self.disk_label.setText(room.text)
        self.warning.setText(room.warning)
        self.warning.setVisible(bool(room.warning))
        if room.full and request is not None:
            self.host.recording.end(self.tr("Recording stopped: the disk is nearly full."))

    def _show_growth(self, path: Path) -> float:
        """Show name, duration, size and messages of the file being written; returns its bytes per
        second."""
        size = path.stat().st_size if path.exists() else 0
        now = time.monotonic()
        rate = self._rate.add(now, size)
        messages = self._messages.add(now, self.host.recording.written)
        self.file_label.setText(path.name)
        self.time_label.setText(duration_text(self.host.recording.elapsed))
        self.size_label.setText(f"{size_text(size)}  ({size_text(rate)}/s)")
        self.messages_label.setText(f"{self.host.recording.written}  ({messages:.0f}/s)")
        return rate
