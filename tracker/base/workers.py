"""Many tasks at once: on this machine's cores or, by the same code, on a cluster through Dask.

A task is a function at the top level of a module; its last argument is called with the share of
the work that is done, and may be called as often as it likes.
"""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass
from typing import Any, Protocol

from tracker.base.damage import LeftOut, gather, merged, pass_on
from tracker.base.errors import ConfigError, DeviceError, GlovetrackError
from tracker.base.notices import Notice, failure, notice
from tracker.base.numeric_threads import limit_this_process

REPORT_EVERY = 0.25  # s between two reports of one task
POLL_EVERY = 0.2  # s
DASK_TIMEOUT = 10  # s
READ_WITHIN = 10.0  # s, for a note that is there


@dataclass(frozen=True)
class WorkItem:
    """``function(*arguments, progress)``; ``weight`` is its part of the whole work."""

    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    weight: float = 1.0


@dataclass(frozen=True)
class TaskOutcome:
    """What a task returned, or why it failed; and what it left out of sessions."""

    value: Any = None
    error: Notice | None = None
    left_out: tuple[LeftOut, ...] = ()


@dataclass(frozen=True)
class WorkerRequest:
    """``processes``: one per core if None. ``dask``: address of a cluster that does it instead."""

    processes: int | None = None
    dask: str = ""


ALL_CORES = WorkerRequest()
"""For this machine."""


class Board(Protocol):
    """The progress queue: (number of the task, share done); travels to the workers."""

    def put(self, note: tuple[int, float]) -> None: ...

    def qsize(self) -> int: ...

    def get(self, timeout: float) -> tuple[int, float]: ...


class StopFlag(Protocol):
    """Set when the results are not needed any more; passed to the workers."""

    def set(self) -> None: ...

    def is_set(self) -> bool: ...


class Workers(Protocol):
    """Who does the work."""

    @property
    def board(self) -> Board: ...

    @property
    def stop(self) -> StopFlag: ...

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]: ...


@contextmanager
def local_workers(count: int) -> Iterator[Workers]:
    """``count`` processes of this machine. After an error, no further work is started."""
    context = multiprocessing.get_context("spawn")  # a fork would copy locks that threads hold
    with context.Manager() as manager:
        pool = ProcessPoolExecutor(count, mp_context=context)
        try:
            yield _Local(pool, manager.Queue(), manager.Event())
        finally:
            pool.shutdown(cancel_futures=True)


@dataclass(frozen=True)
class _Local:
    pool: ProcessPoolExecutor
    board: Any
    stop: Any

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        return self.pool.submit(function, *arguments)


@contextmanager
def dask_workers(address: str) -> Iterator[Workers]:
    """The workers of the Dask scheduler at ``address``, which must see the same files.

    Raises ConfigError without the extra ``cluster``, DeviceError where no scheduler answers.
    """
    try:
        import distributed  # deferred: an extra
    except ImportError as error:
        raise ConfigError(notice("workers.no_dask")) from error
    try:
        client = distributed.Client(address, timeout=DASK_TIMEOUT, set_as_default=False)
    except (OSError, ValueError) as error:  # TimeoutError is an OSError
        raise DeviceError(notice("workers.no_scheduler", address=address)) from error
    with client, client.get_executor(pure=False) as executor:
        yield _Dask(executor, distributed.Queue(client=client), distributed.Event(client=client))


@dataclass(frozen=True)
class _Dask:
    executor: Any
    board: Any
    stop: Any

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        future: Future[Any] = self.executor.submit(function, *arguments)
        return future


def some_workers(count: int, dask: str = "") -> AbstractContextManager[Workers]:
    """Processes of this machine, or the cluster at the address ``dask``."""
    return dask_workers(dask) if dask else local_workers(count)


def run_all(
    tasks: Sequence[WorkItem], workers: Workers, progress: Callable[[float], None]
) -> list[TaskOutcome]:
    """Outcomes in the order of ``tasks``; ``progress`` hears the share of all work that is done."""
    board, stop = workers.board, workers.stop
    futures = {workers.submit(_work, task, i, board, stop): i for i, task in enumerate(tasks)}
    shares = [0.0] * len(tasks)
    total = sum(t.weight for t in tasks) or 1.0
    pending = set(futures)
    try:
        while pending:
            done, pending = wait(pending, POLL_EVERY, FIRST_COMPLETED)
            for i, share in _notes(board):
                shares[i] = max(shares[i], share)
            for future in done:
                shares[futures[future]] = 1.0
            progress(sum(t.weight * s for t, s in zip(tasks, shares, strict=True)) / total)
    except BaseException:
        with suppress(OSError, EOFError):  # who keeps the flag may have been ended, too
            stop.set()  # running tasks end at their next report of progress
        raise
    finally:
        for future in pending:
            future.cancel()
    outcomes = [_outcome(future) for future in futures]
    for outcome in outcomes:
        pass_on(outcome.left_out)
    return outcomes


def _notes(board: Board) -> Iterator[tuple[int, float]]:
    """Everything on the board."""
    while board.qsize():  # Dask's scheduler would log each attempt at an empty one as an error
        yield board.get(timeout=READ_WITHIN)


def _outcome(future: Future[Any]) -> TaskOutcome:
    """Reports a worker that died or did not start like any other failure."""
    error = future.exception()
    if error is None:
        outcome: TaskOutcome = future.result()
        return outcome
    ended = failure("workers.ended", kind=type(error).__name__, why=str(error))
    return TaskOutcome(error=ended)


def _work(task: WorkItem, number: int, board: Board, stop: StopFlag) -> TaskOutcome:
    """Runs in the worker."""
    limit_this_process()
    reported = [-REPORT_EVERY]

    def report(share: float) -> None:
        now = time.monotonic()
        if now - reported[0] >= REPORT_EVERY:
            reported[0] = now
            board.put((number, share))
            if stop.is_set():
                raise GlovetrackError(notice("workers.stopped"))

    try:
        with gather() as left_out:
            value = task.function(*task.arguments, report)
        return TaskOutcome(value, left_out=tuple(merged(left_out)))
    except GlovetrackError as error:
        return TaskOutcome(error=error.notice)
