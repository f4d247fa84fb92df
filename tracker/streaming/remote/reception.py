"""Limits the rate of requests between a socket and the window, and counts them.

Memory is bounded whatever clients send: the oldest peers are removed
first, and the number of pending requests is limited.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass

from tracker.base.clock import monotonic
from tracker.base.notices import failure
from tracker.streaming.publisher import Title
from tracker.streaming.remote.request import Reply, Request, RequestError

PER_PEER_HZ, ALL_HZ = 100.0, 300.0  # five motors at 20 times per second are the useful maximum
ACTS_HZ = 10.0  # of requests other than vibration: each adds a line to the log
MOST_PEERS = 64
MOST_WAITING = 64
UNHURRIED = ("vibrate", "contact", "status")  # not counted as actions

Answer = Callable[[Request], "Future[Reply]"]
"""The handler: called in a socket's thread; any thread may set the future."""


class Allowance:
    """A token bucket that fills at ``rate_hz`` up to two seconds' worth."""

    def __init__(self, rate_hz: float, t: float) -> None:
        self._rate, self._most = rate_hz, 2.0 * rate_hz
        self._left, self._t = self._most, t

    def take(self, t: float) -> bool:
        """Whether one more is allowed at ``t`` s; if so, it is used up."""
        self._left = min(self._most, self._left + self._rate * max(0.0, t - self._t))
        self._t = max(self._t, t)
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


@dataclass(frozen=True)
class DoorCounts:
    """Counts of received messages; ``peers``: senders, the latest last, with s since then."""

    name: Title
    asked: int
    refused: int  # not parsed, or over the limit
    peers: tuple[tuple[str, float], ...]
    clients: int | None  # connected now; None where there are no connections


class Reception:
    """Reception of one socket; `take` is called only from its thread."""

    def __init__(
        self, answer: Answer, clock: Callable[[], float] = monotonic, acts_hz: float = ACTS_HZ
    ) -> None:
        self._answer, self._clock, self._acts_hz = answer, clock, acts_hz
        self._all, self._acts = Allowance(ALL_HZ, clock()), Allowance(acts_hz, clock())
        self._peers: OrderedDict[str, tuple[Allowance, float]] = OrderedDict()
        self._places = threading.BoundedSemaphore(MOST_WAITING)
        self.asked = self.refused = 0

    def admit(self, peer: str) -> float | None:
        """The arrival time of a message from ``peer``; None if it exceeds the limit."""
        t = self._clock()
        allowance, _ = self._peers.pop(peer, (None, 0.0))
        allowance = allowance or Allowance(PER_PEER_HZ, t)
        self._peers[peer] = (allowance, t)
        while len(self._peers) > MOST_PEERS:
            self._peers.popitem(last=False)
        if allowance.take(t) and self._all.take(t):
            return t
        self.refused += 1
        return None

    def take(self, read: Callable[[], Request | None]) -> Future[Reply] | None:
        """Passes the request from ``read`` to the handler; None if there is nothing to answer."""
        try:
            request = read()
        except RequestError as error:
            return self._refuse(Reply.refused("", error.notice))
        if request is None:
            return None
        if request.do not in UNHURRIED and not self._acts.take(request.t):
            limit = failure("request.too_many", rate_hz=self._acts_hz)
            return self._refuse(Reply.refused(request.do, limit, request.id))
        if not self._places.acquire(blocking=False):
            return self._refuse(Reply.refused(request.do, failure("request.busy"), request.id))
        self.asked += 1
        future = self._answer(request)
        future.add_done_callback(lambda _done: self._places.release())
        return future

    def _refuse(self, reply: Reply) -> Future[Reply]:
        self.refused += 1
        out: Future[Reply] = Future()
        out.set_result(reply)
        return out

    def counts(self, name: Title, clients: int | None) -> DoorCounts:
        """From any thread."""
        now = self._clock()
        peers = tuple((peer, now - t) for peer, (_, t) in list(self._peers.items()))
        return DoorCounts(name, self.asked, self.refused, peers, clients)
