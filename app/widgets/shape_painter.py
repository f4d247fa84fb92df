"""Painting of overlay shapes: line widths do not depend on the zoom."""

from __future__ import annotations

import math

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.widgets.image_shapes import Cross, Ellipse, ImageLabel, ImageLine, Ring, Shape

FILLING = 110  # alpha


def _pen(colour: str, width: float, dashed: bool) -> QPen:
    pen = QPen(QColor(colour), width)
    pen.setCosmetic(True)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    if dashed:
        pen.setStyle(Qt.PenStyle.DashLine)
    return pen


def paint_shape(painter: QPainter, shape: Shape, s: float, origin: QPointF) -> None:
    """One shape; ``s`` screen pixels per image pixel, ``origin`` of the image."""

    def at(u: float, v: float) -> QPointF:
        return QPointF(origin.x() + (u + 0.5) * s, origin.y() + (v + 0.5) * s)

    painter.setOpacity(shape.opacity)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if isinstance(shape, ImageLine):
        painter.setPen(_pen(shape.colour, shape.width, shape.dashed))
        painter.drawLine(at(shape.u0, shape.v0), at(shape.u1, shape.v1))
    elif isinstance(shape, Ring):
        painter.setPen(_pen(shape.colour, shape.width, shape.dashed))
        if shape.filled:
            colour = QColor(shape.colour)
            colour.setAlpha(FILLING)
            painter.setBrush(colour)
        painter.drawEllipse(at(shape.u, shape.v), shape.radius * s, shape.radius * s)
    elif isinstance(shape, Ellipse):
        _paint_ellipse(painter, shape, s, at(shape.u, shape.v))
    elif isinstance(shape, Cross):
        _paint_cross(painter, shape, at(shape.u, shape.v))
    elif s >= shape.least_zoom:
        _paint_label(painter, shape, at(shape.u, shape.v))


def _paint_ellipse(painter: QPainter, shape: Ellipse, s: float, centre: QPointF) -> None:
    painter.save()
    painter.setPen(_pen(shape.colour, 1.0, False))
    painter.translate(centre)
    painter.rotate(math.degrees(shape.angle))
    painter.drawEllipse(QPointF(0, 0), shape.a * s, shape.b * s)
    painter.restore()


def _paint_cross(painter: QPainter, shape: Cross, centre: QPointF) -> None:
    painter.setPen(_pen(shape.colour, 1.5, False))
    r = 3.5
    arms = [(r, r), (r, -r)] if shape.diagonal else [(r, 0.0), (0.0, r)]
    for dx, dy in arms:
        arm = QPointF(dx, dy)
        painter.drawLine(centre - arm, centre + arm)


def _paint_label(painter: QPainter, shape: ImageLabel, anchor: QPointF) -> None:
    """Text with a dark outline, legible on any image."""
    where = anchor + QPointF(5, -4)
    painter.setPen(QColor(0, 0, 0, 200))
    for dx, dy in ((1, 1), (-1, 1)):
        painter.drawText(where + QPointF(dx, dy), shape.text)
    painter.setPen(QColor(shape.colour))
    painter.drawText(where, shape.text)
