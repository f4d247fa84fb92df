"""A process that has loaded what tracking needs, so that tracking continues soon after a crash."""

from __future__ import annotations

import contextlib
import threading

from app.engines.apart.process import EngineProcess, Started, start_process
from app.engines.apart.source import Source


class Reserve:
    """At most one waiting process. Loading takes a second and about 100 MB; the process then waits
    without using a processor. Methods may be called from any thread."""

    def __init__(self) -> None:
        self._started: Started | None = None
        self._changing = threading.Lock()
        self._closed = False

    def fill(self, source: Source) -> None:
        """Have a process that has loaded what ``source`` needs."""
        with self._changing:
            if self._closed or (self._started is not None and self._started.process.is_alive()):
                return
            _discard(self._started)
            self._started = start_process(source, waits=True)

    def open(self, source: Source) -> EngineProcess:
        """Open ``source`` in the waiting process, or in a new one if there is none."""
        with self._changing:
            started, self._started = self._started, None
        if started is not None:
            with contextlib.suppress(OSError):  # it has ended
                started.pipe.send(source)
                return EngineProcess(source, started)
        _discard(started)
        return EngineProcess(source)

    def close(self) -> None:
        """End the waiting process."""
        with self._changing:
            self._closed = True
            started, self._started = self._started, None
        _discard(started)


def _discard(started: Started | None) -> None:
    """End a process, which has no device open."""
    if started is not None:
        started.process.kill()
        started.pipe.close()
        started.crash.unlink(missing_ok=True)
