"""Outputs on a running tracker: its latest estimate is looked at, the tracker knows nothing of it.

attached = attach(tracker, [UdpPublisher(Names.of(hand, glove))])
...
attached.close()
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Protocol

from tracker.messages import Estimate
from tracker.streaming.publisher import Publisher
from tracker.streaming.streams import StreamCounts, Streams

MAX_RATE_HZ = 100.0  # of the glove; nothing is newer


class HasEstimate(Protocol):
    """What `tracker.live.runner.LiveTracker` offers."""

    def latest_estimate(self) -> Estimate | None: ...


class Attachment:
    """Polls a tracker and feeds streams until it is closed."""

    def __init__(self, tracker: HasEstimate, streams: Streams, period: float) -> None:
        self._tracker, self._streams, self._period = tracker, streams, period
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-streams", daemon=True)
        self._thread.start()

    def counts(self) -> tuple[StreamCounts, ...]:
        """Per output what was sent, dropped and failed."""
        return self._streams.counts()

    def close(self) -> None:
        """Stop looking and close the outputs. May be called again."""
        self._ending.set()
        self._thread.join()
        self._streams.close()

    def _run(self) -> None:
        last: Estimate | None = None
        while not self._ending.wait(self._period):
            estimate = self._tracker.latest_estimate()
            if estimate is not None and estimate is not last:
                self._streams.offer(estimate)
                last = estimate


def attach(
    tracker: HasEstimate,
    publishers: Sequence[Publisher],
    rate_hz: float = MAX_RATE_HZ,
    say: Callable[[str], None] = lambda _: None,
) -> Attachment:
    """Send the tracker's estimates to ``publishers``, at most ``rate_hz`` times a second.

    ``say`` gets a sentence for the log when an output fails or recovers.
    """
    if not 0 < rate_hz <= MAX_RATE_HZ:
        raise ValueError(f"the rate is between 0 and {MAX_RATE_HZ:g} Hz, not {rate_hz:g}")
    return Attachment(tracker, Streams(publishers, say), 1.0 / rate_hz)
