"""What scrolling curves cost to draw."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg

from app.widgets.scroll_plot import ScrollPlot


def test_axes_are_drawn_when_they_change_and_not_when_curves_move(qtbot, monkeypatch):
    """They cost more than the curves."""
    drawn = []
    paint = pg.AxisItem.paint
    monkeypatch.setattr(pg.AxisItem, "paint", lambda *a: drawn.append(a[0]) or paint(*a))
    plot = ScrollPlot("rate", 8.0, (-400.0, 400.0))
    qtbot.addWidget(plot)
    plot.resize(380, 170)
    plot.set_curves(["#e69f00"])
    plot.show()
    qtbot.waitUntil(lambda: len(drawn) >= 2)
    t = np.linspace(-8, 0, 100)
    plot.plot.viewport().repaint()
    before = len(drawn)
    images = []
    for height in (100.0, 200.0, 300.0):
        plot.show_values(t, height * np.sin(t)[:, None])
        plot.plot.viewport().repaint()
        images.append(plot.grab().toImage())
    assert images[0] != images[2], "the curve has moved"
    assert len(drawn) == before
    plot.plot.setYRange(-50, 50)
    plot.plot.viewport().repaint()
    assert len(drawn) > before
