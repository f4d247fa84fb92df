"""The report of a touch test as HTML, PDF and JSON."""

from __future__ import annotations

import io
import textwrap
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from extensions.touch.result import AXES, NORMAL, FingerResult, TouchResult
from extensions.touch.sheet import CROSSES, TouchSheet
from extensions.touch.statistics import ConfidenceInterval
from tracker import __version__
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, whole_files
from tracker.base.notices import notice
from tracker.base.report_page import html_page, html_table

MM = 1000.0


def write_report(
    result: TouchResult, out: Path, force: bool = False, inputs: Sequence[Path] = ()
) -> list[Path]:
    """Write ``out`` (HTML) and a PDF file of the same name, both or neither; returns their paths.

    Raises ConfigError if the name does not end in .html, FileError for files that exist.
    """
    if out.suffix.lower() not in (".html", ".htm"):
        raise ConfigError(notice("option.html", file=out.name))
    targets = [out, out.with_suffix(".pdf")]
    for target in targets:
        check_target(target, force, inputs)
    with whole_files(*targets, force=force, inputs=inputs) as (page_part, pdf_part):
        page_part.write_bytes(page(result).encode())
        write_pdf(result, summary_rows(result), pdf_part)
    return targets


def page(result: TouchResult) -> str:
    """The report as one HTML page that contains its figures."""
    warnings = "".join(
        f'<p class="{"note" if n.severity == "info" else "warning"}">{escape(str(n))}</p>'
        for n in result.notices
    )
    parts = [
        "<h1>Touch test</h1>",
        f'<p class="quote">{escape(result.line)}</p>',
        _about(result),
        warnings,
        svg(result),
        "<h2>By finger</h2>",
        _fingers(result),
        "<h2>Bias and 95 % limits of agreement by axis of the sheet (mm)</h2>",
        _limits(result),
        "<h2>Fingertip contact</h2>",
        _pulps(result),
        "<h2>Summary</h2>",
        html_table(("", ""), summary_rows(result)),
        _definitions(),
    ]
    return html_page("Touch test", parts)


def _about(result: TouchResult) -> str:
    s = result.session
    words = [s.get("name", ""), s.get("participant", ""), f"{s.get('side', '')} hand"]
    words += [f"glove {s.get('glove', '')}", f"engine {s.get('engine', '')} {s.get('version', '')}"]
    return f'<p class="note">{escape(", ".join(w for w in words if w.strip()))}</p>' if s else ""


def _fingers(result: TouchResult) -> str:
    head = ("finger", "touches", "bias mm", "SD per axis mm", "mean distance mm", "95 % within mm",
            "reported sd mm")  # fmt: skip
    rows = [
        [f.finger, str(f.count), mm(f.bias_length), mm(f.sd), mm(f.distance), mm(f.p95)]
        + [f"{MM * sum(t.sd for t in f.touches) / f.count:.1f}"]
        for f in result.fingers
    ]
    rows.append(
        ["all", str(result.count), mm(result.bias_length), mm(result.sd), mm(result.distance)]
        + [mm(result.p95), f"{MM * result.claimed_sd:.1f}"]
    )
    return html_table(head, rows)


def _limits(result: TouchResult) -> str:
    head = ("finger", *(f"{a}: bias" for a in AXES), *(f"{a}: limits" for a in AXES))
    rows = [
        [f.finger, *(mm(b) for b in f.bias)]
        + [f"{MM * low.value:.1f} to {MM * high.value:.1f}" for low, high in f.limits]
        for f in result.fingers
    ]
    return html_table(head, rows)


def _pulps(result: TouchResult) -> str:
    head = ("finger", "contact from the tip: along, across, out of the nail (mm)",
            "of it not in the hand file (mm)", "± (mm)", "bias without that (mm)",
            "free offset (mm)", "± (mm)", "SD with it (mm)")  # fmt: skip
    rows = [_pulp(f) for f in result.fingers]
    return html_table(head, rows)


def _pulp(f: FingerResult) -> list[str]:
    held, free = f.pulp.held, f.pulp.free
    vectors = (f.pulp.total, held.offset, held.offset_sd, free.offset, free.offset_sd)
    cells = [", ".join(f"{MM * v:.1f}" for v in vector) for vector in vectors]
    return [f.finger, *cells[:3], f"{MM * f.unfitted:.1f}", *cells[3:], f"{MM * free.noise:.1f}"]


def summary_rows(result: TouchResult) -> list[tuple[str, str]]:
    """Name and value of each further figure."""
    within = [
        f"{100 * c.value:.0f} % ({100 * c.low:.0f} to {100 * c.high:.0f}; {100 * n:.1f} if right)"
        for c, n in zip(result.claims, NORMAL, strict=True)
    ]
    rows = [(f"errors within {k} reported sd", text) for k, text in enumerate(within, 1)]
    rows += [
        ("change of the error with distance", f"{_per_100(result.slope)} mm per 100 mm"),
        ("along the line of sight", f"bias {mm(result.depth[0])}, SD {mm(result.depth[1])} mm"),
        ("across it", f"bias {mm(result.across[0])}, SD {mm(result.across[1])} mm"),
    ]
    rows += [(f"mean distance, {how.replace('_', ' ')}", f"{mm(i)} mm")
             for how, i in result.by_how.items()]  # fmt: skip
    if result.ruler is not None:
        r = result.ruler
        scale = f"scale {r.scale.value:.4f} ({r.scale.low:.4f} to {r.scale.high:.4f})"
        rows.append(
            ("lengths between crosses", f"error {mm(r.error)}, SD {MM * r.sd:.1f} mm; {scale}")
        )
    if result.returned is not None:
        rows.append(("return after 5 s out of view", f"{mm(result.returned)} mm"))
    if result.closure is not None:
        c = result.closure
        rows.append((f"pinch closure, {c.count} pinches", f"gap {mm(c.gap)}, SD {mm(c.sd)} mm"))
    rows += [
        (f"noise at rest, {s.finger}, {s.seconds:.0f} s",
         f"{MM * s.noise:.2f} mm per axis, jitter {MM * s.jitter:.3f} mm")
        for s in result.still
    ]  # fmt: skip
    p = result.pose
    scale = f"{p.print_scale:.4f}, by the stereo camera {p.scale:.4f} ± {p.scale_sd:.4f}"
    rows.append(("sheet", f"fit {p.fit_px:.2f} px in {p.images} images, printed scale {scale}"))
    return rows


def mm(interval: ConfidenceInterval) -> str:
    """In mm with its confidence interval."""
    value, low, high = (MM * v for v in (interval.value, interval.low, interval.high))
    return f"{value:.1f} ({low:.1f} to {high:.1f})"


def _per_100(interval: ConfidenceInterval) -> str:
    value, low, high = (100 * v for v in (interval.value, interval.low, interval.high))
    return f"{value:.1f} ({low:.1f} to {high:.1f})"


def _definitions() -> str:
    definitions = (
        "An error is the tracked contact of the fingertip less the cross that it rested on, "
        "relative to the sheet as the same camera sees it. It includes how well the wearer hit the "
        "cross (about 0.5 to 1 mm).",
        "Bias: length of the mean error. SD: per axis, pooled over the axes, about each finger's "
        "bias. In brackets: 95 % confidence interval, by Student's t (means), chi-square (SD), "
        "Wilson (shares) and bootstrap with a fixed seed (lengths of biases, percentiles, scale).",
        "95 % limits of agreement: bias ± 1.96 SD (Bland & Altman 1986).",
        "Contact: the lowest point of a round end of the hand file's radius, and an offset, "
        "constant in the frame of the last segment, by which the wearer's pulp differs. An error "
        "of the tracker that turns with the finger looks like such an offset, so errors are stated "
        "with an offset that is held near zero (prior 0.5 mm per axis). The free offset is the one "
        "that fits best; much more than 3 mm points to wrong lengths in the hand file.",
    )
    items = "".join(f"<li>{escape(s)}</li>" for s in definitions)
    return f"<h2>Definitions</h2><ul>{items}</ul><p>Glovetrack {escape(__version__)}</p>"


def as_json(result: TouchResult) -> dict[str, Any]:
    """All figures in mm; shares as fractions."""
    r = result
    return {
        "line": r.line,
        "session": dict(r.session),
        "touches": r.count,
        "missed": [c.number for c in r.missed],
        "bias_mm": _mm(r.bias_length),
        "sd_mm": _mm(r.sd),
        "distance_mm": _mm(r.distance),
        "p95_mm": _mm(r.p95),
        "within_claimed_sd": [_plain(c) for c in r.claims],
        "claimed_sd_mm": MM * r.claimed_sd,
        "slope_mm_per_m": _mm(r.slope),
        "line_of_sight_mm": {"bias": _mm(r.depth[0]), "sd": _mm(r.depth[1])},
        "across_mm": {"bias": _mm(r.across[0]), "sd": _mm(r.across[1])},
        "by_how_mm": {how: _mm(i) for how, i in r.by_how.items()},
        "fingers": {f.finger: _finger_json(f) for f in r.fingers},
        "ruler_test": None
        if r.ruler is None
        else {"lengths": r.ruler.count, "error_mm": _mm(r.ruler.error),
              "sd_mm": MM * r.ruler.sd, "scale": _plain(r.ruler.scale)},
        "return_mm": None if r.returned is None else _mm(r.returned),
        "pinch": None
        if r.closure is None
        else {"pinches": r.closure.count, "gap_mm": _mm(r.closure.gap), "sd_mm": _mm(r.closure.sd)},
        "stillness": {
            s.finger: {"noise_mm": MM * s.noise, "jitter_mm": MM * s.jitter, "seconds": s.seconds}
            for s in r.still
        },
        "sheet": {
            "print_scale": r.pose.print_scale,
            "print_measured": r.pose.measured,
            "stereo_scale": r.pose.scale,
            "stereo_scale_sd": r.pose.scale_sd,
            "fit_px": r.pose.fit_px,
            "moved_mm": MM * r.pose.moved,
        },
        "notices": [{"code": n.code, "severity": str(n.severity), "text": str(n)}
                    for n in r.notices],
    }  # fmt: skip


def _finger_json(f: FingerResult) -> dict[str, Any]:
    return {
        "touches": f.count,
        "bias_mm": _mm(f.bias_length),
        "bias_axes_mm": {a: _mm(b) for a, b in zip(AXES, f.bias, strict=True)},
        "sd_mm": _mm(f.sd),
        "limits_mm": {
            a: [MM * low.value, MM * high.value]
            for a, (low, high) in zip(AXES, f.limits, strict=True)
        },
        "distance_mm": _mm(f.distance),
        "p95_mm": _mm(f.p95),
        "pulp_mm": [MM * float(v) for v in f.pulp.total],
        "pulp_offset_mm": [MM * float(v) for v in f.pulp.offset],
        "pulp_offset_sd_mm": [MM * float(v) for v in f.pulp.held.offset_sd],
        "free_offset_mm": [MM * float(v) for v in f.pulp.free.offset],
        "free_offset_sd_mm": [MM * float(v) for v in f.pulp.free.offset_sd],
        "sd_with_free_offset_mm": MM * f.pulp.free.noise,
        "bias_without_offset_mm": MM * f.unfitted,
    }


def _mm(interval: ConfidenceInterval) -> dict[str, float]:
    return _plain(interval.scaled(MM))


def _plain(interval: ConfidenceInterval) -> dict[str, float]:
    return {"value": interval.value, "low": interval.low, "high": interval.high}


# ---- the figures of a touch test, and the report as one page of PDF

COLOUR = {"thumb": "#d55e00", "index": "#0072b2", "middle": "#009e73"}
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
