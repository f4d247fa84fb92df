"""What the commands have in common that track simulated people with several devices each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from extensions.evaluation.commands import Trials
from tracker.base.errors import ConfigError
from tracker.base.terminal import progress_line
from tracker.base.workers import WorkItem, run_all, some_workers

Case = TypeVar("Case")
Figures = TypeVar("Figures")
Trial = Callable[[Case, int, Callable[[float], None]], Figures]


def run_trials(
    trial: Trial[Case, Figures], cases: Sequence[Case], participants: int, args: Trials
) -> list[Figures]:
    """The figures of all people in each case, case by case. Raises ConfigError if one fails."""
    seeds = range(args.seed, args.seed + participants)
    tasks = [WorkItem(trial, (case, seed)) for case in cases for seed in seeds]
    with some_workers(max(1, min(args.processes, len(tasks)))) as workers:
        outcomes = run_all(tasks, workers, progress_line(f"tracking {len(tasks)} trials"))
    failed = [outcome.error for outcome in outcomes if outcome.error]
    if failed:
        raise ConfigError(failed[0])
    return [outcome.value for outcome in outcomes]
