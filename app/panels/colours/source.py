"""The image that colours are tuned on: live, frozen, or stored earlier."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QPoint, QRect, QSize, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QLayout,
    QLayoutItem,
    QMenu,
    QToolButton,
    QWidget,
)

from app.engines.snapshot import Snapshot
from app.platform.tasks import TaskOwner
from app.storage.image_folder import (
    Image,
    ImageFolder,
    StoredImage,
    read_image,
    write_image,
)
from app.storage.removed_file import RemovedFile
from app.widgets.measures import NEAR, TIGHT
from app.words import error_text
from tracker.base.errors import GlovetrackError

LIVE = 0


class StoredImages(QObject):
    """The stored images of a camera, and image files opened since the window was.

    ``listed``: other images are available; the name of the one to show, empty for the live image.
    ``removed``: a message and a function that undoes the removal.
    """

    listed = Signal(str)
    failed = Signal(str)
    removed = Signal(str, object)

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self.folder: ImageFolder | None = None
        self._opened: dict[str, StoredImage] = {}

    @property
    def names(self) -> list[str]:
        return [*(self.folder.names() if self.folder is not None else []), *self._opened]

    def use_folder(self, folder: ImageFolder) -> None:
        """Offer the images of another camera."""
        self.folder = folder
        self.listed.emit("")

    def load(self, name: str, show: Callable[[StoredImage], None]) -> None:
        """Call ``show`` with an image once it has been read."""
        if name in self._opened:
            show(self._opened[name])
        elif self.folder is not None:
            path = self.folder.path(name)
            self._tasks.run(self.tr("Opening an image"), lambda _p: read_image(path), show)

    def store(self, left: Image | None, right: Image | None) -> None:
        """Write a pair of images to the camera's folder."""
        if self.folder is None or left is None:
            self.failed.emit(self.tr("There is no image yet that could be stored."))
            return
        folder = self.folder
        shot = StoredImage(folder.free_name(datetime.now()), left, right)
        self._tasks.run(
            self.tr("Storing an image"),
            lambda _progress: folder.store(shot),
            lambda _none: self.listed.emit(shot.name),
        )

    def open_file(self, path: Path) -> None:
        """Show an image of any camera, single or side by side."""
        self._tasks.run(self.tr("Opening an image"), lambda _p: read_image(path), self._add)

    def _add(self, image: StoredImage) -> None:
        self._opened[image.name] = image
        self.listed.emit(image.name)

    def save_file(self, path: Path, left: Image | None, right: Image | None) -> None:
        """Write a pair of images to a file."""
        if left is None:
            self.failed.emit(self.tr("There is no image yet that could be saved."))
            return
        shot = StoredImage(path.stem, left, right)
        self._tasks.run(self.tr("Saving an image"), lambda _p: write_image(path, shot))

    def remove(self, name: str) -> None:
        """Close an opened file, or move a stored image to the bin."""
        opened = self._opened.pop(name, None)
        if opened is not None:
            undo = partial(self._add, opened)
        elif self.folder is not None:
            try:
                undo = partial(self._put_back, self.folder, self.folder.remove(name))
            except GlovetrackError as error:
                self.failed.emit(error_text(error))
                return
        else:
            return
        self.listed.emit("")
        self.removed.emit(self.tr("The image {} was removed.").format(name), undo)

    def _put_back(self, folder: ImageFolder, file: RemovedFile) -> None:
        try:
            file.put_back()
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
            return
        if folder is self.folder:  # the camera is still the same
            self.listed.emit(file.path.stem)


class ColoursSource(QWidget):
    """A row of controls. ``changed``: another image is shown."""

    changed = Signal()
    failed = Signal(str)
    removed = Signal(str, object)  # a message, and a function that undoes the removal

    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stored = StoredImages(tasks, self)
        self.stored.listed.connect(self._list)
        self.stored.failed.connect(self.failed)
        self.stored.removed.connect(self.removed)
        self._view: Snapshot | None = None
        self._stored: StoredImage | None = None
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Image used for tuning"))
        self.choice.setMinimumContentsLength(12)
        self.choice.addItem(self.tr("Live image"))
        self.choice.currentIndexChanged.connect(self._choose)
        self.side = QComboBox()
        self.side.setAccessibleName(self.tr("Camera"))
        self.side.addItems([self.tr("Left"), self.tr("Right")])
        self.side.currentIndexChanged.connect(self.changed)
        self.freeze = QCheckBox(self.tr("Freeze"))
        self.freeze.setToolTip(self.tr("Freeze the image; tracking continues"))
        self.freeze.toggled.connect(self.changed)
        self.store_button = self._button(self.tr("Store"), self.tr("Store this image for later"))
        self.store_button.clicked.connect(self.store_image)
        row = FlowLayout(self, spacing=TIGHT)
        for widget in (self.choice, self.side, self.freeze, self.store_button, self._menu_button()):
            row.addWidget(widget)

    @staticmethod
    def _button(text: str, tip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tip)
        return button

    def _menu_button(self) -> QToolButton:
        button = self._button("⋯", self.tr("More image commands"))
        button.setAccessibleName(self.tr("More image commands"))
        menu = QMenu(button)
        menu.addAction(self.tr("Open an image…"), self.ask_open)
        menu.addAction(self.tr("Save this image…"), self.ask_save)
        menu.addAction(self.tr("Remove this image"), self.remove)
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return button

    # --- displayed data

    def set_folder(self, folder: ImageFolder) -> None:
        """Offer the images of another camera."""
        self._view = None
        self.freeze.setChecked(False)
        self.stored.use_folder(folder)

    def take(self, view: Snapshot) -> None:
        """Show a newer snapshot, unless the image is frozen."""
        if view.frame is not None and not (self.freeze.isChecked() and self._view is not None):
            self._view = view

    @property
    def is_live(self) -> bool:
        return self._stored is None

    @property
    def is_frozen(self) -> bool:
        """Whether a live image is frozen."""
        return self.is_live and self.freeze.isChecked() and self._view is not None

    @property
    def view(self) -> Snapshot | None:
        """The snapshot of the live or frozen image; None for a stored one."""
        return self._view if self._stored is None else None

    def pair(self) -> tuple[Image | None, Image | None]:
        """The images of both cameras."""
        if self._stored is not None:
            return self._stored.left, self._stored.right
        if self._view is None or self._view.frame is None:
            return None, None
        return self._view.frame.left, self._view.frame.right

    @property
    def right(self) -> bool:
        return self.side.currentIndex() == 1

    def image(self) -> Image | None:
        """That of the selected camera."""
        return self.pair()[self.right]

    # --- stored images

    def _list(self, chosen: str) -> None:
        """Fill the list and show the image ``chosen``; empty: the live image."""
        names = self.stored.names
        self.choice.blockSignals(True)
        self.choice.clear()
        self.choice.addItem(self.tr("Live image"))
        self.choice.addItems(names)
        index = 1 + names.index(chosen) if chosen in names else LIVE
        self.choice.setCurrentIndex(index)
        self.choice.blockSignals(False)
        self._choose(index)

    def _choose(self, index: int) -> None:
        if index <= LIVE:
            self._show(None)
        else:
            self.stored.load(self.choice.itemText(index), self._show)

    def _show(self, kept: StoredImage | None) -> None:
        self._stored = kept
        self.changed.emit()

    def store_image(self) -> None:
        """Store the images that are shown in the camera's folder."""
        self.stored.store(*self.pair())

    def ask_open(self) -> None:
        path, _ = QFileDialog.getOpenFileName(
            self, self.tr("Open an image"), "", "*.png *.jpg *.jpeg *.bmp *.tif"
        )
        if path:
            self.stored.open_file(Path(path))

    def ask_save(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save this image"), "glove.png", "*.png"
        )
        if path:
            self.stored.save_file(Path(path).with_suffix(".png"), *self.pair())

    def remove(self) -> None:
        """Remove the stored image that is shown."""
        if self.is_live:
            self.failed.emit(
                self.tr("Select a stored image first. The live image cannot be removed.")
            )
            return
        self.stored.remove(self.choice.currentText())


# ---- a layout that wraps a row of widgets into further lines


class FlowLayout(QLayout):
    """Widgets left to right at their own size, wrapped like words."""

    def __init__(self, parent: QWidget | None = None, spacing: int = NEAR) -> None:
        super().__init__(parent)
        self._items: list[QLayoutItem] = []
        self.setSpacing(spacing)
        self.setContentsMargins(0, 0, 0, 0)

    def addItem(self, item: QLayoutItem) -> None:
        self._items.append(item)

    def count(self) -> int:
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        return Qt.Orientation(0)

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        return self._place(QRect(0, 0, width, 0), move=False)

    def setGeometry(self, rect: QRect) -> None:
        super().setGeometry(rect)
        self._place(rect, move=True)

    def sizeHint(self) -> QSize:
        return self.minimumSize()

    def minimumSize(self) -> QSize:
        """The widest and the highest widget: everything fits into one column."""
        size = QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        return size

    def _place(self, rect: QRect, move: bool) -> int:
        """Lay out the items in ``rect``; returns the required height."""
        lines = self._lines(rect.width())
        y = rect.top()
        for line in lines:
            height = max(item.sizeHint().height() for item in line)
            x = rect.left()
            for item in line:
                size = item.sizeHint()
                if move:
                    top = y + (height - size.height()) // 2
                    item.setGeometry(QRect(QPoint(x, top), size))
                x += size.width() + self.spacing()
            y += height + min(TIGHT, self.spacing())
        return y - rect.top() - (min(TIGHT, self.spacing()) if lines else 0)

    def _lines(self, width: int) -> list[list[QLayoutItem]]:
        lines: list[list[QLayoutItem]] = []
        x = width + 1
        for item in self._items:
            widget = item.widget()
            if widget is not None and widget.isHidden():
                continue
            needed = item.sizeHint().width()
            if not lines or x + needed > width:
                lines.append([])
                x = 0
            lines[-1].append(item)
            x += needed + self.spacing()
        return lines
