"""The 3D view with software rendering, which Qt paints.

It needs neither OpenGL nor a graphics card. With software GL, a QOpenGLWidget would make Qt compose
the whole window in GL, which halves the frame rate. `QWidget.grab` captures it.
"""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.raster.placing import NEAR
from app.widgets.view3d.raster.scene import RasterScene, camera_pose, focal_px
from app.widgets.view3d.scene import Label

MAX_PIXELS = 1000 * 800
"""Larger views are upscaled, so that rendering takes no more than a quarter of the frame time."""


class PaintedView(QWidget):
    """Renders in the calling thread: it takes milliseconds and releases the interpreter lock."""

    on_card = False

    def __init__(self, orbit: Orbit, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._orbit = orbit
        self._caption = ""
        self._labels: tuple[Label, ...] = ()
        self._image: QImage | None = None
        self.scene = RasterScene()

    def set_caption(self, text: str) -> None:
        self._caption = text

    def set_labels(self, labels: tuple[Label, ...]) -> None:
        self._labels = labels

    def render_scene(self) -> None:
        """Render the scene and show it."""
        if self.width() < 2 or self.height() < 2:
            return
        pixels = self.scene.render(self._orbit, *self._size_px())  # the image shares its memory
        height, width = pixels.shape
        self._image = QImage(
            pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB32
        )
        self.update()

    def _size_px(self) -> tuple[int, int]:
        ratio = self.devicePixelRatioF()
        w, h = self.width() * ratio, self.height() * ratio
        shrink = min(1.0, (MAX_PIXELS / (w * h)) ** 0.5)
        return max(2, int(w * shrink)), max(2, int(h * shrink))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        if self._image is not None:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(QRectF(self.rect()), self._image, QRectF(self._image.rect()))
            self._paint_labels(painter)
        if self._caption:
            self._paint_caption(painter)
        painter.end()

    def _paint_caption(self, painter: QPainter) -> None:
        """Draw the caption, legible on either background."""
        flags = int(Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap)
        room = self.rect().adjusted(20, self.height() - 56, -20, -12)
        words = painter.boundingRect(room, flags, self._caption)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(0, 0, 0, 190))
        painter.drawRoundedRect(words.adjusted(-8, -4, 8, 4), 4, 4)
        painter.setPen(QColor("#FFC95C"))
        painter.drawText(words, flags, self._caption)

    def _paint_labels(self, painter: QPainter) -> None:
        if not self._labels:
            return
        R_GC, p_GC = self.scene.camera or camera_pose(self._orbit)
        focal = focal_px(self.height())
        points = (np.array([label.p_G for label in self._labels]) - p_GC) @ R_GC
        for label, (x, y, z) in zip(self._labels, points.tolist(), strict=True):
            if z > NEAR:
                painter.setPen(QColor(label.colour))
                u, v = self.width() / 2 + focal * x / z, self.height() / 2 + focal * y / z
                painter.drawText(QPointF(u, v), label.text)

    def shut_down(self) -> None:
        """Remove the bodies."""
        self.scene.clear()
