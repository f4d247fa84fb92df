"""Workers in the process of the test, where starting processes is not its subject."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any


class WorkersHere:
    """`tracker.base.workers.Workers` that do each task when it is submitted."""

    def __init__(self) -> None:
        self.board: queue.Queue[tuple[int, float]] = queue.Queue()
        self.stop = threading.Event()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        done: Future[Any] = Future()
        done.set_result(function(*arguments))
        return done
