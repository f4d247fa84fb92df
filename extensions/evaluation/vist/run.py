"""Runs all trials of all cases in one or several processes, with progress."""

from __future__ import annotations

import multiprocessing
import signal
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TextIO

from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.metrics import Trial
from extensions.evaluation.vist.stored import StoredTrials
from extensions.evaluation.vist.trial import run_trial

Job = tuple[int, Case, int]


def run_cases(
    cases: Sequence[Case],
    participants: int,
    processes: int = 1,
    progress: ProgressBar | None = None,
    stored: StoredTrials | None = None,
) -> list[list[Trial]]:
    """Trials of each case, by participant; independent of the number of processes.

    Trials in ``stored`` are not run again, and new ones are added to it. After Ctrl+C, only
    finished trials are returned, so some cases have fewer trials or none.
    """
    wanted = [(i, case, k) for i, case in enumerate(cases) for k in range(participants)]
    out, jobs = _done_before(wanted, len(cases), stored)
    progress = progress or ProgressBar()
    try:
        progress.show(0, len(jobs))
        for done, (i, trial) in enumerate(_results(jobs, processes), start=1):
            out[i].append(trial)
            if stored:
                stored.add(cases[i], trial)
            progress.show(done, len(jobs))
    except KeyboardInterrupt:
        progress.end()
    for trials in out:
        trials.sort(key=lambda t: t.participant)
    return out


def _done_before(
    wanted: Sequence[Job], cases: int, stored: StoredTrials | None
) -> tuple[list[list[Trial]], list[Job]]:
    """Stored trials of each case, and the remaining jobs."""
    out: list[list[Trial]] = [[] for _ in range(cases)]
    left = []
    for i, case, participant in wanted:
        trial = stored.find(case, participant) if stored else None
        if trial is None:
            left.append((i, case, participant))
        else:
            out[i].append(trial)
    return out, left


def _results(jobs: Sequence[Job], processes: int) -> Iterator[tuple[int, Trial]]:
    if processes <= 1 or not jobs:
        yield from map(_run, jobs)
        return
    # "spawn": a forked child would inherit the parent's threads in an unknown state
    with _uninterrupted():
        pool = multiprocessing.get_context("spawn").Pool(min(processes, len(jobs)))
    with pool:
        yield from pool.imap_unordered(_run, jobs)


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Processes started in this context ignore Ctrl+C; their parent stops them."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _run(job: Job) -> tuple[int, Trial]:
    index, case, participant = job
    return index, run_trial(case, participant)


class ProgressBar:
    """A progress bar on standard error if that is a terminal; otherwise nothing is printed."""

    WIDTH = 30

    def __init__(
        self, stream: TextIO | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._stream, self._clock = stream or sys.stderr, clock
        self._visible = self._stream.isatty()
        self._begin = clock()

    def show(self, done: int, total: int) -> None:
        """Show that ``done`` of ``total`` trials are finished."""
        if not self._visible:
            return
        filled = self.WIDTH * done // max(total, 1)
        bar = "#" * filled + "-" * (self.WIDTH - filled)
        self._stream.write(f"\r[{bar}] {done}/{total} trials{self._left(done, total):<22}")
        self._stream.flush()
        if done == total:
            self.end()

    def end(self) -> None:
        """End the line of the progress bar."""
        if self._visible:
            self._stream.write("\n")

    def _left(self, done: int, total: int) -> str:
        """Estimated remaining time."""
        if not 0 < done < total:
            return ""
        seconds = (self._clock() - self._begin) * (total - done) / done
        return f", {seconds / 60:.0f} min left" if seconds >= 90 else f", {seconds:.0f} s left"
