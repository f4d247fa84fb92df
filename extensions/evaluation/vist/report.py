"""The report of `evaluate vist`: PNG figures and one HTML page that contains them."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.vist.cases import ABLATIONS, GUIDED, PAPERS_GLOVE, Case
from extensions.evaluation.vist.metrics import (
    PCK_BOUNDS_MM,
    Trial,
    by_seen,
    pck_curve,
    summarise,
)
from extensions.evaluation.vist.paper import CAVEAT, HEAD_NOTE, PAPER
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array

TITLES = {
    "free": "Free motion",
    "object": "Object in hand",
    "device": "Fingertip devices worn",
    "head": "Camera on the head",
}
COLUMNS = (
    ("mean_mm", "mean, mm", 2),
    ("tips_mm", "tips", 2),
    ("joints_mm", "joints", 2),
    ("sd_mm", "SD", 2),
    ("within_sd_mm", "within SD", 2),
    ("between_sd_mm", "between SD", 2),
    ("ci95_mm", "95 % CI", 2),
    ("pck20", "PCK@20", 1),
    ("pck35", "PCK@35", 1),
    ("matched_mean", "matched", 1),
    ("wrong_match_rate", "wrong", 4),
    ("nees_per_dof", "NEES/dof", 2),
    ("lost", "lost", 3),
    ("core_s_per_s", "core s/s", 3),
)
Results = Sequence[tuple[Case, Sequence[Trial]]]
STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; color: #222 }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums }
th, td { padding: .3rem .6rem; border-bottom: 1px solid #ddd; text-align: right }
th:first-child, td:first-child { text-align: left }
td { white-space: nowrap } td:first-child { white-space: normal; min-width: 9rem }
.variants td:first-child { min-width: 22rem }
tr.paper td { color: #666; font-style: italic }
img { max-width: 100%; margin: .5rem 0 }
.caveat { border-left: 4px solid #c8553d; padding-left: 1rem }
figure { display: inline-block; width: 48%; margin: 0; vertical-align: top }
"""


def write_report(
    folder: Path,
    results: Results,
    rows: Sequence[dict[str, Any]],
) -> Path:
    """Write figures and ``report.html`` to ``folder``; returns the page. Raises FileError.

    ``rows`` are those of `vist_table.row_of` for ``results``.
    """
    cases, trials = [case for case, _ in results], [of_case for _, of_case in results]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        page = [_head(cases, trials)]
        for experiment in dict.fromkeys(c.experiment for c in cases):
            page.append(_experiment(folder, experiment, cases, trials, rows))
        page.append(_ablations(folder, results, rows))
        path = folder / "report.html"
        path.write_text(_page("".join(page)), encoding="utf-8")
    except OSError as error:
        raise FileError(notice("evaluation.report_not_written", why=error)) from error
    return path


def _page(body: str) -> str:
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8">'
        f"<title>Hand tracking, evaluated</title><style>{STYLE}</style>"
        f"<body><h1>Hand tracking, evaluated</h1>{body}</body></html>\n"
    )


def _head(cases: Sequence[Case], trials: Sequence[Sequence[Trial]]) -> str:
    people = max((len(t) for t in trials), default=0)
    minutes = sorted({round(c.minutes, 2) for c in cases})
    return (
        f"<p>The protocol of Lee et al. 2021 with {people} simulated "
        f"participant{'s' * (people != 1)}, "
        f"{' and '.join(f'{m:g}' for m in minutes)} minutes a trial. Errors are of four keypoints "
        f"({', '.join(k.replace('_', ' ') for k in MARKED_KEYPOINTS)}); "
        "3D-PCK is the share of instants at which all four are within the bound; an instant with a "
        f'lost keypoint counts as outside.</p><p class="caveat">{html.escape(CAVEAT)}</p>'
    )


def _experiment(
    folder: Path,
    experiment: str,
    cases: Sequence[Case],
    trials: Sequence[Sequence[Trial]],
    rows: Sequence[dict[str, Any]],
) -> str:
    """Table and figures of one experiment without ablations."""
    chosen = [i for i, c in enumerate(cases) if c.experiment == experiment and not c.ablation]
    if not chosen:
        return ""
    group = [(cases[i], trials[i]) for i in chosen]
    note = f"<p>{html.escape(HEAD_NOTE)}</p>" if experiment == "head" else ""
    parts = [f"<h2>{TITLES[experiment]}</h2>{note}", _table([rows[i] for i in chosen], experiment)]
    parts += [_figure(folder, experiment, name, group) for name in FIGURES]
    return "".join(parts)


def _figure(folder: Path, experiment: str, name: str, group: Group) -> str:
    path = folder / f"{experiment}-{name}.png"
    FIGURES[name](group, path)
    return _image(path, f"{experiment}, {name}")


def _image(path: Path, text: str) -> str:
    """The image embedded in the page."""
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    return f'<figure><img alt="{text}" src="data:image/png;base64,{data}"></figure>'


def _table(rows: Sequence[dict[str, Any]], experiment: str) -> str:
    head = "".join(f"<th>{title}" for _, title, _ in COLUMNS)
    body = "".join(_row(_name(r), r, "") for r in rows)
    if experiment in PAPER:
        body += _row("paper (people)", PAPER[experiment], "paper")
    return f"<table><tr><th>{head}{body}</table>"


def _ablations(folder: Path, results: Results, rows: Sequence[dict[str, Any]]) -> str:
    """A table and a figure of variants for each experiment that has variants."""
    head = "".join(f"<th>{title}" for _, title, _ in COLUMNS)
    parts = []
    for experiment in dict.fromkeys(r["experiment"] for r in rows if r["ablation"]):
        chosen = [r for r in rows if r["experiment"] == experiment and r["ablation"]]
        body = "".join(
            _row(f"{r['engine']}: {ABLATIONS[r['ablation']].text}", r, "") for r in chosen
        )
        title = TITLES[experiment].lower()
        parts.append(f"<h2>Variants, {title}</h2>")
        parts.append(f'<table class="variants"><tr><th>{head}{body}</table>')
        group = [(case, trials) for case, trials in results if case.experiment == experiment]
        path = folder / f"{experiment}-variants.png"
        variants(group, path)
        parts.append(_image(path, f"{experiment}, variants"))
    return "".join(parts)


def _name(row: dict[str, Any]) -> str:
    """Name of a row that is not a variant."""
    parts = [row["engine"], GUIDED.get(row["guided"], ""), SESSIONS.get(row["session"], "")]
    parts += ["smoothed"] * row["smoothed"]
    return ", ".join([p for p in parts if p] + [row["glove"]] * (row["glove"] != PAPERS_GLOVE))


def _row(name: str, values: dict[str, Any], kind: str) -> str:
    cells = "".join(f"<td>{_cell(values.get(key), digits)}" for key, _, digits in COLUMNS)
    return f'<tr class="{kind}"><td>{html.escape(name)}{cells}'


def _cell(value: Any, digits: int) -> str:
    if value is None or value == [None, None]:
        return "–"
    if isinstance(value, list | tuple):
        return " to ".join(_cell(v, digits) for v in value)
    return f"{value:.{digits}f}"


# ---- draws the figures of `evaluate vist`, after Lee et al. 2021, figs. 3 and 4

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
