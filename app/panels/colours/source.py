"""Which image colours are tuned on: the live one, a frozen one, or one kept earlier."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QMenu,
    QToolButton,
    QWidget,
)

from app.engines.snapshot import Snapshot
from app.platform.tasks import TaskOwner
from app.storage.image_folder import (
    Image,
    ImageFolder,
    KeptImage,
    read_image,
    write_image,
)
from app.storage.removed_file import RemovedFile
from app.widgets.flow_layout import FlowLayout
from app.widgets.measures import TIGHT
from tracker.base.errors import GlovetrackError

LIVE = 0


class ColoursSource(QWidget):
    """The row of the choices. ``changed`` says that another image is shown."""

    changed = Signal()
    failed = Signal(str)
    removed = Signal(str, object)  # a sentence, and what undoes it

    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self._folder: ImageFolder | None = None
        self._opened: dict[str, KeptImage] = {}  # from files elsewhere, while the window is open
        self._view: Snapshot | None = None
        self._kept: KeptImage | None = None
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Image to tune on"))
        self.choice.setMinimumContentsLength(12)
        self.choice.addItem(self.tr("Live image"))
        self.choice.currentIndexChanged.connect(self._choose)
        self.side = QComboBox()
        self.side.setAccessibleName(self.tr("Camera"))
        self.side.addItems([self.tr("Left"), self.tr("Right")])
        self.side.currentIndexChanged.connect(self.changed)
        self.freeze = QCheckBox(self.tr("Freeze"))
        self.freeze.setToolTip(self.tr("Hold this image; tracking goes on"))
        self.freeze.toggled.connect(self.changed)
        self.keep_button = self._button(self.tr("Keep"), self.tr("Keep this image for later"))
        self.keep_button.clicked.connect(self.keep)
        row = FlowLayout(self, spacing=TIGHT)
        for widget in (self.choice, self.side, self.freeze, self.keep_button, self._menu_button()):
            row.addWidget(widget)

    @staticmethod
    def _button(text: str, tip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tip)
        return button

    def _menu_button(self) -> QToolButton:
        button = self._button("⋯", self.tr("More about images"))
        button.setAccessibleName(self.tr("More about images"))
        menu = QMenu(button)
        menu.addAction(self.tr("Open an image…"), self.ask_open)
        menu.addAction(self.tr("Save this image…"), self.ask_save)
        menu.addAction(self.tr("Remove this image"), self.remove)
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return button

    # --- what is shown

    def set_folder(self, folder: ImageFolder) -> None:
        """Offer the images of another camera."""
        self._folder, self._view = folder, None
        self.freeze.setChecked(False)
        self._list(None)

    def take(self, view: Snapshot) -> None:
        """A newer snapshot; not taken while frozen."""
        if view.frame is not None and not (self.freeze.isChecked() and self._view is not None):
            self._view = view

    @property
    def is_live(self) -> bool:
        return self._kept is None

    @property
    def is_frozen(self) -> bool:
        """Whether a live image is held."""
        return self.is_live and self.freeze.isChecked() and self._view is not None

    @property
    def view(self) -> Snapshot | None:
        """What belongs to the live (or frozen) image; None while a kept one is shown."""
        return self._view if self._kept is None else None

    def pair(self) -> tuple[Image | None, Image | None]:
        """Both images shown now."""
        if self._kept is not None:
            return self._kept.left, self._kept.right
        if self._view is None or self._view.frame is None:
            return None, None
        return self._view.frame.left, self._view.frame.right

    @property
    def right(self) -> bool:
        return self.side.currentIndex() == 1

    def image(self) -> Image | None:
        """The one of the chosen side."""
        return self.pair()[self.right]

    # --- the kept ones

    def _list(self, chosen: str | None) -> None:
        """Fill the choices anew and show ``chosen`` (None: the live image)."""
        names = [*(self._folder.names() if self._folder is not None else []), *self._opened]
        self.choice.blockSignals(True)
        self.choice.clear()
        self.choice.addItem(self.tr("Live image"))
        self.choice.addItems(names)
        index = 1 + names.index(chosen) if chosen in names else LIVE
        self.choice.setCurrentIndex(index)
        self.choice.blockSignals(False)
        self._choose(index)

    def _choose(self, index: int) -> None:
        name = self.choice.itemText(index)
        if index <= LIVE:
            self._show(None)
        elif name in self._opened:
            self._show(self._opened[name])
        elif self._folder is not None:
            path = self._folder.path(name)
            self._tasks.run(self.tr("Opening an image"), lambda _p: read_image(path), self._show)

    def _show(self, kept: KeptImage | None) -> None:
        self._kept = kept
        self.changed.emit()

    def keep(self) -> None:
        """Put the image shown now into the camera's folder."""
        left, right = self.pair()
        if self._folder is None or left is None:
            self.failed.emit(self.tr("There is no image yet that could be kept."))
            return
        folder = self._folder
        shot = KeptImage(folder.free_name(datetime.now()), left, right)
        self._tasks.run(
            self.tr("Keeping an image"),
            lambda _progress: folder.keep(shot),
            lambda _none: self._list(shot.name),
        )

    def ask_open(self) -> None:
        path, _ = QFileDialog.getOpenFileName(
            self, self.tr("Open an image"), "", "*.png *.jpg *.jpeg *.bmp *.tif"
        )
        if path:
            self.open_file(Path(path))

    def open_file(self, path: Path) -> None:
        """Show an image of any camera, single or side by side."""

        def opened(kept: KeptImage) -> None:
            self._opened[kept.name] = kept
            self._list(kept.name)

        self._tasks.run(self.tr("Opening an image"), lambda _p: read_image(path), opened)

    def ask_save(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save this image"), "glove.png", "*.png"
        )
        if path:
            self.save_file(Path(path).with_suffix(".png"))

    def save_file(self, path: Path) -> None:
        left, right = self.pair()
        if left is None:
            self.failed.emit(self.tr("There is no image yet that could be saved."))
            return
        shot = KeptImage(path.stem, left, right)
        self._tasks.run(self.tr("Saving an image"), lambda _p: write_image(path, shot))

    def remove(self) -> None:
        """Remove the kept image that is shown."""
        name = self.choice.currentText()
        if self.is_live or self._folder is None:
            self.failed.emit(self.tr("Choose a kept image first: the live one stays."))
            return
        opened = self._opened.pop(name, None)
        if opened is not None:
            undo = partial(self._reopen, opened)
        else:
            try:
                undo = partial(self._put_back, self._folder, self._folder.remove(name))
            except GlovetrackError as error:
                self.failed.emit(str(error))
                return
        self._list(None)
        self.removed.emit(self.tr("The image {} was removed.").format(name), undo)

    def _reopen(self, image: KeptImage) -> None:
        self._opened[image.name] = image
        self._list(image.name)

    def _put_back(self, folder: ImageFolder, file: RemovedFile) -> None:
        try:
            file.put_back()
        except GlovetrackError as error:
            self.failed.emit(str(error))
            return
        if folder is self._folder:  # of the camera in use
            self._list(file.path.stem)
