"""The disk's own thread, so that tracking never waits for it."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Protocol

from tracker.base.channels import Closed, Fifo
from tracker.base.errors import GlovetrackError, notice_of
from tracker.base.notices import Notice, failure, notice
from tracker.messages import Message, StereoFrame

_log = logging.getLogger(__name__)

MAX_IMAGES_WAITING = 24  # 130 MB at 720p
MAX_WAITING = 20_000  # messages: a minute
BATCH = 0.04  # s that messages wait to go together: each wake-up of a thread disturbs the others
POLL_EVERY = 0.25  # s between checks of the recorder while there is nothing to write


class Recorder(Protocol):
    """Writes messages to disk; see `tracker.session.writer.SessionRecorder`.

    ``write`` returns False if it left out an image; ``side`` is the hand of the message. ``flush``
    is called after every few messages.
    """

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool: ...

    def flush(self) -> None: ...

    def close(self) -> None: ...


class RecordingThread:
    """A recorder behind a bounded queue, in its own thread: it never delays tracking."""

    def __init__(self, recorder: Recorder, report: Callable[[str, Notice], None]) -> None:
        self._recorder, self._report = recorder, report
        self._queue: Fifo[tuple[Message, bool, str]] = Fifo(MAX_WAITING)
        self._images = 0
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self.thinned = 0
        self._thread = threading.Thread(target=self._run, name="glovetrack-disk", daemon=True)
        self._thread.start()

    def put(self, message: Message, side: str = "") -> None:
        """Queues a message; without its pixels if it is an image and the disk is too slow."""
        overloaded = False
        if isinstance(message, StereoFrame):
            with self._lock:
                overloaded = self._images >= MAX_IMAGES_WAITING
                self._images += not overloaded
                self.thinned += overloaded
            if overloaded:
                message = replace(message, left=None, right=None)
        self._queue.put((message, overloaded, side))

    @property
    def overflowed(self) -> int:
        """Messages lost because the recorder was a minute behind."""
        return self._queue.overflowed

    def finish(self, timeout: float | None = None) -> bool:
        """Writes what is queued, then closes the file. Returns whether that took at most
        ``timeout`` s; None: no limit. May be called again.
        """
        self._queue.close()
        self._ending.set()
        if self._thread is not threading.current_thread():
            self._thread.join(timeout)
        return not self._thread.is_alive()

    def _run(self) -> None:
        try:
            while True:
                self._write_waiting()
                self._ending.wait(BATCH)
        except Closed:
            if self._closed():
                self._report("recording", notice("recording.finished"))
        except Exception as error:  # noqa: BLE001 - whatever it is, the file is closed and the user informed
            if not isinstance(error, GlovetrackError | OSError):
                _log.exception("The recorder failed")
            self._queue.close()
            self._closed()
            self._report("error", failure("recording.ended", why=notice_of(error)))

    def _write_waiting(self) -> None:
        """Writes all queued messages. Raises Closed at the end."""
        first = self._queue.get(POLL_EVERY)
        for item in (first, *self._queue.drain()) if first is not None else ():
            self._write(*item)
        self._recorder.flush()

    def _write(self, message: Message, overloaded: bool, side: str) -> None:
        taken = self._recorder.write(message, overloaded, side)
        if isinstance(message, StereoFrame) and not overloaded:
            with self._lock:
                self._images -= 1
                self.thinned += not taken

    def _closed(self) -> bool:
        try:
            self._recorder.close()
        except Exception as error:  # noqa: BLE001 - as above
            if not isinstance(error, GlovetrackError | OSError):
                _log.exception("The recorder failed at its end")
            self._report("error", failure("recording.not_finished", why=notice_of(error)))
            return False
        return True
