"""The 3D view: rendered on the graphics card if possible, otherwise in software."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from app.widgets.view3d.orbit import Orbit, OrbitControl
from app.widgets.view3d.raster.placing import NEAR
from app.widgets.view3d.raster.scene import RasterScene, camera_pose, focal_px
from app.widgets.view3d.scene import BodyScene, Label, contrast

if TYPE_CHECKING:
    from app.widgets.view3d.gpu_view import GpuView

MAX_PIXELS = 1000 * 800
"""Larger views are upscaled, so that rendering takes no more than a quarter of the frame time."""


class PaintedView(QWidget):
    """The view with software rendering, which Qt paints: it needs neither OpenGL nor a card.

    With software GL, a QOpenGLWidget would make Qt compose the whole window in GL, which halves the
    frame rate. `QWidget.grab` captures this view. It renders in the calling thread: that takes
    milliseconds and releases the interpreter lock.
    """

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


_log = logging.getLogger(__name__)


LEAST = 4.5  # minimum contrast of text
STEPS = 20


def luminance(colour: str) -> float:
    """Relative luminance of ``#rrggbb`` in sRGB, 0 to 1 (WCAG 2.1)."""
    shares = [share / 255 for share in _channels(colour)]
    linear = [s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast_of(one: str, other: str) -> float:
    """Contrast ratio: 1 for identical colours, 21 for black on white."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@cache
def legible(colour: str, ground: str) -> str:
    """``colour``, made darker or lighter until text is legible on ``ground`` (WCAG 2.1, 1.4.3)."""
    end = max(("#000000", "#FFFFFF"), key=lambda c: contrast_of(c, ground))
    mixed = (_mixed(colour, end, k / STEPS) for k in range(STEPS + 1))
    return next((c for c in mixed if contrast_of(c, ground) >= LEAST), end)


def _mixed(one: str, other: str, share: float) -> str:
    pairs = zip(_channels(one), _channels(other), strict=True)
    return "#" + "".join(f"{round(a + share * (b - a)):02x}" for a, b in pairs)


def _channels(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]


class View3D(QWidget):
    """Owns the orbit and the renderer; ``scene`` is None after shut-down.

    ``scene_changed``: another renderer is in use, with an empty scene.
    """

    scene_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.orbit = Orbit()
        self._background = "#000000"
        self._labels: tuple[Label, ...] = ()
        self._view: PaintedView | GpuView | None = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self.setMinimumSize(200, 48)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.use_painted()

    def sizeHint(self) -> QSize:
        return QSize(480, 400)

    # --- which view

    @property
    def scene(self) -> BodyScene | None:
        return self._view.scene if self._view is not None else None

    @property
    def on_card(self) -> bool:
        """Whether the graphics card renders the view."""
        return self._view is not None and self._view.on_card

    def use_painted(self) -> None:
        """Use software rendering."""
        self._put(PaintedView(self.orbit))

    def use_card(self) -> bool:
        """Use the graphics card; False, without a change, if that fails."""
        try:
            # deferred: needs the extra packages of the graphics card's view
            from app.widgets.view3d.gpu_view import GpuView

            view = GpuView(self.orbit)
        except Exception as error:  # noqa: BLE001  a dead driver fails in its own ways
            _log.warning("The 3D view stays painted: %s", error)
            return False
        self._put(view)
        return True

    def _put(self, view: PaintedView | GpuView) -> None:
        """Replace the current renderer."""
        before, self._view = self._view, view
        if before is not None:
            self._column.removeWidget(before)
            before.shut_down()
            before.deleteLater()
        surface = getattr(view, "surface", view)
        surface.setAccessibleName(self.tr("The hand in 3D"))
        OrbitControl(surface, self.orbit).turned.connect(self.render_scene)
        self.setFocusProxy(surface)
        self._column.addWidget(view, 1)
        if view.scene is not None:
            view.scene.set_background(self._background)
            view.scene.set_ink(contrast(self._background))
        self._write_labels()
        self.scene_changed.emit()

    # --- drawing

    @property
    def caption(self) -> str:
        return self._caption

    @caption.setter
    def caption(self, text: str) -> None:
        self._caption = text
        if self._view is not None:
            self._view.set_caption(text)

    _caption = ""

    def set_background(self, colour: str) -> None:
        self._background = colour
        if self.scene is not None:
            self.scene.set_background(colour)
            self.scene.set_ink(contrast(colour))
        self._write_labels()

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Set short texts next to points of G, drawn over everything."""
        if tuple(labels) != self._labels:  # by identity
            self._labels = tuple(labels)
            self._write_labels()

    def _write_labels(self) -> None:
        if self._view is not None:
            ground = self._background
            legible_labels = (replace(w, colour=legible(w.colour, ground)) for w in self._labels)
            self._view.set_labels(tuple(legible_labels))

    def render_scene(self) -> None:
        """Render the scene; if the graphics card fails, switch to software rendering."""
        if self._view is None:
            return
        try:
            self._view.render_scene()
        except Exception as error:
            if not self.on_card:
                raise
            _log.warning("The graphics card gave up, the 3D view is painted from now on: %s", error)
            self.use_painted()

    def shut_down(self) -> None:
        """Release the renderer's resources before its window is deleted."""
        if self._view is not None:
            self._view.shut_down()
            self._view = None
