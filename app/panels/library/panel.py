"""The library of recorded sessions: replay, track again, compare, export, recover."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QTabBar, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.host_parts import EngineChanges
from app.engines.protocols import Player
from app.engines.snapshot import Snapshot
from app.panels.command_kind import RecordingAction
from app.panels.library.comparing import Comparing, ComparingHost
from app.panels.library.export_dialog import ExportSettings
from app.panels.library.export_list import Exporting, ExportList
from app.panels.library.gap_page import GapPage, Gaps
from app.panels.library.session_files import FilesHost, SessionFiles, open_folder
from app.panels.library.session_page import SessionPage
from app.panels.library.track_dialog import TrackDialog
from app.panels.library.transport import TransportBar
from app.panels.panel import Panel
from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.storage.settings import FolderSettings, SettingsOf, sessions_folder
from app.viewmodels.library import Details, SessionRow, read_details, scan
from app.widgets.measures import APART, NEAR, TIGHT

LOW = 260  # px, above the minimum height; below it the transport bar is hidden


class Pages(QWidget):
    """Pages whose tabs and controls share one line, which leaves more height for the page."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.bar = QTabBar()
        self.bar.setDocumentMode(True)
        self.bar.setExpanding(False)
        self.bar.setDrawBase(False)
        self._pages, self._heads = QStackedWidget(), QStackedWidget()
        line = QHBoxLayout()
        line.setSpacing(APART)
        line.addWidget(self.bar)
        line.addWidget(self._heads, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(line)
        column.addWidget(self._pages, 1)
        self.bar.currentChanged.connect(self._pages.setCurrentIndex)
        self.bar.currentChanged.connect(self._heads.setCurrentIndex)

    def add(self, page: QWidget, head: QWidget, title: str) -> None:
        """``head``: its controls."""
        self._pages.addWidget(page)
        self._heads.addWidget(head)
        self.bar.addTab(title)

    def page(self, index: int) -> QWidget:
        found = self._pages.widget(index)
        if found is None:
            raise IndexError(index)
        return found


class LibraryHost(ComparingHost, EngineChanges, FilesHost, Protocol):
    """What the library uses of the engine host."""


class LibrarySettings(ExportSettings, FolderSettings, Protocol):
    """The settings of this panel and its dialogs."""

    @property
    def library_columns(self) -> list[int]: ...


class LibraryPanel(Panel):
    period = 0.05
    replay = Signal(object)  # Path
    second_named = Signal(str)  # name of a second tracking that the replay shows

    def __init__(
        self,
        host: LibraryHost,
        store: SettingsOf[LibrarySettings],
        tasks: TaskOwner,
        actions: Mapping[str, RecordingAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store, self._tasks, self._actions = store, tasks, actions
        self._player: Player | None = None
        self.exporting = Exporting(tasks, store, self)
        self.exports = self.exporting.queue
        self.files = SessionFiles(host, tasks, self)
        self._looked = False
        self.transport = TransportBar()
        self.page = SessionPage({name: action.title for name, action in actions.items()})
        self.table, self.buttons = self.page.table, self.page.buttons
        self.table.set_widths(store.value.library_columns)
        self._scan = LibraryScan(tasks, self)
        self._comparing = Comparing(host, tasks, self)
        listed = ExportList(self.exports)
        self.gaps = Gaps(tasks, GapPage(), self)
        self.pages = Pages()
        self.pages.add(self.page, self.page.head, self.tr("Sessions"))
        self.pages.add(listed, listed.head, self.tr("Exports"))
        self.pages.add(self.gaps.page, self.gaps.page.head, self.tr("Gaps"))
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, TIGHT, NEAR, NEAR)
        column.setSpacing(NEAR)
        column.addWidget(self.pages, 1)
        column.addWidget(self.transport)
        self._connect()

    def _connect(self) -> None:
        self.exports.changed.connect(self._name_exports)
        self.exporting.begun.connect(lambda: self.pages.bar.setCurrentIndex(1))
        self.files.renamed.connect(lambda _before, path: self.table.choose(path))
        self.files.restored.connect(self.table.choose_all)
        self.files.changed.connect(self.rescan)
        self.host.opened.connect(self._opened)
        self.host.closed.connect(lambda: self._set_player(None))
        self.host.recording.begun.connect(self.rescan)
        self.host.recording.finished.connect(lambda _path: self.rescan())
        self._scan.stale.connect(self.rescan)
        self._scan.found.connect(self._show_rows)
        self._scan.detailed.connect(self.table.show_details)
        self.page.requested.connect(self._do)
        self._comparing.replay.connect(self.replay)
        self._comparing.second_named.connect(self.second_named)
        self._comparing.ended.connect(self.rescan)
        self.gaps.counted.connect(self._name_gaps)
        self.gaps.made.connect(self.files.made)
        self.gaps.ended.connect(self.rescan)
        self.gaps.page.shown_changed.connect(self.transport.timeline.show_spans)

    def _do(self, requested: str) -> None:
        paths = [row.path for row in self.table.selected()]
        whole_list: dict[str, Callable[[], object]] = {
            "track": self.ask_track,
            "compare": self.compare_selected,
            "beside": partial(self.compare_selected, as_two_recordings=True),
            "export": self.ask_export,
        }
        selected: dict[str, Callable[[], object]] = {
            "replay": self._replay_selected,
            "recover": lambda: self.files.recover(paths[0]),
            "rename": lambda: self.files.ask_name(paths[0]),
            "tags": lambda: self.files.ask_tags(paths),
            "bin": lambda: self.files.bin(paths),
        }
        if requested == "folder":
            open_folder(paths[0].parent if paths else sessions_folder(self._store.value))
        elif requested in whole_list:
            whole_list[requested]()
        elif paths and requested in self._actions:
            self._actions[requested].run(paths)
        elif paths:
            selected[requested]()

    def _name_exports(self) -> None:
        waiting = sum(i.open for i in self.exports.items)
        self.pages.bar.setTabText(
            1, self.tr("Exports ({})").format(waiting) if waiting else self.tr("Exports")
        )

    def _name_gaps(self, count: int) -> None:
        self.pages.bar.setTabText(
            2, self.tr("Gaps ({})").format(count) if count else self.tr("Gaps")
        )

    # --- sessions

    def rescan(self) -> None:
        """Read the folder again in the background."""
        self._looked = True
        self._scan.begin(sessions_folder(self._store.value), self.host.recording.file)

    def showEvent(self, event: QShowEvent) -> None:
        """Read the folder when the panel is shown for the first time."""
        super().showEvent(event)
        if not self._looked:
            self.rescan()

    def _show_rows(self, rows: list[SessionRow], known: dict[Path, Details]) -> None:
        self.table.show_rows(rows, known)
        self.page.enable()

    def selected(self) -> SessionRow | None:
        """The first of the selected sessions."""
        return self.page.selected()

    def _replay_selected(self) -> None:
        row = self.selected()
        if row is None:
            return
        if row.problem:
            self.host.error.emit(row.problem)
        else:
            self.replay.emit(row.path)

    # --- exports

    def ask_export(self, opened_first: bool = False) -> None:
        """The selected sessions, or the open one.

        ``opened_first``: the open one, unless others are selected in the focused list.
        """
        chosen, opened = [row.path for row in self.table.selected()], self._opened_paths()
        first = opened_first and not self.table.hasFocus()
        paths = (opened or chosen) if first else (chosen or opened)
        if not paths:
            self.host.error.emit(self.tr("Select a session in the library to export it."))
            return
        self.ask_export_of(paths)

    def ask_export_of(self, paths: list[Path]) -> None:
        """Show the export dialog, with the selected range of the session that is being replayed."""
        self.exporting.ask(paths, self.transport.range() if paths == self._opened_paths() else None)

    def _opened_paths(self) -> list[Path]:
        return [self._player.path] if self._player is not None else []

    # --- track again, compare, recover

    def ask_track(self) -> None:
        row = self.selected()
        path = row.path if row is not None else next(iter(self._opened_paths()), None)
        if path is None:
            self.host.error.emit(self.tr("Select a session in the library to track it again."))
            return
        dialog = TrackDialog(path, self)
        dialog.wanted.connect(self._comparing.track_again)
        dialog.open()

    def compare_selected(self, as_two_recordings: bool = False) -> None:
        """Compare the two selected sessions, the older one first."""
        rows = self.table.selected()
        if len(rows) != 2:
            self.host.error.emit(self.tr("Select two sessions in the library."))
        elif as_two_recordings:
            self._comparing.side_by_side(rows[1].path, rows[0].path)
        else:
            self._comparing.compare(rows[1].path, rows[0].path)

    # --- replay

    def crop(self) -> None:
        """Create a session of the range between in and out point of the open one."""
        part = self.transport.range()
        if self._player is None or part is None:
            text = self.tr("Mark a range first: press I at its start and O at its end.")
            self.host.error.emit(text)
        else:
            self.files.crop(self._player.path, part)

    def _opened(self, setup: EngineSetup) -> None:
        self._set_player(setup.player)
        if setup.player is not None:
            self.table.choose(setup.player.path)
        self.rescan()

    def _set_player(self, player: Player | None) -> None:
        self._player = player
        self.transport.set_player(player)
        self._comparing.set_player(player)
        self.gaps.set_player(player)

    def refresh(self, view: Snapshot | None) -> None:
        self.transport.put_in_one_line(self.height() < LOW)
        self.transport.refresh()
        self.transport.interpolated.setVisible(self.gaps.is_interpolated)
        self._comparing.follow()

    def shut_down(self) -> None:
        """Store the column widths; stop watching the folder."""
        self._scan.shut_down()
        self._comparing.shut_down()
        self.gaps.shut_down()
        widths = self.table.widths()
        if widths != self._store.value.library_columns:
            self._store.update(library_columns=widths)


# ---- reads the folder of recorded sessions in the background, and watches it

SETTLE_MS = 300  # without changes after which a folder is read again


class LibraryScan(QObject):
    """First reads the index of each file, then thumbnails and quality.

    ``stale``: a file was added, removed or renamed.
    """

    stale = Signal()
    found = Signal(object, object)  # the rows, and `Details` known from earlier scans by path
    detailed = Signal(object, object)  # a path and its `Details`

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._details: dict[tuple[Path, tuple[int, int]], Details] = {}
        self._reading: RunningJob | None = None
        self._request_number = 0
        self._looking: RunningJob | None = None
        self._watcher = QFileSystemWatcher(self)
        self._quiet = QTimer(self, singleShot=True, interval=SETTLE_MS)
        self._watcher.directoryChanged.connect(lambda _path: self._quiet.start())
        self._quiet.timeout.connect(self.stale)

    def begin(self, folder: Path, recording: Path | None) -> None:
        """``recording``: the file that is being written."""
        self._watch(folder)
        self._request_number += 1
        number = self._request_number
        if self._reading is not None:
            self._reading.cancel()
        self._reading = self._tasks.run(
            self.tr("Reading the library"),
            lambda progress: (number, scan(folder, progress, recording)),
            self._found,
        )

    def _watch(self, folder: Path) -> None:
        """Watch only this folder."""
        others = [d for d in self._watcher.directories() if d != str(folder)]
        if others:
            self._watcher.removePaths(others)
        if folder.is_dir() and str(folder) not in self._watcher.directories():
            self._watcher.addPath(str(folder))

    def _found(self, numbered: tuple[int, list[SessionRow]]) -> None:
        number, rows = numbered
        if number != self._request_number:
            return  # outdated: there is a newer request
        known = {r.path: d for r in rows if (d := self._details.get((r.path, r.stamp)))}
        self.found.emit(rows, known)
        new = [r for r in rows if r.path not in known and not r.problem]
        if new:
            self._read_details(new)

    def _read_details(self, rows: list[SessionRow]) -> None:
        """Read thumbnails and quality; stops an earlier job."""
        if self._looking is not None:
            self._looking.cancel()

        def found(row: SessionRow, details: Details) -> None:
            self._details[row.path, row.stamp] = details

        def job(progress: JobProgress) -> None:
            read_details(rows, found, progress)

        self._looking = self._tasks.run(
            self.tr("Reading session details"),
            job,
            ended=lambda: self._warn_of(rows),
            progressed=lambda _share, _name: self._warn_of(rows),
        )

    def _warn_of(self, rows: list[SessionRow]) -> None:
        for row in rows:
            details = self._details.get((row.path, row.stamp))
            if details is not None:
                self.detailed.emit(row.path, details)

    def shut_down(self) -> None:
        """Stop watching."""
        self._quiet.stop()
        if self._watcher.directories():
            self._watcher.removePaths(self._watcher.directories())
