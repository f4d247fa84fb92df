"""The benchmark's table and plot, and whether a goal is reached."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from tests.benchmarks.history import Run, change
from tests.benchmarks.rows import BenchRow
from tracker.base.errors import FileError

REACHED, MISSED, NEUTRAL = "#2f7d4f", "#c8553d", "#6b7280"
_LIMIT = re.compile(r"(<= |>= )?(peer [+-] )?(\d[\d.e+-]*)( s)?")


def reached(row: BenchRow) -> bool | None:
    """Whether the goal is reached; None where there is none, or no peer to compare with.

    A bare number bounds the ratio, or the value of a row that has no unit to compare; "<= n s"
    and ">= n" bound the value; "<= peer + n" and ">= peer - n" bound it relative to the peer's.
    """
    match = _LIMIT.fullmatch(row.goal)
    if match is None:
        return None
    sense, peer, number = match[1], match[2], float(match[3])
    if peer:
        if row.peer_value is None:
            return None
        bound = row.peer_value + (number if "+" in peer else -number)
        return row.value >= bound if sense == ">= " else row.value <= bound
    if sense == ">= ":
        return row.value >= number
    if sense or row.peer == "-":
        return row.value <= number
    return None if row.ratio is None else row.ratio <= number


def table(rows: Sequence[BenchRow], former: Sequence[Run] = ()) -> str:
    """Text for a terminal; the last column is this run's figure over a former run's."""
    cells: list[tuple[str, ...]] = [("", "ours", "peer's", "unit", "ratio", "goal", "", "vs last")]
    cells += [_cells(r, former) for r in rows]
    widths = [max(len(c[k]) for c in cells) for k in range(len(cells[0]))]
    lines = []
    for c in cells:
        text = [
            c[0].ljust(widths[0]),
            *(v.rjust(w) for v, w in zip(c[1:], widths[1:], strict=True)),
        ]
        lines.append("  ".join(text).rstrip())
    absent = [f"{r.name}: not compared, {r.peer} is not here" for r in rows if _is_absent(r)]
    return "\n".join([*lines, *absent])


def _is_absent(row: BenchRow) -> bool:
    return row.peer != "-" and row.peer_value is None


def _cells(row: BenchRow, former: Sequence[Run]) -> tuple[str, ...]:
    verdict = {True: "reached", False: "MISSED", None: ""}[reached(row)]
    changed = change(row, former)
    return (
        row.name,
        _number(row.value),
        _number(row.peer_value),
        row.unit,
        _number(row.ratio),
        row.goal,
        verdict,
        "" if changed is None else f"x {changed:.2f}",
    )


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}"


def plot(rows: Sequence[BenchRow], path: Path) -> None:
    """Ratios as bars on a logarithmic axis, with each goal as a mark. Raises FileError."""
    shown = [r for r in rows if r.ratio and r.unit in ("s", "ms", "µs")]
    figure = Figure(figsize=(8.0, 0.8 + 0.34 * max(len(shown), 1)), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    for k, r in enumerate(reversed(shown)):
        colour = {True: REACHED, False: MISSED, None: NEUTRAL}[reached(r)]
        ax.barh(k, r.ratio or 0.0, color=colour, height=0.6)
        if reached(r) is not None:
            ax.plot(float(r.goal), k, "k|", ms=14)
    ax.set_xscale("log")
    ax.axvline(1.0, color=NEUTRAL, lw=1, ls="--")
    ax.set_yticks(range(len(shown)), [r.name.strip() for r in reversed(shown)], fontsize=8)
    ax.set_xlabel("ours / peer's (mark: goal)")
    ax.grid(axis="x", alpha=0.25)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, dpi=120)
    except OSError as error:
        raise FileError(f"The plot {path} could not be written: {error}.") from error
