"""The cost of drawing curves, and the thinning of many points."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg

from app.widgets.curve_plot import CurveLook, ScrollPlot, thinned


def test_axes_are_drawn_when_they_change_and_not_when_curves_move(qtbot, monkeypatch):
    """They cost more than the curves."""
    drawn = []
    paint = pg.AxisItem.paint
    monkeypatch.setattr(pg.AxisItem, "paint", lambda *a: drawn.append(a[0]) or paint(*a))
    plot = ScrollPlot("rate", 8.0, (-400.0, 400.0))
    qtbot.addWidget(plot)
    plot.resize(380, 170)
    plot.set_looks([CurveLook("#e69f00")])
    plot.show()
    qtbot.waitUntil(lambda: len(drawn) >= 2)
    t = np.linspace(-8, 0, 100)
    plot.plot.viewport().repaint()
    before = len(drawn)
    images = []
    for height in (100.0, 200.0, 300.0):
        plot.draw([(t, height * np.sin(t))])
        plot.plot.viewport().repaint()
        images.append(plot.grab().toImage())
    assert images[0] != images[2], "the curve has moved"
    assert len(drawn) == before
    plot.plot.setYRange(-50, 50)
    plot.plot.viewport().repaint()
    assert len(drawn) > before


def test_thinned_curves_keep_their_peaks_and_interruptions_while_they_scroll():
    t = np.arange(0, 60, 0.001)
    values = np.sin(t)
    values[30_017] = 5.0
    values[40_000:40_300] = np.nan
    for shift in (0.0, 0.37, 1.0):
        x, y = thinned(t, values, 10.0 + shift, 50.0 + shift, 400)
        assert len(x) < 900 and (np.diff(x) >= 0).all()
        assert np.nanmax(y) == 5.0
        assert np.isnan(y[(x > 40.11) & (x < 40.19)]).all() and np.isnan(y).any()
    few = thinned(t[:100], values[:100], 0.02, 0.05, 400)
    np.testing.assert_array_equal(few[0], t[19:52])
    first, second = (thinned(t, values, 10.0 + shift, 50.0 + shift, 400) for shift in (0, 0.1))
    shared = np.intersect1d(first[0], second[0])
    assert len(shared) > 390, "columns do not wander while a curve scrolls"


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
