"""A recorded session as an engine for the window."""

from __future__ import annotations

import logging
import threading
import time
from bisect import bisect_right
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path

from app.engines.engine import CameraPart, EngineSetup, seen_from_main
from app.engines.replay.hands import HandsInFile, OfFile, has_topic
from app.engines.replay.sights import ReplayPlayer, Transport, first_sight, sights
from app.engines.warm_up import warm_up_view
from app.platform.tasks import JobProgress
from resources import folder
from tracker.base.errors import FileError, GlovetrackError
from tracker.live.colours import KIND
from tracker.messages import Estimate, Event
from tracker.session.description import SessionInfo
from tracker.session.holes import is_hole
from tracker.session.notes import latest_versions
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.rig import StereoRig, ideal_rig

MAX_EVENTS = 5000

FROM_IMAGES = ("/image/compressed", "/blobs")
"""Endings of the names of a camera's topics."""
_log = logging.getLogger(__name__)


class ReplayEngine:
    """A `WindowEngine` of a file; its ``player`` moves through it."""

    def __init__(self, path: Path) -> None:
        self.hands = HandsInFile(path)
        self._reader, self.info = self.hands.main, self.hands.main.info
        tracked = has_topic(self._reader, "/hand/")
        cut_off = not self._reader.source.contents.finished
        duration, references = self._reader.duration, self.hands.references
        self.player = ReplayPlayer(path, duration, references, tracked, cut_off)
        self._thread = ReplayThread(self.hands, self.player)
        try:
            self._colours = ColoursOfFile(_first_colours(self.info, path), ())
        except GlovetrackError:
            self.hands.close()
            raise

    @property
    def start_t(self) -> float:
        """The file's start, s of the monotonic clock."""
        return self._thread.start_t

    @property
    def rig(self) -> StereoRig | None:
        """None if the session has no calibrated camera."""
        return self.info.rig

    @property
    def has_camera(self) -> bool:
        """Whether the session has a camera: its calibration, images or blobs."""
        return self.rig is not None or any(
            t.endswith(FROM_IMAGES) for t in self._reader.topic_names
        )

    def read_events(self) -> None:
        """Read the notes and events for the timeline, and begin at the first image with blobs."""
        found: list[Event] = []
        try:
            messages = self._reader.messages((Event,))
            found += [m for m in islice(messages, MAX_EVENTS) if isinstance(m, Event)]
        except FileError as error:
            self.hands.report(Event.of(0.0, "error", error.notice))
        where = self.player.clamped
        self.player.events = tuple((where(e.t - self.start_t), e) for e in latest_versions(found))
        self._colours = ColoursOfFile(self._colours.at(0.0), self.player.events)
        sight = first_sight(self._reader)
        if sight is not None:
            self.player.seek(sight - self.start_t)

    def start(self) -> None:
        self._thread.start()

    def stop(self, timeout: float | None = None) -> None:
        self._thread.stop()

    def close(self) -> None:
        self.stop()
        self.hands.close()

    def drain_events(self) -> list[Event]:
        return self.hands.drain_events()

    @property
    def profile(self) -> ColourProfile:
        """The colours that were searched at the position, or those that are tried."""
        return self._colours.at(self.player.position)

    def set_profile(self, profile: ColourProfile) -> None:
        """Try other colours; the colours panel searches images with them."""
        self._colours.tried(profile)

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        """Add a note to the log; the file is not changed."""
        self.hands.report(Event(self.start_t + self.player.position, "note", text))


def _first_colours(info: SessionInfo, path: Path) -> ColourProfile:
    """The colours at the beginning of a session. Raises FileError."""
    default = (folder("colours") / "fabric-default.toml").read_text("utf-8")
    return parse_profile(info.colours_text or default, f"{path.name}, colours.toml")


def open_replay(path: Path, progress: JobProgress, at: float | None = None) -> EngineSetup:
    """Open a session file for the window, paused at ``at`` s if that is given. Raises FileError."""
    progress(-1.0, path.name)
    warm_up_view()
    engine = ReplayEngine(path)
    try:
        info = engine.info
        rig = engine.rig
        engine.read_events()
    except GlovetrackError:
        engine.close()
        raise
    if at is not None:
        engine.player.pause_at(at)
    setups = [
        EngineSetup(
            name=path.name,
            engine=engine,
            tracked=engine.hands.moments[seen.side],
            hand=seen.hand,
            glove=seen.glove,
            camera=CameraPart(rig or ideal_rig(), engine.has_camera, rig is not None),
            profile=engine.profile,
            close=engine.close,
            truth=engine.hands.references[seen.side].truth(),
            simulated=info.simulated,
            player=engine.player,
            listeners=engine.hands.listeners[seen.side].by_name,
            anchor=info.anchor,
        )
        for seen in info.hands
    ]
    return seen_from_main(setups)


class ColoursOfFile:
    """The colours that a session was searched with, which follow its light, and those tried on it.

    Positions are s from the file's start.
    """

    def __init__(self, first: ColourProfile, events: Sequence[tuple[float, Event]]) -> None:
        """``first``: the colours at the beginning of the session."""
        changes = sorted(
            (
                (t, str(e.data["colours"]))
                for t, e in events
                if e.kind == KIND and "colours" in e.data
            ),
            key=lambda of: of[0],
        )
        self._first, self._tried = first, first
        self._starts = [t for t, _ in changes]
        self._texts = [text for _, text in changes]
        self._read: dict[int, ColourProfile] = {}  # only those that were shown: parsing is slow

    def tried(self, profile: ColourProfile) -> None:
        """Show these colours everywhere, until the file's own are set again."""
        self._tried = profile

    def at(self, position: float) -> ColourProfile:
        """The colours to show at a position."""
        if self._tried is not self._first and self._tried not in self._read.values():
            return self._tried
        return self._of(bisect_right(self._starts, position) - 1)

    def _of(self, index: int) -> ColourProfile:
        """The colours of a change; unreadable ones and those of other hues are ignored."""
        if index < 0:
            return self._first
        if index not in self._read:
            before = self._of(index - 1)
            try:
                new = parse_profile(self._texts[index])
            except GlovetrackError as error:
                _log.warning("Colours in the session are ignored: %s", error)
                new = before
            self._read[index] = new if new.hue_names == before.hue_names else before
        return self._read[index]


# ---- plays a session in real time on one thread, at the position of the transport

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
        self._has_blobs = has_topic(reader, "/camera/")

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
