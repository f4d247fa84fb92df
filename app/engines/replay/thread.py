"""Plays a session in real time on one thread, at the position of the transport."""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Iterable, Iterator
from itertools import islice

from app.engines.replay.hands import HandsInFile, OfFile, holds
from app.engines.replay.sights import sights
from app.engines.replay.transport import Transport
from tracker.base.errors import GlovetrackError
from tracker.messages import Estimate, Event
from tracker.session.holes import is_hole

_log = logging.getLogger(__name__)

IDLE_S = 0.03
LEAD_IN_S = 0.12  # read before the requested position: an image is older than its blobs
SAME_S = 1e-6  # rounding of a time that is converted to a position and back
LOOK_BACK_S = (0.5, 2.0, 10.0)  # spans searched for the previous image, nearest first
AHEAD_S = 0.4
"""How far the next estimate is searched ahead: on an overloaded computer estimates arrive late and
in bursts, but without a hole between their instants."""


class ReplayThread:
    """Keeps ``hands`` at the position of ``transport``."""

    def __init__(self, hands: HandsInFile, transport: Transport) -> None:
        self._hands, self._transport = hands, transport
        reader = hands.main
        self.start_t = reader.anchor.monotonic(reader.span_ns[0])
        hands.follow(lambda: self.start_t + transport.position)
        self._thread: threading.Thread | None = None
        self._shown_at = 0.0  # position of the image on the screen
        # A session tracked again has no blobs, so no images: steps go from estimate to estimate.
        self._has_blobs = holds(reader, "/camera/")

    def start(self) -> None:
        self._thread = threading.Thread(target=self._run, name="glovetrack-replay")
        self._thread.start()

    def stop(self) -> None:
        self._transport.stopping.set()
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    def _run(self) -> None:
        transport = self._transport
        while not transport.stopping.is_set():
            try:
                if transport.steps_back:
                    self._seek_back()
                if transport.seek_to is None:
                    transport.stopping.wait(IDLE_S)
                    continue
                start, transport.seek_to = transport.seek_to, None
                self._play_from(start)
            except GlovetrackError as error:  # damaged here; elsewhere it may be whole
                _log.warning("Replay stopped at %.3f s: %s", transport.position, error)
                transport.playing = False
                self._hands.report(Event.of(0.0, "error", error.notice))

    def _seek_back(self) -> None:
        """Go to the image that is ``steps_back`` before the one on the screen."""
        back, self._transport.steps_back = self._transport.steps_back, 0
        before: list[float] = []
        for reach in LOOK_BACK_S:
            begin = self.start_t + self._shown_at - reach * back
            end = self.start_t + self._shown_at
            before = [t - self.start_t for t in self._steps(begin, end)]
            if len(before) >= back or begin <= self.start_t:
                break
        self._transport.seek_to = before[-back] if len(before) >= back else 0.0

    def _steps(self, begin: float, end: float) -> list[float]:
        """The positions (s) of steps between two times."""
        reader = self._hands.main
        if self._has_blobs:
            return sights(reader, begin, end)
        found = reader.messages((Estimate,), start=begin, end=end)
        return [OfFile("", m).arrival for m in found]

    def _play_from(self, start: float) -> None:
        """Play from a position (s). A paused replay shows the image and the hand of that instant;
        if no image is near before it, the next one."""
        self._hands.forget()
        self._transport.images_due, self._transport.position = 1, start
        begin = self.start_t + start - LEAD_IN_S
        self._hands.seek(begin)
        there = shows = False
        for read, before_hole in marked(self._hands.messages(start=begin)):
            position = read.arrival - self.start_t
            if not there and position > start + SAME_S:
                there = True
                self._hands.arrive()
                self._count(shows)  # only now: a step requested meanwhile continues from here
            if there and not self._wait_for(position):
                return
            shown = self._take(read, position >= start - SAME_S)
            if before_hole:
                self._hands.begin_hole(read)
            self._hands.report_damage()
            shows |= shown
            self._count(shown and there)
        self._hands.arrive()
        self._hands.report_damage(every=True)
        self._transport.end(self._transport.duration)

    def _count(self, shown: bool) -> None:
        """Count an image that was shown."""
        self._transport.images_due = max(0, self._transport.images_due - shown)

    def _take(self, read: OfFile, due: bool) -> bool:
        """Process a message; returns whether the image changed. ``due``: it is not from before the
        requested position."""
        before = self._hands.frame
        if due or not isinstance(read.message, Event):
            self._hands.take(read)
        self._hands.advance(read, due)
        shown = self._hands.frame is not before
        if not (shown if self._has_blobs else isinstance(read.message, Estimate)):
            return False
        self._shown_at = read.arrival - self.start_t
        return True

    def _wait_for(self, position: float) -> bool:
        """Sleep until ``position`` is due; returns False if stopped or sent elsewhere."""
        transport = self._transport
        while not transport.sent_elsewhere:
            if not transport.playing and transport.images_due > 0:
                transport.position = max(transport.position, position)
                return True  # a paused replay shows the requested image
            if transport.playing and transport.position >= transport.range[1]:
                transport.end(transport.range[1])
                continue
            ahead = position - transport.position
            if ahead <= 0:
                return True
            before = time.monotonic()
            transport.stopping.wait(min(IDLE_S, ahead / transport.speed))
            if transport.playing:
                passed = (time.monotonic() - before) * transport.speed
                transport.position = min(position, transport.position + passed)
        return False


def marked(messages: Iterable[OfFile]) -> Iterator[tuple[OfFile, bool]]:
    """Each message, and whether it is an estimate after which its hand has a hole.

    At the end of the file there is none, unless other messages continue for `AHEAD_S`.
    """
    coming, waiting, is_end = iter(messages), deque[OfFile](), False
    while True:
        while not is_end and not (waiting and _is_decided(waiting)):
            read = next(coming, None)
            is_end = read is None
            if read is not None:
                waiting.append(read)
        if not waiting:
            return
        is_last = _is_decided(waiting) and _is_last(waiting)
        yield waiting.popleft(), is_last


def _is_decided(waiting: deque[OfFile]) -> bool:
    """Whether enough messages were read ahead to apply `_is_last` to the first one."""
    first = waiting[0]
    if not isinstance(first.message, Estimate):
        return True
    is_far = waiting[-1].arrival - first.arrival > AHEAD_S
    return is_far or _next_estimate(waiting) is not None


def _is_last(waiting: deque[OfFile]) -> bool:
    """Whether a hole begins with the first one."""
    message, found = waiting[0].message, _next_estimate(waiting)
    return isinstance(message, Estimate) and (found is None or is_hole(message.t, found.t))


def _next_estimate(waiting: deque[OfFile]) -> Estimate | None:
    """The one of the same hand that follows the first one."""
    side = waiting[0].side
    for read in islice(waiting, 1, None):
        if read.side == side and isinstance(read.message, Estimate):
            return read.message
    return None
