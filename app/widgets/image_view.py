"""An image with shapes drawn over it; zoomed by the wheel, moved by dragging.

Image and shapes are composed by compiled code (`app.widgets.image_canvas`) when they change, and
painted as one image.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetrics,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.platform.painting_pauses import PAINTING
from app.widgets.image_canvas import ImageCanvas, Labels, Placing
from app.widgets.image_shapes import Drawn
from app.widgets.measures import SMALL

KEY_ZOOM = 1.25
ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
BACKGROUND = QColor("#15181c")


MAX_ZOOM = 16.0
MAX_FOLLOW_ZOOM = 4.0
FILL = 0.6  # share of the view that a followed box fills
STEADY = 0.2  # relative movement per image


class ImageZoom:
    """An image of ``width`` by ``height`` pixels in ``view``; a zoom of 1 shows all of it."""

    def __init__(self, view: QWidget) -> None:
        self._view = view
        self.width = self.height = 1
        self.zoom = 1.0
        self.centre = QPointF(0.5, 0.5)  # of the view, in fractions of the image

    def _fitting(self) -> float:
        """Screen pixels per image pixel when the whole image is visible."""
        return min(self._view.width() / self.width, self._view.height() / self.height)

    @property
    def scale(self) -> float:
        """Screen pixels per image pixel."""
        return self._fitting() * self.zoom

    @property
    def origin(self) -> QPointF:
        """Position of the image's top-left corner on the widget."""
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
        """Zoom around ``position`` of the widget."""
        before = self.to_image(position)
        self.zoom = min(max(self.zoom * factor, 1.0), MAX_ZOOM)
        after = self.to_image(position)
        self.move(before[0] - after[0], before[1] - after[1])

    def move(self, du: float, dv: float) -> None:
        """Move the view by image pixels."""
        self.centre += QPointF(du / self.width, dv / self.height)
        self.clamp()

    def clamp(self) -> None:
        """Limit the view to the image."""
        margin = 0.5 / self.zoom
        x = min(max(self.centre.x(), margin), 1 - margin)
        y = min(max(self.centre.y(), margin), 1 - margin)
        self.centre = QPointF(x, y)

    def follow(self, u: float, v: float, width: float, height: float) -> None:
        """Move gradually towards a view in which a box of image pixels fills the centre."""
        view = self._view
        wanted = FILL * min(view.width() / max(width, 1), view.height() / max(height, 1))
        wanted = min(max(wanted / self._fitting(), 1.0), MAX_FOLLOW_ZOOM)
        self.zoom += STEADY * (wanted - self.zoom)
        self.centre += (QPointF(u / self.width, v / self.height) - self.centre) * STEADY
        self.clamp()


class ImageView(QWidget):
    """Shows a BGR image (h, w, 3) uint8 and `Shape`s in its pixels."""

    picked = Signal(float, float, object)  # u, v in image pixels, Qt.KeyboardModifiers
    handled = Signal()  # the user has zoomed or moved the image

    def __init__(self, title: str, placeholder: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = title
        self._placeholder = placeholder
        self._array: NDArray[np.uint8] | None = None
        self._shapes: Sequence[Drawn] = ()
        self._canvas = ImageCanvas()
        self._composed: object = None  # content of the canvas
        self._labels: Labels | None = None
        self._titled: tuple[tuple[str, str, float] | None, QPixmap] = None, QPixmap()
        self.zoom = ImageZoom(self)
        self._drag: QPointF | None = None
        self._picking = False
        self.setMinimumSize(160, 64)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(title)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(
            self.tr("Wheel or + −: zoom. Drag or arrows: move. Double-click or 0: whole image.")
        )

    def sizeHint(self) -> QSize:
        return QSize(480, 270)

    def show_image(self, image: NDArray[np.uint8] | None, shapes: Sequence[Drawn] = ()) -> None:
        """Show ``image`` (None: a placeholder) with ``shapes`` drawn over it."""
        self._array = None if image is None else np.ascontiguousarray(image)
        self._shapes, self._composed = shapes, None
        if self._array is not None:
            self.zoom.height, self.zoom.width = self._array.shape[:2]
        self.update()

    def set_title(self, text: str) -> None:
        """Set the text in the corner."""
        self._title = text
        self.update()

    def set_placeholder(self, text: str) -> None:
        self._placeholder = text
        self.update()

    def set_picking(self, on: bool) -> None:
        """While picking is on, a click reports a pixel instead of moving the image."""
        self._picking = on
        self.setCursor(Qt.CursorShape.CrossCursor if on else Qt.CursorShape.ArrowCursor)

    def fit(self) -> None:
        """Show the whole image."""
        self.zoom.fit()
        self.update()

    def show_like(self, other: ImageView) -> None:
        """Show the same part of the image as ``other``, which has the same size."""
        self.zoom.zoom, self.zoom.centre = other.zoom.zoom, QPointF(other.zoom.centre)
        self.zoom.clamp()
        self.update()

    def follow(self, u: float, v: float, width: float, height: float) -> None:
        """Move gradually towards a view in which a box of image pixels fills the centre."""
        if self._array is None or self._drag is not None:
            return
        self.zoom.follow(u, v, width, height)

    # --- events

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self._array is None:
            return
        self.zoom.zoom_at(event.position(), math.pow(1.0015, event.angleDelta().y()))
        self._handled()
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        middle, step = QPointF(self.rect().center()), self.width() / 8
        if self._array is None:
            super().keyPressEvent(event)
            return
        if event.key() in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
            self.zoom.zoom_at(middle, KEY_ZOOM)
        elif event.key() == Qt.Key.Key_Minus:
            self.zoom.zoom_at(middle, 1 / KEY_ZOOM)
        elif event.key() == Qt.Key.Key_0:
            self.zoom.fit()
        elif Qt.Key(event.key()) in ARROWS:
            right, down = ARROWS[Qt.Key(event.key())]
            self.zoom.move(right * step / self.zoom.scale, down * step / self.zoom.scale)
        else:
            super().keyPressEvent(event)
            return
        self._handled()

    def _handled(self) -> None:
        """The user has selected another part of the image."""
        self.update()
        self.handled.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._array is None:
            return
        if self._picking and event.button() == Qt.MouseButton.LeftButton:
            u, v = self.zoom.to_image(event.position())
            height, width = self._array.shape[:2]
            if 0 <= round(u) < width and 0 <= round(v) < height:
                self.picked.emit(u, v, event.modifiers())
            return
        self._drag = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._drag is None or self._array is None:
            return
        step, s = self._drag - event.position(), self.zoom.scale
        self._drag = event.position()
        self.zoom.move(step.x() / s, step.y() / s)
        self._handled()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._drag = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if not self._picking:
            self.handled.emit()
            self.fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.zoom.clamp()

    # --- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        if self._array is None:
            painter.fillRect(self.rect(), BACKGROUND)
            _paint_placeholder(painter, self.rect(), self._placeholder)
        else:
            self._paint_image(painter, self._array)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font())
        self._paint_title(painter)
        if self.hasFocus():
            _paint_focus(painter, self)
        painter.end()

    def _paint_image(self, painter: QPainter, image: NDArray[np.uint8]) -> None:
        ratio, origin = self.devicePixelRatioF(), self.zoom.origin
        size = round(self.width() * ratio), round(self.height() * ratio)
        corner = ratio * origin.x(), ratio * origin.y()
        state = (size, self.zoom.scale, corner, self.font().key())
        if state != self._composed:
            PAINTING.pause()
            self._labels = _labels_of(self.font(), ratio, self._labels)
            placing = Placing(ratio * self.zoom.scale, *corner, self._labels)
            self._canvas.compose(size, image, self._shapes, placing, BACKGROUND)
            self._composed = state
        painter.drawImage(0, 0, self._canvas.image)

    def _paint_title(self, painter: QPainter) -> None:
        """The painted title is cached: it would otherwise be painted with each camera image."""
        made = self._title, self.font().key(), self.devicePixelRatioF()
        if made != self._titled[0]:
            self._titled = made, _title_image(self._title, self.font(), made[2])
        painter.drawPixmap(8, 8, self._titled[1])


def _labels_of(font: QFont, ratio: float, before: Labels | None) -> Labels:
    """Labels in small letters of ``font``: ``before``, if these are the same."""
    font = QFont(font)
    font.setPointSizeF(SMALL)
    same = before is not None and before.font == font and before.ratio == ratio
    return before if before is not None and same else Labels(font, ratio)


def _title_image(title: str, font: QFont, ratio: float) -> QPixmap:
    """The title in a dark box."""
    metrics = QFontMetrics(font)
    box = QRectF(0, 0, metrics.horizontalAdvance(title) + 16, metrics.height() + 6)
    image = QPixmap((box.size() * ratio).toSize())
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setFont(font)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(0, 0, 0, 140))
    painter.drawRoundedRect(box, 4, 4)
    painter.setPen(QColor("#f2f4f6"))
    painter.drawText(box, int(Qt.AlignmentFlag.AlignCenter), title)
    painter.end()
    return image


def _paint_placeholder(painter: QPainter, room: QRect, text: str) -> None:
    painter.setPen(QColor("#9aa4af"))
    flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    painter.drawText(room.adjusted(16, 16, -16, -16), int(flags), text)


def _paint_focus(painter: QPainter, widget: QWidget) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(QPen(widget.palette().highlight().color(), 2))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(widget.rect().adjusted(1, 1, -1, -1))
