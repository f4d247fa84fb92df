"""Runs applications as listeners of the hand: in their own thread, or in that of a replay."""

from __future__ import annotations

import io
import pickle
import threading
from collections import Counter, deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from extensions.applications.extension import LISTENER
from extensions.applications.runner import Outcome
from extensions.applications.sinks import KIND as MOTOR
from extensions.applications.sinks import all_sinks
from extensions.applications.stage import ApplicationStage, ShownStage, Viewer
from tracker.base.channels import Closed, Fifo
from tracker.base.urgency import run_soon
from tracker.live.listeners import ListenedHand, Listener, ListenerLine, LiveAccess
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
        self._sender, self._sent, self._shown = ArraySender(), StageUpdate(), 0

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

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> StageUpdate:
        """As `ApplicationStage.show`; returns the new state."""
        self.stage.show(name, settings)
        self._shown += 1
        return self._state()

    def set(self, key: str, value: Any) -> None:
        """As `ApplicationStage.set`."""
        self.stage.set(key, value)

    def news(self) -> Packed | None:
        """A `StageUpdate` if the state has changed."""
        now = self._state()
        if now == self._sent:
            return None
        self._sent = now
        return self._sender.pack(now)

    def _state(self) -> StageUpdate:
        shown, stage = self._shown, self.stage  # in this order
        counts = Counter(dict(stage.counts))
        return StageUpdate(
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


# ---- applications of a hand that another process tracks: they run there, next to the glove's
# motors
#
# The window has an `ApplicationProxy` with a `RemoteStage`, which shows what the last `StageUpdate`
# contained and passes the user's choices on.


@dataclass(frozen=True)
class StageUpdate:
    """The state of a stage: see `ApplicationStage`. ``shown`` counts the applications that were
    started or stopped before."""

    shown: int = 0
    name: str = ""
    title: str = ""
    settings: Any = None
    outcome: Outcome | None = None
    counts: Counter[str] = field(default_factory=Counter)
    last: Event | None = None
    latest: Mapping[str, Event] = field(default_factory=dict)
    problem: str = ""


class RemoteStage:
    """`ShownStage` of an application in another process. Written by one thread, read by any."""

    def __init__(self, line: ListenerLine) -> None:
        self._line = line
        self._news = StageUpdate()  # replaced, never changed
        self._replacing = threading.Lock()
        self.viewers: list[Viewer] = []

    @property
    def name(self) -> str:
        return self._news.name

    @property
    def title(self) -> str:
        return self._news.title

    @property
    def settings(self) -> Any:
        return self._news.settings

    @property
    def outcome(self) -> Outcome | None:
        return self._news.outcome

    @property
    def counts(self) -> Counter[str]:
        return self._news.counts

    @property
    def last(self) -> Event | None:
        return self._news.last

    @property
    def latest(self) -> Mapping[str, Event]:
        return self._news.latest

    @property
    def problem(self) -> str:
        return self._news.problem

    @property
    def delays_window(self) -> bool:
        """It runs in another process."""
        return False

    def show(self, name: str, settings: Mapping[str, Any] | None = None) -> None:
        """As `ApplicationStage.show`. Raises GlovetrackError."""
        shown: StageUpdate = self._line.ask("show", name, settings)
        self._replace(shown)

    def set(self, key: str, value: Any) -> None:
        """As `ApplicationStage.set`. Raises GlovetrackError."""
        self._line.ask("set", key, value)

    def restart(self) -> None:
        self._line.tell("restart")

    def take(self, news: StageUpdate) -> None:
        """News that were sent before the last `show` are discarded."""
        if self._replace(news) and news.outcome is not None:
            for viewer in list(self.viewers):
                viewer.show(news.title, news.outcome.hand, news.outcome.drawing)

    def _replace(self, news: StageUpdate) -> bool:
        with self._replacing:
            if news.shown < self._news.shown:
                return False
            self._news = news
            return True

    def close(self) -> None:
        """Close the viewers."""
        viewers, self.viewers = self.viewers, []
        for viewer in viewers:
            viewer.close()


class ApplicationProxy:
    """The window's representative of `LiveApplication`, which receives the estimates itself."""

    def __init__(self, line: ListenerLine) -> None:
        self.stage = RemoteStage(line)
        self._receiver = ArrayReceiver()

    def take(self, news: Packed) -> None:
        """What `LiveApplication.news` has returned."""
        self.stage.take(self._receiver.unpack(news))

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """The listener has received the estimate in its process."""

    def restart(self) -> None:
        """The listener restarts with the recording in its process."""

    def close(self) -> None:
        self.stage.close()


# ---- sends drawings between processes: large arrays, such as a mesh's points, once

LARGE = 2000  # bytes; smaller arrays are sent each time
MOST = 64  # arrays that are remembered; then all are sent again


class Packed(NamedTuple):
    """A pickled object without its large arrays; ``new`` are those that were not sent before, by
    number. ``forget``: those sent before are no longer referred to."""

    data: bytes
    new: Mapping[int, np.ndarray]
    forget: bool


class ArraySender:
    """Packs objects in the order in which they are sent. Their large arrays must not be modified
    in place."""

    def __init__(self) -> None:
        self._sent: dict[int, tuple[int, np.ndarray]] = {}  # by id; kept, so that ids are unique
        self._number = 0

    def pack(self, what: object) -> Packed:
        forget = len(self._sent) > MOST
        if forget:
            self._sent.clear()
        out, new = io.BytesIO(), dict[int, np.ndarray]()
        _Pickler(out, self._numbered, new).dump(what)
        return Packed(out.getvalue(), new, forget)

    def _numbered(self, array: np.ndarray, new: dict[int, np.ndarray]) -> int:
        found = self._sent.get(id(array))
        if found is None:
            self._number += 1
            found = self._sent[id(array)] = self._number, array
            new[self._number] = array
        return found[0]


class ArrayReceiver:
    """Unpacks what a `ArraySender` has packed: everything, in order."""

    def __init__(self) -> None:
        self._known: dict[int, np.ndarray] = {}

    def unpack(self, packed: Packed) -> Any:
        if packed.forget:
            self._known.clear()
        self._known.update(packed.new)
        return _Unpickler(io.BytesIO(packed.data), self._known).load()


class _Pickler(pickle.Pickler):
    def __init__(self, out: io.BytesIO, numbered: Any, new: dict[int, np.ndarray]) -> None:
        super().__init__(out, pickle.HIGHEST_PROTOCOL)
        self._numbered, self._new = numbered, new

    def persistent_id(self, what: object) -> int | None:
        if type(what) is np.ndarray and what.nbytes >= LARGE:
            return int(self._numbered(what, self._new))
        return None


class _Unpickler(pickle.Unpickler):
    def __init__(self, data: io.BytesIO, known: Mapping[int, np.ndarray]) -> None:
        super().__init__(data)
        self._known = known

    def persistent_load(self, number: int) -> np.ndarray:
        return self._known[number]
