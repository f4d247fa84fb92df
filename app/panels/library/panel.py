"""Recorded sessions: look, replay, track again, compare, export, recover."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QTabWidget, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup, Player
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.jobs.export import ExportQueue, ExportRequest
from app.jobs.offline_tracking import compare_job, free_name, track_job
from app.jobs.recovery import recover_job
from app.panels.library.compare_dialog import CompareDialog
from app.panels.library.export_dialog import ExportDialog
from app.panels.library.export_list import ExportList
from app.panels.library.session_table import SessionTable
from app.panels.library.track_dialog import TrackDialog
from app.panels.library.transport import TransportBar
from app.panels.panel import Panel
from app.platform.tasks import Job, JobProgress, RunningJob, TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.viewmodels.compare import Comparison
from app.viewmodels.library import Details, SessionRow, look_inside, scan
from tracker.errors import GlovetrackError
from tracker.offline.options import TrackOptions


class LibraryPanel(Panel):
    name = "library"
    period = 0.05
    replay = Signal(object)  # Path
    compared = Signal(object)  # Comparison; its second tracking is shown in the replay

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(host, parent)
        self._store, self._tasks = store, tasks
        self._details: dict[tuple[Path, tuple[int, int]], Details] = {}
        self._looking: RunningJob | None = None
        self._player: Player | None = None
        self._reference: tuple[Path, Path] | None = None  # a session, and what to show beside it
        self.exports = ExportQueue(tasks, self)
        self.transport = TransportBar()
        self.table = SessionTable()
        self.table.cellDoubleClicked.connect(lambda _row, _column: self.replay_selected())
        self.table.itemSelectionChanged.connect(self._enable)
        self.tabs = QTabWidget()
        self.tabs.setDocumentMode(True)
        self.tabs.addTab(self._sessions(), self.tr("Sessions"))
        self.tabs.addTab(ExportList(self.exports), self.tr("Exports"))
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 4, 8, 8)
        column.setSpacing(6)
        column.addWidget(self.tabs, 1)
        column.addWidget(self.transport)
        self._connect()

    def _connect(self) -> None:
        self.exports.changed.connect(self._name_exports)
        self.host.opened.connect(self._opened)
        self.host.closed.connect(lambda: self._set_player(None))
        self.host.recording.changed.connect(lambda on: None if on else self.rescan())
        self._enable()

    def title(self) -> str:
        return self.tr("Library && replay")

    def _sessions(self) -> QWidget:
        page = QWidget()
        column = QVBoxLayout(page)
        column.setContentsMargins(0, 6, 0, 0)
        column.addWidget(self.table, 1)
        row = QHBoxLayout()
        self.buttons: dict[str, QPushButton] = {}
        for key, text, slot in (
            ("replay", self.tr("Replay"), self.replay_selected),
            ("track", self.tr("Track again…"), self.ask_track),
            ("compare", self.tr("Compare"), self.compare_selected),
            ("export", self.tr("Export…"), self.ask_export),
            ("recover", self.tr("Recover"), self.recover_selected),
            ("refresh", self.tr("Refresh"), self.rescan),
        ):
            self.buttons[key] = QPushButton(text)
            self.buttons[key].clicked.connect(slot)
            row.addWidget(self.buttons[key])
        self.buttons["compare"].setToolTip(self.tr("Choose two sessions of one movement"))
        row.addStretch(1)
        column.addLayout(row)
        return page

    def _enable(self) -> None:
        rows = self.table.selected()
        one = len(rows) == 1
        for key, on in (
            ("replay", one),
            ("track", one),
            ("compare", len(rows) == 2),
            ("export", bool(rows)),
            ("recover", one and rows[0].recoverable),
        ):
            self.buttons[key].setEnabled(on)

    def _name_exports(self) -> None:
        waiting = sum(i.open for i in self.exports.items)
        self.tabs.setTabText(
            1, self.tr("Exports ({})").format(waiting) if waiting else self.tr("Exports")
        )

    # --- sessions

    def rescan(self) -> None:
        """Look into the folder again, in the background."""
        folder = sessions_folder(self._store.value)
        request = self.host.recording.request
        recording = request.path if request is not None else None
        self._tasks.run(
            self.tr("Reading the library"),
            lambda progress: scan(folder, progress, recording),
            self.show_rows,
        )

    def show_rows(self, rows: list[SessionRow]) -> None:
        known = {r.path: d for r in rows if (d := self._details.get((r.path, r.stamp)))}
        self.table.show_rows(rows, known)
        self._enable()
        new = [r for r in rows if r.path not in known and not r.problem]
        if new:
            self._look_inside(new)

    def _look_inside(self, rows: list[SessionRow]) -> None:
        """Thumbnails and quality, one file after the other; an earlier look is ended."""
        if self._looking is not None:
            self._looking.cancel()

        def found(row: SessionRow, details: Details) -> None:
            self._details[row.path, row.stamp] = details

        def job(progress: JobProgress) -> None:
            look_inside(rows, found, progress)

        self._looking = self._tasks.run(
            self.tr("Looking into sessions"),
            job,
            ended=lambda: self._show_details(rows),
            progressed=lambda _share, _name: self._show_details(rows),
        )

    def _show_details(self, rows: list[SessionRow]) -> None:
        for row in rows:
            details = self._details.get((row.path, row.stamp))
            if details is not None:
                self.table.show_details(row.path, details)

    def selected(self) -> SessionRow | None:
        """The first of the selected sessions."""
        return next(iter(self.table.selected()), None)

    def replay_selected(self) -> None:
        row = self.selected()
        if row is None:
            return
        if row.problem:
            self.host.error.emit(row.problem)
        else:
            self.replay.emit(row.path)

    # --- exports

    def ask_export(self) -> None:
        rows = self.table.selected()
        if not rows:
            self.host.error.emit(self.tr("Choose a session in the library to export it."))
            return
        part = self.transport.range() if [r.path for r in rows] == [self._replayed()] else None
        dialog = ExportDialog([r.path for r in rows], part, self)
        dialog.wanted.connect(self.add_export)
        dialog.open()

    def _replayed(self) -> Path | None:
        return self._player.path if self._player is not None else None

    def add_export(self, request: ExportRequest) -> None:
        """Queue an export; the tab shows it and can cancel it."""
        self.exports.add(request)
        self.tabs.setCurrentIndex(1)

    def export(self, source: Path, form: str, target: Path) -> None:
        """Export a whole session as the format usually is."""
        self.add_export(ExportRequest(source, form, target))

    # --- track again, compare, recover

    def ask_track(self) -> None:
        row = self.selected()
        path = row.path if row is not None else self._replayed()
        if path is None:
            self.host.error.emit(self.tr("Choose a session in the library to track it again."))
            return
        dialog = TrackDialog(path, self)
        dialog.wanted.connect(self.track_again)
        dialog.open()

    def track_again(self, source: Path, wanted: TrackOptions) -> None:
        """Track ``source`` in the background; then both are shown and compared."""
        try:
            out = free_name(source, wanted.engine)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        title = self.tr("Tracking {} again").format(source.name)
        self._run(title, track_job(source, out, wanted))

    def compare_selected(self) -> None:
        """Compare the two selected sessions, the older one first."""
        rows = self.table.selected()
        if len(rows) == 2:
            job = compare_job(rows[1].path, rows[0].path)
            self._run(self.tr("Comparing"), job)

    def _run(self, title: str, job: Job) -> None:
        self._tasks.run(title, job, self._show_comparison, self.rescan)

    def _show_comparison(self, comparison: Comparison | None) -> None:
        """Figures in a dialog, the second hand beside the first one in the replay."""
        if comparison is None:
            return
        CompareDialog(comparison, self).show()
        self._reference = (comparison.first, comparison.second)
        if self._replayed() == comparison.first:
            self._show_reference()
        elif not self.host.running or self._player is not None:
            self.replay.emit(comparison.first)
        self.compared.emit(comparison)

    def _show_reference(self) -> None:
        if (
            self._player is None
            or self._reference is None
            or self._reference[0] != self._player.path
        ):
            return
        try:
            self._player.set_reference(self._reference[1])
        except GlovetrackError as error:
            self.host.error.emit(str(error))

    def recover_selected(self) -> None:
        """Make a whole file of one that was cut off; the original stays."""
        row = self.selected()
        if row is not None:
            self._tasks.run(
                self.tr("Recovering {}").format(row.name), recover_job(row.path), ended=self.rescan
            )

    # --- replay

    def _opened(self, setup: EngineSetup) -> None:
        self._set_player(setup.player)
        self._show_reference()
        self.rescan()

    def _set_player(self, player: Player | None) -> None:
        self._player = player
        self.transport.set_player(player)

    def refresh(self, view: Snapshot | None) -> None:
        self.transport.refresh()
