"""Images with shapes, composed by compiled code: compared with Qt's own painter."""

from __future__ import annotations

import math

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPainter, QPen

from app.widgets.image_canvas import ImageCanvas, Labels, Placing
from app.widgets.image_shapes import Cross, Ellipse, ImageLabel, ImageLine, Ring
from app.widgets.image_view import ImageView

pytestmark = pytest.mark.styled

SIZE = (120, 90)  # width and height of the canvas
BACK = QColor("#203040")


def composed(shapes, scale=1.0, corner=(0.0, 0.0), source=None, ratio=1.0) -> np.ndarray:
    """(h, w, 3) red, green and blue."""
    source = np.full((90, 120), 90, np.uint8) if source is None else source
    canvas = ImageCanvas()
    placing = Placing(scale, *corner, Labels(QFont(), ratio))
    canvas.compose(SIZE, source, shapes, placing, BACK)
    return pixels(canvas.image)


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGB32)
    height, width = image.height(), image.width()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(height, width, 4)
    return rows[:, :, 2::-1].astype(int)


def painted(draw) -> np.ndarray:
    """What Qt paints over the same grey image."""
    image = QImage(*SIZE, QImage.Format.Format_RGB32)
    image.fill(QColor(90, 90, 90))
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw(painter)
    painter.end()
    return pixels(image)


def pen(colour: str, width: float) -> QPen:
    made = QPen(QColor(colour), width)
    made.setCapStyle(Qt.PenCapStyle.RoundCap)
    return made


def line(painter: QPainter) -> None:
    painter.setPen(pen("#ff8000", 2.5))
    painter.drawLine(QPointF(10.5, 12.5), QPointF(100.5, 70.5))


def ring(painter: QPainter) -> None:
    painter.setPen(pen("#00c0ff", 2.0))
    filling = QColor("#00c0ff")
    filling.setAlpha(110)
    painter.setBrush(filling)
    painter.drawEllipse(QPointF(60.5, 45.5), 20.0, 20.0)


def ellipse(painter: QPainter) -> None:
    painter.setOpacity(0.8)
    painter.setPen(pen("#ffffff", 1.0))
    painter.translate(QPointF(60.5, 45.5))
    painter.rotate(math.degrees(0.6))
    painter.drawEllipse(QPointF(0, 0), 40.0, 14.0)


def cross(painter: QPainter) -> None:
    painter.setPen(pen("#ff2020", 1.5))
    for arm in (QPointF(3.5, 3.5), QPointF(3.5, -3.5)):
        painter.drawLine(QPointF(30.5, 30.5) - arm, QPointF(30.5, 30.5) + arm)


@pytest.mark.parametrize(
    ("shape", "draw"),
    [
        (ImageLine(10, 12, 100, 70, "#ff8000", 2.5), line),
        (Ring(60, 45, 20, "#00c0ff", 2.0, filled=True), ring),
        (Ellipse(60, 45, 40, 14, 0.6, "#ffffff", 0.8), ellipse),
        (Cross(30, 30, "#ff2020", diagonal=True), cross),
    ],
    ids=["line", "ring", "ellipse", "cross"],
)
def test_shapes_look_as_qt_paints_them(qapp, shape, draw):
    """The two differ in how they estimate a pixel's coverage, by up to half of it at the
    sharp ends of ellipses, by a tenth on average."""
    ours, qts = composed([shape]), painted(draw)
    inked = (np.abs(qts - 90) > 4).any(axis=2)
    assert inked.sum() > 20
    contrast = np.abs(qts - 90).max()
    difference = np.abs(ours - qts).max(axis=2)
    assert difference.max() < 0.5 * contrast
    assert difference[inked].mean() < 0.12 * contrast
    ink = np.abs(ours - 90).sum() / np.abs(qts - 90).sum()
    thin = isinstance(shape, Ellipse)  # Qt draws pens of one pixel fainter than they are wide
    assert ink == pytest.approx(1.2 if thin else 1.0, abs=0.08)
    assert (ours[~inked] == 90).mean() > 0.97


def test_dashed_lines_have_gaps(qapp):
    whole = composed([ImageLine(5, 45, 115, 45, "#ffffff", 2.0)])[45, 10:110, 0]
    dashed = composed([ImageLine(5, 45, 115, 45, "#ffffff", 2.0, dashed=True)])[45, 10:110, 0]
    assert (whole > 240).all()
    assert (dashed > 200).mean() == pytest.approx(4 / 6, abs=0.06)
    assert (dashed == 90).mean() > 0.2


def test_the_image_is_scaled_as_by_qt(qapp):
    """To a pixel of the image, where Qt rounds its corner."""
    v, u = np.mgrid[:30, :40]
    source = np.stack([6 * u, 255 - 6 * u, 8 * v], axis=2).astype(np.uint8)
    for scale, corner in ((2.5, (7.25, -3.5)), (0.7, (20.0, 10.0))):
        ours = composed([], scale, corner, source)
        image = QImage(*SIZE, QImage.Format.Format_RGB32)
        image.fill(BACK)
        painter = QPainter(image)
        shared = QImage(source.data, 40, 30, 120, QImage.Format.Format_BGR888)
        target = QRectF(*corner, 40 * scale, 30 * scale)
        painter.drawImage(target, shared, QRectF(0, 0, 40, 30))
        painter.end()
        difference = np.abs(ours - pixels(image)).max(axis=2)
        assert (difference <= 8).mean() > 0.96, "but for rounding at edges"
        assert (difference == 0).mean() > 0.5


def test_texts_are_drawn_next_to_their_point_and_hidden_where_they_would_overlap(qapp):
    label = ImageLabel(40, 50, "17", "#ffd000", least_zoom=0.8)
    drawn = composed([label])
    rows, columns = np.nonzero((drawn != 90).any(axis=2))
    assert rows.min() > 30 and rows.max() < 54 and columns.min() > 43 and columns.max() < 66
    assert (drawn[:, :, 0] > 200).any() and (drawn[:, :, 0] < 60).any(), "ink and outline"
    assert (composed([label], scale=0.5)[:40, :50] == 90).all()


def test_shapes_outside_the_canvas_change_nothing(qapp):
    far = [
        Ring(-500, 45, 20, "#ffffff", filled=True),
        Ellipse(5000, -400, 60, 3, 1.0, "#ffffff"),
        ImageLine(-50, -50, -10, 300, "#ffffff"),
        Cross(400, 45, "#ffffff"),
        ImageLabel(-90, 45, "outside", "#ffffff"),
    ]
    np.testing.assert_array_equal(composed(far), composed([]))


def test_a_view_is_composed_again_when_it_is_zoomed_or_gets_an_image(qtbot):
    view = ImageView("left", "no image")
    qtbot.addWidget(view)
    view.resize(200, 120)
    image = np.random.default_rng(1).integers(0, 256, (60, 100, 3), np.uint8)
    view.show_image(image, [Ring(50, 30, 10, "#ffffff")])
    first = view.grab().toImage()
    assert view.grab().toImage() == first
    qtbot.keyClick(view, Qt.Key.Key_Plus)
    zoomed = view.grab().toImage()
    assert zoomed != first
    view.show_image(255 - image)
    assert view.grab().toImage() != zoomed
