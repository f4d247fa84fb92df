"""The disk's own thread, so that tracking never waits for it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Protocol

from tracker.channels import Closed, Fifo
from tracker.errors import GlovetrackError
from tracker.messages import Message, StereoFrame

MAX_IMAGES_WAITING = 24  # 130 MB at 720p


class Recorder(Protocol):
    """Takes messages to disk; see `tracker.session.writer.SessionRecorder`."""

    def write(self, message: Message, overloaded: bool = False) -> None: ...

    def close(self) -> None: ...


class RecordingThread:
    """A recorder behind a bounded queue and its own thread: never in the way of tracking."""

    def __init__(self, recorder: Recorder, say: Callable[[str, str], None]) -> None:
        self._recorder, self._say = recorder, say
        self._queue: Fifo[tuple[Message, bool]] = Fifo(20_000)
        self._images = 0
        self._lock = threading.Lock()
        self.thinned = 0
        self._thread = threading.Thread(target=self._run, name="glovetrack-disk", daemon=True)
        self._thread.start()

    def put(self, message: Message) -> None:
        """Queue a message; an image that the disk has no time for goes without its pixels."""
        overloaded = False
        if isinstance(message, StereoFrame):
            with self._lock:
                overloaded = self._images >= MAX_IMAGES_WAITING
                self._images += not overloaded
            if overloaded:
                self.thinned += 1
                message = replace(message, left=None, right=None)
        self._queue.put((message, overloaded))

    def finish(self) -> None:
        """Write what waits, then close the file."""
        self._queue.close()
        if self._thread is not threading.current_thread():
            self._thread.join()

    def _run(self) -> None:
        try:
            while True:
                item = self._queue.get(None)
                if item is not None:
                    self._write(*item)
        except Closed:
            self._close()
        except (GlovetrackError, OSError) as error:
            self._queue.close()
            self._close()
            self._say("error", f"The recording has ended: {error}")

    def _write(self, message: Message, overloaded: bool) -> None:
        self._recorder.write(message, overloaded)
        if isinstance(message, StereoFrame) and not overloaded:
            with self._lock:
                self._images -= 1

    def _close(self) -> None:
        try:
            self._recorder.close()
        except (GlovetrackError, OSError) as error:
            self._say("error", f"The recording could not be finished: {error}")
