"""Runs outputs with bounded queues, so that none waits for another.

One thread composes and sends the messages of all outputs; one that hangs gets a thread of its own,
see `Senders`. An output that cannot keep up discards the oldest estimates, which are counted. The
engine's threads only put estimates into the queues, and have priority.
"""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field
from typing import Protocol

from tracker.base.channels import Backlog, Closed
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, failure, notice, warning
from tracker.messages import Estimate
from tracker.streaming.publisher import Publisher, Title

_log = logging.getLogger(__name__)

BACKLOG = 50  # estimates: half a second; older ones are of no use to a live client
RATE_WINDOW = 3.0  # s over which rates are counted
LATE_STORED = 100  # estimates; a second
END_WAIT = 1.0  # s that `close` allows an output to finish sending


@dataclass(frozen=True)
class StreamCounts:
    """Counts of the estimates offered to one output, of one hand or of all hands."""

    name: Title
    sent: int
    dropped: int  # discarded because the output could not keep up
    failed: int
    error: Title  # of the last failure; empty if the last message was sent
    clients: int | None = None  # connected; None if the protocol does not report it
    rates_hz: tuple[float, ...] = ()  # messages per second in the last `RATE_WINDOW`, for each hand
    late: tuple[float, ...] = ()
    """s from the instants of the last `LATE_STORED` estimates' samples until they were sent; of no
    use in a replay."""
    missed: Mapping[str, int] = field(default_factory=dict)
    """Messages that slow clients missed, by address; "" for clients that have left."""

    @property
    def left_out(self) -> int:
        """Messages that readers missed, summed over readers."""
        return self.dropped + self.failed + sum(self.missed.values())


def delivery(publisher: Publisher, sent: int) -> Notice:
    """Whether a program receives what ``publisher`` sends; may take a second."""
    probe: Callable[[], Notice | None] = getattr(publisher, "probe", lambda: None)
    clients: int | None = getattr(publisher, "clients", None)
    found = probe()
    if found is not None:
        return found
    if clients is None:
        return warning("stream.test_sent", stream=publisher.name, count=sent)
    if clients == 0:
        return failure("stream.test_no_client", stream=publisher.name)
    return notice("stream.test_clients", stream=publisher.name, count=clients)


def of_all_hands(counts: Sequence[StreamCounts]) -> StreamCounts:
    """The counts of one output for several hands with the same clients."""
    first = counts[0]
    return StreamCounts(
        first.name,
        sum(c.sent for c in counts),
        sum(c.dropped for c in counts),
        sum(c.failed for c in counts),
        next((c.error for c in counts if c.error), ""),
        first.clients,
        tuple(rate for c in counts for rate in c.rates_hz),
        tuple(late for c in counts for late in c.late),
        first.missed,
    )


class Streams:
    """Numbers estimates and passes them to all outputs.

    ``report`` receives a notice when an output begins to fail and when it works again. `close`
    closes the publishers.
    """

    def __init__(
        self,
        publishers: Sequence[Publisher],
        report: Callable[[Notice], None] = lambda _: None,
        pause: Callable[[], None] = lambda: None,
    ) -> None:
        """``pause`` waits while the engine processes a message (`tracker.live.work_priority`)."""
        self._outputs = [_Output(p, report, pause) for p in publishers]
        for output in self._outputs:
            SENDERS.add(output)
        self._offered = 0

    def offer(self, estimate: Estimate, number: int | None = None) -> None:
        """Queues an estimate for every output; never waits. From one thread at a time.

        ``number``: its number, if estimates before it may be missing.
        """
        self._offered = self._offered if number is None else number
        for output in self._outputs:
            output.queue.put((self._offered, estimate))
        SENDERS.wake()
        self._offered += 1

    def counts(self) -> tuple[StreamCounts, ...]:
        return tuple(output.counts() for output in self._outputs)

    def close(self, wait: float = END_WAIT) -> None:
        """Ends all outputs; one that hangs is abandoned after ``wait`` s. May be called
        repeatedly."""
        for output in self._outputs:
            output.queue.close()
        SENDERS.wake()
        for output in self._outputs:
            output.ended.wait(wait)


def _numbered(number: int, estimate: Estimate) -> Estimate:
    """A copy with this number, and without the checks of a new estimate."""
    out = copy(estimate)
    object.__setattr__(out, "seq", number)
    return out


def _reason(error: Exception) -> Title:
    return error.notice if isinstance(error, GlovetrackError) else str(error) or repr(error)


class _Output:
    """One publisher and its queue."""

    def __init__(
        self,
        publisher: Publisher,
        report: Callable[[Notice], None],
        pause: Callable[[], None],
    ) -> None:
        self._publisher, self._report, self._pause = publisher, report, pause
        self.queue: Backlog[tuple[int, Estimate]] = Backlog(BACKLOG)
        self._times: deque[float] = deque()  # of what was sent in the last `RATE_WINDOW`
        self._began = time.monotonic()
        self._late: deque[float] = deque(maxlen=LATE_STORED)
        self._timing = threading.Lock()
        self._sent = self._failed = 0
        self._error: Title = ""
        self.ended = threading.Event()

    def counts(self) -> StreamCounts:
        return StreamCounts(
            self._publisher.name,
            self._sent,
            self.queue.dropped,
            self._failed,
            self._error,
            getattr(self._publisher, "clients", None),
            (self._rate(time.monotonic()),),
            tuple(self._late),
            getattr(self._publisher, "missed", dict)(),
        )

    def _rate(self, now: float, sent: int = 0) -> float:
        """Rate (1/s) after ``sent`` more messages."""
        with self._timing:
            self._times.extend([now] * sent)
            while self._times and self._times[0] < now - RATE_WINDOW:
                self._times.popleft()
            return len(self._times) / min(max(now - self._began, 0.5), RATE_WINDOW)

    def step(self, timeout: float | None) -> bool:
        """Sends the oldest estimate if one arrives within ``timeout`` s; returns whether one did or
        the output has ended."""
        try:
            numbered = self.queue.get(timeout)
        except Closed:
            try:
                self._publisher.close()
            finally:
                self.ended.set()
            return True
        if numbered is None:
            return False
        self._pause()
        self._send(_numbered(*numbered))
        return True

    def _send(self, estimate: Estimate) -> None:
        try:
            self._publisher.send(estimate)
        except Exception as error:  # noqa: BLE001 - one output's error must not end the others
            self._failed += 1
            if not self._error:  # once, until it works again
                _log.warning("The stream %s failed", self._publisher.name, exc_info=True)
            self._report_error(_reason(error))
        else:
            now = time.monotonic()
            self._sent += 1
            self._rate(now, sent=1)
            self._late.append(now - estimate.t)
            self._report_error("")

    def _report_error(self, error: Title) -> None:
        """Reports the start and the end of a failure, once each."""
        before, self._error = self._error, error
        if error and not before:
            self._report(warning("stream.failing", stream=self._publisher.name, why=error))
        elif before and not error:
            self._report(notice("stream.works_again", stream=self._publisher.name))


# ---- the thread that sends for all outputs of a process, and what happens to outputs that hang
#
# All threads of a process share Python's lock. Twelve threads that each wake up for an estimate,
# and release the lock whenever they send, spend as much time on waiting for one another as on the
# work. One thread sends for all outputs, one after another. A second one watches it: an output
# that takes longer than `QUEUE_TIMEOUT` keeps the thread in which it hangs from then on, and the
# watching thread continues with the others.

QUEUE_TIMEOUT = 0.1  # s; a loaded computer may interrupt a thread for some 10 ms


class Sender(Protocol):
    """An output with a queue."""

    ended: threading.Event

    def step(self, timeout: float | None) -> bool:
        """Sends what arrives within ``timeout`` s (None: no limit); returns whether there was
        something to do."""


class Senders:
    """Threads for any number of outputs; they end when there are none."""

    def __init__(self, queue_timeout: float = QUEUE_TIMEOUT) -> None:
        self._queue_timeout = queue_timeout
        self._lock = threading.Lock()
        self._arrived = threading.Condition(self._lock)
        self._ended = threading.Condition(self._lock)  # of the last output
        self._outputs: list[Sender] = []  # of the common thread
        self._leader: threading.Thread | None = None
        self._watched = False  # a thread watches the leader
        self._fresh = False  # something may have arrived since the leader looked
        self._at: tuple[Sender, float] | None = None  # what the leader does, and since when

    def add(self, output: Sender) -> None:
        with self._lock:
            self._outputs.append(output)
            if self._leader is None:
                self._start()

    def wake(self) -> None:
        """To be called after something was put into a queue or a queue was closed."""
        with self._lock:
            self._fresh = True
            self._arrived.notify_all()

    def _start(self) -> None:
        """A thread that leads."""
        self._leader = threading.Thread(target=self._lead, name="glovetrack-sender", daemon=True)
        self._leader.start()

    def _lead(self) -> None:
        me = threading.current_thread()
        while (outputs := self._next(me)) is not None:
            for output in outputs:
                if not self._run(me, output):
                    self._run_alone(output)
                    return

    def _next(self, me: threading.Thread) -> list[Sender] | None:
        """The outputs, once something has arrived; None if there are none any more."""
        with self._lock:
            self._outputs = [output for output in self._outputs if not output.ended.is_set()]
            if not self._outputs:
                self._leader = None
                self._ended.notify_all()  # no thread has to watch
                return None
            self._arrived.wait_for(lambda: self._fresh)
            self._fresh = False
            return list(self._outputs)

    def _run(self, me: threading.Thread, output: Sender) -> bool:
        """Sends all that waits in its queue; returns whether this thread still leads."""
        busy = True
        while busy and not output.ended.is_set():
            self._at = output, time.monotonic()
            if not self._watched:
                self._watch()
            busy = _step(output, 0.0)
            with self._lock:
                if self._leader is not me:
                    return False
                self._at = None
        return True

    @staticmethod
    def _run_alone(output: Sender) -> None:
        """The rest of the life of an output that hung."""
        while not output.ended.is_set():
            _step(output, None)

    def _watch(self) -> None:
        self._watched = True
        name = "glovetrack-sender-watch"
        threading.Thread(target=self._take_over, name=name, daemon=True).start()

    def _take_over(self) -> None:
        """Waits until the leader hangs, and then leads."""
        with self._lock:
            while self._leader is not None:
                at = self._at
                if at is not None and time.monotonic() - at[1] > self._queue_timeout:
                    break
                self._ended.wait(self._queue_timeout)
            self._watched = False
            if self._leader is None:
                return
            hung = self._at
            if hung is not None:
                self._outputs = [output for output in self._outputs if output is not hung[0]]
            self._leader, self._at, self._fresh = threading.current_thread(), None, True
        self._lead()


def _step(output: Sender, timeout: float | None) -> bool:
    try:
        return output.step(timeout)
    except Exception:  # noqa: BLE001 - one output must not end the others
        _log.exception("An output failed")
        return True


SENDERS = Senders()
"""Those of this process."""
