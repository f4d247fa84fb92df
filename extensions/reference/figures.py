"""Figures of the accuracy report, as SVG."""

from __future__ import annotations

import io

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from extensions.reference.accuracy import MULTIPLES, Measured, ScalarRow, expected
from extensions.reference.pairs import Quantity

_OURS, _GREY, _LIMIT = "#0072b2", "#888888", "#d55e00"
_COLUMNS = 4
_MOST = 800  # points of a scatter plot; more are not visible


def svg(figure: Figure) -> str:
    """SVG text without the XML declaration; deterministic."""
    with mpl.rc_context({"svg.hashsalt": "glovetrack", "svg.fonttype": "none"}):
        out = io.StringIO()
        FigureCanvasSVG(figure).print_svg(out, metadata={"Date": None, "Creator": None})
    return out.getvalue()[out.getvalue().index("<svg") :]


def agreement(m: Measured) -> Figure:
    """Bland-Altman plots of the joint angles: difference over mean, bias and limits, in degrees."""
    rows = {r.name: r for r in m.scalars if r.is_angle}
    shown = [q for q in m.quantities if q.name in rows and np.isfinite(q.ours - q.theirs).any()]
    lines = max(1, -(-len(shown) // _COLUMNS))
    figure = Figure(figsize=(10, 2.3 * lines), layout="constrained")
    for k, q in enumerate(shown):
        axes = figure.add_subplot(lines, _COLUMNS, k + 1)
        _agreement(axes, q, rows[q.name])
    return figure


def _agreement(axes: Axes, q: Quantity, row: ScalarRow) -> None:
    a, b = np.rad2deg(q.ours), np.rad2deg(q.theirs)
    known = np.flatnonzero(np.isfinite(a - b))
    some = known[:: max(1, len(known) // _MOST)]
    axes.plot((a + b)[some] / 2, (a - b)[some], ".", color=_OURS, ms=2, alpha=0.4, rasterized=True)
    found = row.agreement
    for value, style in ((found.bias, "-"), (found.low, "--"), (found.high, "--")):
        if np.isfinite(value):
            axes.axhline(float(np.rad2deg(value)), color=_LIMIT, lw=1, ls=style)
    axes.set_title(q.name.replace("_", " "), fontsize=9)
    axes.tick_params(labelsize=7)
    axes.grid(alpha=0.3)


def errors(m: Measured) -> Figure:
    """Root mean square by speed, and the share of errors within multiples of the claimed sd."""
    figure = Figure(figsize=(10, 3.2), layout="constrained")
    axes = figure.add_subplot(1, 2, 1)
    names = [b.name for b in m.speeds]
    axes.bar(range(len(names)), [1e3 * b.rmse for b in m.speeds], color=_OURS)
    axes.plot(range(len(names)), [1e3 * b.p95 for b in m.speeds], "v", color=_LIMIT)
    axes.set_xticks(range(len(names)), [n.replace(" m/s", "") for n in names], fontsize=7)
    axes.set_xlabel("speed of the keypoint, m/s")
    axes.set_ylabel("rms error, mm (▾ 95th percentile)")
    axes.grid(alpha=0.3, axis="y")
    axes = figure.add_subplot(1, 2, 2)
    axes.plot(MULTIPLES, 100 * expected(), color=_GREY, label="correct sd")
    axes.plot(MULTIPLES, 100 * np.array(m.calibration), ".-", color=_OURS, label="found")
    axes.set_xlabel("k: multiple of the reported standard deviation")
    axes.set_ylabel("errors within k sd, %")
    axes.set_ylim(0, 102)
    axes.legend(loc="lower right", frameon=False)
    axes.grid(alpha=0.3)
    return figure
