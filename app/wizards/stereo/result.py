"""The result of a camera calibration: solved in the background, shown with its rejected views."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.viewmodels.states import BAD, GOOD
from app.viewmodels.stereo import problems, solution_figures, view_rows
from app.widgets.measures import APART, FAR, NEAR, WIDE
from app.words import error_text, notice_text
from tracker.base.files import free_path, slug
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.calibration.stereo.coverage import Coverage
from tracker.calibration.stereo.files import save_calibration
from tracker.calibration.stereo.solve import CalibrationError, Solution, solve
from tracker.calibration.stereo.views import Size, StereoView
from tracker.vision.rig import StereoRig


class ResultPage(QWidget):
    """Shows progress, then the solution or the reason why there is none."""

    cancelled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.words = QLabel()
        self.words.setProperty("role", "figure")
        self.words.setWordWrap(True)
        self.reasons = QLabel()
        self.reasons.setProperty("role", "warning")
        self.reasons.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 100)
        self.cancel = QPushButton(self.tr("Cancel"))
        self.cancel.clicked.connect(self.cancelled)
        self.table = QTableWidget(0, 4)
        self.table.setHorizontalHeaderLabels(
            [self.tr("View"), self.tr("Left, px"), self.tr("Right, px"), self.tr("State")]
        )
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.horizontalHeader().setStretchLastSection(True)
        self._grid = QGridLayout()
        self._grid.setColumnStretch(1, 1)
        self._grid.setVerticalSpacing(NEAR)
        self._grid.setHorizontalSpacing(WIDE)
        self._lay_out()

    def _lay_out(self) -> None:
        working = QHBoxLayout()
        working.addWidget(self.bar, 1)
        working.addWidget(self.cancel)
        left = QVBoxLayout()
        left.addLayout(self._grid)
        left.addStretch(1)
        row = QHBoxLayout()
        row.setSpacing(FAR)
        row.addLayout(left, 1)
        row.addWidget(self.table, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(APART)
        column.addWidget(self.words)
        column.addLayout(working)
        column.addWidget(self.reasons)
        column.addLayout(row, 1)

    def show_working(self, share: float, text: str) -> None:
        """Progress of the solution; ``share`` 0..1."""
        self._working(True)
        self.words.setText(
            self.tr("Calibrating: {}").format(text) if text else self.tr("Calibrating")
        )
        self.bar.setValue(round(100 * share))
        self.reasons.hide()

    def show_failure(self, why: str) -> None:
        """Show why there is no solution."""
        self._working(False)
        self.words.setText(f"{BAD.sign}  " + self.tr("No calibration"))
        self._show_reasons([why])
        self.table.setRowCount(0)

    def show_solution(self, solution: Solution, cover: Coverage, baseline: float) -> bool:
        """Show figures and views of the solution, and whether it can be checked. ``baseline`` as in
        `problems`."""
        self._working(False)
        found = problems(solution, cover, baseline)
        look = BAD if found else GOOD
        verdict = (
            self.tr("Rejected") if found else self.tr("Calibrated. Now check it on new views.")
        )
        self.words.setText(f"{look.sign}  {verdict}")
        self._show_reasons([notice_text(problem) for problem in found])
        self._show_figures(solution)
        self._show_views(solution)
        return not found

    def _working(self, on: bool) -> None:
        self.bar.setVisible(on)
        self.cancel.setVisible(on)

    def _show_reasons(self, reasons: list[str]) -> None:
        self.reasons.setVisible(bool(reasons))
        self.reasons.setText("\n".join(reasons))

    def _show_figures(self, solution: Solution) -> None:
        while (item := self._grid.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        for i, (name, text) in enumerate(solution_figures(solution)):
            label = QLabel(name)
            label.setProperty("role", "faint")
            self._grid.addWidget(label, i, 0)
            self._grid.addWidget(QLabel(text), i, 1, Qt.AlignmentFlag.AlignLeft)

    def _show_views(self, solution: Solution) -> None:
        rows = view_rows(solution)
        self.table.setRowCount(len(rows))
        self.table.setColumnHidden(2, solution.right is None)
        first = self.tr("Error, px") if solution.right is None else self.tr("Left, px")
        self.table.setHorizontalHeaderItem(1, QTableWidgetItem(first))
        for i, row in enumerate(rows):
            state = f"{row.look.sign} {row.state}"
            texts = (row.name, row.errors[0], row.errors[-1], state)
            for j, text in enumerate(texts):
                self.table.setItem(i, j, QTableWidgetItem(text))


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
        """``done`` receives the solution, or the reason why there is none."""
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
    """The job; a failure to solve is a result, too, shown on the page."""

    def job(progress: JobProgress) -> Solution | str:
        try:
            return solve(views, sizes, progress=progress)
        except CalibrationError as error:
            return error_text(error)

    return job


def save_rig(folder: Path, title: str, rig: StereoRig, note: str) -> Path:
    """Write a new file named by camera and date. Raises FileError."""
    path = free_path(folder / f"{slug(title)}-{datetime.now():%Y%m%d}.yml")
    cameras = extrinsics_of(rig)
    save_calibration(path, cameras.left, cameras.right, cameras.R, cameras.T, note, rig.line_time)
    return path
