"""Writes the accuracy report of sessions."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from extensions.reference.accuracy import (
    ALL,
    MULTIPLES,
    Bin,
    Measured,
    PointRow,
    ScalarRow,
    expected,
    headline,
    measure,
    summary,
)
from extensions.reference.angles import MODEL
from extensions.reference.pairs import Quantity, anonymized, read_pairs
from extensions.reference.statistics import Interval
from tracker import __version__
from tracker.base.files import check_target, write_whole
from tracker.base.report_page import html_page, html_table


def write_report(
    sessions: Sequence[Path], out: Path, offsets: bool = True, anonymous: bool = False,
    force: bool = False, watch: Callable[[float], None] = lambda share: None,
) -> list[Measured]:  # fmt: skip
    """Writes the page ``out`` and returns what it reports for each hand, in the order of the
    sessions. ``offsets``: with marker offsets; ``watch`` receives the share done.

    Raises FileError if a session has no reference, or if ``out`` exists without ``force``.
    """
    check_target(out, force, sessions)
    pairs = []
    for n, path in enumerate(sessions):
        pairs += read_pairs(path)
        watch(_READ * (n + 1) / len(sessions))
    pairs = anonymized(pairs) if anonymous else pairs
    measured = []
    for n, each in enumerate(pairs):
        measured.append(measure(each, offsets))
        watch(_READ + (_MEASURED - _READ) * (n + 1) / len(pairs))
    write_whole(out, page(measured, offsets), force, sessions)
    return measured


_READ, _MEASURED = 0.4, 0.9  # shares of the progress


# ---- the accuracy report as one HTML page that contains its figures


def page(measured: Sequence[Measured], offsets: bool = True) -> str:
    """The report of one or several recordings; ``offsets``: errors are with marker offsets."""
    parts = [
        "<h1>Accuracy against a reference</h1>",
        f'<p class="quote">{escape(headline(measured))}</p>',
        _recordings(measured),
        _summary(measured),
    ]
    for m in measured:
        parts += _one(m, offsets)
    parts.append(_definitions(offsets))
    return html_page("Accuracy against a reference", parts)


def number(value: float, digits: int = 1) -> str:
    """Empty if the value is unknown."""
    return f"{value:.{digits}f}" if np.isfinite(value) else ""


def _interval(ci: Interval, scale: float = 1.0, digits: int = 1) -> str:
    if not np.isfinite(ci).all():
        return ""
    return f"{scale * ci[0]:.{digits}f} to {scale * ci[1]:.{digits}f}"


def _recordings(measured: Sequence[Measured]) -> str:
    head = ("recording", "participant", "engine", "reference", "time offset s", "drift ppm",
            "time residual ms", "registration rigid mm", "with marker offsets mm", "RMSE mm",
            "95 % interval", "joint angles °")  # fmt: skip
    rows = []
    for m in measured:
        about, timing = m.pairs.about, m.pairs.about.timing
        drift = f"{1e6 * timing.drift:+.1f} ± {1e6 * timing.drift_sd:.1f}"
        rows.append([
            m.pairs.name, m.pairs.person, f"{m.pairs.engine} {m.pairs.version}",
            f"{about.file} ({about.kind}, {about.rate:.6g} Hz)", f"{timing.offset:+.4f}",
            drift if np.isfinite(timing.drift_sd) else "not estimated",
            number(1e3 * timing.residual, 2), number(1e3 * about.rigid.residual, 2),
            number(1e3 * about.with_offsets.residual, 2), number(1e3 * m.whole.rmse, 2),
            _interval(m.whole.rmse_ci, 1e3, 2), number(float(np.rad2deg(m.angle_rmse))),
        ])  # fmt: skip
    return "<h2>Recordings</h2>" + html_table(head, rows)


def _summary(measured: Sequence[Measured]) -> str:
    head = ("", "unit", "mean", "95 % interval", "sd between people", "sd within a person",
            "people", "recordings")  # fmt: skip
    rows = [
        [r.name, r.unit, number(p.mean, 2), _interval(p.ci, digits=2), number(p.between, 2),
         number(p.within, 2), str(p.people), str(p.recordings)]
        for r in summary(measured)
        for p in [r.pooled]
    ]  # fmt: skip
    return "<h2>All recordings</h2>" + html_table(head, rows) if len(measured) > 1 else ""


def _one(m: Measured, offsets: bool) -> list[str]:
    angles = [r for r in m.scalars if r.is_angle]
    lengths = [r for r in m.scalars if not r.is_angle]
    parts = [
        f"<h2>{escape(m.pairs.name)}</h2>",
        "<h3>Keypoints</h3>",
        _points(m, offsets),
        _marker_offsets(m),
    ]
    if angles:
        parts += ["<h3>Joint angles</h3>", _scalars(angles), svg(agreement(m))]
    if lengths:
        parts += ["<h3>Distances of fingertips</h3>", _scalars(lengths)]
    parts += [
        "<h3>Speed, state and reported standard deviation</h3>",
        svg(errors(m)),
        _bins([*m.speeds, *m.states]),
        '<p class="note">Mean squared error in units of the reported variance (1 if it is '
        f"correct): {number(m.nees, 2)}.</p>",
        "<h3>Largest errors</h3>",
        _worst(m),
    ]
    return parts


def _points(m: Measured, offsets: bool) -> str:
    head = ["", "n", "independent", "RMSE mm", "95 % interval", "95 % below mm"]
    head += [f"bias {a} mm" for a in "xyz"] + [f"limits {a} mm" for a in "xyz"] + ["ICC(2,1)"]
    if offsets:
        head.insert(5, "without marker offsets mm")
    return html_table(head, [_point(r, offsets) for r in m.points])


def _point(r: PointRow, offsets: bool) -> list[str]:
    cells = [r.name, str(r.n), number(r.n_effective, 0), number(1e3 * r.rmse, 2)]
    cells += [_interval(r.rmse_ci, 1e3, 2), number(1e3 * r.p95)]
    if offsets:
        cells.insert(5, number(1e3 * r.rmse_rigid, 2))
    cells += [number(1e3 * a.bias, 2) for a in r.axes]
    cells += [_interval((a.low, a.high), 1e3) for a in r.axes]
    icc = number(r.icc.value, 3) + (f" ({_interval(r.icc.ci, digits=3)})" if r.name != ALL else "")
    return [*cells, icc.removesuffix(" ()")]


def _marker_offsets(m: Measured) -> str:
    found = m.pairs.about
    if not found.with_offsets.offsets.any():
        return ""
    rows = [
        [name, *(_with_sd(1e3 * v, 1e3 * s) for v, s in zip(d, sd, strict=True)),
         number(1e3 * float(np.linalg.norm(d)))]
        for name, d, sd in zip(found.keypoints, found.with_offsets.offsets,
                               found.with_offsets.offset_sd, strict=True)
    ]  # fmt: skip
    note = (
        '<p class="note">Marker offsets: the constant position of each marker relative to the '
        "estimated keypoint, in the axes of the keypoint's segment. They contain the placement of "
        "the marker and the constant error of the estimate.</p>"
    )
    return note + html_table(("", "x mm", "y mm", "z mm", "length mm"), rows)


def _with_sd(value: float, sd: float) -> str:
    return f"{value:+.1f} ± {sd:.1f}" if np.isfinite(sd) else f"{value:+.1f} (inferred)"


def _scalars(rows: Sequence[ScalarRow]) -> str:
    head = ("", "unit", "independent", "RMSE", "bias", "95 % interval", "sd", "limits of agreement",
            "interval of the lower", "of the upper", "ICC(2,1)", "95 % interval")  # fmt: skip
    out = []
    for r in rows:
        scale, unit = (float(np.rad2deg(1.0)), "°") if r.is_angle else (1e3, "mm")
        a = r.agreement
        out.append([
            r.name, unit, number(a.n_effective, 0), number(scale * r.rmse, 2),
            number(scale * a.bias, 2), _interval(a.bias_ci, scale, 2), number(scale * a.sd, 2),
            _interval((a.low, a.high), scale, 1), _interval(a.low_ci, scale, 1),
            _interval(a.high_ci, scale, 1), number(r.icc.value, 3), _interval(r.icc.ci, digits=3),
        ])  # fmt: skip
    return html_table(head, out)


def _bins(bins: Sequence[Bin]) -> str:
    rows = [[b.name, number(100 * b.share), number(1e3 * b.rmse, 2), number(1e3 * b.p95)]
            for b in bins]  # fmt: skip
    return html_table(("", "share %", "RMSE mm", "95 % below mm"), rows)


def clock(t: float) -> str:
    """Time in the session as the replay shows it: minutes, seconds and milliseconds."""
    minutes, seconds = divmod(t, 60.0)
    return f"{int(minutes)}:{seconds:06.3f}"


def _worst(m: Measured) -> str:
    head = ["time in the session", "keypoint", "error mm", "state", "reported sd mm", "speed m/s"]
    rows = [[clock(w.t), w.keypoint, number(1e3 * w.error), w.state, number(1e3 * w.sd),
             number(w.speed, 2)] for w in m.worst]  # fmt: skip
    if not m.pairs.linked:
        return html_table(head, rows)
    rows = [[*row, replay(m.pairs.path.name, w.t)] for row, w in zip(rows, m.worst, strict=True)]
    note = (
        '<p class="note">Each command opens the replay, paused at the instant. Run it in the '
        "recording's folder, or double-click the row in the window (Replay, Accuracy report).</p>"
    )
    return html_table([*head, "command"], rows) + note


def replay(file: str, t: float) -> str:
    """The command that opens a session at t s; rounded up, since the replay shows the last estimate
    up to this time."""
    plain = all(c.isalnum() or c in "._-+" for c in file)
    name = file if plain else json.dumps(file, ensure_ascii=False)
    return f"glovetrack {name} --at {np.ceil(1e3 * t) / 1e3:.3f}"


def _definitions(offsets: bool) -> str:
    how = "after the marker offsets" if offsets else "without marker offsets"
    definitions = (
        f"Errors are estimate minus reference at each instant of the estimate, {how}. The "
        "reference was registered with the estimate, so a constant difference of position, "
        "orientation and, by movement, time between both systems is not part of the error. Errors "
        "contain those of the reference.",
        "x, y and z are the axes of the hand: to the fingers, to the left, out of the back.",
        "Limits of agreement: bias ± 1.96 sd (Bland & Altman 1986). Intervals are 95 % confidence "
        "intervals from the number of independent values, which follows from the autocorrelation "
        "of the errors (Geyer 1992).",
        "ICC(2,1): absolute agreement, two-way random effects, single measurement (Shrout & Fleiss "
        "1979; interval of McGraw & Wong 1996). Of a keypoint: the least of its three coordinates.",
        f"Joint angles of both are computed from keypoints by one model: {MODEL}.",
        "Errors within k sd: the distance is compared with k √3 times the reported standard "
        "deviation per coordinate; the grey curve is χ²₃(3k²).",
        "All recordings: a random intercept per person, by the method of moments; the interval is "
        "by Student's t with one degree of freedom less than there are people. With one recording "
        "per person the sd between people contains that within a person.",
        "Measured: the part was seen by an IMU or a marker within the last half second. Inferred: "
        "by synergy or from earlier measurements, as in occlusions. Lost values have no error.",
    )
    items = "".join(f"<li>{escape(s)}</li>" for s in definitions)
    return f"<h2>Definitions</h2><ul>{items}</ul><p>Glovetrack {escape(__version__)}</p>"


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
