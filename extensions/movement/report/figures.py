"""Draws the figures of a report, as SVG to embed in a page."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Sequence
from functools import partial

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from extensions.movement.report.measure import MeasuredTake
from tracker.hand.names import CHAINS
from tracker.messages import Array, IntArray, Validity
from tracker.session.edits import Mask
from tracker.session.motion import Take, distance, pair_of

_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_INTERPOLATED = 3
_SHADES = {
    int(Validity.INFERRED): "#f4e3b2",
    int(Validity.LOST): "#e3c5c5",
    _INTERPOLATED: "#c9d7ef",
}
"""Background colours of curves by state; the last one marks interpolated gaps."""
DOTS = 150
"""Dots per inch of PNG figures."""
_MOST = 3000  # points per curve; more are not visible


def svg(figure: Figure) -> str:
    """SVG text without the XML declaration; deterministic."""
    with mpl.rc_context({"svg.hashsalt": "glovetrack", "svg.fonttype": "none"}):
        out = io.StringIO()
        FigureCanvasSVG(figure).print_svg(out, metadata={"Date": None, "Creator": None})
    return out.getvalue()[out.getvalue().index("<svg") :]


def png(figure: Figure) -> bytes:
    """PNG bytes at 150 dots per inch; deterministic."""
    out = io.BytesIO()
    figure.set_dpi(DOTS)  # drawing as SVG sets it to 72

    FigureCanvasAgg(figure).print_png(out, metadata={"Software": None})
    return out.getvalue()


def flexion_names(measured: MeasuredTake) -> list[str]:
    """Names of the flexion angles of fingers and thumb."""
    names = measured.take.angle_names
    return [n for n in names if n.endswith("_flexion") and n.split("_")[0] in CHAINS]


def all_figures(takes: Sequence[MeasuredTake]) -> Iterator[tuple[str, Figure]]:
    """Yields each figure of a report with a name for its file."""
    for name, draw in _drawn(takes):
        yield name, draw()


def figure_names(takes: Sequence[MeasuredTake]) -> list[str]:
    """Names of `all_figures`, without drawing them."""
    return [name for name, _ in _drawn(takes)]


def _drawn(takes: Sequence[MeasuredTake]) -> Iterator[tuple[str, Callable[[], Figure]]]:
    yield "ranges", partial(ranges, takes)
    for number, measured in enumerate(takes, 1):
        yield f"{number}_flexion", partial(courses, measured, flexion_names(measured))
        if aperture_names(measured):
            yield f"{number}_aperture", partial(apertures, measured)


def aperture_names(measured: MeasuredTake) -> list[str]:
    """Names of the distances between the tips of thumb and fingers."""
    return [r.measure.name for r in measured.rows if not r.measure.is_angle]


def ranges(takes: Sequence[MeasuredTake]) -> Figure:
    """Ranges of all recorded angles, takes side by side, with two standard deviations at both
    ends."""
    names = [r.measure.name for r in takes[0].rows if r.measure.is_angle and not r.isb]
    figure = Figure(figsize=(9, 0.8 + 0.26 * len(names) * max(1, 0.6 * len(takes))))
    axes = figure.add_subplot()
    for k, measured in enumerate(takes):
        for i, name in enumerate(names):
            row = measured.row(name)
            if row is None or not np.isfinite(row.measure.range):
                continue
            low, high, sd = np.rad2deg(
                [row.measure.least, row.measure.greatest, row.measure.claimed_sd]
            )
            at = i + 0.7 * (k + 0.5) / len(takes) - 0.35
            colour = _COLOURS[k % len(_COLOURS)]
            axes.plot([low, high], [at, at], "-", color=colour, lw=3, solid_capstyle="butt")
            if np.isfinite(sd):
                err = [2 * sd] * 2
                axes.errorbar([low, high], [at, at], xerr=err, fmt="none", ecolor="#555", lw=0.7)
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.set_xlabel("deg, flexion positive")
    axes.grid(axis="x", alpha=0.3)
    figure.tight_layout()
    return figure


def courses(measured: MeasuredTake, names: Sequence[str]) -> Figure:
    """Angles (deg) over time, one row each, with inferred and lost parts shaded."""
    take = measured.take
    figure = Figure(figsize=(9, 0.6 + 1.05 * len(names)))
    for k, name in enumerate(names):
        axes = figure.add_subplot(len(names), 1, k + 1)
        j = take.angle_names.index(name)
        _shade(axes, take, take.angle_state[:, j], take.angle_filled, j)
        _curve(axes, take.t, np.rad2deg(take.angles[:, j]), _COLOURS[k % len(_COLOURS)])
        axes.set_ylabel(f"{name.replace('_', chr(10), 1)}", rotation=0, ha="right", va="center")
        axes.set_xlim(take.t[0], take.t[-1])
        axes.grid(alpha=0.3)
        if k < len(names) - 1:
            axes.set_xticklabels([])
    axes.set_xlabel("s")
    figure.tight_layout()
    return figure


def apertures(measured: MeasuredTake) -> Figure:
    """Distances (mm) between the tips of thumb and fingers over time, with marked maxima."""
    figure = Figure(figsize=(9, 2.6))
    axes = figure.add_subplot()
    for k, name in enumerate(aperture_names(measured)):
        away, _, state = distance(measured.take, pair_of(name))
        shown = 1e3 * np.where(state == Validity.LOST, np.nan, away)
        colour = _COLOURS[k % len(_COLOURS)]
        _curve(axes, measured.take.t, shown, colour, name.split(" - ")[1].removesuffix("_tip"))
        if np.isfinite(shown).any():
            top = int(np.nanargmax(shown))
            axes.plot(measured.take.t[top], shown[top], "v", color=colour, ms=5)
    axes.set_xlim(measured.take.t[0], measured.take.t[-1])
    axes.set_xlabel("s")
    axes.set_ylabel("mm")
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1), frameon=False)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    return figure


def _curve(axes: Axes, t: Array, values: Array, colour: str, label: str = "") -> None:
    every = max(1, len(t) // _MOST)
    axes.plot(t[::every], values[::every], "-", color=colour, lw=1, label=label)


def _shade(axes: Axes, take: Take, state: IntArray, filled: Mask | None, j: int) -> None:
    """Shade the parts of a curve that were not measured; ``filled`` (N, J): interpolated ones."""
    if filled is not None:
        state = np.where(filled[:, j], _INTERPOLATED, state)
    edges = np.flatnonzero(np.diff(state)) + 1
    for a, b in zip(np.r_[0, edges], np.r_[edges, len(state)], strict=True):
        colour = _SHADES.get(int(state[a]))
        if colour is not None:
            axes.axvspan(take.t[a], take.t[min(b, len(state) - 1)], color=colour, lw=0)
