"""A recorded session as an engine for the window."""

from __future__ import annotations

import logging
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from itertools import islice
from pathlib import Path

from app.engines.engine import CameraPart, EngineSetup, seen_from_main
from app.engines.replay.hands import HandsInFile, holds
from app.engines.replay.sights import first_sight
from app.engines.replay.thread import ReplayThread
from app.engines.replay.transport import ReplayPlayer
from app.engines.warm_up import warm_up_view
from app.platform.tasks import JobProgress
from resources import folder
from tracker.base.errors import FileError, GlovetrackError
from tracker.live.colours import KIND
from tracker.messages import Event
from tracker.session.description import SessionInfo
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
        tracked = holds(self._reader, "/hand/")
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

    def stop(self, patience: float | None = None) -> None:
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
