"""Jobs of the window in threads of the test's process: a process takes a second or two to start."""

from __future__ import annotations

import multiprocessing
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler
from typing import Any

from app.platform import subprocess_job

RUNNING: set[threading.Thread] = set()
"""Those that have not ended."""


def start_here(name: str, _: Callable[..., object], work: Any) -> tuple[Connection, Any]:
    """In place of `tracker.base.child.start_child`; the work is pickled as for a process."""
    ours, theirs = multiprocessing.Pipe()
    copied = ForkingPickler.loads(ForkingPickler.dumps(work))
    thread = threading.Thread(target=_answer, args=(theirs, copied), name=f"{name} here")
    RUNNING.add(thread)
    thread.start()
    return ours, thread


def _answer(pipe: Connection, work: Any) -> None:
    try:
        with pipe:
            subprocess_job.answer(pipe, work)
    except OSError:  # the window has closed the pipe, as a process that ends would notice
        return
    finally:
        RUNNING.discard(threading.current_thread())
