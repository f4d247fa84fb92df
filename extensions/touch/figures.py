"""The figures of a touch test, and the report as one page of PDF."""

from __future__ import annotations

import io
import textwrap
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from extensions.touch.result import AXES, NORMAL, TouchResult
from extensions.touch.sheet import CROSSES, TouchSheet

COLOUR = {"thumb": "#d55e00", "index": "#0072b2", "middle": "#009e73"}
MM = 1000.0
ENLARGED = 5.0
"""Factor by which errors are drawn longer than the sheet."""


def svg(result: TouchResult) -> str:
    """The four figures as SVG without the XML declaration; deterministic."""
    figure = Figure(figsize=(10.0, 7.2), layout="constrained")
    draw(figure.subplots(2, 2).ravel().tolist(), result)
    with mpl.rc_context({"svg.hashsalt": "glovetrack", "svg.fonttype": "none"}):
        out = io.StringIO()
        FigureCanvasSVG(figure).print_svg(out, metadata={"Date": None, "Creator": None})
    return out.getvalue()[out.getvalue().index("<svg") :]


def write_pdf(result: TouchResult, rows: list[tuple[str, str]], path: Path) -> None:
    """One A4 page: the line to quote, the figures, and ``rows`` of name and value."""
    figure = Figure(figsize=(8.27, 11.69))
    figure.text(0.07, 0.955, "Touch test", fontsize=16, weight="bold")
    line = textwrap.fill(result.line, 100)
    figure.text(0.07, 0.94, line, fontsize=9, va="top")
    grid = figure.add_gridspec(2, 2, left=0.1, right=0.95, top=0.87, bottom=0.42, hspace=0.35,
                               wspace=0.28)  # fmt: skip
    draw([figure.add_subplot(grid[k // 2, k % 2]) for k in range(4)], result)
    for k, (name, value) in enumerate(rows):
        y = 0.37 - 0.0155 * k
        figure.text(0.07, y, name, fontsize=7.5, color="#555")
        figure.text(0.33, y, value, fontsize=7.5)
    with PdfPages(path, metadata={"Title": "Touch test", "CreationDate": None}) as pdf:
        pdf.savefig(figure)


def draw(axes: list[Axes], result: TouchResult) -> None:
    """The map, the errors by axis, the claimed standard deviations, error against distance."""
    _map(axes[0], result)
    _by_axis(axes[1], result)
    _claims(axes[2], result)
    _distance(axes[3], result)
    for ax in axes:
        ax.spines[["top", "right"]].set_visible(False)
        ax.tick_params(labelsize=8)


def _map(ax: Axes, result: TouchResult) -> None:
    """Errors on the sheet, seen from above."""
    place = {c.name: np.array([c.x, -c.y]) * MM for c in CROSSES}
    for cross in CROSSES:
        x, y = place[cross.name]
        ax.plot(x, y, "+", color="#888", markersize=9)
        ax.annotate(cross.name, (x, y), (3, 3), textcoords="offset points", fontsize=7)
    for finger in result.fingers:
        for touch, error in zip(finger.touches, finger.error_S, strict=True):
            x, y = place[touch.cue.target]
            dx, dy = ENLARGED * MM * error[:2]
            ax.plot([x, x + dx], [y, y + dy], color=COLOUR[finger.finger], linewidth=1)
            ax.plot(x + dx, y + dy, ".", color=COLOUR[finger.finger], markersize=5)
    ax.set_xlim(30, MM * TouchSheet.width - 30)
    ax.set_aspect("equal")
    ax.set_title(f"Errors on the sheet, {ENLARGED:g} times as long (mm)", fontsize=9)


def _by_axis(ax: Axes, result: TouchResult) -> None:
    """Each touch, bias and limits of agreement."""
    wide = 0.8 / len(result.fingers)
    for i, finger in enumerate(result.fingers):
        colour = COLOUR[finger.finger]
        for k in range(3):
            x = k + (i - (len(result.fingers) - 1) / 2) * wide
            ends = x - 0.4 * wide, x + 0.4 * wide
            values = MM * finger.error_S[:, k]
            ax.plot(np.full(len(values), x), values, ".", color=colour, markersize=4,
                    label=finger.finger if k == 0 else None)  # fmt: skip
            ax.plot(ends, [MM * finger.bias[k].value] * 2, color=colour, linewidth=1.5)
            for limit in finger.limits[k]:
                ax.plot(ends, [MM * limit.value] * 2, color=colour, linewidth=0.8, linestyle="--")
    ax.axhline(0, color="#aaa", linewidth=0.6)
    ax.set_xticks(range(3), AXES)
    ax.legend(fontsize=7, frameon=False)
    ax.set_title("Error by axis, bias and 95 % limits (mm)", fontsize=9)


def _claims(ax: Axes, result: TouchResult) -> None:
    """Share of errors within claimed standard deviations, and that of a normal distribution."""
    for k, claim in enumerate(result.claims):
        ax.bar(k, 100 * claim.value, width=0.5, color="#9db8d9")
        ax.plot([k, k], [100 * claim.low, 100 * claim.high], color="#333", linewidth=1)
        ax.plot([k - 0.35, k + 0.35], [100 * NORMAL[k]] * 2, color="#d55e00", linewidth=1.5)
    ax.set_xticks(range(3), ["1 sd", "2 sd", "3 sd"])
    ax.set_ylim(0, 105)
    ax.set_title("Errors within reported sd (%); line: normal", fontsize=9)


def _distance(ax: Axes, result: TouchResult) -> None:
    for finger in result.fingers:
        away = [MM * t.distance for t in finger.touches]
        off = MM * np.linalg.norm(finger.error_S, axis=1)
        ax.plot(away, off, "o", color=COLOUR[finger.finger], markersize=3.5)
    ax.set_ylim(bottom=0)
    ax.set_xlabel("distance from the camera (mm)", fontsize=8)
    ax.set_title("Length of the error against distance (mm)", fontsize=9)
