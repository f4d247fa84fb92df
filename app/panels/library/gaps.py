"""Lists the gaps of the replayed session and fills those that are selected, as jobs."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.engines.engine import Player
from app.jobs.gaps import fill_job, list_gaps_job
from app.panels.library.gap_page import GapPage
from app.platform.tasks import LatestJob, TaskOwner
from app.viewmodels.gaps import FilledSession, SessionGaps, filled_text


class Gaps(QObject):
    """``made``: the Path of a filled session and a sentence about it. ``counted``: how many gaps
    are listed. ``ended`` after filling, however it ended."""

    made = Signal(object, str)
    counted = Signal(int)
    ended = Signal()

    def __init__(self, tasks: TaskOwner, page: GapPage, parent: QObject) -> None:
        super().__init__(parent)
        self._tasks, self.page = tasks, page
        self._player: Player | None = None
        self._reading = LatestJob(self.tr("Listing the gaps"), self)
        page.limit_changed.connect(self._read)
        page.fill_asked.connect(self.fill)
        page.sought.connect(self._seek)
        page.shown_changed.connect(lambda _shown: self.counted.emit(page.table.rowCount()))

    def set_player(self, player: Player | None) -> None:
        """The replay that is open now."""
        self._player = player
        self.page.show_gaps(None)
        self._read()

    def _read(self) -> None:
        if self._player is None or not self._player.tracked:
            self._reading.forget()
            return
        job = list_gaps_job(self._player.path, self.page.limit.value())
        self._reading.run(job, self._show)

    def _show(self, found: SessionGaps) -> None:
        if self._player is not None and self._player.path == found.path:
            self.page.show_gaps(found)

    def _seek(self, position: float) -> None:
        if self._player is not None:
            self._player.play(False)
            self._player.seek(position)

    @property
    def is_interpolated(self) -> bool:
        """Whether the replay stands in a gap that was filled."""
        found, player = self.page.found, self._player
        return found is not None and player is not None and found.is_interpolated(player.position)

    def fill(self) -> None:
        """Fill the selected gaps in a new file."""
        gaps, found = self.page.fillable(), self.page.found
        if found is None or not gaps:
            return
        path, page = found.path, self.page
        lengths = page.longest.value(), page.limit.value()
        job = fill_job(path, gaps, page.method.currentData(), *lengths)
        title = self.tr("Filling gaps of {}").format(path.name)
        self._tasks.run(title, job, lambda made: self._filled(path, made), self.ended.emit)

    def _filled(self, source: Path, made: FilledSession) -> None:
        self.made.emit(made.path, filled_text(made, source.name))

    def shut_down(self) -> None:
        self._reading.shut_down()
