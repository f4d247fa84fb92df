"""The thread that sends for all outputs of a process, and what happens to outputs that hang.

All threads of a process share Python's lock. Twelve threads that each wake up for an estimate, and
release the lock whenever they send, spend as much time on waiting for one another as on the work.
One thread sends for all outputs, one after another. A second one watches it: an output that takes
longer than `PATIENCE` keeps the thread in which it hangs, from then on for itself, and the watching
thread continues with the others.
"""

from __future__ import annotations

import logging
import threading
import time
from typing import Protocol

_log = logging.getLogger(__name__)
PATIENCE = 0.1  # s; a loaded computer may interrupt a thread for some 10 ms


class Sender(Protocol):
    """An output with a queue."""

    ended: threading.Event

    def step(self, timeout: float | None) -> bool:
        """Sends what arrives within ``timeout`` s (None: no limit); returns whether there was
        something to do."""


class Senders:
    """Threads for any number of outputs; they end when there are none."""

    def __init__(self, patience: float = PATIENCE) -> None:
        self._patience = patience
        self._lock = threading.Lock()
        self._arrived = threading.Condition(self._lock)
        self._ended = threading.Condition(self._lock)  # of the last output
        self._outputs: list[Sender] = []  # of the common thread
        self._leader: threading.Thread | None = None
        self._watched = False  # a thread watches the leader
        self._fresh = False  # something may have arrived since the leader looked
        self._at: tuple[Sender, float] | None = None  # what the leader does, and since when

    def add(self, output: Sender) -> None:
        with self._lock:
            self._outputs.append(output)
            if self._leader is None:
                self._start()

    def wake(self) -> None:
        """To be called after something was put into a queue or a queue was closed."""
        with self._lock:
            self._fresh = True
            self._arrived.notify_all()

    def _start(self) -> None:
        """A thread that leads."""
        self._leader = threading.Thread(target=self._lead, name="glovetrack-sender", daemon=True)
        self._leader.start()

    def _lead(self) -> None:
        me = threading.current_thread()
        while (outputs := self._next(me)) is not None:
            for output in outputs:
                if not self._run(me, output):
                    self._run_alone(output)
                    return

    def _next(self, me: threading.Thread) -> list[Sender] | None:
        """The outputs, once something has arrived; None if there are none any more."""
        with self._lock:
            self._outputs = [output for output in self._outputs if not output.ended.is_set()]
            if not self._outputs:
                self._leader = None
                self._ended.notify_all()  # no thread has to watch
                return None
            self._arrived.wait_for(lambda: self._fresh)
            self._fresh = False
            return list(self._outputs)

    def _run(self, me: threading.Thread, output: Sender) -> bool:
        """Sends all that waits in its queue; returns whether this thread still leads."""
        busy = True
        while busy and not output.ended.is_set():
            self._at = output, time.monotonic()
            if not self._watched:
                self._watch()
            busy = _step(output, 0.0)
            with self._lock:
                if self._leader is not me:
                    return False
                self._at = None
        return True

    @staticmethod
    def _run_alone(output: Sender) -> None:
        """The rest of the life of an output that hung."""
        while not output.ended.is_set():
            _step(output, None)

    def _watch(self) -> None:
        self._watched = True
        name = "glovetrack-sender-watch"
        threading.Thread(target=self._take_over, name=name, daemon=True).start()

    def _take_over(self) -> None:
        """Waits until the leader hangs, and then leads."""
        with self._lock:
            while self._leader is not None:
                at = self._at
                if at is not None and time.monotonic() - at[1] > self._patience:
                    break
                self._ended.wait(self._patience)
            self._watched = False
            if self._leader is None:
                return
            hung = self._at
            if hung is not None:
                self._outputs = [output for output in self._outputs if output is not hung[0]]
            self._leader, self._at, self._fresh = threading.current_thread(), None, True
        self._lead()


def _step(output: Sender, timeout: float | None) -> bool:
    try:
        return output.step(timeout)
    except Exception:  # noqa: BLE001 - one output must not end the others
        _log.exception("An output failed")
        return True


SENDERS = Senders()
"""Those of this process."""
