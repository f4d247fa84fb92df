"""The 3D view of a machine without a graphics card: VTK renders off-screen, Qt paints the picture.

On software GL a QOpenGLWidget makes Qt compose the whole window in GL, which halves the window's
rate; a picture painted like any other does not, and `QWidget.grab` sees it. Multisampling is off
there: it costs four times the rendering.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.widgets.orbit import Orbit

if TYPE_CHECKING:
    from app.widgets.vtk_scene import VtkScene

MAX_PIXELS = 900 * 700
"""Software GL fills about 10⁸ pixels a second with this scene; a larger view is scaled up."""


class PaintedView(QWidget):
    """Raises what VTK raises where no OpenGL can be had at all."""

    on_card = False

    def __init__(self, orbit: Orbit, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        from app.widgets.vtk_scene import VtkScene

        self._orbit = orbit
        self._caption = ""
        self._image: QImage | None = None
        self._pixels: np.ndarray | None = None
        self.scene: VtkScene | None = VtkScene()

    def set_caption(self, text: str) -> None:
        self._caption = text

    def render_scene(self) -> None:
        """Render the scene from the orbit's eye and show it."""
        if self.scene is not None and self.width() >= 2 and self.height() >= 2:
            self._show(self.scene.render(self._orbit, *self._size_px()))

    def _size_px(self) -> tuple[int, int]:
        ratio = self.devicePixelRatioF()
        w, h = self.width() * ratio, self.height() * ratio
        shrink = min(1.0, (MAX_PIXELS / (w * h)) ** 0.5)
        return max(2, int(w * shrink)), max(2, int(h * shrink))

    def _show(self, pixels: np.ndarray) -> None:
        height, width = pixels.shape[:2]
        self._pixels = pixels  # the image shares its memory
        self._image = QImage(
            pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB888
        )
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        if self._image is not None:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(QRectF(self.rect()), self._image, QRectF(self._image.rect()))
        if self._caption:
            box = self.rect().adjusted(12, self.height() - 44, -12, -8)
            painter.setPen(QColor("#E69F00"))
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(box, int(flags), self._caption)
        painter.end()

    def shut_down(self) -> None:
        """Free the GL context while it can still be made current."""
        scene, self.scene = self.scene, None
        if scene is not None:
            scene.close()
