"""What the commands have in common that track simulated people with several devices each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from tracker.base.arguments import argument
from tracker.base.errors import ConfigError
from tracker.base.terminal import force_option, json_option, progress_line
from tracker.base.workers import WorkItem, run_all, some_workers

Case = TypeVar("Case")
Figures = TypeVar("Figures")
Trial = Callable[[Case, int, Callable[[float], None]], Figures]


@dataclass(frozen=True, kw_only=True)
class Trials:
    """Arguments: how people are tracked, by blobs or also by images, how many at once, and the file
    for the figures."""

    engine: str = field(default="chain", metadata=argument("chain or vist"))
    images: bool = field(default=False, metadata=argument("render images and detect blobs"))
    fps: float = field(
        default=60.0, metadata=argument("frame rate of the camera, Hz (default: 60)")
    )
    seed: int = field(default=0, metadata=argument("random seed of the first person"))
    processes: int = field(
        default=1, metadata=argument("worker processes (default: 1)", metavar="N")
    )
    json: str | None = json_option()
    force: bool = force_option()


@dataclass(frozen=True, kw_only=True)
class BlobTrials(Trials):
    """The same without images."""

    images: bool = False


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
