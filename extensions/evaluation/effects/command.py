"""The command ``evaluate effects``: the errors of real devices, each alone and all at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from extensions.evaluation.commands import EvaluateEffectsArguments
from extensions.evaluation.effects.trial import EFFECTS, EffectsCase, EffectsFigures, run_trial
from extensions.evaluation.trials import run_trials
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.engine.kinds import ENGINES

LARGEST_RATIO = 1.15
"""Goal: error with all effects relative to the error with none."""


SHORT = ("clean", "all")


class EffectsRow(NamedTuple):
    """For several people with one set of effects: mean error (mm), its ratio to that without any,
    the smallest share of instants at which a hand is tracked, and the number of keypoints called
    measured that are more than 50 mm wrong."""

    name: str
    error_mm: float
    ratio: float
    tracked: float
    wrong: int


def evaluate_effects(args: EvaluateEffectsArguments) -> int:
    """Track the people with each set of effects and print the figures."""
    check_json(args.trials)
    ENGINES.get(args.trials.engine)  # raises ConfigError if the name is unknown
    if args.participants < 1 or args.seconds < 5:
        raise ConfigError(notice("evaluation.effects_options"))
    names = [n for n in (SHORT if args.short else EFFECTS) if args.trials.images or n != "flicker"]
    how = args.trials.engine, args.trials.images, args.trials.fps, args.seconds
    cases = [EffectsCase(EFFECTS[name], *how) for name in names]
    figures = run_trials(run_trial, cases, args.participants, args.trials)
    rows = rows_of(names, figures)
    found = summary(rows)
    finish(args.trials, found, table(rows))
    return 0 if found["ok"] else 1


def rows_of(names: Sequence[str], figures: Sequence[EffectsFigures]) -> list[EffectsRow]:
    """The figures, in the order of the trials, as one row for each name; the first is without
    effects."""
    people, rows, clean = len(figures) // len(names), list[EffectsRow](), 1.0
    for k, name in enumerate(names):
        of_name = figures[k * people : (k + 1) * people]
        error = sum(f.error_mm for f in of_name) / people
        clean = error if k == 0 else clean
        tracked, wrong = min(f.tracked for f in of_name), sum(f.wrong for f in of_name)
        rows.append(EffectsRow(name, error, error / clean, tracked, wrong))
    return rows


def summary(rows: Sequence[EffectsRow]) -> dict[str, Any]:
    """JSON values: the rows, and whether the goal is met by the last one, with all effects."""
    ok = rows[-1].ratio <= LARGEST_RATIO and not any(row.wrong for row in rows)
    return {"rows": [row._asdict() for row in rows], "ratio": rows[-1].ratio, "ok": ok}


def table(rows: Sequence[EffectsRow]) -> list[str]:
    """The table as lines of text."""
    lines = [f"{'effects':<18}{'mm':>7}{'ratio':>8}{'tracked %':>11}{'wrong':>7}"]
    lines += [
        f"{r.name:<18}{r.error_mm:>7.2f}{r.ratio:>8.3f}{100 * r.tracked:>11.1f}{r.wrong:>7d}"
        for r in rows
    ]
    return lines
