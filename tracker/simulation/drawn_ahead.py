"""Packets that are made before they are due, so that none waits for the making of others."""

from __future__ import annotations

import queue
import threading
from collections.abc import Iterator

from tracker.messages import ImuSample

PACKETS = 30  # that are ready, 0.3 s of them: making a second of them takes up to 0.1 s
LOOK_EVERY = 0.2  # s between checks whether images are still requested


class DrawnAhead:
    """``source`` gone through in a thread of its own, `PACKETS` ahead of whoever takes them.

    A simulator makes a second of packets at once: whoever asked it for the first of them would
    wait that long, and the packet with him. A real glove knows no such wait.
    """

    def __init__(self, source: Iterator[ImuSample]) -> None:
        self._source = source
        self._ready: queue.Queue[ImuSample | None] = queue.Queue(PACKETS)
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._draw, name="glovetrack-packets", daemon=True)
        self._thread.start()

    def __iter__(self) -> Iterator[ImuSample]:
        return self

    def __next__(self) -> ImuSample:
        sample = self._ready.get()
        if sample is None:
            self._ready.put(None)  # for whoever asks again
            raise StopIteration
        return sample

    def close(self) -> None:
        """Make no more. May be called again."""
        self._closed.set()
        self._thread.join()

    def _draw(self) -> None:
        for sample in self._source:
            if not self._put(sample):
                return
        self._put(None)

    def _put(self, sample: ImuSample | None) -> bool:
        while not self._closed.is_set():
            try:
                self._ready.put(sample, timeout=LOOK_EVERY)
            except queue.Full:
                continue
            return True
        return False
