"""The stereo calibration as a job that can be cancelled, and the file that its result becomes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.words import told
from tracker.base.files import free_path, slug
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.calibration.stereo.files import save_calibration
from tracker.calibration.stereo.solve import CalibrationError, Solution, solve
from tracker.calibration.stereo.views import Size, StereoView
from tracker.vision.rig import StereoRig


class Solving(QObject):
    """One calculation at a time."""

    progressed = Signal(float, str)
    ended = Signal()

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._task: RunningJob | None = None

    @property
    def running(self) -> bool:
        return self._task is not None

    def start(
        self,
        views: tuple[StereoView, ...],
        sizes: Sequence[Size],
        done: Callable[[Solution | str], None],
    ) -> None:
        """``done`` gets the solution, or why there is none."""
        job = _solving(views, sizes)
        self._task = self._tasks.run(self.tr("Camera calibration"), job, done, self._ended)
        self._task.progressed.connect(self.progressed)

    def cancel(self) -> None:
        if self._task is not None:
            self._task.cancel()

    def _ended(self) -> None:
        self._task = None
        self.ended.emit()


def _solving(
    views: tuple[StereoView, ...], sizes: Sequence[Size]
) -> Callable[[JobProgress], Solution | str]:
    """The job; what cannot be solved is a result too, shown on the page."""

    def job(progress: JobProgress) -> Solution | str:
        try:
            return solve(views, sizes, progress=progress)
        except CalibrationError as error:
            return told(str(error))

    return job


def save_rig(folder: Path, title: str, rig: StereoRig, note: str) -> Path:
    """A new file named by the camera and the day. Raises FileError."""
    path = free_path(folder / f"{slug(title)}-{datetime.now():%Y%m%d}.yml")
    cameras = extrinsics_of(rig)
    save_calibration(path, cameras.left, cameras.right, cameras.R, cameras.T, note)
    return path
