"""A child process for one job, with a pipe to it."""

from __future__ import annotations

import multiprocessing as mp
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from tracker.base.numeric_threads import limit_this_process
from tracker.base.urgency import run_as_others


def start_child(
    name: str, serve: Callable[..., object], *args: Any, daemon: bool = True
) -> tuple[Connection, BaseProcess]:
    """Starts a process that runs ``serve(its end, *args)``; returns our end of the pipe and it.

    The process is spawned, since a fork would copy locks that threads hold. It is stopped at the
    end of this one, unless ``daemon`` is false: then it may have processes of its own, and ends by
    itself when its pipe is closed.
    Its end of the pipe is closed here, so that ours reports when the process has ended.
    """
    context = mp.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_run, args=(serve, theirs, *args), name=name, daemon=daemon)
    process.start()
    theirs.close()
    return ours, process


def _run(serve: Callable[..., object], *args: Any) -> None:
    run_as_others()
    limit_this_process()
    serve(*args)
