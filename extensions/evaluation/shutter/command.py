"""The command ``evaluate shutter``: fast hands and a turning head in front of a rolling shutter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from extensions.evaluation.commands import EvaluateShutterArguments
from extensions.evaluation.shutter.trial import ShutterCase, ShutterFigures, run_trial
from extensions.evaluation.trials import run_trials
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.engine.kinds import ENGINES

LARGEST_RATIO = 1.03
"""Goal: error with a rolling shutter relative to the error with a global one."""


class ShutterRow(NamedTuple):
    """Mean errors (mm) with a global shutter, with a rolling one whose line time is not known, and
    with one whose line time is known."""

    speed: float
    turning_deg: float
    global_mm: float
    unknown_mm: float
    known_mm: float

    @property
    def ratio(self) -> float:
        return self.known_mm / self.global_mm


def evaluate_shutter(args: EvaluateShutterArguments) -> int:
    """Track the people in front of three cameras each and print the figures."""
    check_json(args.trials)
    ENGINES.get(args.trials.engine)  # raises ConfigError if the name is unknown
    if args.participants < 1 or args.seconds < 5 or not 0 < args.readout_ms <= 50:
        raise ConfigError(notice("evaluation.shutter_options"))
    movements = [(speed, 0.0) for speed in args.speeds]
    if args.turning_deg:
        movements.append((args.speeds[0], args.turning_deg))
    shutters = ((0.0, True), (args.readout_ms / 1000, False), (args.readout_ms / 1000, True))
    how = args.trials.engine, args.trials.images, args.trials.fps, args.seconds
    cases = [
        ShutterCase(speed, turning, readout, known, *how)
        for speed, turning in movements
        for readout, known in shutters
    ]
    figures = run_trials(run_trial, cases, args.participants, args.trials)
    rows = rows_of(movements, figures, args.participants)
    found = summary(rows)
    finish(args.trials, found, table(rows))
    return 0 if found["ok"] else 1


def rows_of(
    movements: Sequence[tuple[float, float]], figures: Sequence[ShutterFigures], people: int
) -> list[ShutterRow]:
    """The figures, in the order of the trials, as one row for each movement."""
    errors = iter(f.error_mm for f in figures)
    means = [sum(next(errors) for _ in range(people)) / people for _ in range(3 * len(movements))]
    return [ShutterRow(*m, *means[3 * i : 3 * i + 3]) for i, m in enumerate(movements)]


def summary(rows: Sequence[ShutterRow]) -> dict[str, Any]:
    """JSON values: the rows, the largest ratio, and whether the goal is met."""
    largest = max(row.ratio for row in rows)
    return {
        "rows": [row._asdict() | {"ratio": row.ratio} for row in rows],
        "ratio": largest,
        "ok": largest <= LARGEST_RATIO,
    }


def table(rows: Sequence[ShutterRow]) -> list[str]:
    """The table as lines of text."""
    head = f"{'hand m/s':>9}{'camera °/s':>12}{'global mm':>11}{'not corrected mm':>18}"
    lines = [head + f"{'corrected mm':>14}{'ratio':>8}"]
    for r in rows:
        lines.append(
            f"{r.speed:>9.1f}{r.turning_deg:>12.0f}{r.global_mm:>11.2f}{r.unknown_mm:>18.2f}"
            f"{r.known_mm:>14.2f}{r.ratio:>8.3f}"
        )
    return lines
