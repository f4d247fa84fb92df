"""The report of `evaluate vist`: PNG figures and one HTML page that contains them."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.vist.cases import ABLATIONS, GUIDED, PAPERS_GLOVE, Case
from extensions.evaluation.vist.metrics import Trial
from extensions.evaluation.vist.paper import CAVEAT, HEAD_NOTE, PAPER
from extensions.evaluation.vist.report_figures import FIGURES, Group, variants
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.hand.names import MARKED_KEYPOINTS

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
