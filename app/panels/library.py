"""Recorded sessions: look, replay, export."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QSlider,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engine import EngineSetup, Player
from app.export import FORMATS, export_job
from app.panels.panel import Panel
from app.session import Session
from app.settings import SettingsStore, sessions_folder
from app.tasks import TaskOwner
from app.viewmodels.library import SessionRow, scan
from app.viewmodels.recording import duration_text
from app.viewmodels.snapshot import Snapshot

TICKS = 1000
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)


class LibraryPanel(Panel):
    name = "library"
    period = 0.1
    replay = Signal(object)  # Path

    def __init__(
        self,
        session: Session,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(session, parent)
        self._store, self._tasks = store, tasks
        self._rows: list[SessionRow] = []
        self._player: Player | None = None
        self.table = self._table()
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(6)
        column.addWidget(self.table, 1)
        column.addLayout(self._buttons())
        column.addLayout(self._transport())
        session.opened.connect(self._opened)
        session.closed.connect(lambda: self._set_player(None))
        session.recording_changed.connect(lambda on: None if on else self.rescan())
        self._set_player(None)

    def title(self) -> str:
        return self.tr("Library && replay")

    def _table(self) -> QTableWidget:
        table = QTableWidget(0, 5)
        table.setHorizontalHeaderLabels(
            [
                self.tr("Session"),
                self.tr("Recorded"),
                self.tr("Length"),
                self.tr("Size"),
                self.tr("File"),
            ]
        )
        table.verticalHeader().hide()
        table.setShowGrid(False)
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        table.cellDoubleClicked.connect(lambda _row, _column: self._replay())
        return table

    def _buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        for text, slot in (
            (self.tr("Replay"), self._replay),
            (self.tr("Export…"), self.ask_export),
            (self.tr("Refresh"), self.rescan),
        ):
            button = QPushButton(text)
            button.clicked.connect(slot)
            row.addWidget(button)
        self.format = QComboBox()
        self.format.addItems(FORMATS)
        self.format.setAccessibleName(self.tr("Export format"))
        row.insertWidget(2, self.format)
        row.addStretch(1)
        return row

    def _transport(self) -> QHBoxLayout:
        self.play_button = QPushButton(self.tr("Pause"))
        self.play_button.clicked.connect(self._toggle)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, TICKS)
        self.slider.setAccessibleName(self.tr("Position"))
        self.slider.sliderMoved.connect(self._seek)
        self.position = QLabel("–")
        self.position.setMinimumWidth(90)
        self.speed = QComboBox()
        for speed in SPEEDS:
            self.speed.addItem(f"{speed:g}×", speed)
        self.speed.setCurrentIndex(SPEEDS.index(1.0))
        self.speed.currentIndexChanged.connect(self._set_speed)
        row = QHBoxLayout()
        row.addWidget(self.play_button)
        row.addWidget(self.slider, 1)
        row.addWidget(self.position)
        row.addWidget(self.speed)
        return row

    # --- sessions

    def rescan(self) -> None:
        """Look into the folder again, in the background."""
        folder = sessions_folder(self._store.value)
        self._tasks.run(
            self.tr("Reading the library"), lambda progress: scan(folder, progress), self.show_rows
        )

    def show_rows(self, rows: list[SessionRow]) -> None:
        self._rows = rows
        self.table.setRowCount(len(rows))
        for i, row in enumerate(rows):
            integrity = f"{row.look.sign} {row.integrity}"
            for j, text in enumerate((row.name, row.when, row.duration, row.size, integrity)):
                item = QTableWidgetItem(text)
                item.setToolTip(row.problem or str(row.path))
                self.table.setItem(i, j, item)
        if rows:
            self.table.selectRow(0)

    def selected(self) -> SessionRow | None:
        row = self.table.currentRow()
        return self._rows[row] if 0 <= row < len(self._rows) else None

    def _replay(self) -> None:
        row = self.selected()
        if row is None:
            return
        if row.problem:
            self.session.error.emit(row.problem)
        else:
            self.replay.emit(row.path)

    def ask_export(self) -> None:
        row = self.selected()
        if row is None:
            self.session.error.emit(self.tr("Choose a session in the library to export it."))
            return
        form = self.format.currentText()
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Export"), str(row.path.with_suffix(f".{form}")), f"*.{form}"
        )
        if path:
            self.export(row.path, form, Path(path))

    def export(self, source: Path, form: str, target: Path) -> None:
        """Export in the background; the status bar shows it and can cancel it."""
        title = self.tr("Exporting {}").format(target.name)
        self._tasks.run(title, export_job(source, form, target))

    # --- replay

    def _opened(self, setup: EngineSetup) -> None:
        self._set_player(setup.player)
        self.rescan()

    def _set_player(self, player: Player | None) -> None:
        self._player = player
        for widget in (self.play_button, self.slider, self.speed):
            widget.setEnabled(player is not None)
        self.position.setText("–")

    def _toggle(self) -> None:
        if self._player is not None:
            self._player.play(not self._player.playing)

    def _seek(self, tick: int) -> None:
        if self._player is not None:
            self._player.seek(tick / TICKS * self._player.duration)

    def _set_speed(self, _index: int) -> None:
        if self._player is not None:
            self._player.set_speed(float(self.speed.currentData()))

    def refresh(self, view: Snapshot | None) -> None:
        player = self._player
        if player is None:
            return
        self.play_button.setText(self.tr("Pause") if player.playing else self.tr("Play"))
        text = f"{duration_text(player.position)} / {duration_text(player.duration)}"
        self.position.setText(text)
        if not self.slider.isSliderDown() and player.duration > 0:
            self.slider.setValue(round(player.position / player.duration * TICKS))
