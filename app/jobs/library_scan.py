"""Looks through the folder of recorded sessions, in the background."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.viewmodels.library import Details, SessionRow, look_inside, scan


class LibraryScan(QObject):
    """First what the files' index tells, then what is inside, one file after the other."""

    found = Signal(object, object)  # the rows, and `Details` known of earlier scans by path
    detailed = Signal(object, object)  # a path and its `Details`

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._details: dict[tuple[Path, tuple[int, int]], Details] = {}
        self._looking: RunningJob | None = None

    def begin(self, folder: Path, recording: Path | None) -> None:
        """``recording``: the file that is being written."""
        self._tasks.run(
            self.tr("Reading the library"),
            lambda progress: scan(folder, progress, recording),
            self._found,
        )

    def _found(self, rows: list[SessionRow]) -> None:
        known = {r.path: d for r in rows if (d := self._details.get((r.path, r.stamp)))}
        self.found.emit(rows, known)
        new = [r for r in rows if r.path not in known and not r.problem]
        if new:
            self._look_inside(new)

    def _look_inside(self, rows: list[SessionRow]) -> None:
        """Thumbnails and quality; an earlier look is ended."""
        if self._looking is not None:
            self._looking.cancel()

        def found(row: SessionRow, details: Details) -> None:
            self._details[row.path, row.stamp] = details

        def job(progress: JobProgress) -> None:
            look_inside(rows, found, progress)

        self._looking = self._tasks.run(
            self.tr("Looking into sessions"),
            job,
            ended=lambda: self._tell(rows),
            progressed=lambda _share, _name: self._tell(rows),
        )

    def _tell(self, rows: list[SessionRow]) -> None:
        for row in rows:
            details = self._details.get((row.path, row.stamp))
            if details is not None:
                self.detailed.emit(row.path, details)
