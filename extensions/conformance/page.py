"""The verdict as one self-contained HTML page."""

from __future__ import annotations

import html
from collections.abc import Sequence
from typing import Any

import numpy as np

from extensions.conformance.finding import PASS, Plot, RuleFinding
from extensions.conformance.run import TakeVerdict
from extensions.conformance.take import ScriptStep
from tracker import __version__
from tracker.base.clock import NS

LAYERS = {
    "signal": "Signal",
    "shape": "Shape of the hand",
    "placement": "Placement in the room",
    "steps": "Scripted steps",
}
WIDTH, HEIGHT, EDGE = 640, 110, 34
POINTS = 600
STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 66rem; margin: 2rem auto; padding: 0 1rem;
  color: #222; background: #fff }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
th, td { padding: .3rem .6rem; border-bottom: 1px solid #ddd; text-align: left }
.pass { color: #1a7f37 } .fail { color: #b42318; font-weight: 600 } .unknown { color: #946200 }
svg { display: block; max-width: 100% } details summary { cursor: pointer; color: #555 }
.verdict { font-size: 1.2rem; padding: .6rem 1rem; border-left: 5px solid }
"""


def page(verdict: TakeVerdict) -> str:
    """The HTML text."""
    mark = "pass" if verdict.ok else "fail"
    outcome = "All rules passed." if verdict.ok else "Not all rules passed."
    body = [
        f"<h1>Conformance of {html.escape(verdict.name)}</h1>",
        f"<p class='verdict {mark}'>{outcome} {_counts(verdict)}</p>",
        "<p>Rules and limits of NVIDIA's acceptance test of hand devices, checked by glovetrack "
        f"{__version__} on {_span(verdict)}.</p>",
    ]
    for layer, title in LAYERS.items():
        found = [f for f in verdict.findings if f.layer == layer]
        body.append(f"<h2>{title}</h2>\n{_table(found, verdict.steps, _zero(verdict))}")
    head = f"<meta charset='utf-8'><title>Conformance</title><style>{STYLE}</style>"
    return (
        f"<!doctype html><html lang='en'><head>{head}</head><body>{''.join(body)}</body></html>\n"
    )


def as_json(verdict: TakeVerdict) -> dict[str, Any]:
    """The page's content without plots: ``checks`` as specified for the command, and ``findings``
    with the status and whether a rule is only advice."""
    return {
        "take": verdict.name,
        "ok": verdict.ok,
        "glovetrack": __version__,
        "checks": [
            {
                "group": f.layer,
                "name": f.rule,
                "hand": f.side,
                "value": f.figure,
                "limit": f.limit,
                "ok": f.status == PASS,
            }
            for f in verdict.findings
        ],
        "findings": [
            {
                "layer": f.layer,
                "rule": f.rule,
                "side": f.side,
                "status": f.status,
                "figure": f.figure,
                "limit": f.limit,
                "advice": f.advice,
            }
            for f in verdict.findings
        ],
    }


def _counts(verdict: TakeVerdict) -> str:
    count: dict[str, int] = {}
    for f in verdict.findings:
        count[f.status] = count.get(f.status, 0) + 1
    return ", ".join(f"{n} {status}" for status, n in count.items()) + "."


def _span(verdict: TakeVerdict) -> str:
    parts = [f"{len(t)} records of the {t.side} hand over {t.t[-1]:.1f} s" for t in verdict.takes]
    return " and ".join(parts)


def _zero(verdict: TakeVerdict) -> dict[str, int]:
    return {t.side: int(t.sample[0]) for t in verdict.takes}


def _table(found: Sequence[RuleFinding], steps: Sequence[ScriptStep], zero: dict[str, int]) -> str:
    rows = ["<tr><th>rule<th>hand<th>verdict<th>figure<th>limit</tr>"]
    for f in found:
        mark = f.status if f.status in ("pass", "fail") else "unknown"
        status = f.status + (" (advice)" if f.advice else "")
        cells = [f.rule, f.side, f.figure, f.limit]
        rule, side, figure, limit = map(html.escape, cells)
        rows.append(
            f"<tr><td>{rule}<td>{side}<td class='{mark}'>{status}<td>{figure}<td>{limit}</tr>"
        )
        if f.plot is not None:
            drawn = _svg(f.plot, steps, zero[f.side])
            shown = " open" if f.status == "fail" else ""
            rows.append(
                f"<tr><td colspan=5><details{shown}><summary>plot</summary>{drawn}</details></tr>"
            )
    return f"<table>{''.join(rows)}</table>"


def _svg(plot: Plot, steps: Sequence[ScriptStep], zero: int) -> str:
    """SVG plot of the minimum and maximum in each of `POINTS` intervals, which shows outliers."""
    known = plot.values[np.isfinite(plot.values)]
    if not len(known):
        return "<p>nothing known</p>"
    every = np.r_[known, plot.limits]
    low, high = float(every.min()), float(every.max())
    span = max(high - low, 1e-12)
    end = max(float(plot.t[-1]), 1e-9)

    def x(t: float) -> float:
        return EDGE + (WIDTH - EDGE) * t / end

    def y(value: float) -> float:
        return 6 + (HEIGHT - 24) * (1 - (value - low) / span)

    parts = [f"<svg viewBox='0 0 {WIDTH} {HEIGHT}' width='{WIDTH}' height='{HEIGHT}' role='img'>"]
    for s in steps:
        a, b = (x((ns - zero) / NS) for ns in (s.start_ns, s.end_ns))
        tip = f"<title>{html.escape(s.label)}</title>"
        parts.append(
            f"<rect x='{a:.1f}' y='4' width='{b - a:.1f}' height='{HEIGHT - 20}' "
            f"fill='#eef3fb'>{tip}</rect>"
        )
    for limit in plot.limits:
        parts.append(
            f"<line x1='{EDGE}' x2='{WIDTH}' y1='{y(limit):.1f}' y2='{y(limit):.1f}' "
            "stroke='#c8553d' stroke-dasharray='4 3'/>"
        )
    for run in _pieces(plot):
        points = " ".join(f"{x(t):.1f},{y(v):.1f}" for t, v in run)
        parts.append(f"<polyline points='{points}' fill='none' stroke='#1f77b4'/>")
    unit = html.escape(plot.unit)
    for value in (low, high):
        parts.append(f"<text x='0' y='{y(value) + 4:.1f}' font-size='10'>{value:.3g}</text>")
    parts.append(f"<text x='{EDGE}' y='{HEIGHT - 4}' font-size='10'>{unit} over {end:.0f} s</text>")
    return "".join(parts) + "</svg>"


def _pieces(plot: Plot) -> list[list[tuple[float, float]]]:
    """Runs of known values, decimated."""
    out: list[list[tuple[float, float]]] = [[]]
    size = max(1, len(plot.values) // POINTS)
    for start in range(0, len(plot.values), size):
        part, t = plot.values[start : start + size], float(plot.t[start])
        part = part[np.isfinite(part)]
        if not len(part):
            out.append([])
            continue
        out[-1] += [(t, float(part.min())), (t, float(part.max()))][: 1 if len(part) == 1 else 2]
    return [run for run in out if len(run) > 1]
