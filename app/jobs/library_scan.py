"""Reads the folder of recorded sessions in the background, and watches it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.viewmodels.library import Details, SessionRow, look_inside, scan

QUIET_MS = 300  # without changes after which a folder is read again


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
        self._asked = 0
        self._looking: RunningJob | None = None
        self._watcher = QFileSystemWatcher(self)
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MS)
        self._watcher.directoryChanged.connect(lambda _path: self._quiet.start())
        self._quiet.timeout.connect(self.stale)

    def begin(self, folder: Path, recording: Path | None) -> None:
        """``recording``: the file that is being written."""
        self._watch(folder)
        self._asked += 1
        number = self._asked
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
        if number != self._asked:
            return  # outdated: there is a newer request
        known = {r.path: d for r in rows if (d := self._details.get((r.path, r.stamp)))}
        self.found.emit(rows, known)
        new = [r for r in rows if r.path not in known and not r.problem]
        if new:
            self._look_inside(new)

    def _look_inside(self, rows: list[SessionRow]) -> None:
        """Read thumbnails and quality; stops an earlier job."""
        if self._looking is not None:
            self._looking.cancel()

        def found(row: SessionRow, details: Details) -> None:
            self._details[row.path, row.stamp] = details

        def job(progress: JobProgress) -> None:
            look_inside(rows, found, progress)

        self._looking = self._tasks.run(
            self.tr("Reading session details"),
            job,
            ended=lambda: self._tell(rows),
            progressed=lambda _share, _name: self._tell(rows),
        )

    def _tell(self, rows: list[SessionRow]) -> None:
        for row in rows:
            details = self._details.get((row.path, row.stamp))
            if details is not None:
                self.detailed.emit(row.path, details)

    def shut_down(self) -> None:
        """Stop watching."""
        self._quiet.stop()
        if self._watcher.directories():
            self._watcher.removePaths(self._watcher.directories())
