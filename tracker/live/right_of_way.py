"""Priority of threads in Python: work for a motor or a robot goes before painting.

All threads of a process share Python's lock. A thread that paints releases it after every step and
reacquires it immediately, so that half a millisecond of another thread's work, in a dozen pieces,
takes ten. If the painter waits until that work is done, it does not delay it.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

PATIENCE = 0.01  # s that one is waited for, who then waits himself: a painter must get on, too


class RightOfWay:
    """``with priority:`` around urgent work, in any thread; `give` between pieces of other work."""

    def __init__(
        self, patience: float = PATIENCE, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._patience, self._clock = patience, clock
        self._changing = threading.Lock()
        self._at_work = 0
        self._clear = threading.Event()
        self._clear.set()
        self._impatient_until = 0.0

    def __enter__(self) -> None:
        with self._changing:
            self._at_work += 1
            self._clear.clear()

    def __exit__(self, *_: object) -> None:
        with self._changing:
            self._at_work -= 1
            if not self._at_work:
                self._clear.set()

    @property
    def is_taken(self) -> bool:
        """Whether anybody is at hurried work."""
        return not self._clear.is_set()

    def give(self) -> None:
        """Waits while urgent work is being done, at most ``patience`` s; then runs for as long."""
        if not self.is_taken or self._clock() < self._impatient_until:
            return
        if not self._clear.wait(self._patience):
            self._impatient_until = self._clock() + self._patience
