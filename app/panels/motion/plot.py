"""Curves over the last seconds, or over a whole take with a cursor that a click moves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from app.panels.graphs.looks import curve_looks
from app.viewmodels.motion import shown_name
from app.widgets.curve_plot import CurvePlot, span_of
from tracker.messages import Array


class MotionPlot(CurvePlot):
    """``sought``: a click at an instant (s from the take's first image)."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent=parent)
        self.plot.setMinimumHeight(90)
        self.plot.setLabel("bottom", "s")
        self.plot.addLegend(offset=(1, 1))

    def show_names(self, names: Sequence[str]) -> None:
        """A curve for each, empty."""
        self.set_looks(curve_looks([shown_name(name) for name in names]))

    def show_curves(self, curves: Sequence[tuple[Array, Array]]) -> None:
        """All of each curve."""
        t = [t for t, _ in curves if len(t)]
        if not t:
            return
        self.plot.setXRange(min(x[0] for x in t), max(x[-1] for x in t), padding=0.02)
        found = span_of(np.concatenate([values for _, values in curves]))
        if found is not None:
            self.plot.setYRange(*found, padding=0)
        self.draw(curves)
