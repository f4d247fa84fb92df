"""The image of curves, when axes are drawn, and the thinning of many points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication

from app.widgets.curve_plot import CurveLook, ScrollPlot
from app.widgets.curve_strokes import (
    BEGIN,
    COLUMNS,
    COUNT,
    END,
    SHOWN,
    WIDE,
    thin_curve,
    visible_spans,
)


def shown(plot: ScrollPlot) -> np.ndarray:
    """(h, w, 3) pixels over the view."""
    image = plot.plot.viewport().children()[-1].pixmap().toImage()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)
    return rows[:, : image.width(), 2::-1].astype(int)


def plot_of(qtbot, size: tuple[int, int], looks: Sequence[CurveLook]) -> ScrollPlot:
    plot = ScrollPlot("rate", 8.0, (-400.0, 400.0))
    qtbot.addWidget(plot)
    plot.resize(*size)
    plot.set_colours("#000000", "#ffffff")
    plot.set_looks(looks)
    plot.show()
    qtbot.waitExposed(plot)
    return plot


def test_axes_are_drawn_when_they_change_and_not_when_curves_move(qtbot, monkeypatch):
    """They cost more than the curves."""
    drawn = []
    paint = pg.AxisItem.paint
    monkeypatch.setattr(pg.AxisItem, "paint", lambda *a: drawn.append(a[0]) or paint(*a))
    plot = plot_of(qtbot, (380, 170), [CurveLook("#e69f00")])
    qtbot.waitUntil(lambda: len(drawn) >= 2)
    t = np.linspace(0, 8, 100)
    plot.draw([(t, t)], 8.0)
    qtbot.wait(50)
    before = len(drawn)
    images = []
    for height in (100.0, 200.0, 300.0):
        plot.draw([(t, height * np.sin(t))], 8.0)
        QApplication.processEvents()
        images.append(shown(plot))
    assert (images[0] != images[2]).any()
    assert len(drawn) == before
    plot.plot.setYRange(-50, 50)
    qtbot.waitUntil(lambda: len(drawn) > before)
    qtbot.waitUntil(lambda: not np.array_equal(shown(plot), images[2]))


def test_curves_are_where_their_values_are_and_interrupted_where_there_are_none(qtbot):
    looks = [CurveLook("#ff0000"), CurveLook("#00ff00", Qt.PenStyle.DotLine)]
    plot = plot_of(qtbot, (240, 130), looks)
    plot.plot.showGrid(y=False)
    t = np.arange(0, 8.01, 0.05)
    flat = np.full(len(t), 200.0)
    flat[(t > 3.0) & (t < 5.0)] = np.nan
    plot.draw([(t, flat), (t, np.full(len(t), -200.0))], 8.0)
    rows, columns = shown(plot).shape[:2]
    red, green = shown(plot)[:, :, 0], shown(plot)[:, :, 1]
    box = plot.plot.getPlotItem().vb
    y = box.mapViewToDevice(QPointF(-4.0, 200.0)).y() - box.mapViewToDevice(QPointF(0, 400)).y()
    ink = red - shown(plot)[:, :, 2]
    middle = (ink * (np.arange(rows) + 0.5)[:, None]).sum() / ink.sum()
    assert abs(middle - y) < 1.0 and ink[int(y) - 3 : int(y) + 3].max() > 120
    where = ink.max(axis=0)
    gap = slice(int(columns * 3.2 / 8), int(columns * 4.8 / 8))
    assert (where[gap] == 0).all() and (where[: gap.start - 5] > 60).all()
    dots = (green - shown(plot)[:, :, 2]).max(axis=0)
    assert 0.15 < (dots[5:-5] < 30).mean() < 0.7, "dots"
    plot.show_curve(0, False)
    assert (shown(plot)[:, :, 0] == shown(plot)[:, :, 2]).all()


def test_thinned_curves_keep_their_peaks_and_interruptions_while_they_scroll():
    t = np.arange(0, 24, 0.01)
    values = np.sin(t)
    values[1203] = 5.0
    values[1600:1700] = np.nan

    def thinned(begin: float, end: float) -> tuple[np.ndarray, np.ndarray]:
        row = np.zeros((1, COLUMNS))
        row[0, [COUNT, BEGIN, END, WIDE, SHOWN]] = len(t), begin, end, 50, 1
        first, last = np.searchsorted(t, [begin, end])
        around = values[first - 1 : last + 1]
        np.testing.assert_array_equal(
            visible_spans(t, values, row)[0], [np.nanmin(around), np.nanmax(around)]
        )
        return thin_curve(t, values, row, 0, int(first) - 1, int(last) + 1)

    for shift in (0.0, 0.13, 0.5):
        x, y = thinned(4.0 + shift, 20.0 + shift)
        assert len(x) < 110 and (np.diff(x) >= 0).all()
        assert np.nanmax(y) == 5.0
        assert np.isnan(y[(x > 16.01) & (x < 16.6)]).all() and np.isnan(y).any()
    few = thinned(0.205, 0.505)
    np.testing.assert_array_equal(few[0], t[20:52])
    first, second = (thinned(4.0 + shift, 20.0 + shift) for shift in (0, 0.1))
    shared = np.intersect1d(first[0], second[0])
    assert len(shared) > 45, "columns do not wander while a curve scrolls"


def test_a_title_longer_than_its_axis_keeps_its_unit(qtbot):
    title = "Beschleunigung mit langem Namen / g"
    plot = ScrollPlot(title, 8.0, (-2.0, 2.0))
    qtbot.addWidget(plot)
    axis = plot.plot.getAxis("left")
    for height, whole in ((400, True), (110, False), (400, True)):
        plot.resize(300, height)
        plot.show()
        qtbot.waitUntil(lambda h=height: plot.height() == h)
        assert (axis.labelText == title) is whole
        assert axis.labelText.endswith("g")
        assert axis.label.boundingRect().width() <= height
