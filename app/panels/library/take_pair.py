"""What the cameras saw in two takes at one instant of both, side by side."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSplitter, QWidget

from app.platform.tasks import JobProgress, LatestJob
from app.viewmodels.take_images import Image, TakeImages
from app.viewmodels.two_takes import TwoTakes
from app.widgets.image_view import ImageView

HIGH = 200  # px


class TakePair(QSplitter):
    """Images are read beside the window, the newest position alone; they move together."""

    def __init__(self, takes: TwoTakes, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        paths = takes.first.path, takes.second.path
        self._sources = tuple(TakeImages(path) for path in paths)
        nothing = self.tr("No image here")
        self.views = tuple(ImageView(path.stem, nothing) for path in paths)
        self.setChildrenCollapsible(False)
        for view, other in (self.views, self.views[::-1]):
            view.setMinimumHeight(HIGH)
            view.handled.connect(lambda v=view, o=other: o.show_like(v))
            self.addWidget(view)
        self._asked: tuple[float, ...] = ()
        self._reading = LatestJob(self.tr("Reading images"), self)

    def show_at(self, *positions: float) -> None:
        """s after the first measurement of each take."""
        if positions == self._asked:
            return
        self._asked = positions
        sources = self._sources

        def read(_progress: JobProgress) -> list[Image | None]:
            return [source.at(p) for source, p in zip(sources, positions, strict=True)]

        self._reading.run(read, self._show)

    def _show(self, images: Sequence[Image | None]) -> None:
        for view, image in zip(self.views, images, strict=True):
            view.show_image(image)

    def shut_down(self) -> None:
        """Wait for the image that is read, and close both files."""
        self._reading.shut_down()
        for source in self._sources:
            source.close()
