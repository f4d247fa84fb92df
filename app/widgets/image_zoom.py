"""Which part of an image a widget shows, and how large."""

from __future__ import annotations

from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QWidget

MAX_ZOOM = 16.0
MAX_FOLLOW_ZOOM = 4.0
FILL = 0.6  # share of the view that a followed box takes
CALM = 0.2  # share of the way at each image


class ImageZoom:
    """An image of ``width`` by ``height`` pixels in ``view``; at a zoom of 1 all of it is seen."""

    def __init__(self, view: QWidget) -> None:
        self._view = view
        self.width = self.height = 1
        self.zoom = 1.0
        self.centre = QPointF(0.5, 0.5)  # of the view, in fractions of the image

    def _fitting(self) -> float:
        """Screen pixels per image pixel where the whole image is seen."""
        return min(self._view.width() / self.width, self._view.height() / self.height)

    @property
    def scale(self) -> float:
        """Screen pixels per image pixel."""
        return self._fitting() * self.zoom

    @property
    def origin(self) -> QPointF:
        """Where the image's top-left corner is on the widget."""
        s = self.scale
        u = self._view.width() / 2 - self.centre.x() * self.width * s
        v = self._view.height() / 2 - self.centre.y() * self.height * s
        return QPointF(u, v)

    def to_image(self, position: QPointF) -> tuple[float, float]:
        """A point of the widget in image pixels; pixel centres are whole numbers."""
        offset, s = position - self.origin, self.scale
        return offset.x() / s - 0.5, offset.y() / s - 0.5

    def fit(self) -> None:
        """Show the whole image."""
        self.zoom, self.centre = 1.0, QPointF(0.5, 0.5)

    def zoom_at(self, position: QPointF, factor: float) -> None:
        """Zoom, the pixel at ``position`` of the widget staying there."""
        before = self.to_image(position)
        self.zoom = min(max(self.zoom * factor, 1.0), MAX_ZOOM)
        after = self.to_image(position)
        self.move(before[0] - after[0], before[1] - after[1])

    def move(self, du: float, dv: float) -> None:
        """Move the view by image pixels."""
        self.centre += QPointF(du / self.width, dv / self.height)
        self.clamp()

    def clamp(self) -> None:
        """Keep the image in the view."""
        margin = 0.5 / self.zoom
        x = min(max(self.centre.x(), margin), 1 - margin)
        y = min(max(self.centre.y(), margin), 1 - margin)
        self.centre = QPointF(x, y)

    def follow(self, u: float, v: float, width: float, height: float) -> None:
        """Go some of the way to a view in which a box of image pixels fills the middle."""
        view = self._view
        wanted = FILL * min(view.width() / max(width, 1), view.height() / max(height, 1))
        wanted = min(max(wanted / self._fitting(), 1.0), MAX_FOLLOW_ZOOM)
        self.zoom += CALM * (wanted - self.zoom)
        self.centre += (QPointF(u / self.width, v / self.height) - self.centre) * CALM
        self.clamp()
