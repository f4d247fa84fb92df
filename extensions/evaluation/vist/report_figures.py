"""Draws the figures of `evaluate vist`, after Lee et al. 2021, figs. 3 and 4."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.metrics import (
    PCK_BOUNDS_MM,
    Trial,
    by_seen,
    pck_curve,
    summarise,
)
from extensions.evaluation.vist.paper import PAPER
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array

Group = Sequence[tuple[Case, Sequence[Trial]]]
COLOURS = {"chain": "#1b6ca8", "vist": "#c8553d"}
LINES = {"chain": "-", "vist": "--"}  # readable without colour vision
HATCHES = {"vist": "//"}
OTHER = "#6b7280"
PAPER_COLOUR = "#333333"


def colour_of(case: Case) -> str:
    """One colour per engine."""
    return COLOURS.get(case.engine, OTHER)


def line_of(case: Case) -> str:
    """One line style per engine."""
    return LINES.get(case.engine, ":")


def keypoints(group: Group, path: Path) -> None:
    """Mean error of each keypoint with its 95 % interval over participants (fig. 3C)."""
    figure, ax = _axes()
    width = 0.8 / max(len(group), 1)
    x = np.arange(len(MARKED_KEYPOINTS))
    for i, (case, trials) in enumerate(group):
        s = summarise(trials)
        mean = np.array([s.keypoints[k] for k in MARKED_KEYPOINTS])
        ci = np.array([s.keypoints_ci95_mm[k] for k in MARKED_KEYPOINTS])
        half = np.nan_to_num((ci[:, 1] - ci[:, 0]) / 2)
        whisker = [np.minimum(half, mean), half]  # errors are not negative
        at = x + (i - (len(group) - 1) / 2) * width
        ax.bar(at, mean, width, yerr=whisker, capsize=3, color=colour_of(case),
               hatch=HATCHES.get(case.engine), edgecolor="white", label=case.engine)  # fmt: skip
    _paper_line(ax, group)
    ax.set_xticks(x, [k.replace("_", " ") for k in MARKED_KEYPOINTS])
    ax.set_ylabel("mean error, mm (bars: 95 % CI)")
    _save(figure, ax, path)


def pck(group: Group, path: Path) -> None:
    """3D-PCK over the bound, with the paper's two published points (fig. 3D)."""
    figure, ax = _axes()
    for case, trials in group:
        ax.plot(PCK_BOUNDS_MM, pck_curve(trials), line_of(case), color=colour_of(case),
                label=case.engine)  # fmt: skip
    published = PAPER.get(group[0][0].experiment)
    if published is not None:
        shares = [float(str(published[k])) for k in ("pck20", "pck35")]
        ax.plot([20, 35], shares, "o", color=PAPER_COLOUR, label="paper (people)")
    ax.set_xlabel("bound on the worst of four keypoints, mm")
    ax.set_ylabel("share of instants, %")
    ax.set_ylim(0, 101)
    _save(figure, ax, path)


def seen(group: Group, path: Path) -> None:
    """Mean error and share of instants over the number of matched markers (fig. 3E)."""
    figure, ax = _axes()
    share = ax.twinx()
    for case, trials in group:
        b = by_seen(trials)
        share.step(b.seen, 100 * b.share, where="mid", color=colour_of(case), alpha=0.35)
        known = np.isfinite(b.mean_mm)
        ax.plot(b.seen[known], b.mean_mm[known], f"o{line_of(case)}", ms=3, color=colour_of(case),
                label=case.engine)  # fmt: skip
    ax.set_xlabel("markers matched in both images")
    ax.set_ylabel("mean error, mm")
    ax.set_ylim(bottom=0)
    share.set_ylabel("share of instants, % (steps)")
    _save(figure, ax, path)


def hand_length(group: Group, path: Path) -> None:
    """Mean error of each participant over the length of the hand (figs. 3F and 3G)."""
    figure, ax = _axes()
    for case, trials in group:
        length = np.array([t.hand_length for t in trials]) * 1000
        mean = np.array([_mean_mm(t) for t in trials])
        ax.plot(length, mean, "o", color=colour_of(case), label=f"{case.engine}, mm")
        ax.plot(length, 1000 * mean / length, "x", color=colour_of(case),
                label=f"{case.engine}, per mille of length")  # fmt: skip
    _paper_line(ax, group)
    ax.set_xlabel("hand length, mm")
    ax.set_ylabel("mean error, mm; × per mille of hand length")
    _save(figure, ax, path)


def over_time(group: Group, path: Path) -> None:
    """Error over time, median of participants, which shows the effect of calibration."""
    figure, ax = _axes()
    for case, trials in group:
        shortest = min((len(t.t) for t in trials), default=0)
        if not shortest:
            continue
        error = np.stack([np.mean(t.error[:shortest], axis=1) for t in trials]) * 1000
        median = np.full(shortest, np.nan)
        given = np.isfinite(error).any(axis=0)
        median[given] = np.nanmedian(error[:, given], axis=0)
        ax.plot(trials[0].t[:shortest], _smooth(median), line_of(case), color=colour_of(case),
                label=case.engine)  # fmt: skip
    ax.set_ylim(bottom=0)
    ax.set_xlabel("time, s")
    ax.set_ylabel("mean error of four keypoints, mm (1 s median)")
    _save(figure, ax, path)


def variants(group: Group, path: Path) -> None:
    """Mean error of every variant of an experiment, the default first."""
    names = list(dict.fromkeys(case.ablation or "as usual" for case, _ in group))
    engines = list(dict.fromkeys(case.engine for case, _ in group))
    figure, ax = _axes(height=1.2 + 0.45 * len(names))
    height = 0.8 / len(engines)
    named: set[str] = set()
    for case, trials in group:
        i = engines.index(case.engine)
        at = names.index(case.ablation or "as usual") + (i - (len(engines) - 1) / 2) * height
        label = None if case.engine in named else case.engine
        named.add(case.engine)
        ax.barh(at, summarise(trials).mean_mm, height, color=colour_of(case), edgecolor="white",
                hatch=HATCHES.get(case.engine), label=label)  # fmt: skip
    ax.set_yticks(range(len(names)), names)
    ax.invert_yaxis()
    ax.set_xlabel("mean error of four keypoints, mm")
    _save(figure, ax, path)


FIGURES = {
    "keypoints": keypoints,
    "pck": pck,
    "matched": seen,
    "hand-length": hand_length,
    "time": over_time,
}


def _mean_mm(trial: Trial) -> float:
    given = trial.error[np.isfinite(trial.error)]
    return float(given.mean() * 1000) if given.size else float("nan")


def _smooth(values: Array, window: int = 100) -> Array:
    """Running mean over ``window`` packets; NaN stays NaN."""
    known = np.isfinite(values)
    kernel = np.ones(min(window, max(len(values), 1)))
    total = np.convolve(np.where(known, values, 0.0), kernel, "same")
    count = np.convolve(known.astype(float), kernel, "same")
    return np.where(known, total / np.maximum(count, 1), np.nan)


def _axes(height: float = 4.0) -> tuple[Figure, Axes]:
    """``height`` in inches."""
    figure = Figure(figsize=(6.4, height), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    ax.grid(alpha=0.25)
    return figure, ax


def _paper_line(ax: Axes, group: Group) -> None:
    published = PAPER.get(group[0][0].experiment)
    if published is not None:
        ax.axhline(float(str(published["mean_mm"])), color=PAPER_COLOUR, ls="--", lw=1,
                   label="paper's mean (people)")  # fmt: skip


def _save(figure: Figure, ax: Axes, path: Path) -> None:
    ax.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=120)
