"""Reads a session at its own pace, in one thread, and goes where the transport is sent."""

from __future__ import annotations

import threading
import time
from collections import deque

from app.engines.replay.moment import ReplayMoment
from app.engines.replay.references import References
from app.engines.replay.sights import sights
from app.engines.replay.transport import Transport
from tracker.applications.stage import ApplicationStage
from tracker.errors import GlovetrackError
from tracker.messages import Estimate, Event, Message
from tracker.session.reader import SessionReader

IDLE_S = 0.03
LEAD_IN_S = 0.12  # read before the position asked for: an image is older than its blobs
LOOK_BACK_S = (0.5, 2.0, 10.0)  # where the image before is looked for, nearest first


class ReplayThread:
    """Brings ``moment``, ``references`` and ``stage`` to where ``transport`` wants them."""

    def __init__(
        self,
        reader: SessionReader,
        transport: Transport,
        moment: ReplayMoment,
        references: References,
        stage: ApplicationStage,
    ) -> None:
        self._reader, self._transport = reader, transport
        self._moment, self._references, self._stage = moment, references, stage
        self.start_t = reader.anchor.monotonic(reader.span_ns[0])
        self._thread: threading.Thread | None = None
        self._shown_at = 0.0  # where the image on screen stands
        # Without blobs (a session tracked again) there is no image: one steps by estimates.
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
                transport.playing = False
                self._moment.take(Event(0.0, "error", str(error)))

    def _seek_back(self) -> None:
        """To the image that is ``steps_back`` before the one on screen."""
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
        """Where (s) one steps to between two times."""
        if self._has_blobs:
            return sights(self._reader, begin, end)
        return [_arrival(m) for m in self._reader.messages((Estimate,), start=begin, end=end)]

    def _play_from(self, start: float) -> None:
        self._moment.forget()
        self._stage.begin_anew()
        self._transport.position, self._transport.images_due = start, 1
        begin = self.start_t + start - LEAD_IN_S
        self._references.seek(begin)
        for message in self._reader.messages(start=begin):
            position = _arrival(message) - self.start_t
            if position >= start and not self._wait_for(position):
                return
            self._take(message, position >= start)
        self._transport.end(self._transport.duration)

    def _take(self, message: Message, due: bool) -> None:
        """``due``: not of the time before the position that was asked for."""
        before = self._moment.frame
        if due or not isinstance(message, Event):
            self._moment.take(message)
        if isinstance(message, Estimate):
            self._references.advance(message.t)
            if due:
                deque(self._stage.feed(message), maxlen=0)
        shown = self._moment.frame is not before
        if due and (shown if self._has_blobs else isinstance(message, Estimate)):
            self._shown_at = _arrival(message) - self.start_t
            self._transport.images_due = max(0, self._transport.images_due - 1)

    def _wait_for(self, position: float) -> bool:
        """Sleep until ``position`` is due; False when stopped or sent elsewhere."""
        transport = self._transport
        while not transport.sent_elsewhere:
            if not transport.playing and transport.images_due > 0:
                transport.position = max(transport.position, position)
                return True  # a paused replay shows the image it was sent to
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


def holds(reader: SessionReader, topic: str) -> bool:
    """Whether there are blobs or keypoints under ``topic``."""
    endings = ("/blobs", "/keypoints")
    return any(n.startswith(topic) and n.endswith(endings) for n in reader.topic_names)


def _arrival(message: Message) -> float:
    return float(getattr(message, "t_arrival", message.t))
