"""Attaches outputs to a running tracker: they subscribe to its estimates; a player is polled.

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

MAX_RATE_HZ = 100.0  # rate of the glove: there are no newer estimates
JITTER = 1e-3  # s of unevenness of packets' stamps


class HasEstimate(Protocol):
    """Something that can be polled, such as a player of a session."""

    def latest_estimate(self) -> Estimate | None: ...


@runtime_checkable
class PublishesEstimates(Protocol):
    """The interface of `tracker.live.runner.HandOfTracker`: no estimate is missed."""

    def subscribe(self, subscriber: Callable[[Estimate], None]) -> Callable[[], None]:
        """Calls ``subscriber``, which must not wait, with each estimate, in order of time; the
        returned function ends the subscription."""


class Attachment:
    """Feeds streams until it is closed."""

    def __init__(self, streams: Streams, stop: Callable[[], None]) -> None:
        """``stop`` ends the feeding; it may be called again."""
        self._streams, self._stop = streams, stop

    def counts(self) -> tuple[StreamCounts, ...]:
        """Numbers of sent, dropped and failed messages of each output."""
        return self._streams.counts()

    def close(self) -> None:
        """Stop feeding and close the outputs. May be called again."""
        self._stop()
        self._streams.close()


class _Poll:
    """Offers the latest estimate when it is new, at most once per ``period`` (s)."""

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
    """Passes on estimates whose times are at least one ``period`` (s) apart, on average."""

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
    """Sends the tracker's estimates to ``publishers``, at most ``rate_hz`` times per second.

    At `MAX_RATE_HZ` all estimates of a tracker that publishes them are sent. ``report``
    receives a notice when an output fails or recovers. Outputs wait while a tracker with a
    ``work_priority`` processes a message.
    """
    if not 0 < rate_hz <= MAX_RATE_HZ:
        raise ValueError(f"the rate is between 0 and {MAX_RATE_HZ:g} Hz, not {rate_hz:g}")
    priority = getattr(tracker, "work_priority", None)
    pause: Callable[[], None] = priority.wait if priority is not None else lambda: None
    streams = Streams(publishers, report, pause)
    if not isinstance(tracker, PublishesEstimates):
        return Attachment(streams, _Poll(tracker, streams.offer, 1.0 / rate_hz).stop)
    offer = streams.offer if rate_hz == MAX_RATE_HZ else _Thinned(streams.offer, 1.0 / rate_hz)
    return Attachment(streams, tracker.subscribe(offer))
