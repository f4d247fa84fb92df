"""Runs applications as listeners of the hand: in their own thread, or in that of a replay."""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from extensions.applications.extension import LISTENER
from extensions.applications.remote import ApplicationProxy, StageNews
from extensions.applications.runner import Outcome
from extensions.applications.sharing import ArraySender, Packed
from extensions.applications.sinks import KIND as MOTOR
from extensions.applications.sinks import all_sinks
from extensions.applications.stage import ApplicationStage, ShownStage
from tracker.base.channels import Closed, Fifo
from tracker.base.urgency import run_soon
from tracker.live.listeners import ListenedHand, Listener, LiveAccess
from tracker.messages import Estimate, Event

MOST_WAITING = 200  # estimates, 2 s: an application that is slower loses some
WAIT = 0.05  # s between checks of the thread whether to stop


def listener(hand: ListenedHand) -> ReplayedApplication:
    """A stage for the applications of a hand, live or replayed."""
    if hand.live is None:
        return ReplayedApplication(ApplicationStage(hand.hand, hand.glove))
    stage = ApplicationStage(hand.hand, hand.glove, hand.live.record)
    telemetry = hand.live.telemetry

    def tell(event: Event) -> None:
        of = event.data.get("of")
        if event.kind == MOTOR and isinstance(of, float):
            telemetry.took("motor", event.t - of)
        stage.tell(event)

    stage.sinks += all_sinks(hand.live.vibrate, tell)
    return LiveApplication(stage, hand.live)


def stage_of(listeners: Mapping[str, Listener]) -> ShownStage | None:
    """The stage among the listeners of a hand; None where it has none."""
    found = listeners.get(LISTENER.name)
    return found.stage if isinstance(found, ReplayedApplication | ApplicationProxy) else None


class ReplayedApplication:
    """Feeds a stage on the thread that calls `feed`."""

    def __init__(self, stage: ApplicationStage) -> None:
        self.stage = stage

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """Run the application to the end of this estimate."""
        deque(self.stage.feed(estimate), maxlen=0)

    def restart(self) -> None:
        """Start the application over with the next estimate."""
        self.stage.restart()

    def close(self) -> None:
        """Stop the devices. May be called again."""
        self.stage.close()


class _Fed(NamedTuple):
    estimate: Estimate
    t_arrival: float


class LiveApplication(ReplayedApplication):
    """Feeds a stage on a thread of its own, so that no application delays tracking.

    The thread starts with the first estimate while an application is shown. If a process of its own
    tracks, this is in that process, and `ApplicationProxy` in the window's.
    """

    def __init__(self, stage: ApplicationStage, live: LiveAccess) -> None:
        super().__init__(stage)
        self._priority, self._telemetry, self._clock = live.priority, live.telemetry, live.clock
        self._inbox: Fifo[_Fed] = Fifo(MOST_WAITING)
        self._next: _Fed | None = None
        self._thread: threading.Thread | None = None
        live.telemetry.ask(self._figures)
        self._sender, self._sent, self._shown = ArraySender(), StageNews(), 0

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """Queue an estimate for the thread."""
        if self._thread is None:
            if not self.stage.name:
                return
            self._thread = threading.Thread(
                target=self._run, name="glovetrack-application", daemon=True
            )
            self._thread.start()
        self._inbox.put(_Fed(estimate, t_arrival))

    def close(self) -> None:
        """End the thread and stop the devices. May be called again."""
        self._inbox.close()
        self._inbox.drain()
        if self._thread is not None:
            self._thread.join()
        super().close()

    # --- requests of `ApplicationProxy`

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> StageNews:
        """As `ApplicationStage.show`; returns the new state."""
        self.stage.show(name, settings)
        self._shown += 1
        return self._state()

    def set(self, key: str, value: Any) -> None:
        """As `ApplicationStage.set`."""
        self.stage.set(key, value)

    def news(self) -> Packed | None:
        """A `StageNews` if the state has changed."""
        now = self._state()
        if now == self._sent:
            return None
        self._sent = now
        return self._sender.pack(now)

    def _state(self) -> StageNews:
        shown, stage = self._shown, self.stage  # in this order
        counts = Counter(dict(stage.counts))
        return StageNews(
            shown,
            stage.name,
            stage.title,
            stage.settings,
            stage.outcome,
            counts,
            stage.last,
            stage.latest,
            stage.problem,
        )

    def _figures(self) -> dict[str, float]:
        """Number of estimates lost because an application was too slow."""
        return {"application_missed": self._inbox.overflowed}

    def _run(self) -> None:
        run_soon()
        try:
            while True:
                fed, self._next = self._next or self._inbox.get(WAIT), None
                if fed is not None:
                    self._feed_stage(fed)
        except Closed:
            return

    def _feed_stage(self, fed: _Fed) -> None:
        """Process an estimate; predicted samples wait for their time or the next estimate."""
        began = self._clock()
        outcomes = self.stage.feed(fed.estimate)
        while (outcome := self._next_of(outcomes)) is not None:
            now = self._clock()
            if outcome.t == fed.estimate.t:
                self._telemetry.took("application", now - fed.t_arrival)
            self._telemetry.tick("application", now)
            self._wait_until(began + outcome.t - fed.estimate.t + outcome.next_after)

    def _next_of(self, outcomes: Iterator[Outcome]) -> Outcome | None:
        with self._priority:
            return next(outcomes, None)

    def _wait_until(self, due: float) -> None:
        """Wait until ``due`` or until the next estimate arrives."""
        left = due - self._clock()
        if left > 0 and self._next is None:
            self._next = self._inbox.get(left)
