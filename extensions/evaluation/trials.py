"""What the commands have in common that track simulated people with several devices each."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import TypeVar

from tracker.base.errors import ConfigError
from tracker.base.terminal import add_json, progress_line
from tracker.base.workers import WorkItem, run_all, some_workers

Case = TypeVar("Case")
Figures = TypeVar("Figures")
Trial = Callable[[Case, int, Callable[[float], None]], Figures]


def add_trials(parser: argparse.ArgumentParser, images: bool = True) -> None:
    """Arguments: how people are tracked, by blobs or also by ``images``, how many at once, and the
    file for the figures."""
    parser.add_argument("--engine", default="chain", help="chain or vist")
    if images:
        parser.add_argument("--images", action="store_true", help="render images and detect blobs")
    parser.add_argument(
        "--fps", type=float, default=60.0, help="frame rate of the camera, Hz (default: 60)"
    )
    parser.add_argument("--seed", type=int, default=0, help="random seed of the first person")
    parser.add_argument(
        "--processes", type=int, default=1, metavar="N", help="worker processes (default: 1)"
    )
    add_json(parser)


def run_trials(
    trial: Trial[Case, Figures], cases: Sequence[Case], args: argparse.Namespace
) -> list[Figures]:
    """The figures of all people in each case, case by case. Raises ConfigError if one fails."""
    seeds = range(args.seed, args.seed + args.participants)
    tasks = [WorkItem(trial, (case, seed)) for case in cases for seed in seeds]
    with some_workers(max(1, min(args.processes, len(tasks)))) as workers:
        outcomes = run_all(tasks, workers, progress_line(f"tracking {len(tasks)} trials"))
    failed = [outcome.error for outcome in outcomes if outcome.error]
    if failed:
        raise ConfigError(failed[0])
    return [outcome.value for outcome in outcomes]
