"""Generates packets in advance, so that their generation does not delay them."""

from __future__ import annotations

import queue
import threading
from collections.abc import Iterator

from tracker.messages import ImuSample

PACKETS = 30  # packets in advance, 0.3 s: generating one second takes up to 0.1 s
POLL_INTERVAL = 0.2  # s between checks whether images are still requested


class DrawnAhead:
    """Iterates over ``source`` in a separate thread, `PACKETS` ahead of its consumer.

    A simulator generates one second of packets at once: a direct request for the first one would
    block for that long and delay the packet, unlike a real glove.
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
            self._ready.put(None)  # for further calls
            raise StopIteration
        return sample

    def close(self) -> None:
        """Stop generating. Idempotent."""
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
                self._ready.put(sample, timeout=POLL_INTERVAL)
            except queue.Full:
                continue
            return True
        return False
