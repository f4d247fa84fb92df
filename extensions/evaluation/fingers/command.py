"""The command ``evaluate fingers``: each fingertip with and without the glove's cloth, with true
silhouettes, and with patches on the end segments."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from extensions.evaluation.commands import EvaluateFingersArguments
from extensions.evaluation.fingers.trial import Bound, TipErrors, bound_of, tips_of
from tracker.base.terminal import check_json, finish, progress_line
from tracker.messages import Array

WITHOUT, WITH, BOUND = CLOTH = ("without", "with", "silhouette")
"""Without the cloth for ring and little finger, with it, and with the hand's true silhouettes."""


DISTAL = "distal"
"""Without the cloth, by a glove with patches on the end segments."""


HALF = 0.5  # share of a digit


class TipRow(NamedTuple):
    """One fingertip; by which cloth (`CLOTH`): mean error (mm), share of instants at which it is
    reported as measured, mean errors (mm) of those instants and of the others (None where there are
    none), the share of errors within three standard deviations, and the mean error (mm) while at
    least half of the digit is visible in one image."""

    tip: str
    cloth: str
    error_mm: float
    measured: float
    measured_mm: float | None
    inferred_mm: float | None
    true: float
    visible_mm: float | None


def evaluate_fingers(args: EvaluateFingersArguments) -> int:
    """Track each session with and without the cloth and with true silhouettes, and others with
    distal patches, and print the figures of all together."""
    paths, distal = [Path(name) for name in args.sessions], [Path(name) for name in args.distal]
    check_json(args, [*paths, *distal])

    def bounds_of(sessions: Sequence[Path]) -> list[Bound]:
        return [
            bound_of(path, args.colours, progress_line(f"silhouettes of {path.name}"))
            for path in sessions
        ]

    def rows_with(
        sessions: Sequence[Path], bounds: Sequence[Bound], cloth: bool, as_: str
    ) -> list[TipRow]:
        found = [
            tips_of(path, args.colours, cloth, b.seen, progress_line(f"tracking {path.name}"))
            for path, b in zip(sessions, bounds, strict=True)
        ]
        return rows_of(found, as_)

    bounds = bounds_of(paths)
    rows = [row for c in (WITHOUT, WITH) for row in rows_with(paths, bounds, c == WITH, c)]
    rows += rows_of([bound.tips for bound in bounds], BOUND)
    if distal:
        rows += rows_with(distal, bounds_of(distal), False, DISTAL)
    cost = cost_of(np.concatenate([bound.cost for bound in bounds]))
    report = {"rows": [row._asdict() for row in rows], "cost": cost._asdict()}
    finish(args, report, [*table(rows), *cost_lines(cost)], [*paths, *distal])
    return 0


class Cost(NamedTuple):
    """Processor time (ms) of evaluating the cloth in ``pairs`` stereo pairs that show the hand."""

    pairs: int
    mean_ms: float
    median_ms: float
    p99_ms: float


def cost_of(times: Array) -> Cost:
    """Of ``times`` (n,) s."""
    if not len(times):
        return Cost(0, 0.0, 0.0, 0.0)
    ms = 1e3 * times
    middle, most = np.percentile(ms, [50, 99]).tolist()
    return Cost(len(ms), float(ms.mean()), middle, most)


def cost_lines(cost: Cost) -> list[str]:
    """The cost as lines of text."""
    if not cost.pairs:
        return []
    return [
        f"processor time of evaluating the cloth (silhouettes) in {cost.pairs} stereo pairs: "
        f"mean {cost.mean_ms:.1f} ms, median {cost.median_ms:.1f} ms, 99 % {cost.p99_ms:.1f} ms"
    ]


def rows_of(found: Sequence[Mapping[str, TipErrors]], cloth: str) -> list[TipRow]:
    """A row for each fingertip, over all sessions."""
    rows = []
    for tip in dict.fromkeys(name for tips in found for name in tips):
        parts = [tips[tip] for tips in found if tip in tips]
        error, sd, measured, visible = (np.concatenate(v) for v in zip(*parts, strict=True))
        if not len(error):
            continue
        seen, other = _mean_mm(error[measured]), _mean_mm(error[~measured])
        mean, share = 1e3 * float(error.mean()), float(measured.mean())
        true = float((error < 3 * sd).mean())
        half = _mean_mm(error[visible >= HALF])
        rows.append(TipRow(tip, cloth, mean, share, seen, other, true, half))
    return rows


def _mean_mm(error: Array) -> float | None:
    """The mean of errors in m; None if there are none."""
    return 1e3 * float(error.mean()) if len(error) else None


def table(rows: Sequence[TipRow]) -> list[str]:
    """The table as lines of text."""
    lines = [
        f"{'fingertip':<12}{'cloth':>11}{'error mm':>10}{'measured %':>12}{'measured mm':>13}"
        f"{'inferred mm':>13}{'within 3 sd %':>15}{'half visible mm':>17}"
    ]
    for r in sorted(rows, key=lambda row: [q.tip for q in rows].index(row.tip)):
        states = "".join(f"{_number(mm):>13}" for mm in r[4:6])
        lines.append(
            f"{r.tip:<12}{r.cloth:>11}{r.error_mm:>10.1f}"
            f"{100 * r.measured:>12.0f}{states}{100 * r.true:>15.1f}{_number(r.visible_mm):>17}"
        )
    return lines


def _number(mm: float | None) -> str:
    return "-" if mm is None else f"{mm:.1f}"
