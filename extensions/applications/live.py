"""The thread of an application: it sees every estimate, in order, and is never in the way."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from typing import NamedTuple

from extensions.applications.runner import Outcome
from extensions.applications.stage import ApplicationStage
from tracker.base.channels import Closed, Fifo
from tracker.base.urgency import run_soon
from tracker.live.right_of_way import RightOfWay
from tracker.live.telemetry import Telemetry
from tracker.messages import Estimate

MOST_WAITING = 200  # estimates, 2 s: an application that is too slow loses some
WAIT = 0.05  # s that the thread waits before it looks again


class _Fed(NamedTuple):
    estimate: Estimate
    t_arrival: float


class ApplicationThread:
    """Feeds a stage; started with the first estimate that an application is there for."""

    def __init__(
        self,
        stage: ApplicationStage,
        telemetry: Telemetry,
        clock: Callable[[], float],
        way: RightOfWay,
    ) -> None:
        self._way = way
        self._stage, self._telemetry, self._clock = stage, telemetry, clock
        self._inbox: Fifo[_Fed] = Fifo(MOST_WAITING)
        self._next: _Fed | None = None
        self._thread: threading.Thread | None = None

    def put(self, estimate: Estimate, t_arrival: float) -> None:
        """An estimate, and when (s) its packet came."""
        if self._thread is None:
            if not self._stage.name:
                return
            self._thread = threading.Thread(
                target=self._run, name="glovetrack-application", daemon=True
            )
            self._thread.start()
        self._inbox.put(_Fed(estimate, t_arrival))

    def figures(self) -> dict[str, float]:
        """Estimates that an application was too slow for."""
        return {"application_missed": self._inbox.overflowed}

    def close(self) -> None:
        """End the thread and let the devices rest. May be called again."""
        self._inbox.close()
        self._inbox.drain()
        if self._thread is not None:
            self._thread.join()
        self._stage.close()

    def _run(self) -> None:
        run_soon()
        try:
            while True:
                fed, self._next = self._next or self._inbox.get(WAIT), None
                if fed is not None:
                    self._feed(fed)
        except Closed:
            return

    def _feed(self, fed: _Fed) -> None:
        """Foretold samples wait for their time, unless the next estimate is there before."""
        began = self._clock()
        outcomes = self._stage.feed(fed.estimate)
        while (outcome := self._next_of(outcomes)) is not None:
            now = self._clock()
            if outcome.t == fed.estimate.t:
                self._telemetry.took("application", now - fed.t_arrival)
            self._telemetry.tick("application", now)
            self._wait_until(began + outcome.t - fed.estimate.t + outcome.next_after)

    def _next_of(self, outcomes: Iterator[Outcome]) -> Outcome | None:
        with self._way:
            return next(outcomes, None)

    def _wait_until(self, due: float) -> None:
        """Or until the next estimate is there."""
        left = due - self._clock()
        if left > 0 and self._next is None:
            self._next = self._inbox.get(left)
