"""Outputs on a running tracker: they subscribe to its estimates, and a player is polled.

attached = attach(tracker, [UdpPublisher(Names.of(hand, glove))])
...
attached.close()
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Protocol, runtime_checkable

from tracker.base.notices import Notice
from tracker.messages import Estimate
from tracker.streaming.publisher import Publisher
from tracker.streaming.streams import StreamCounts, Streams

MAX_RATE_HZ = 100.0  # of the glove; nothing is newer
JITTER = 1e-3  # s that the stamps of packets are uneven


class HasEstimate(Protocol):
    """What can be polled: a player of a session, for one."""

    def latest_estimate(self) -> Estimate | None: ...


@runtime_checkable
class PublishesEstimates(Protocol):
    """What `tracker.live.runner.HandOfTracker` offers: no estimate is missed."""

    def subscribe(self, subscriber: Callable[[Estimate], None]) -> Callable[[], None]:
        """Call ``subscriber``, which must not wait, with each estimate, in order of time; what is
        returned ends that."""


class Attachment:
    """Feeds streams until it is closed."""

    def __init__(self, streams: Streams, stop: Callable[[], None]) -> None:
        """``stop`` ends the feeding; it may be called again."""
        self._streams, self._stop = streams, stop

    def counts(self) -> tuple[StreamCounts, ...]:
        """Per output what was sent, dropped and failed."""
        return self._streams.counts()

    def close(self) -> None:
        """Stop feeding and close the outputs. May be called again."""
        self._stop()
        self._streams.close()


class _Poll:
    """Offers the latest estimate whenever there is another one, at most once a ``period`` (s)."""

    def __init__(
        self, tracker: HasEstimate, offer: Callable[[Estimate], None], period: float
    ) -> None:
        self._tracker, self._offer, self._period = tracker, offer, period
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-streams", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End the thread. May be called again."""
        self._ending.set()
        self._thread.join()

    def _run(self) -> None:
        last: Estimate | None = None
        while not self._ending.wait(self._period):
            estimate = self._tracker.latest_estimate()
            if estimate is not None and estimate is not last:
                self._offer(estimate)
                last = estimate


class _Thinned:
    """Passes on estimates of instants at least a ``period`` (s) apart, on average."""

    def __init__(self, offer: Callable[[Estimate], None], period: float) -> None:
        self._offer, self._period = offer, period
        self._due = float("-inf")

    def __call__(self, estimate: Estimate) -> None:
        if estimate.t >= self._due - JITTER:
            is_late = estimate.t > self._due + self._period  # or the first
            self._due = (estimate.t if is_late else self._due) + self._period
            self._offer(estimate)


def attach(
    tracker: HasEstimate | PublishesEstimates,
    publishers: Sequence[Publisher],
    rate_hz: float = MAX_RATE_HZ,
    report: Callable[[Notice], None] = lambda _: None,
) -> Attachment:
    """Send the tracker's estimates to ``publishers``, at most ``rate_hz`` times a second.

    At `MAX_RATE_HZ` a tracker that publishes its estimates has all of them sent. ``report``
    receives a notice when an output fails or recovers. Outputs wait while a tracker with a
    ``right_of_way`` processes a message.
    """
    if not 0 < rate_hz <= MAX_RATE_HZ:
        raise ValueError(f"the rate is between 0 and {MAX_RATE_HZ:g} Hz, not {rate_hz:g}")
    priority = getattr(tracker, "right_of_way", None)
    give: Callable[[], None] = priority.give if priority is not None else lambda: None
    streams = Streams(publishers, report, give)
    if not isinstance(tracker, PublishesEstimates):
        return Attachment(streams, _Poll(tracker, streams.offer, 1.0 / rate_hz).stop)
    offer = streams.offer if rate_hz == MAX_RATE_HZ else _Thinned(streams.offer, 1.0 / rate_hz)
    return Attachment(streams, tracker.subscribe(offer))
