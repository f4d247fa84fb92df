"""Who waits for whom in Python: what a motor or a robot waits for goes before what is painted.

All threads of a process share Python's lock. One that paints gives it back after every step and has
it again at once, so that half a millisecond of another's work, in a dozen pieces, takes ten. A
painter that waits as a whole until that work is done costs it nothing.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

PATIENCE = 0.01  # s that one is waited for, who then waits himself: a painter must get on, too


class RightOfWay:
    """``with way:`` around hurried work, in any thread; `give` between the pieces of other work."""

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
        """Wait while anybody is at hurried work, ``patience`` s at most; where that was too little
        go on for as long."""
        if not self.is_taken or self._clock() < self._impatient_until:
            return
        if not self._clear.wait(self._patience):
            self._impatient_until = self._clock() + self._patience
