"""A process of its own for one job, with a pipe to it."""

from __future__ import annotations

import multiprocessing as mp
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from tracker.base.numeric_threads import limit_this_process


def start_child(
    name: str, serve: Callable[..., object], *args: Any
) -> tuple[Connection, BaseProcess]:
    """Our end of the pipe and the process, which runs ``serve(its end, *args)``.

    It is spawned, since a fork would copy locks that threads hold, and ends with this one.
    Its end of the pipe is closed here, so that ours tells when it has gone.
    """
    context = mp.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_run, args=(serve, theirs, *args), name=name, daemon=True)
    process.start()
    theirs.close()
    return ours, process


def _run(serve: Callable[..., object], *args: Any) -> None:
    limit_this_process()
    serve(*args)
