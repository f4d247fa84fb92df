"""The curves of a plot as one image over the plot's view."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QImage, QPainter, QPixmap
from PySide6.QtWidgets import QLabel

from app.platform.painting_pauses import PAINTING
from app.widgets.curve_strokes import COLUMNS, COUNT, FIRST, SHOWN, draw_curves, visible_spans
from app.widgets.image_canvas import rgb
from tracker.messages import Array

DASHES = {
    Qt.PenStyle.SolidLine: (0.0, 1.0),
    Qt.PenStyle.DashLine: (4.0, 6.0),
    Qt.PenStyle.DotLine: (1.0, 3.0),
}
"""Length of a dash, and distance from one to the next, in widths: Qt's."""


Joined = tuple[list[tuple[Array, Array]], Array, Array]
"""Curves, and all their instants and values."""


class DrawnCurve(Protocol):
    """A curve's look and the axes that it belongs to."""

    colour: str
    style: Qt.PenStyle
    box: pg.ViewBox

    def isVisible(self) -> bool: ...


class CurveCanvas:
    """A label over the view of ``plot``. Qt paints it without Python, and the plot's own scene,
    whose axes and grid are the backdrop, only when it changes. The mouse does not notice it."""

    def __init__(self, plot: pg.PlotWidget) -> None:
        self._plot = plot
        self.label = QLabel(plot.viewport())
        self.label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.label.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.label.hide()
        self._place = QRect()
        self._ratio = 1.0
        self._pixels = self._backdrop = np.zeros((0, 0), np.uint32)
        self._cover = np.zeros((0, 0), np.uint8)
        self._image = QImage()
        self.is_stale = True  # whether the backdrop has changed
        self._joined: Joined = [], np.empty(0), np.empty(0)

    def hide(self) -> None:
        """Show the plot's own scene, which has no curves."""
        self.label.hide()

    def spans(
        self, curves: Sequence[DrawnCurve], data: Sequence[tuple[Array, Array]], now: float
    ) -> Array:
        """(n, 2): least and greatest visible value of each curve, NaN without any."""
        t, values = self._join(data)
        return visible_spans(t, values, self._rows(curves, data, now))

    def compose(
        self, curves: Sequence[DrawnCurve], data: Sequence[tuple[Array, Array]], now: float
    ) -> None:
        """Draw the curves: t (k,) s, of which ``now`` is 0 of the axis, and values (k,) of each."""
        PAINTING.pause()
        self._follow_view()
        if self._place.isEmpty():
            self.label.hide()
            return
        t, values = self._join(data)
        rows = self._rows(curves, data, now)
        draw_curves(t, values, rows, self._backdrop, self._cover, self._pixels)
        self.label.setPixmap(QPixmap.fromImage(self._image))
        self.label.show()

    def _join(self, data: Sequence[tuple[Array, Array]]) -> tuple[Array, Array]:
        """All instants and all values; those of a whole recording are joined only once."""
        before, t, values = self._joined
        same = len(before) == len(data) and all(
            a[0] is b[0] and a[1] is b[1] for a, b in zip(before, data, strict=True)
        )
        if not same:
            t = np.concatenate([each for each, _ in data])
            values = np.concatenate([each for _, each in data])
            self._joined = list(data), t, values
        return t, values

    def _rows(
        self, curves: Sequence[DrawnCurve], data: Sequence[tuple[Array, Array]], now: float
    ) -> Array:
        """(n, `COLUMNS`), see `curve_strokes`."""
        rows, first = np.empty((len(curves), COLUMNS)), 0
        ranges: dict[int, tuple[float, ...]] = {}
        for row, curve, (t, _) in zip(rows, curves, data, strict=True):
            if id(curve.box) not in ranges:
                ranges[id(curve.box)] = self._axes_of(curve.box, now)
            row[FIRST], row[COUNT], row[SHOWN] = first, len(t), curve.isVisible()
            row[COUNT + 1 : SHOWN] = (
                *ranges[id(curve.box)], self._ratio, *DASHES[curve.style], *rgb(curve.colour)
            )  # fmt: skip
            first += len(t)
        return rows

    def _axes_of(self, box: pg.ViewBox, now: float) -> tuple[float, ...]:
        """Instants and values at the edges of a view; left, top, width and height, px."""
        (begin, end), (low, high) = box.viewRange()
        view = self._plot.viewportTransform().mapRect(box.sceneBoundingRect())
        left, top = view.x() - self._place.x(), view.y() - self._place.y()
        size = (left, top, view.width(), view.height())
        return begin + now, end + now, low, high, *(self._ratio * part for part in size)

    def _follow_view(self) -> None:
        """Place the label over the plot's view, and render axes and grid if they have changed."""
        plot = self._plot
        view = plot.viewportTransform().mapRect(plot.getPlotItem().vb.sceneBoundingRect())
        position = view.toAlignedRect().intersected(plot.viewport().rect())
        ratio = plot.devicePixelRatioF()
        if position == self._place and ratio == self._ratio and not self.is_stale:
            return
        self._place, self._ratio, self.is_stale = position, ratio, False
        self.label.setGeometry(position)
        shape = max(round(position.height() * ratio), 0), max(round(position.width() * ratio), 0)
        if shape != self._pixels.shape:
            self._pixels, self._cover = np.empty(shape, np.uint32), np.zeros(shape, np.uint8)
            self._image = _image_of(self._pixels, ratio)
        self._backdrop = self._rendered(shape)

    def _rendered(self, shape: tuple[int, int]) -> NDArray[np.uint32]:
        """The plot without curves."""
        if not shape[0] * shape[1]:
            return np.empty(shape, np.uint32)
        image = QImage(shape[1], shape[0], QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(self._ratio)
        image.fill(self._plot.backgroundBrush().color())
        painter = QPainter(image)
        target = QRectF(0, 0, self._place.width(), self._place.height())
        self._plot.render(painter, target, self._place)
        painter.end()
        return np.frombuffer(image.constBits(), np.uint32).reshape(shape).copy()


def _image_of(pixels: NDArray[np.uint32], ratio: float) -> QImage:
    """An image that shares the memory of pixels (h, w)."""
    height, width = pixels.shape
    image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    return image
