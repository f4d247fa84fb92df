"""The image that colours are tuned on, with its mask and the detected blobs."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.panels.colours.source import ColoursSource
from app.platform.tasks import LatestJob, TaskOwner
from app.viewmodels.colour_search import MaskShown, ShownImage
from app.viewmodels.colour_tuning import ColourTuning
from app.widgets.image_view import ImageView
from app.widgets.measures import TIGHT
from tracker.messages import Blobs


class ColoursImage(QWidget):
    """The part of the panel with the image. ``changed``: the image or its blobs have changed.

    Stored images and those of a replay are searched in the background: a search takes tens of
    milliseconds.
    """

    changed = Signal()
    picked = Signal(float, float, object)  # u, v in the mask, Qt.KeyboardModifiers
    failed = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tuning: ColourTuning | None = None
        self.source = ColoursSource(tasks)
        self.source.changed.connect(self._image_changed)
        self.source.failed.connect(self.failed)
        self.mask_view = ImageView(self.tr("Mask"), self.tr("No image yet"))
        self.mask_view.picked.connect(self.picked)
        self._search = LatestJob(self.tr("Searching the image"), self)
        self._search.failed.connect(self.failed)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(TIGHT)
        column.addWidget(self.source)
        column.addWidget(self.mask_view, 1)

    def shown(self) -> ShownImage:
        source = self.source
        return ShownImage(source.image(), source.view, source.right, source.is_frozen)

    def _image_changed(self) -> None:
        frozen = self.source.is_frozen
        self.mask_view.set_title(self.tr("Mask, image frozen") if frozen else self.tr("Mask"))
        self.search()
        self.changed.emit()

    def refresh(self) -> None:
        """Search the next image of a replay after the previous search has finished; restarting on
        every image would never finish if images arrive faster than they are searched."""
        new = self.tuning is not None and self.tuning.search.is_new(self.shown())
        if new and not self._search.is_busy:
            self.search()

    def search(self) -> None:
        """Search the image with the current profile; discard the result of an earlier search."""
        work = self.tuning.search_work(self.shown()) if self.tuning is not None else None
        if work is None:
            self._search.forget()
        else:
            self._search.run(lambda _progress: work(), self._found)

    def _found(self, blobs: Blobs) -> None:
        if self.tuning is not None:
            self.tuning.search.found(blobs)
            self.changed.emit()

    def show_mask(self, mask: MaskShown | None) -> None:
        self.mask_view.show_image(*((None, ()) if mask is None else (mask.image, mask.rings)))

    def shut_down(self) -> None:
        self._search.shut_down()
