"""Bringing a file down to its disk in a thread beside the one that writes it.

A disk takes milliseconds for it, a card or a busy one tenths of a second, each time; meanwhile
the next chunks are written, and one time for all of them follows.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

from tracker.base.files import DiskError


class SyncBeside:
    """Calls ``sync``, which may raise DiskError, after `soon`; methods are for one thread."""

    def __init__(self, sync: Callable[[], None]) -> None:
        self._sync = sync
        self._asked, self._ending = threading.Event(), False
        self._error: DiskError | None = None
        self._thread = threading.Thread(target=self._run, name="glovetrack-sync", daemon=True)
        self._thread.start()

    def soon(self) -> None:
        """What is written by now goes down to the disk. Raises DiskError of an earlier time."""
        if self._error is not None:
            raise self._error
        self._asked.set()

    def _run(self) -> None:
        while True:
            self._asked.wait()
            self._asked.clear()
            if self._ending:
                return
            try:
                self._sync()
            except DiskError as error:
                self._error = error
                return

    def end(self) -> None:
        """Wait for the time that has begun; there is none after it."""
        self._ending = True
        self._asked.set()
        self._thread.join()
