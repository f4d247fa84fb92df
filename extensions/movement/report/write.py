"""`write_report` writes the page, the table and the figures of a report; `as_json` its values."""

from __future__ import annotations

import base64
import csv
import io
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from extensions.movement.report.angles import RECORDED, SEQUENCE
from extensions.movement.report.course import CUTOFF
from extensions.movement.report.figures import all_figures, figure_names, png, svg
from extensions.movement.report.measure import MeasuredTake, Row, measure_hands
from tracker import __version__
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, whole_files
from tracker.base.notices import notice
from tracker.base.report_page import html_page, html_table
from tracker.session.edits import lines as edit_lines
from tracker.session.motion import Units

SVG_HEAD = '<?xml version="1.0" encoding="utf-8"?>\n'


def write_report(
    sessions: Sequence[Path],
    out: Path,
    anonymous: bool = False,
    force: bool = False,
    watch: Callable[[float], None] = lambda share: None,
) -> list[MeasuredTake]:
    """Write ``out`` (HTML), a CSV file of the same name and each figure as ``NAME_ranges.png`` and
    ``.svg``, ``NAME_1_flexion.png``…; either all files are written or none.

    ``watch`` receives the share of sessions read so far and may raise to cancel. Raises ConfigError
    if the name does not end in .html, FileError for a session without estimates.
    """
    if out.suffix.lower() not in (".html", ".htm"):
        raise ConfigError(notice("option.html", file=out.name))
    for target in (out, out.with_suffix(".csv")):
        check_target(target, force, sessions)
    takes = []
    for k, path in enumerate(sessions):
        watch(k / len(sessions))
        takes += [replace(hand, session=k) for hand in measure_hands(path, anonymous)]

    for name in figure_names(takes):
        for ending in (".png", ".svg"):
            check_target(out.with_name(f"{out.stem}_{name}{ending}"), force, sessions)
    made: dict[str, str | bytes] = {}
    drawn = {}
    for name, figure in all_figures(takes):
        drawn[name] = svg(figure)
        made |= {f"_{name}.png": png(figure), f"_{name}.svg": SVG_HEAD + drawn[name]}
    made |= {".csv": table(takes), out.suffix: page(takes, drawn)}
    files = {out.with_name(out.stem + ending): data for ending, data in made.items()}
    with whole_files(*files, force=force, inputs=sessions) as parts:
        for part, data in zip(parts, files.values(), strict=True):
            part.write_bytes(data if isinstance(data, bytes) else data.encode())
    return takes


_HEAD = (
    "", "unit", "minimum", "maximum", "range", "± of range", "mean", "sd", "± of a value",
    "peak speed /s", "at s", "maximum at s", "arc length", "log jerk", "repetitions",
    "range of one", "sd of one", "measured %", "inferred %", "lost %",
    "interpolated %",
)  # fmt: skip


def page(takes: Sequence[MeasuredTake], drawn: Mapping[str, str]) -> str:
    """The report of one or several takes as HTML; ``drawn``: `figures.all_figures` as SVG."""
    csv = base64.b64encode(table(takes).encode()).decode()
    link = f'<a download="report.csv" href="data:text/csv;base64,{csv}">all numbers as CSV</a>'
    parts = [
        f"<h1>Hand movement</h1><p>{len(takes)} recording{'s' * (len(takes) > 1)}; {link}.</p>",
        _takes(takes),
        "<h2>Ranges of motion</h2>",
        drawn["ranges"],
    ]
    if len(takes) > 1:
        parts += [_compared(takes), _wearers(takes)]
    for number, measured in enumerate(takes, 1):
        parts += _one(measured, number, drawn)
    parts.append(_definitions())
    return html_page("Glovetrack report", parts)


def name_of(measured: MeasuredTake, number: int) -> str:
    return measured.name or f"take {number}"


def _takes(takes: Sequence[MeasuredTake]) -> str:
    rows = [
        [name_of(t, n), t.wearer, t.side, text(t.seconds, 1), f"{t.engine} {t.version}"]
        + ["simulated" if t.simulated else "recorded"]
        for n, t in enumerate(takes, 1)
    ]
    return html_table(("take", "wearer", "hand", "s", "tracked by", ""), rows)


def _one(measured: MeasuredTake, number: int, drawn: Mapping[str, str]) -> list[str]:
    recorded = [r for r in measured.rows if r.measure.is_angle and not r.isb]
    isb = [r for r in measured.rows if r.isb]
    apart = [r for r in measured.rows if not r.measure.is_angle]
    legend = (
        '<p class="note">Shading: <span class="key" style="background:#f4e3b2"></span> '
        'inferred, <span class="key" style="background:#c9d7ef"></span> interpolated, '
        '<span class="key" style="background:#e3c5c5"></span> lost.</p>'
    )
    edited = "".join(f'<p class="note">{escape(line)}.</p>' for line in edit_lines(measured.edits))
    return [
        f"<h2>{escape(name_of(measured, number))}</h2>",
        edited,
        "<h3>Flexion over time (deg)</h3>",
        legend,
        drawn[f"{number}_flexion"],
        f'<h3>Angles as recorded</h3><p class="note">Sequence {escape(RECORDED)}.</p>',
        _numbers(recorded),
        f'<h3>Angles by ISB</h3><p class="note">Sequence {escape(SEQUENCE)}. Joints with one axis '
        "have the recorded angle.</p>",
        _numbers(isb),
        "<h3>Aperture between thumb and fingertips</h3>",
        drawn.get(f"{number}_aperture", ""),
        _numbers(apart),
    ]


def _numbers(rows: Sequence[Row]) -> str:
    return html_table(_HEAD, [_cells(r) for r in rows])


def _cells(row: Row) -> list[str]:
    m, c = row.measure, row.course
    sizes = (m.least, m.greatest, m.range, row.range_sd, m.mean, m.sd, m.claimed_sd, c.fastest)
    return [
        m.name,
        "deg" if m.is_angle else "mm",
        *(text(scaled(row, v), 1) for v in sizes),
        *(text(v, 2) for v in (c.at, row.peak_at, c.arc, c.jerk)),
        str(c.repetitions),
        *(text(scaled(row, v), 1) for v in (c.each, c.each_sd)),
        *(text(100 * v, 1) for v in (m.measured, m.inferred, m.lost, m.interpolated)),
    ]


def _compared(takes: Sequence[MeasuredTake]) -> str:
    """Ranges of the takes side by side, and their spread."""
    head = ["range", *(name_of(t, n) for n, t in enumerate(takes, 1)), "mean", "sd"]
    rows = []
    for row in takes[0].rows:
        found = [t.row(row.measure.name) for t in takes]
        values = [np.nan if r is None else scaled(r, r.measure.range) for r in found]
        unit = "deg" if row.measure.is_angle else "mm"
        rows.append(
            [f"{row.measure.name}, {unit}", *(text(v, 1) for v in [*values, *_spread(values)])]
        )
    return "<h2>Takes compared</h2>" + html_table(head, rows)


def _wearers(takes: Sequence[MeasuredTake]) -> str:
    """Mean range ± sd of each wearer, if there are several."""
    of: dict[str, list[MeasuredTake]] = defaultdict(list)
    for measured in takes:
        of[measured.wearer].append(measured)
    if len(of) < 2 or "" in of:
        return ""
    rows = []
    for row in takes[0].rows:
        cells = [row.measure.name]
        for mine in of.values():
            found = [t.row(row.measure.name) for t in mine]
            mean, sd = _spread([np.nan if r is None else scaled(r, r.measure.range) for r in found])
            cells.append(f"{text(mean, 1)} ± {text(sd, 1)}" if len(mine) > 1 else text(mean, 1))
        rows.append(cells)
    head = ["mean range ± sd", *(f"{w} ({len(mine)})" for w, mine in of.items())]
    return "<h2>Wearers compared</h2>" + html_table(head, rows)


def _spread(values: Sequence[float]) -> tuple[float, float]:
    known = [v for v in values if np.isfinite(v)]
    mean = float(np.mean(known)) if known else float("nan")
    return mean, float(np.std(known, ddof=1)) if len(known) > 1 else float("nan")


def _definitions() -> str:
    definitions = (
        "Flexion is positive towards the palm. Abduction is about the axis out of the back of the "
        "hand: towards the thumb for a right hand, towards the little finger for a left hand.",
        "± is the standard deviation reported by the tracker. That of an angle follows from the "
        "standard deviations at both ends of the bones, that of a distance from its two points, "
        "with errors assumed to be independent; that of a range is √2 times larger. The cell is "
        "empty if the tracker reports none.",
        f"Peak speed, smoothness and repetitions are computed below {CUTOFF:g} Hz (zero-phase "
        "second-order Butterworth filter) from parts without gaps. Spectral arc length and "
        "logarithm of the dimensionless jerk: Balasubramanian et al. 2015, of the longest part; "
        "nearer to zero is smoother. A repetition crosses the middle of the range; the range of "
        "one is the median between successive turning points. The range of a whole recording "
        "includes slip of the cloth and changes of the calibration; the range of one repetition "
        "includes very little of both.",
        "Measured: the part was seen by an IMU or a marker within the last half second. Inferred: "
        "by synergy or from earlier measurements. Lost values are not used. Interpolated: an edit "
        "filled a gap; these values count as inferred, not as measured.",
    )
    items = "".join(f"<li>{escape(s)}</li>" for s in definitions)
    return f"<h2>Definitions</h2><ul>{items}</ul><p>Glovetrack {escape(__version__)}</p>"


def as_json(takes: Sequence[MeasuredTake]) -> dict[str, Any]:
    """``hand`` by side for one session; for several, ``sessions`` is a list of such objects."""
    sessions: dict[int, dict[str, Any]] = {}
    for measured in takes:
        found = sessions.setdefault(measured.session, {"hand": {}})
        found["hand"][measured.side] = _hand(measured)
    if len(sessions) == 1:
        return next(iter(sessions.values()))
    return {"sessions": list(sessions.values())}


def _hand(measured: MeasuredTake) -> dict[str, Any]:
    recorded = [r for r in measured.rows if r.measure.is_angle and not r.isb]
    isb = [r for r in measured.rows if r.isb]
    apart = [r for r in measured.rows if not r.measure.is_angle]
    return {
        "take": measured.name,
        "duration_s": measured.seconds,
        "angles": {r.measure.name: _row(r, "deg") for r in recorded},
        "isb_angles": {r.measure.name: _row(r, "deg") for r in isb},
        "aperture_mm": {r.measure.name: _row(r, "mm") for r in apart},
        "measured_percent": _percent([r.measure.measured for r in recorded]),
        "lost_percent": _percent([r.measure.lost for r in recorded]),
    }


def _row(row: Row, unit: str) -> dict[str, float | int]:
    m, c = row.measure, row.course
    values = {"min": m.least, "max": m.greatest, "range": m.range, "sd": m.sd}
    named = {f"{name}_{unit}": scaled(row, value) for name, value in values.items()}
    peak = scaled(row, c.fastest)
    return {**named, f"peak_{unit}_s": peak, "repetitions": int(c.repetitions)}


def _percent(shares: Sequence[float]) -> float:
    """Mean over the recorded angles in percent."""
    return 100.0 * float(np.mean(shares)) if shares else float("nan")


# ---- the values of a report as CSV: one line per take and quantity, with a column for the unit

COLUMNS = (
    "take", "wearer", "side", "name", "unit", "sequence", "min", "max", "range", "range_sd",
    "mean", "sd", "claimed_sd", "peak_speed_per_s", "peak_speed_at_s", "greatest_at_s",
    "spectral_arc_length", "log_dimensionless_jerk", "repetitions",
    "range_of_one", "sd_of_one", "measured_percent", "inferred_percent", "lost_percent",
    "interpolated_percent",
)  # fmt: skip
_UNITS = Units()


def table(takes: Sequence[MeasuredTake]) -> str:
    """CSV text: angles in degrees, distances in mm, empty cells for unknown values."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    for measured in takes:
        for row in measured.rows:
            writer.writerow([measured.name, measured.wearer, measured.side, *_table_cells(row)])
    return out.getvalue()


def _table_cells(row: Row) -> list[str]:
    m, c = row.measure, row.course
    sequence = (SEQUENCE if row.isb else RECORDED) if m.is_angle else ""
    spread = (m.least, m.greatest, m.range, row.range_sd, m.mean, m.sd, m.claimed_sd, c.fastest)
    numbers = [text(scaled(row, v)) for v in spread]
    plain = [text(v) for v in (c.at, row.peak_at, c.arc, c.jerk)]
    shares = [text(100 * v, 2) for v in (m.measured, m.inferred, m.lost, m.interpolated)]
    each = [text(scaled(row, v)) for v in (c.each, c.each_sd)]
    unit = _UNITS.name(m.is_angle)
    return [m.name, unit, sequence, *numbers, *plain, str(c.repetitions), *each, *shares]


def scaled(row: Row, value: float) -> float:
    """An angle in degrees, a distance in mm."""
    return _UNITS.of(value, row.measure.is_angle)


def text(value: float, digits: int = 4) -> str:
    return f"{value:.{digits}f}" if np.isfinite(value) else ""
