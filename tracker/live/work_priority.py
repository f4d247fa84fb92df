"""Priority between threads: work for a motor or a robot runs before painting.

All threads of a process share Python's lock. A thread that paints releases it after every step and
reacquires it immediately, so that half a millisecond of another thread's work, in a dozen pieces,
takes ten. If the painting thread waits until that work is done, it does not delay it.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

LONGEST_WAIT = 0.01  # s of one wait; then the waiting thread runs for as long, to progress, too


class WorkPriority:
    """``with priority:`` around urgent work, in any thread; `wait` between pieces of other work."""

    def __init__(
        self, longest_wait: float = LONGEST_WAIT, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._longest_wait, self._clock = longest_wait, clock
        self._changing = threading.Lock()
        self._urgent_count = 0
        self._idle = threading.Event()
        self._idle.set()
        self._next_wait_at = 0.0

    def __enter__(self) -> None:
        with self._changing:
            self._urgent_count += 1
            self._idle.clear()

    def __exit__(self, *_: object) -> None:
        with self._changing:
            self._urgent_count -= 1
            if not self._urgent_count:
                self._idle.set()

    @property
    def has_urgent_work(self) -> bool:
        """Whether urgent work is being done in any thread."""
        return not self._idle.is_set()

    def wait(self) -> None:
        """Wait while urgent work is being done, at most ``longest_wait`` s; then do not wait again
        for as long."""
        if not self.has_urgent_work or self._clock() < self._next_wait_at:
            return
        if not self._idle.wait(self._longest_wait):
            self._next_wait_at = self._clock() + self._longest_wait
