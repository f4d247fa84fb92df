"""Two trackings of one movement: made, compared in a dialog, and shown beside each other."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.engines.engine import Player
from app.engines.engine_host import EngineHost
from app.jobs.offline_tracking import compare_job, free_name, track_job
from app.panels.library.compare_dialog import CompareDialog
from app.platform.tasks import Job, TaskOwner
from app.viewmodels.compare import Comparison
from tracker.errors import GlovetrackError
from tracker.offline.options import TrackOptions


class Comparing(QObject):
    """Does both as jobs; ``ended`` after each, however it ended."""

    replay = Signal(object)  # the path that is to be seen
    compared = Signal(object)  # Comparison; its second tracking is shown in the replay
    ended = Signal()

    def __init__(self, host: EngineHost, tasks: TaskOwner, parent: QWidget) -> None:
        super().__init__(parent)
        self._host, self._tasks, self._window = host, tasks, parent
        self._player: Player | None = None
        self._pair: tuple[Path, Path] | None = None  # a session, and what to show beside it

    def set_player(self, player: Player | None) -> None:
        """The replay that is open now."""
        self._player = player
        self._show_reference()

    def track_again(self, source: Path, wanted: TrackOptions) -> None:
        """Track ``source`` in the background; then both are shown and compared."""
        try:
            out = free_name(source, wanted.engine)
        except GlovetrackError as error:
            self._host.error.emit(str(error))
            return
        title = self.tr("Tracking {} again").format(source.name)
        self._run(title, track_job(source, out, wanted))

    def compare(self, first: Path, second: Path) -> None:
        self._run(self.tr("Comparing"), compare_job(first, second))

    def _run(self, title: str, job: Job) -> None:
        self._tasks.run(title, job, self._show, self.ended.emit)

    def _show(self, comparison: Comparison | None) -> None:
        """Figures in a dialog, the second hand beside the first one in the replay."""
        if comparison is None:
            return
        CompareDialog(comparison, self._window).show()
        self._pair = (comparison.first, comparison.second)
        if self._player is not None and self._player.path == comparison.first:
            self._show_reference()
        elif not self._host.running or self._player is not None:
            self.replay.emit(comparison.first)
        self.compared.emit(comparison)

    def _show_reference(self) -> None:
        if self._player is None or self._pair is None or self._pair[0] != self._player.path:
            return
        try:
            self._player.set_reference(self._pair[1])
        except GlovetrackError as error:
            self._host.error.emit(str(error))
