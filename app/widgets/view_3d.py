"""A 3D view for any machine: VTK renders off-screen, Qt paints the picture.

On software GL a QOpenGLWidget makes Qt compose the whole window in GL, which halves the window's
rate; a picture painted like any other does not, and `QWidget.grab` sees it. Multisampling is off
there: it costs four times the rendering.
"""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.widgets.orbit import Orbit

if TYPE_CHECKING:
    from app.widgets.vtk_scene import VtkScene

_log = logging.getLogger(__name__)
MAX_PIXELS = 900 * 700
"""Software GL fills about 10⁸ pixels a second with this scene; a larger view is scaled up."""


class View3D(QWidget):
    """Owns the scene; ``scene`` is None where no OpenGL can be had."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.orbit = Orbit()
        self.problem = ""
        self.caption = ""
        self._image: QImage | None = None
        self._pixels: np.ndarray | None = None
        self._drag: QPointF | None = None
        self.scene = self._make_scene()
        self.setMinimumSize(200, 160)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:
        return QSize(480, 400)

    def _make_scene(self) -> VtkScene | None:
        try:
            from app.widgets.vtk_scene import VtkScene

            return VtkScene()
        except Exception as error:  # noqa: BLE001  a dead driver fails in its own ways
            _log.warning("No 3D view: %s", error)
            self.problem = self.tr("This machine offers no OpenGL, so the 3D view is off.")
            return None

    def set_background(self, colour: str) -> None:
        if self.scene is not None:
            self.scene.set_background(colour)

    def render_scene(self) -> None:
        """Render the scene from the orbit's eye and show it."""
        if self.scene is None or self.width() < 2 or self.height() < 2:
            return
        self._show(self.scene.render(self.orbit, *self._size_px()))

    def _size_px(self) -> tuple[int, int]:
        ratio = self.devicePixelRatioF()
        w, h = self.width() * ratio, self.height() * ratio
        shrink = min(1.0, (MAX_PIXELS / (w * h)) ** 0.5)
        return max(2, int(w * shrink)), max(2, int(h * shrink))

    def _show(self, pixels: np.ndarray) -> None:
        height, width = pixels.shape[:2]
        self._pixels = pixels
        self._image = QImage(
            pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB888
        )
        self.update()

    # --- events

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._drag = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._drag is None:
            return
        step = event.position() - self._drag
        self._drag = event.position()
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.orbit.turn(-step.x() * 0.008, step.y() * 0.008)
        else:
            self.orbit.pan(-step.x() / self.height(), step.y() / self.height())
        self.render_scene()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._drag = None

    def wheelEvent(self, event: QWheelEvent) -> None:
        self.orbit.zoom(0.999 ** event.angleDelta().y())
        self.render_scene()
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        if self._image is not None:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(QRectF(self.rect()), self._image, QRectF(self._image.rect()))
        text = self.problem or self.caption
        if text:
            self._paint_caption(painter, text)
        painter.end()

    def _paint_caption(self, painter: QPainter, text: str) -> None:
        box = self.rect().adjusted(12, self.height() - 44, -12, -8)
        painter.setPen(QColor("#E69F00"))
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(box, int(flags), text)

    def shut_down(self) -> None:
        """Free the GL context while it can still be made current."""
        if self.scene is not None:
            self.scene.close()
            self.scene = None
