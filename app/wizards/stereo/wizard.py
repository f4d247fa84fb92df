"""The calibration of a stereo camera or of one camera: board, views, result, check, file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QTimer, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import TaskOwner
from app.viewmodels.stereo import split_fresh
from app.widgets.measures import APART, WIDE
from app.wizards.sizing import fit_to_screen
from app.wizards.stereo.board import BoardPage, ImageChoice
from app.wizards.stereo.board_watcher import Watching
from app.wizards.stereo.image_choices import folder_choice
from app.wizards.stereo.result import ResultPage, Solving, save_rig
from app.wizards.stereo.views import CheckPage, CollectPage
from app.words import error_text, mark, tr
from tracker.base.errors import GlovetrackError
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.coverage import coverage
from tracker.calibration.stereo.files import MissingFacts, load_rig
from tracker.calibration.stereo.solve import Solution, SolveParams
from tracker.calibration.stereo.views import BoardFinder, Size, StereoView, sizes_of
from tracker.vision.rig import StereoRig

TICK_MS = 50
BOARD, VIEWS, RESULT, CHECK = range(4)


class StereoWizard(QDialog):
    """Not modal. ``finished_with``: the file of the calibration, and whether it is for the real
    camera."""

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
        self.watching = Watching(tasks, self.tr("Closing the camera"))
        self._solving = Solving(tasks, self)
        self._fresh: list[StereoView] | None = (
            None  # views of a folder of images, reserved for the check
        )
        self._rig: StereoRig | None = None
        self._imported = ""  # name of the imported file, or empty
        self._file: Path | None = None  # an existing file that is used unchanged
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
        self.setWindowTitle(self.tr("Camera calibration"))
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
        column.setContentsMargins(WIDE, APART, WIDE, APART)
        column.setSpacing(APART)
        column.addWidget(self._steps)
        column.addWidget(self.pages, 1)
        column.addLayout(buttons)

    def _connect(self) -> None:
        self.back.clicked.connect(self.go_back)
        self.next.clicked.connect(self.go_on)
        self.stop.clicked.connect(self.close)
        self.folder.clicked.connect(lambda: self.use_folder(ask_folder(self)))
        self.board.changed.connect(self._enable)
        self.board.import_zed.connect(lambda: self._import(ask_zed(self)))
        self.board.import_opencv.connect(lambda: self._import(ask_opencv(self)))
        self.collect.removed.connect(self.watching.remove)
        self.outcome.cancelled.connect(self._cancel)
        self._solving.progressed.connect(self.outcome.show_working)
        self._solving.ended.connect(self._enable)

    # --- going from page to page

    def go_on(self) -> None:
        """Do what the page's main button offers."""
        page = self.pages.currentIndex()
        (self._start_views, self._start_solving, self._start_check, self._finish)[page]()

    def go_back(self) -> None:
        page = self.pages.currentIndex()
        if page == VIEWS or self._imported:
            self.watching.stop()
            self._imported, self._file = "", None
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
        self.back.setText(self.tr("&Back"))
        words = (self.tr("Start"), self.tr("Calibrate"), self.tr("Check"), self.tr("Save and use"))
        self.next.setText(self.tr("Save") if page == CHECK and self._simulated() else words[page])
        self._enable()

    def _enable(self) -> None:
        page = self.pages.currentIndex()
        if page == BOARD:
            on = self.board.spec() is not None and self.board.choice() is not None
        elif page == VIEWS:
            on = len(self.watching.views()) >= SolveParams().least_views
        elif page == RESULT:
            on = self._usable and not self._solving.running
        else:
            found = self.check.found
            state = found.verdict()[0] if found is not None else "waiting"
            # an imported file may be used without the board
            on = state in ("good", "usable") or (state == "waiting" and bool(self._imported))
        self.next.setEnabled(on)

    def _simulated(self) -> bool:
        choice = self.board.choice()
        return not self._imported and choice is not None and choice.simulated

    def _tick(self) -> None:
        watcher = self.watching.watcher
        if watcher is None:
            return
        page, views = self.pages.currentIndex(), self.watching.views()
        if page == VIEWS:
            self.collect.show_seen(watcher.latest(), views, watcher.problem)
            self.collect.show_list(views, watcher.error_px)
        elif page == CHECK and self._fresh is None:
            self.check.show_seen(watcher.latest(), views, watcher.problem)
        self._enable()

    # --- views

    def _start_views(self) -> None:
        self._start_watching()
        self._go(VIEWS)

    def _start_watching(self) -> None:
        self.watching.stop()
        spec, choice = self.board.spec(), self.board.choice()
        if spec is not None and choice is not None:
            self.board_used.emit(spec)
            self.watching.start(lambda: choice.make(spec), BoardFinder(spec))

    def use_folder(self, folder: Path | None) -> None:
        """Use images from a folder and continue; None if the user cancels."""
        if folder is None:
            return
        self.board.set_choices([folder_choice(folder), *self.board.choices])
        self.board.images.setCurrentIndex(0)
        self._enable()

    # --- solving

    def _start_solving(self) -> None:
        views, watcher = self.watching.views(), self.watching.watcher
        seen = watcher.latest() if watcher is not None else None
        if watcher is None or seen is None:
            return
        self._fresh = None
        if not watcher.live:
            kept, self._fresh = split_fresh(views)
            views = tuple(kept)
        sizes = sizes_of(seen.pair)
        self._usable = False
        self._go(RESULT)
        self.outcome.show_working(0.0, "")
        self._solving.start(views, sizes, lambda found: self._solved(found, views, sizes))

    def _solved(
        self, found: Solution | str, views: tuple[StereoView, ...], sizes: Sequence[Size]
    ) -> None:
        if isinstance(found, str):
            self.outcome.show_failure(found)
            return
        cover, baseline = coverage(views, sizes), self.board.baseline_mm.value() / 1000
        self._usable = self.outcome.show_solution(found, cover, baseline)
        self._rig = found.rig if self._usable else None

    def _cancel(self) -> None:
        if self._solving.running:
            self._solving.cancel()
            self._go(VIEWS)

    # --- check

    def _start_check(self) -> None:
        if self._rig is None:
            return
        self.check.set_rig(self._rig)
        if self._fresh is not None:
            self.check.images.wait(self.tr("Checked on every third image of the folder."))
            self.check.show_views(self._fresh)
        elif self.watching.watcher is not None:
            self.watching.watcher.restart()
        self._go(CHECK)

    def _finish(self) -> None:
        if self._rig is None:
            return
        choice, found = self.board.choice(), self.check.found
        title = choice.title if choice is not None else "camera"
        if self._imported:
            title = self._imported  # instead of the source of the images for the check
        note = tr("checked: {:.3f} px").format(found.rms_px) if found is not None else ""
        try:
            path = self._file or save_rig(self._folder, title, self._rig, note)
        except GlovetrackError as error:
            self.check.words.setText(error_text(error))
            return
        self.finished_with.emit(path, not self._simulated())
        self.close()

    # --- files of before

    def _import(self, chosen: tuple[Path, MissingFacts | None] | None) -> None:
        if chosen is not None:
            self.take_file(*chosen)

    def take_file(self, path: Path, form: MissingFacts | None = None) -> bool:
        """Check a file; if it is valid, it can be used directly or tested with the board first."""
        try:
            rig = load_rig(path, form)
        except GlovetrackError as error:
            self.board.problem.setText(error_text(error))
            self.board.problem.show()
            return False
        self._rig, self._fresh = rig, None
        self._imported, self._file = path.stem, path if form is None else None
        self.check.set_rig(rig)
        choice = self.board.choice()
        if choice is not None and not choice.simulated:
            self._start_watching()
        self._go(CHECK)
        return True

    def done(self, result: int) -> None:
        """Release the camera and stop a running calculation, however the dialog is closed."""
        self._timer.stop()
        self._solving.cancel()
        self.watching.stop()
        super().done(result)


# ---- dialogs for calibration files of other programs, and for information that these files do
# not contain

ZED_FOLDER = Path("/usr/local/zed/settings")
UNITS = (("mm", 1e-3), ("m", 1.0), ("cm", 1e-2), (mark("squares of the board"), 0.0))


class ImportFormDialog(QDialog):
    """Asks for the image size, and the unit of the baseline."""

    def __init__(self, path: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Import {}").format(path.name))
        default = MissingFacts()
        self.width_px, self.height_px = _pixels(default.width), _pixels(default.height)
        self.unit = QComboBox()
        for name, metres in UNITS:
            self.unit.addItem(tr(name), metres)
        self.square_mm = QDoubleSpinBox()
        self.square_mm.setRange(1.0, 500.0)
        self.square_mm.setValue(25.0)
        self.square_mm.setSuffix(self.tr(" mm"))
        self.unit.currentIndexChanged.connect(self._enable)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow(self.tr("Image's &width, px"), self.width_px)
        form.addRow(self.tr("Image's &height, px"), self.height_px)
        form.addRow(self.tr("&Unit of T in the file"), self.unit)
        form.addRow(self.tr("Side of a &square"), self.square_mm)
        form.addRow(buttons)
        self._enable()

    def form(self) -> MissingFacts:
        unit = self.unit.currentData() or self.square_mm.value() / 1000
        return MissingFacts(self.width_px.value(), self.height_px.value(), unit)

    def _enable(self) -> None:
        self.square_mm.setEnabled(self.unit.currentData() == 0.0)


def ask_import_form(path: Path, parent: QWidget) -> MissingFacts | None:
    """None if the user cancels."""
    dialog = ImportFormDialog(path, parent)
    return dialog.form() if dialog.exec() == QDialog.DialogCode.Accepted else None


def _pixels(value: int) -> QSpinBox:
    box = QSpinBox()
    box.setRange(160, 8192)
    box.setValue(value)
    return box


def ask_zed(parent: QWidget) -> tuple[Path, None] | None:
    """Ask for the factory file of the camera."""
    start = str(ZED_FOLDER) if ZED_FOLDER.is_dir() else ""
    title = QCoreApplication.translate("StereoWizard", "ZED factory file")
    path, _ = QFileDialog.getOpenFileName(parent, title, start, "*.conf")
    return (Path(path), None) if path else None


def ask_opencv(parent: QWidget) -> tuple[Path, MissingFacts] | None:
    """Ask for a file written by OpenCV's tools, and for missing information."""
    title = QCoreApplication.translate("StereoWizard", "OpenCV calibration")
    path, _ = QFileDialog.getOpenFileName(parent, title, "", "*.yml *.yaml *.xml *.json *.toml")
    form = ask_import_form(Path(path), parent) if path else None
    return (Path(path), form) if form is not None else None


def ask_folder(parent: QWidget) -> Path | None:
    """Ask for the folder of the images."""
    title = QCoreApplication.translate("StereoWizard", "Folder with left and right images")
    path = QFileDialog.getExistingDirectory(parent, title)
    return Path(path) if path else None
