"""Runs outputs in a separate process, so that encoding never delays tracking.

All threads of a process share Python's lock. Ten outputs that each encode 100 estimates per second
would hold it for most of the time. `StreamsProcess` sends each estimate once, to a process that
encodes and sends what the streams need; `tracker.streaming.apart_child` runs there. On Linux, where
one can know that a pipe has room, the thread that makes an estimate writes it there: waking another
one took three times as long. Elsewhere the thread of `tracker.streaming.streams` does.
"""

from __future__ import annotations

import contextlib
import itertools
import logging
import select
import sys
import threading
from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeout
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler
from typing import Any

from tracker.base.child import start_child
from tracker.base.notices import Notice, failure
from tracker.messages import Estimate
from tracker.streaming.apart_child import serve
from tracker.streaming.apart_estimate import packed
from tracker.streaming.apart_messages import Counted, Reported, StreamReply, StreamRequest
from tracker.streaming.attach import HasEstimate, PublishesEstimates, attach
from tracker.streaming.connection import StreamError
from tracker.streaming.publisher import Names, Title
from tracker.streaming.streams import BACKLOG, StreamCounts

START_WAIT = 60.0  # s for the process to import what a stream needs, on a loaded computer
ANSWER_WAIT = 15.0  # s for a test or the end of a stream
END_WAIT = 3.0  # s for the process to end without being stopped
_log = logging.getLogger(__name__)


def _has_ended() -> StreamError:
    return StreamError(failure("stream.process_ended"))


class EstimateLine:
    """A pipe to the process, for estimates (see `StreamsProcess.open_line`) and requests. Methods
    may be called from any thread."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe, self._sending = pipe, threading.Lock()
        self._room = None
        if sys.platform == "linux":
            self._room = select.poll()
            self._room.register(pipe.fileno(), select.POLLOUT)

    def send(self, hand: int, estimate: Estimate) -> None:
        """Passes on an estimate; may wait until the process accepts it. Raises StreamError."""
        self.write(packed(hand, estimate, estimate.seq))

    def write(self, data: bytes | memoryview) -> None:
        """Sends bytes; may wait. Raises StreamError."""
        with self._sending:
            try:
                self._pipe.send_bytes(data)
            except (OSError, ValueError) as error:
                raise _has_ended() from error

    def offer(self, data: bytes) -> bool:
        """Sends a packed estimate unless that would wait; returns whether it was sent. On Linux;
        elsewhere one cannot know, so it may wait."""
        if not self._sending.acquire(blocking=False):
            return False
        try:
            if self._room is not None and not self._room.poll(0):
                return False  # more than a quarter of the buffer is used
            self._pipe.send_bytes(data)
        except (OSError, ValueError):  # the counts report that it has ended
            return False
        finally:
            self._sending.release()
        return True

    def close(self) -> None:
        self._pipe.close()


class StreamsProcess:
    """The process; methods may be called from any thread. `feed` never waits for it."""

    def __init__(self) -> None:
        self._pipe, self._process = start_child("glovetrack-streams", serve)
        self.line = EstimateLine(self._pipe)
        self._numbers, self._keys = itertools.count(1), itertools.count(1)
        self._waiting: dict[int, Future[Any]] = {}
        self._counts: dict[int, tuple[StreamCounts, ...]] = {}
        self._reports: dict[int, Callable[[Notice], None]] = {}
        self.ended = False
        self._thread = threading.Thread(target=self._read, name="glovetrack-streams-answers")
        self._thread.daemon = True
        self._thread.start()

    @property
    def pid(self) -> int:
        return self._process.pid or 0

    def open(self, kind: str, options: Any, hands: Sequence[Names]) -> ApartStream:
        """Opens a stream of this kind. Raises StreamError."""
        key = next(self._keys)
        titles = self.ask("open", key, (kind, options, tuple(hands)), START_WAIT)
        return ApartStream(self, key, titles)

    def open_line(self) -> Connection:
        """Returns the end of a pipe for the estimates of another process (`EstimateLine`), which do
        not pass through this one. Raises StreamError."""
        theirs, ours = Pipe(duplex=False)
        try:
            self.ask("read", 0, theirs, START_WAIT)
        finally:
            theirs.close()
        return ours

    def ask(self, do: str, key: int, data: Any = None, wait: float = ANSWER_WAIT) -> Any:
        """Sends a request and returns the answer. Raises StreamError."""
        number, future = next(self._numbers), Future[Any]()
        self._waiting[number] = future
        try:
            self._send(StreamRequest(number, do, key, data))
            return future.result(wait)
        except FutureTimeout as error:
            raise StreamError(failure("stream.process_silent")) from error
        finally:
            self._waiting.pop(number, None)

    def tell(self, do: str, key: int) -> None:
        """Sends a request without an answer."""
        with contextlib.suppress(StreamError):  # the counts report that it has ended
            self._send(StreamRequest(0, do, key))

    def counts(self, key: int) -> tuple[StreamCounts, ...]:
        """Counts of one stream for each hand; at most half a second old."""
        return self._counts.get(key, ())

    def listen(self, key: int, report: Callable[[Notice], None]) -> None:
        """Calls ``report`` in another thread with the stream's notices."""
        self._reports[key] = report

    def forget(self, key: int) -> None:
        self._reports.pop(key, None)
        self._counts.pop(key, None)

    def close(self) -> None:
        """Ends the process and closes all its streams."""
        if not self.ended:
            with contextlib.suppress(StreamError):  # it has already ended
                self._send(None)
        self._process.join(END_WAIT)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()
        self._thread.join()

    def _send(self, item: object) -> None:
        if self.ended:
            raise _has_ended()
        self.line.write(ForkingPickler.dumps(item))  # also a pipe

    def _read(self) -> None:
        try:
            while True:
                self._take(self._pipe.recv())
        except (EOFError, OSError):
            self.ended = True
            for future in list(self._waiting.values()):
                future.set_exception(_has_ended())
            self._pipe.close()

    def _take(self, item: object) -> None:
        if isinstance(item, Counted):
            self._counts = item.counts
        elif isinstance(item, Reported):
            report = self._reports.get(item.key)
            if report is not None:
                report(item.what)
        elif isinstance(item, StreamReply):
            future = self._waiting.get(item.number)
            if future is not None and item.problem is not None:
                future.set_exception(StreamError(item.problem))
            elif future is not None:
                future.set_result(item.result)


class ApartStream:
    """One stream in the process; ``titles`` are the names of its publishers."""

    def __init__(self, process: StreamsProcess, key: int, titles: Sequence[Title]) -> None:
        self._process, self._key, self.titles = process, key, tuple(titles)

    def start(self, report: Callable[[Notice], None]) -> None:
        """Sends every estimate that is fed from now on; ``report`` is called in another thread."""
        self._process.listen(self._key, report)
        self._process.tell("start", self._key)

    def counts(self) -> tuple[StreamCounts, ...]:
        """Counts of each hand."""
        found = self._process.counts(self._key)
        if self._process.ended:
            ended = _has_ended().notice
            return tuple(StreamCounts(title, 0, 0, 0, ended) for title in self.titles)
        return found or tuple(StreamCounts(title, 0, 0, 0, "") for title in self.titles)

    def test(self) -> Notice:
        """Whether a program receives it. Raises StreamError."""
        found: Notice = self._process.ask("test", self._key)
        return found

    def close(self) -> None:
        """Waits until pending data have been sent. May be called again."""
        if not self._process.ended:
            try:
                self._process.ask("close", self._key)
            except StreamError as error:
                _log.info("%s", error)
        self._process.forget(self._key)


class DirectFeed:
    """Passes a hand's estimates to the process in the thread that makes them, which takes less of
    its time than waking another one up. Never waits: those that the process does not accept yet are
    sent with the next one, and the oldest of more than `BACKLOG` are discarded."""

    def __init__(self, line: EstimateLine, hand: int) -> None:
        self._line, self._hand = line, hand
        self._numbers = itertools.count()
        self._waiting: deque[bytes] = deque(maxlen=BACKLOG)

    def __call__(self, estimate: Estimate) -> None:
        self._waiting.append(packed(self._hand, estimate, next(self._numbers)))
        while self._waiting and self._line.offer(self._waiting[0]):
            self._waiting.popleft()


class ApartFeed:
    """A publisher that passes a hand's estimates to the process."""

    def __init__(self, line: EstimateLine, hand: int) -> None:
        self.name = f"streams of hand {hand}"
        self._line, self._hand = line, hand

    def send(self, estimate: Estimate) -> None:
        self._line.send(self._hand, estimate)

    def close(self) -> None: ...


def feed(
    tracker: HasEstimate | PublishesEstimates, line: EstimateLine, hand: int
) -> Callable[[], None]:
    """Passes a tracker's estimates to the process from now on; the returned function ends it."""
    if sys.platform == "linux" and isinstance(tracker, PublishesEstimates):
        return tracker.subscribe(DirectFeed(line, hand))
    return attach(tracker, [ApartFeed(line, hand)]).close
