"""The hands of a session file: each read by its own reader, their messages in one order."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from typing import NamedTuple

from app.engines.replay.moment import ReplayMoment
from app.engines.replay.references import References
from app.engines.replay.tell_markers import MarkerTeller
from tracker.base.damage import reports
from tracker.live.listeners import ListenedHand, Listeners
from tracker.messages import Calibration, Estimate, Event, ImuSample, Message, Status
from tracker.session.decode import MESSAGE_KINDS
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

OF_A_HAND = (ImuSample, Estimate, Calibration, Status)
"""Kinds of messages that are of one hand; all others are of the take."""


class OfFile(NamedTuple):
    """A message, and the side of the hand that it was read with."""

    side: str
    message: Message

    @property
    def arrival(self) -> float:
        """When it was fed, s."""
        return float(getattr(self.message, "t_arrival", self.message.t))


class HandsInFile:
    """Of one hand or of two. ``main`` reads the one that is shown first, and what is of no hand.

    ``moments``, ``references`` and ``listeners`` are by side. Raises FileError where it is
    unreadable.
    """

    def __init__(self, path: Path) -> None:
        self.main = SessionReader(path)
        info = self.main.info
        self._others = [SessionReader(path, side=other.side) for other in info.others]
        readers = self._readers = (self.main, *self._others)
        self._damage_told = 0  # messages
        has_images = any("/image" in name for name in self.main.topic_names)
        self.moments = {
            r.info.side: ReplayMoment(len(r.info.glove.markers), has_images, _teller(r))
            for r in readers
        }
        self.references = {
            r.info.side: References(path, r.info.side, holds(r, f"/truth/{r.info.side}/"))
            for r in readers
        }
        self._events: deque[Event] = deque(maxlen=1000)  # of the window
        self.listeners = {r.info.side: self._attach_listeners(r) for r in readers}

    def _attach_listeners(self, reader: SessionReader) -> Listeners:
        listeners = Listeners(lambda what: self.tell(Event.of(0.0, "error", what)))
        listeners.attach(ListenedHand(reader.info.hand, reader.info.glove))
        return listeners

    def messages(
        self,
        kinds: Collection[type] = MESSAGE_KINDS,
        start: float | None = None,
        end: float | None = None,
    ) -> Iterator[OfFile]:
        """As those of `SessionReader.messages`, of all hands."""
        own = tuple(kind for kind in kinds if kind in OF_A_HAND)
        streams = [_sided(self.main, kinds, start, end)]
        streams += [_sided(other, own, start, end) for other in self._others if own]
        return heapq.merge(*streams, key=lambda m: m.arrival) if self._others else streams[0]

    @property
    def frame(self) -> object:
        """What is shown of the cameras, to be compared with what was shown before."""
        return self.moments[self.main.info.side].latest_frame()

    def take(self, read: OfFile) -> None:
        """Show a message with its hand, or with all."""
        if isinstance(read.message, OF_A_HAND):
            self.moments[read.side].take(read.message)
            return
        for moment in self.moments.values():
            moment.take(read.message)

    def begin_hole(self, read: OfFile) -> None:
        """No estimate of this hand follows for longer than `LONGEST_FILLED`."""
        self.moments[read.side].begin_hole(read.arrival + LONGEST_FILLED)

    def arrive(self) -> None:
        """All that is shown is of the position that the replay was sent to."""
        for moment in self.moments.values():
            moment.arrive()

    def follow(self, position: Callable[[], float]) -> None:
        """``position`` gives where the replay is, s of the file's monotonic clock."""
        for moment in self.moments.values():
            moment.position = position

    def forget(self) -> None:
        """See `ReplayMoment.forget`; listeners start over."""
        for moment in self.moments.values():
            moment.forget()
        for listeners in self.listeners.values():
            listeners.restart()

    def advance(self, read: OfFile, due: bool) -> None:
        """Advance the reference hands and, if ``due``, the listeners to an estimate."""
        message = read.message
        if isinstance(message, Estimate):
            self.references[read.side].advance(message.t)
            if due:
                self.listeners[read.side].feed(message, read.arrival)

    def tell(self, event: Event) -> None:
        """Report something that happens now, which is not an event of the file."""
        self._events.append(event)

    def tell_damage(self, every: bool = False) -> None:
        """How many messages were left out because they are damaged: at the first one, and when
        there are twice as many; with ``every``, whenever there are more."""
        found = [reader.source.left_out for reader in self._readers]
        count = sum(map(len, found))
        if count > self._damage_told and (every or count >= 2 * self._damage_told):
            self._damage_told = count
            for what in reports(found):
                self.tell(Event.of(0.0, "error", what))

    def take_events(self) -> list[Event]:
        """What was told since the last call."""
        events = []
        while self._events:
            events.append(self._events.popleft())
        return events

    def seek(self, t: float) -> None:
        """Begin anew with the hands beside, at ``t`` s of the monotonic clock."""
        for references in self.references.values():
            references.seek(t)

    def close(self) -> None:
        for reader in (self.main, *self._others):
            reader.close()
        for references in self.references.values():
            references.close()
        for listeners in self.listeners.values():
            listeners.close()


def _teller(reader: SessionReader) -> MarkerTeller | None:
    info = reader.info
    return MarkerTeller(info.hand, info.glove, info.rig) if info.rig is not None else None


def _sided(
    reader: SessionReader, kinds: Collection[type], start: float | None, end: float | None
) -> Iterator[OfFile]:
    for message in reader.messages(kinds, start, end):
        yield OfFile(reader.info.side, message)


def holds(reader: SessionReader, topic: str) -> bool:
    """Whether there are blobs or keypoints under ``topic``."""
    endings = ("/blobs", "/keypoints")
    return any(n.startswith(topic) and n.endswith(endings) for n in reader.topic_names)
