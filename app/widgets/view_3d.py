"""A 3D view for any machine: VTK renders off-screen, Qt paints the picture.

On software GL a QOpenGLWidget makes Qt compose the whole window in GL, which halves the window's
rate; a picture painted like any other does not, and `QWidget.grab` sees it. Multisampling is off
there: it costs four times the rendering.
"""

from __future__ import annotations

import logging
import os
import sys

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.widgets.orbit import Orbit

_log = logging.getLogger(__name__)
MAX_PIXELS = 900 * 700
"""Software GL fills about 10⁸ pixels a second with this scene; a larger view is scaled up."""

if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")


class View3D(QWidget):
    """Owns a pyvista plotter; ``plotter`` is None where no OpenGL can be had."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.orbit = Orbit()
        self.problem = ""
        self.caption = ""
        self._image: QImage | None = None
        self._pixels: np.ndarray | None = None
        self._drag: QPointF | None = None
        self.plotter = self._make_plotter()
        self.setMinimumSize(200, 160)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:
        return QSize(480, 400)

    def _make_plotter(self):  # type: ignore[no-untyped-def]
        try:
            import pyvista as pv

            plotter = pv.Plotter(off_screen=True, window_size=(480, 400), lighting="light kit")
            plotter.render_window.SetMultiSamples(0)
        except Exception as error:  # noqa: BLE001  a dead driver fails in its own ways
            _log.warning("No 3D view: %s", error)
            self.problem = self.tr("This machine offers no OpenGL, so the 3D view is off.")
            return None
        return plotter

    def set_background(self, colour: str) -> None:
        if self.plotter is not None:
            self.plotter.set_background(colour)

    def render_scene(self) -> None:
        """Render what the plotter holds from the orbit's eye and show it."""
        if self.plotter is None or self.width() < 2 or self.height() < 2:
            return
        self._fit_window()
        camera = self.plotter.camera
        camera.position = self.orbit.eye.tolist()
        camera.focal_point = self.orbit.target.tolist()
        camera.up = self.orbit.up.tolist()
        camera.view_angle = 32.0
        self.plotter.renderer.ResetCameraClippingRange()
        self.plotter.render()
        pixels = np.ascontiguousarray(self.plotter.screenshot(None, return_img=True))
        self._show(pixels)

    def _fit_window(self) -> None:
        ratio = self.devicePixelRatioF()
        w, h = self.width() * ratio, self.height() * ratio
        shrink = min(1.0, (MAX_PIXELS / (w * h)) ** 0.5)
        size = [max(2, int(w * shrink)), max(2, int(h * shrink))]
        if list(self.plotter.window_size) != size:
            self.plotter.window_size = size

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
        if self.plotter is not None:
            self.plotter.close()
            self.plotter = None
