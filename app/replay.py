"""A recorded session that behaves like a live engine, so that the same panels show it."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Sequence
from pathlib import Path

from app.engine import EngineSetup, Recorder
from app.tasks import Progress
from resources import folder
from tracker.errors import GlovetrackError
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
)
from tracker.session.reader import SessionReader
from tracker.vision.colours import ColourProfile, parse_profile

HISTORY_S = 10.0
IDLE_S = 0.03
PICTURES_WAITING = 30


class ReplayEngine:
    """Plays a file at its own pace in one thread; `seek` starts it anew from another place."""

    def __init__(self, path: Path) -> None:
        self._reader = SessionReader(path)
        self._markers = len(self._reader.info.glove.markers)
        self._start_t = self._reader.anchor.monotonic(self._reader.span_ns[0])
        self._thread: threading.Thread | None = None
        self._stopping = threading.Event()
        self._seek_to: float | None = 0.0
        self._playing, self._speed, self._position = True, 1.0, 0.0
        self._show_one = False
        self._events: deque[Event] = deque(maxlen=1000)
        self._forget()

    def _forget(self) -> None:
        self._estimate: Estimate | None = None
        self._frame: tuple[StereoFrame, BlobFrame, FrameResult] | None = None
        self._pictures: dict[float, StereoFrame] = {}
        self._calibration: Calibration | None = None
        self._status = Status(0.0, Tracking.SEARCHING, {})
        self._imu: deque[ImuSample] = deque()

    # --- LiveEngine

    def start(self) -> None:
        self._thread = threading.Thread(target=self._run, name="glovetrack-replay")
        self._thread.start()

    def stop(self) -> None:
        self._stopping.set()
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    def close(self) -> None:
        self.stop()
        self._reader.close()

    def latest_estimate(self) -> Estimate | None:
        return self._estimate

    def latest_frame(self) -> tuple[StereoFrame, BlobFrame, FrameResult] | None:
        return self._frame

    def recent_imu(self) -> Sequence[ImuSample]:
        return tuple(self._imu.copy())

    def calibration(self) -> Calibration | None:
        return self._calibration

    def status(self) -> Status:
        return self._status

    def take_events(self) -> list[Event]:
        events = []
        while self._events:
            events.append(self._events.popleft())
        return events

    def set_profile(self, profile: ColourProfile) -> None:
        """A replay shows what was found when it was recorded."""

    def set_engine(self, name: str) -> None:
        """A replay shows what was tracked when it was recorded."""

    def set_recorder(self, recorder: Recorder | None) -> None:
        """A replay is not recorded again."""

    def note(self, text: str) -> None:
        self._events.append(Event(self._start_t + self._position, "note", text))

    # --- Player

    @property
    def duration(self) -> float:
        return self._reader.duration

    @property
    def position(self) -> float:
        return self._position

    @property
    def playing(self) -> bool:
        return self._playing

    def seek(self, position: float) -> None:
        self._seek_to = min(max(position, 0.0), self.duration)

    def play(self, on: bool) -> None:
        self._playing = on

    def set_speed(self, speed: float) -> None:
        self._speed = speed

    # --- the thread

    def _run(self) -> None:
        try:
            while not self._stopping.is_set():
                if self._seek_to is None:
                    self._stopping.wait(IDLE_S)
                    continue
                start, self._seek_to = self._seek_to, None
                self._play_from(start)
        except GlovetrackError as error:
            self._events.append(Event(0.0, "error", str(error)))

    def _play_from(self, start: float) -> None:
        self._forget()
        self._position = start
        self._show_one = True
        for message in self._reader.messages(start=self._start_t + start):
            if not self._wait_for(_arrival(message) - self._start_t):
                return
            self._take(message)
        self._playing = False

    def _wait_for(self, position: float) -> bool:
        """Sleep until ``position`` is due; False when stopped or sent elsewhere."""
        while not self._stopping.is_set() and self._seek_to is None:
            if self._show_one and not self._playing:
                self._position = max(self._position, position)
                return True  # a paused replay shows the picture it was sent to
            ahead = position - self._position
            if ahead <= 0:
                return True
            before = time.monotonic()
            self._stopping.wait(min(IDLE_S, ahead / self._speed))
            if self._playing:
                passed = (time.monotonic() - before) * self._speed
                self._position = min(position, self._position + passed)
        return False

    def _take(self, message: Message) -> None:
        if isinstance(message, ImuSample):
            self._imu.append(message)
            while self._imu[-1].t - self._imu[0].t > HISTORY_S:
                self._imu.popleft()
        elif isinstance(message, Estimate):
            self._estimate = message
        elif isinstance(message, StereoFrame):
            self._pictures[message.t] = message
            while len(self._pictures) > PICTURES_WAITING:
                self._pictures.pop(next(iter(self._pictures)))
        elif isinstance(message, BlobFrame):
            self._take_blobs(message)
        elif isinstance(message, Calibration):
            self._calibration = message
        elif isinstance(message, Status):
            self._status = message
        elif isinstance(message, Event):
            self._events.append(message)

    def _take_blobs(self, blobs: BlobFrame) -> None:
        picture = self._pictures.pop(blobs.t, None)
        if picture is None:
            picture = StereoFrame(blobs.t, blobs.t_arrival, None, None, blobs.pose, blobs.index)
        tracking = self._estimate.tracking if self._estimate else Tracking.SEARCHING
        self._frame = (picture, blobs, FrameResult.nothing(blobs.t, tracking, self._markers))
        self._show_one = False


def _arrival(message: Message) -> float:
    return float(getattr(message, "t_arrival", message.t))


def open_replay(path: Path, progress: Progress) -> EngineSetup:
    """Open a session file for the window. Raises FileError in words."""
    progress(-1.0, path.name)
    engine = ReplayEngine(path)
    try:
        info = engine._reader.info
        rig = engine._reader.rig()
    except GlovetrackError:
        engine.close()
        raise
    default = (folder("colours") / "fabric-default.toml").read_text("utf-8")
    profile = parse_profile(info.colours_text or default, f"{path.name}, colours.toml")
    return EngineSetup(
        name=path.name,
        engine=engine,
        hand=info.hand,
        glove=info.glove,
        rig=rig,
        profile=profile,
        anchor=info.anchor,
        close=engine.close,
        simulated=info.simulated,
        player=engine,
    )
