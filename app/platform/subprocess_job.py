"""Runs the work of a job in a subprocess, which leaves interpreter lock and processor to
tracking."""

from __future__ import annotations

import os
import signal
import traceback
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

from app.platform.tasks import Cancelled, JobProgress
from tracker.base.child import start_child
from tracker.base.damage import gather, merged, pass_on
from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice

Work = Callable[[Callable[..., None]], Any]
STEP = 0.01  # minimum progress between two reports, after which cancellation is checked
LOW_PRIORITY = 10  # that the window and the trackers come first


def run_in_subprocess(name: str, work: Work, progress: JobProgress) -> Any:
    """The result of ``work(progress)``; both are pickled.

    Raises Cancelled, GlovetrackError with the message of a failure in the work, RuntimeError after
    an unexpected end.
    """
    pipe, process = start_child(f"glovetrack {name}", _serve, work)
    try:
        return _follow(pipe, progress)
    finally:
        pipe.close()
        process.join()


def _follow(pipe: Connection, progress: JobProgress) -> Any:
    while True:
        try:
            kind, value = pipe.recv()
            if kind == "share":
                progress(value)
                pipe.send(True)
        except (EOFError, OSError) as error:
            raise GlovetrackError(notice("window.process_ended")) from error
        if kind == "left out":
            pass_on(value)
        if kind == "done":
            return value
        if kind == "refused":
            raise GlovetrackError(value)
        if kind == "failed":
            raise RuntimeError(value)


def _serve(pipe: Connection, work: Work) -> None:
    """In the subprocess."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # meant for the window, which then cancels
    if hasattr(os, "nice"):
        os.nice(LOW_PRIORITY)
    answer(pipe, work)


def answer(pipe: Connection, work: Work) -> None:
    """Run the work and send its result."""
    try:
        with gather() as left_out:
            result = ("done", work(_ProgressReporter(pipe)))
        pipe.send(("left out", merged(left_out)))
    except Cancelled:
        return
    except GlovetrackError as error:
        result = ("refused", error.notice)
    except Exception as error:  # noqa: BLE001  a crash must reach the window, whatever it is
        traceback.print_exc()
        result = ("failed", f"{type(error).__name__}: {error}")
    pipe.send(result)


class _ProgressReporter:
    """Reports progress and checks for cancellation at each step."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe, self._reported = pipe, -STEP

    def __call__(self, share: float, _text: str = "") -> None:
        if share - self._reported < STEP:
            return
        self._reported = share
        try:
            self._pipe.send(("share", share))
            self._pipe.recv()
        except (EOFError, OSError) as error:  # the window has closed the pipe
            raise Cancelled from error
