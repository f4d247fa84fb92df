"""The hands of a session file: each has its own reader, their messages are merged in order."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.engines.replay.marker_matches import MarkerMatcher
from app.engines.replay.references import References
from tracker.base.damage import reports
from tracker.live.history import History, SearchedImage
from tracker.live.listeners import ListenedHand, Listeners
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.session.decode import MESSAGE_KINDS
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

IMAGES_WAITING = 30
HANDS = 60  # estimates that are stored: an image is about 40 ms older than the newest
LATE = 0.3  # s after which an image is shown without its blobs, and blobs without their image
OF_A_HAND = (ImuSample, Estimate, Calibration, Status)
"""Kinds of messages that belong to one hand; all others belong to the whole recording."""


class ReplayMoment:
    """One hand of a replay. Updated by the replay's thread, read by the window's.

    ``markers`` is their number on the glove. ``has_images``: the file contains images, so blobs
    wait for theirs. Of one arrival time either may be first, because images are compressed by a
    process of their own. ``matcher`` assigns blobs to markers; None without a calibrated camera.
    ``position`` returns the replay's position, s of the file's monotonic clock.
    """

    def __init__(
        self, markers: int, has_images: bool, matcher: MarkerMatcher | None = None
    ) -> None:
        self._markers, self._has_images, self._matcher = markers, has_images, matcher
        self._hands: deque[Estimate] = deque(maxlen=HANDS)
        self._estimate: Estimate | None = None
        self._in_hole: Estimate | None = None  # shown after it begins; None where no hole follows
        self._hole = np.inf  # s, its begin
        self._is_fresh = False  # whether an estimate was read since the last `forget`
        self.position: Callable[[], float] = lambda: -np.inf
        self._frame: tuple[StereoFrame, BlobFrame, FrameResult] | None = None
        self._calibration: Calibration | None = None
        self._status = Status(0.0, Tracking.SEARCHING, {})
        self.forget()

    def forget(self) -> None:
        """Discard data of the old position; the hand is shown until the next estimate."""
        self._images: dict[float, StereoFrame] = {}
        self._hands.clear()
        self._is_fresh = False
        self._imu: History[ImuSample] = History()
        self._estimates: History[Estimate] = History()
        self._searched: float | None = None  # t of the last blobs, or of the first image
        self._pictured: float | None = None  # t of the last image, or of the first blobs
        self._waiting: BlobFrame | None = None  # the last blobs, whose image has not arrived yet

    def take(self, message: Message) -> None:
        """Process the next message of the file; an image waits for its blobs.

        Events of the file are shown on the timeline.
        """
        if isinstance(message, ImuSample):
            self._imu.add(message)
        elif isinstance(message, Estimate):
            self._estimate, self._is_fresh = message, True
            self._hole, self._in_hole = np.inf, None
            self._hands.append(message)
            self._estimates.add(message)
        elif isinstance(message, StereoFrame):
            self._take_image(message)
        elif isinstance(message, BlobFrame):
            self._take_blobs(message)
        elif isinstance(message, Calibration):
            self._calibration = message
        elif isinstance(message, Status):
            self._status = message

    def _take_image(self, image: StereoFrame) -> None:
        self._pictured = image.t
        if self._waiting is not None and self._waiting.t == image.t:
            blobs, self._waiting = self._waiting, None
            self._show(image, blobs)
            return
        self._images[image.t] = image
        while len(self._images) > IMAGES_WAITING:
            self._images.pop(next(iter(self._images)))
        if self._searched is None:
            self._searched = image.t
        if image.t - self._searched > LATE:
            self._show(image, BlobFrame(image.t, image.t_arrival, (), None, None, image.pose))

    def _take_blobs(self, blobs: BlobFrame) -> None:
        self._searched = blobs.t
        if self._pictured is None:
            self._pictured = blobs.t
        image = self._images.pop(blobs.t, None)
        if image is not None:
            self._show(image, blobs)
        elif self._has_images and blobs.t - self._pictured <= LATE:
            self._waiting = blobs  # the previous image is shown until then
        else:
            empty = StereoFrame(blobs.t, blobs.t_arrival, None, None, blobs.pose, blobs.index)
            self._show(empty, blobs)

    def _show(self, image: StereoFrame, blobs: BlobFrame) -> None:
        if self._matcher is not None:
            result = self._matcher.match(blobs, self._hands)
        else:
            tracking = self._estimate.tracking if self._estimate else Tracking.SEARCHING
            result = FrameResult.nothing(blobs.t, tracking, self._markers)
        self._frame = (image, blobs, result)

    def begin_hole(self, at: float) -> None:
        """Show the hand as lost from ``at`` (s) to the next estimate."""
        if self._estimate is not None:
            self._hole, self._in_hole = at, lost(self._estimate)

    def arrive(self) -> None:
        """The replay has reached the requested position: hide the hand if it has no estimate
        there."""
        if not self._is_fresh:
            self.begin_hole(-np.inf)

    @property
    def is_in_hole(self) -> bool:
        """Whether the file has no estimates around the position."""
        return self._in_hole is not None and self.position() >= self._hole

    def latest_estimate(self) -> Estimate | None:
        hole = self._in_hole
        return hole if hole is not None and self.position() >= self._hole else self._estimate

    def latest_frame(
        self, t: float | None = None
    ) -> tuple[StereoFrame, BlobFrame, FrameResult] | None:
        """``t`` (s): only if it is the one of that exposure."""
        frame = self._frame
        return frame if t is None or (frame is not None and frame[0].t == t) else None

    def calibration(self) -> Calibration | None:
        return self._calibration

    def status(self) -> Status:
        """The latest one, with the tracking state of the estimate: a status is written once a
        second, and does not include gaps that were interpolated later."""
        hand = self.latest_estimate()
        if hand is None or not (self._is_fresh or self.is_in_hole):
            return self._status
        return replace(self._status, tracking=hand.tracking)

    def recent_imu(self) -> Sequence[ImuSample]:
        """The samples of the last seconds."""
        return self._imu.recent()

    def recent_estimates(self) -> Sequence[Estimate]:
        """The estimates of the last seconds."""
        return self._estimates.recent()

    def recent_images(self) -> Sequence[SearchedImage]:
        """Empty: a file does not contain the filter's result for each image."""
        return ()


def lost(estimate: Estimate) -> Estimate:
    """The estimate during a hole after this one: all values are NaN."""
    known = ("keypoints", "keypoint_q", "keypoint_sd", "angles", "segment_R", "segment_p")
    nothing = {name: np.full_like(getattr(estimate, name), np.nan) for name in known}
    states = {
        name: np.full_like(getattr(estimate, name), int(Validity.LOST))
        for name in ("keypoint_state", "angle_state")
    }
    return replace(estimate, tracking=Tracking.LOST, **nothing, **states)


class OfFile(NamedTuple):
    """A message, and the side of the hand of its reader."""

    side: str
    message: Message

    @property
    def arrival(self) -> float:
        """The time of its arrival in s."""
        return float(getattr(self.message, "t_arrival", self.message.t))


class HandsInFile:
    """Reads one hand or two. ``main`` reads the one that is shown first, and common messages.

    ``moments``, ``references`` and ``listeners`` are by side. Raises FileError if the file is
    unreadable.
    """

    def __init__(self, path: Path) -> None:
        self.main = SessionReader(path)
        info = self.main.info
        self._others = [SessionReader(path, side=other.side) for other in info.others]
        readers = self._readers = (self.main, *self._others)
        self._damage_reported = 0  # messages
        has_images = any("/image" in name for name in self.main.topic_names)
        self.moments = {
            r.info.side: ReplayMoment(len(r.info.glove.markers), has_images, _matcher(r))
            for r in readers
        }
        self.references = {
            r.info.side: References(path, r.info.side, known_hand(r)) for r in readers
        }
        self._events: deque[Event] = deque(maxlen=1000)  # for the window
        self.listeners = {r.info.side: self._attach_listeners(r) for r in readers}

    def _attach_listeners(self, reader: SessionReader) -> Listeners:
        listeners = Listeners(lambda what: self.report(Event.of(0.0, "error", what)))
        listeners.attach(ListenedHand(reader.info.hand, reader.info.glove))
        return listeners

    def messages(
        self,
        kinds: Collection[type] = MESSAGE_KINDS,
        start: float | None = None,
        end: float | None = None,
    ) -> Iterator[OfFile]:
        """Like `SessionReader.messages`, for all hands."""
        own = tuple(kind for kind in kinds if kind in OF_A_HAND)
        streams = [_sided(self.main, kinds, start, end)]
        streams += [_sided(other, own, start, end) for other in self._others if own]
        return heapq.merge(*streams, key=lambda m: m.arrival) if self._others else streams[0]

    @property
    def frame(self) -> object:
        """The present camera images, to detect a change."""
        return self.moments[self.main.info.side].latest_frame()

    def take(self, read: OfFile) -> None:
        """Process a message of one hand, or of all."""
        if isinstance(read.message, OF_A_HAND):
            self.moments[read.side].take(read.message)
            return
        for moment in self.moments.values():
            moment.take(read.message)

    def begin_hole(self, read: OfFile) -> None:
        """Begin a hole: no estimate of this hand follows for `LONGEST_FILLED`."""
        self.moments[read.side].begin_hole(read.arrival + LONGEST_FILLED)

    def arrive(self) -> None:
        """The replay is at the position that it was sent to."""
        for moment in self.moments.values():
            moment.arrive()

    def follow(self, position: Callable[[], float]) -> None:
        """``position`` returns the replay's position, s of the file's monotonic clock."""
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

    def report(self, event: Event) -> None:
        """Reports an event with the current time, which is not in the file."""
        self._events.append(event)

    def report_damage(self, every: bool = False) -> None:
        """Report how many damaged messages were skipped: at the first one, and each time the number
        has doubled; with ``every``, whenever it has grown."""
        found = [reader.source.left_out for reader in self._readers]
        count = sum(map(len, found))
        if count > self._damage_reported and (every or count >= 2 * self._damage_reported):
            self._damage_reported = count
            for what in reports(found):
                self.report(Event.of(0.0, "error", what))

    def drain_events(self) -> list[Event]:
        """Return the events since the last call."""
        events = []
        while self._events:
            events.append(self._events.popleft())
        return events

    def seek(self, t: float) -> None:
        """Restart the reference hands at ``t`` s of the monotonic clock."""
        for references in self.references.values():
            references.seek(t)

    def close(self) -> None:
        for reader in (self.main, *self._others):
            reader.close()
        for references in self.references.values():
            references.close()
        for listeners in self.listeners.values():
            listeners.close()


def _matcher(reader: SessionReader) -> MarkerMatcher | None:
    info = reader.info
    return MarkerMatcher(info.hand, info.glove, info.rig) if info.rig is not None else None


def _sided(
    reader: SessionReader, kinds: Collection[type], start: float | None, end: float | None
) -> Iterator[OfFile]:
    for message in reader.messages(kinds, start, end):
        yield OfFile(reader.info.side, message)


def known_hand(reader: SessionReader) -> str:
    """The session's other data about the reader's hand: a laboratory's
    ``reference``, the ``truth`` of a simulation, or nothing."""
    known = ("reference", "truth")
    return next((k for k in known if has_topic(reader, f"/{k}/{reader.info.side}/")), "")


def has_topic(reader: SessionReader, topic: str) -> bool:
    """Whether there are blobs or keypoints under ``topic``."""
    endings = ("/blobs", "/keypoints")
    return any(n.startswith(topic) and n.endswith(endings) for n in reader.topic_names)
