"""The stereo calibration: board, views, result, check, file."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.viewmodels.stereo import split_fresh
from app.wizards.sizing import fit_to_screen
from app.wizards.stereo.board import BoardPage, ImageChoice
from app.wizards.stereo.board_watcher import BoardWatcher
from app.wizards.stereo.image_choices import folder_choice
from app.wizards.stereo.import_form import ask_import_form
from app.wizards.stereo.result import ResultPage
from app.wizards.stereo.views import CheckPage, CollectPage
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.checks import extrinsics_of
from tracker.calibration.stereo.coverage import coverage
from tracker.calibration.stereo.files import ImportForm, load_rig, save_calibration
from tracker.calibration.stereo.solve import CalibrationError, Solution, SolveParams, solve
from tracker.calibration.stereo.views import BoardFinder, StereoView
from tracker.errors import GlovetrackError
from tracker.files import free_path
from tracker.vision.rig import StereoRig

TICK_MS = 50
ZED_FOLDER = Path("/usr/local/zed/settings")
BOARD, VIEWS, RESULT, CHECK = range(4)


class StereoWizard(QDialog):
    """Not modal: the window lives on beside it. ``finished_with`` gives the calibration's file, and
    whether it is one of the real camera."""

    finished_with = Signal(object, bool)
    board_used = Signal(object)  # BoardSpec

    def __init__(
        self,
        tasks: TaskOwner,
        choices: list[ImageChoice],
        folder: Path,
        spec: BoardSpec | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._tasks, self._folder = tasks, folder
        self._watcher: BoardWatcher | None = None
        self._task: RunningJob | None = None
        self._views: tuple[StereoView, ...] = ()
        self._fresh: list[StereoView] | None = None  # of images that do not come anew
        self._rig: StereoRig | None = None
        self._imported = False
        self._file: Path | None = None  # one that is used as it is
        self._usable = False
        self.board = BoardPage(spec or BoardSpec(), choices)
        self.collect, self.outcome, self.check = CollectPage(), ResultPage(), CheckPage()
        self._lay_out()
        self._connect()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(TICK_MS)
        self._go(BOARD)

    # --- making

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Stereo calibration"))
        self.setObjectName("stereo_wizard")
        fit_to_screen(self, 980, 680)
        self._steps = QLabel()
        self._steps.setAccessibleName(self.tr("Steps"))
        self.pages = QStackedWidget()
        for page in (self.board, self.collect, self.outcome, self.check):
            self.pages.addWidget(page)
        self.back, self.next = QPushButton(), QPushButton()
        self.next.setProperty("role", "primary")
        self.next.setDefault(True)
        self.stop = QPushButton(self.tr("Close"))
        self.folder = QPushButton(self.tr("Images from a folder…"))
        buttons = QHBoxLayout()
        buttons.addWidget(self.stop)
        buttons.addWidget(self.folder)
        buttons.addStretch(1)
        buttons.addWidget(self.back)
        buttons.addWidget(self.next)
        column = QVBoxLayout(self)
        column.setContentsMargins(18, 14, 18, 14)
        column.setSpacing(12)
        column.addWidget(self._steps)
        column.addWidget(self.pages, 1)
        column.addLayout(buttons)

    def _connect(self) -> None:
        self.back.clicked.connect(self.go_back)
        self.next.clicked.connect(self.go_on)
        self.stop.clicked.connect(self.close)
        self.folder.clicked.connect(self._ask_folder)
        self.board.changed.connect(self._enable)
        self.board.import_zed.connect(self._ask_zed)
        self.board.import_opencv.connect(self._ask_opencv)
        self.collect.removed.connect(self._remove)
        self.outcome.cancelled.connect(self._cancel)

    # --- going from page to page

    def go_on(self) -> None:
        """What the page's main button does."""
        page = self.pages.currentIndex()
        (self._start_views, self._start_solving, self._start_check, self._finish)[page]()

    def go_back(self) -> None:
        page = self.pages.currentIndex()
        if page == VIEWS or self._imported:
            self._stop_watching()
            self._imported, self._file = False, None
            self._go(BOARD)
        elif page == CHECK:
            self._go(RESULT)
        elif page == RESULT:
            self._cancel()
            self._go(VIEWS)

    def _go(self, page: int) -> None:
        self.pages.setCurrentIndex(page)
        names = (self.tr("Board"), self.tr("Views"), self.tr("Result"), self.tr("Check"))
        shown = [
            f"<b>{i + 1} {n}</b>" if i == page else f"{i + 1} {n}" for i, n in enumerate(names)
        ]
        self._steps.setText(" &nbsp;›&nbsp; ".join(shown))
        self.back.setVisible(page != BOARD)
        self.folder.setVisible(page == BOARD)
        self.back.setText(self.tr("Back"))
        words = (self.tr("Start"), self.tr("Calibrate"), self.tr("Check"), self.tr("Save and use"))
        self.next.setText(self.tr("Save") if page == CHECK and self._simulated() else words[page])
        self._enable()

    def _enable(self) -> None:
        page = self.pages.currentIndex()
        if page == BOARD:
            on = self.board.spec() is not None and self.board.choice() is not None
        elif page == VIEWS:
            on = len(self._watched()) >= SolveParams().least_views
        elif page == RESULT:
            on = self._usable and self._task is None
        else:
            found = self.check.found
            state = found.verdict()[0] if found is not None else "waiting"
            # a file of before may be used without the board at hand
            on = state in ("good", "usable") or (state == "waiting" and self._imported)
        self.next.setEnabled(on)

    def _simulated(self) -> bool:
        choice = self.board.choice()
        return not self._imported and choice is not None and choice.simulated

    def _tick(self) -> None:
        watcher = self._watcher
        if watcher is None:
            return
        page, views = self.pages.currentIndex(), self._watched()
        if page == VIEWS:
            self.collect.show_seen(watcher.latest(), views, watcher.trouble)
            self.collect.show_list(views, watcher.error_px)
        elif page == CHECK and self._fresh is None:
            self.check.show_seen(watcher.latest(), views, watcher.trouble)
        self._enable()

    # --- views

    def _start_views(self) -> None:
        self._start_watching()
        self._go(VIEWS)

    def _start_watching(self) -> None:
        self._stop_watching()
        spec, choice = self.board.spec(), self.board.choice()
        if spec is not None and choice is not None:
            self.board_used.emit(spec)
            self._watcher = BoardWatcher(lambda: choice.make(spec), BoardFinder(spec))

    def _stop_watching(self) -> None:
        """A camera may take a second to close: not in the window's thread."""
        watcher, self._watcher = self._watcher, None
        if watcher is not None:
            self._tasks.run(self.tr("Closing the camera"), lambda _progress: watcher.stop())

    def _watched(self) -> tuple[StereoView, ...]:
        return self._watcher.views() if self._watcher is not None else ()

    def _remove(self, index: int) -> None:
        if self._watcher is not None and index >= 0:
            self._watcher.remove(index)

    def _ask_folder(self) -> None:
        path = QFileDialog.getExistingDirectory(self, self.tr("Folder with left and right images"))
        if path:
            self.use_folder(Path(path))

    def use_folder(self, folder: Path) -> None:
        """Take images from files, and go on."""
        self.board.set_choices([folder_choice(folder), *self.board.choices])
        self.board.images.setCurrentIndex(0)
        self._enable()

    # --- solving

    def _start_solving(self) -> None:
        views, seen = self._watched(), self._watcher.latest() if self._watcher else None
        if self._watcher is None or seen is None:
            return
        self._fresh = None
        if not self._watcher.live:
            kept, self._fresh = split_fresh(views)
            views = tuple(kept)
        height, width = seen.pair[0].shape[:2]
        self._usable = False
        self._go(RESULT)
        self.outcome.show_working(0.0, "")
        self._task = self._tasks.run(
            self.tr("Stereo calibration"),
            _solving(views, width, height),
            lambda found: self._solved(found, views, width, height),
            self._solving_ended,
        )
        self._task.progressed.connect(self.outcome.show_working)

    def _solved(
        self, found: Solution | str, views: tuple[StereoView, ...], width: int, height: int
    ) -> None:
        if isinstance(found, str):
            self.outcome.show_failure(found)
            return
        cover, baseline = coverage(views, width, height), self.board.baseline_mm.value() / 1000
        self._usable = self.outcome.show_solution(found, cover, baseline)
        self._rig = found.rig if self._usable else None

    def _solving_ended(self) -> None:
        self._task = None
        self._enable()

    def _cancel(self) -> None:
        if self._task is not None:
            self._task.cancel()
            self._go(VIEWS)

    # --- check

    def _start_check(self) -> None:
        if self._rig is None:
            return
        self.check.set_rig(self._rig)
        if self._fresh is not None:
            self.check.images.wait(self.tr("Checked on every third image of the folder."))
            self.check.show_views(self._fresh)
        elif self._watcher is not None:
            self._watcher.begin_anew()
        self._go(CHECK)

    def _finish(self) -> None:
        if self._rig is None:
            return
        path = self._file or self._save(self._rig)
        if path is not None:
            self.finished_with.emit(path, not self._simulated())
            self.close()

    def _save(self, rig: StereoRig) -> Path | None:
        choice, found = self.board.choice(), self.check.found
        title = choice.title if choice is not None else "camera"
        name = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")
        path = free_path(self._folder / f"{name}-{datetime.now():%Y%m%d}.yml")
        note = f"checked: {found.rms_px:.3f} px" if found is not None else ""
        cameras = extrinsics_of(rig)
        try:
            save_calibration(path, cameras.left, cameras.right, cameras.R, cameras.T, note)
        except GlovetrackError as error:
            self.check.words.setText(str(error))
            return None
        return path

    # --- files of before

    def _ask_zed(self) -> None:
        start = str(ZED_FOLDER) if ZED_FOLDER.is_dir() else ""
        path, _ = QFileDialog.getOpenFileName(self, self.tr("ZED factory file"), start, "*.conf")
        if path:
            self.take_file(Path(path))

    def _ask_opencv(self) -> None:
        kinds = "*.yml *.yaml *.xml *.json"
        path, _ = QFileDialog.getOpenFileName(self, self.tr("OpenCV calibration"), "", kinds)
        form = ask_import_form(Path(path), self) if path else None
        if form is not None:
            self.take_file(Path(path), form)

    def take_file(self, path: Path, form: ImportForm | None = None) -> bool:
        """Check a file; where it is good, it can be used at once or tried on the board first."""
        try:
            rig = load_rig(path, form)
        except GlovetrackError as error:
            self.board.trouble.setText(str(error))
            self.board.trouble.show()
            return False
        self._rig, self._fresh = rig, None
        self._imported, self._file = True, path if form is None else None
        self.check.set_rig(rig)
        choice = self.board.choice()
        if choice is not None and not choice.simulated:
            self._start_watching()
        self._go(CHECK)
        return True

    def done(self, result: int) -> None:
        """However it is closed: the camera is freed, a calculation under way ends."""
        self._timer.stop()
        if self._task is not None:
            self._task.cancel()
        self._stop_watching()
        super().done(result)


def _solving(
    views: tuple[StereoView, ...], width: int, height: int
) -> Callable[[JobProgress], Solution | str]:
    """The job; what cannot be solved is a result too, shown on the page."""

    def job(progress: JobProgress) -> Solution | str:
        try:
            return solve(views, width, height, progress=progress)
        except CalibrationError as error:
            return str(error)

    return job
