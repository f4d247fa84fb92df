"""All trials of all cases, in one process or several, with progress."""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Iterator, Sequence
from typing import TextIO

from tracker.evaluation.metrics import Trial
from tracker.evaluation.vist_cases import Case
from tracker.evaluation.vist_trial import run_trial

Job = tuple[int, Case, int]


def run_cases(
    cases: Sequence[Case], participants: int, processes: int = 1, progress: Progress | None = None
) -> list[list[Trial]]:
    """Trials of each case, by participant; the same for any number of processes."""
    jobs = [(i, case, k) for i, case in enumerate(cases) for k in range(participants)]
    out: list[list[Trial]] = [[] for _ in cases]
    for done, (i, trial) in enumerate(_results(jobs, processes), start=1):
        out[i].append(trial)
        if progress is not None:
            progress.show(done, len(jobs))
    for trials in out:
        trials.sort(key=lambda t: t.participant)
    return out


def _results(jobs: Sequence[Job], processes: int) -> Iterator[tuple[int, Trial]]:
    if processes <= 1 or not jobs:
        yield from map(_run, jobs)
        return
    # "spawn": a forked child would inherit the parent's threads in an unknown state
    with multiprocessing.get_context("spawn").Pool(min(processes, len(jobs))) as pool:
        yield from pool.imap_unordered(_run, jobs)


def _run(job: Job) -> tuple[int, Trial]:
    index, case, participant = job
    return index, run_trial(case, participant)


class Progress:
    """A bar on standard error where that is a terminal; silent elsewhere."""

    WIDTH = 30

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream or sys.stderr
        self._visible = self._stream.isatty()

    def show(self, done: int, total: int) -> None:
        """``done`` of ``total`` trials are finished."""
        if not self._visible:
            return
        filled = self.WIDTH * done // max(total, 1)
        bar = "#" * filled + "-" * (self.WIDTH - filled)
        end = "\n" if done == total else ""
        self._stream.write(f"\r[{bar}] {done}/{total} trials{end}")
        self._stream.flush()
