"""The command ``evaluate hands``: pairs of simulated hands, tracked together and each alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from extensions.evaluation.commands import EvaluateHandsArguments
from extensions.evaluation.hands.trial import HandFigures, run_trial
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.workers import WorkItem, run_all, some_workers
from tracker.engine.kinds import ENGINES

LONGEST_RATIO, LONGEST_OFF = 1.2, 0.2
"""Goals: error together relative to error alone, and longest time in s with a wrong position."""


def evaluate_hands(args: EvaluateHandsArguments) -> int:
    """Track the pairs and print the figures."""
    check_json(args)
    ENGINES.get(args.engine)  # raises ConfigError if the name is unknown
    if args.pairs < 1 or args.seconds < 4 or not 5 <= args.fps <= 240:
        raise ConfigError(notice("evaluation.hands_options"))
    seeds = range(args.seed, args.seed + args.pairs)
    tasks = [
        WorkItem(run_trial, (seed, args.seconds, args.engine, args.fps, args.session))
        for seed in seeds
    ]
    with some_workers(max(1, min(args.processes, args.pairs))) as workers:
        outcomes = run_all(tasks, workers, progress_line(f"tracking {args.pairs} pairs"))
    failed = [outcome.error for outcome in outcomes if outcome.error]
    if failed:
        raise ConfigError(failed[0])
    rows = [row for outcome in outcomes for row in outcome.value]
    found = summary(rows)
    finish(args, found, table(rows, found))
    return 0 if found["ok"] else 1


def summary(rows: Sequence[HandFigures]) -> dict[str, Any]:
    """JSON values: each hand, means over all, and whether the goals are met."""
    together = sum(r.together_mm for r in rows) / len(rows)
    alone = sum(r.alone_mm for r in rows) / len(rows)
    covered = sum(r.covered_mm for r in rows) / len(rows)
    longest = max(r.longest_off_s for r in rows)
    return {
        "rows": [asdict(r) | {"ratio": r.ratio, "confusion": r.confusion} for r in rows],
        "together_mm": together,
        "alone_mm": alone,
        "covered_mm": covered,
        "ratio": together / alone,
        "confusion": together / covered,
        "longest_off_s": longest,
        "ok": together <= LONGEST_RATIO * alone and longest <= LONGEST_OFF,
    }


def table(rows: Sequence[HandFigures], found: dict[str, Any]) -> list[str]:
    """The table as lines of text."""
    head = f"{'pair':>5} {'hand':<6}{'together mm':>12}{'alone mm':>10}{'ratio':>7}"
    head += f"{'covered mm':>12}{'ratio':>7}"
    lines = [head + f"{'known':>8}{'tracked':>9}{'off, longest s':>16}"]
    for r in rows:
        lines.append(
            f"{r.seed:>5} {r.side:<6}{r.together_mm:>12.2f}{r.alone_mm:>10.2f}{r.ratio:>7.2f}"
            f"{r.covered_mm:>12.2f}{r.confusion:>7.2f}"
            f"{r.known:>8.1%}{r.tracked:>9.1%}{r.longest_off_s:>16.2f}"
        )
    lines.append(
        f"{'all':>5} {'':<6}{found['together_mm']:>12.2f}{found['alone_mm']:>10.2f}"
        f"{found['ratio']:>7.2f}{found['covered_mm']:>12.2f}{found['confusion']:>7.2f}"
        f"{'':>17}{found['longest_off_s']:>16.2f}"
    )
    return lines
