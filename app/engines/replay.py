"""A recorded session that behaves like a live engine, so that the same panels show it."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Sequence
from pathlib import Path

from app.engines.engine import EngineSetup, ReferenceHand
from app.engines.replay_reference import ReferenceTrack
from app.engines.replay_transport import IDLE_S, Transport
from app.engines.warm_up import warm_up_view
from app.platform.tasks import JobProgress
from resources import folder
from tracker.errors import FileError, GlovetrackError
from tracker.live.imu_history import HISTORY_S
from tracker.live.recording import Recorder
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
from tracker.vision.rig import StereoRig

IMAGES_WAITING = 30
LEAD_IN_S = 0.12  # read before the place asked for: an image is older than its blobs
LOOK_BACK_S = (0.5, 2.0, 10.0)  # where the image before is looked for, nearest first
MAX_EVENTS = 5000


class ReplayEngine(Transport):
    """Plays a file at its own pace in one thread; `seek` starts it anew from another place."""

    def __init__(self, path: Path) -> None:
        self._reader = SessionReader(path)
        super().__init__(self._reader.duration)
        self.info = self._reader.info
        self._markers = len(self.info.glove.markers)
        self._start_t = self._reader.anchor.monotonic(self._reader.span_ns[0])
        self._thread: threading.Thread | None = None
        self._shown_at = 0.0  # where the image on screen stands
        self._events: deque[Event] = deque(maxlen=1000)
        self._timeline: tuple[tuple[float, Event], ...] = ()
        self._truth = ReferenceTrack(path, truth=True) if self._holds("/truth/") else None
        # Without blobs (a session tracked again) there is no image: one steps by estimates.
        self._steps_by: type = BlobFrame if self._holds("/camera/") else Estimate
        self._reference: ReferenceTrack | None = None
        self._reference_wanted: ReferenceTrack | None = None
        self._true_pose: ReferenceHand | None = None
        self._reference_pose: ReferenceHand | None = None
        self._estimate: Estimate | None = None
        self._frame: tuple[StereoFrame, BlobFrame, FrameResult] | None = None
        self._calibration: Calibration | None = None
        self._status = Status(0.0, Tracking.SEARCHING, {})
        self._forget()

    def _holds(self, topic: str) -> bool:
        endings = ("/blobs", "/keypoints")
        names = self._reader.topic_names
        return any(n.startswith(topic) and n.endswith(endings) for n in names)

    @property
    def has_truth(self) -> bool:
        return self._truth is not None

    @property
    def rig(self) -> StereoRig:
        """Raises FileError that says what of the camera is missing."""
        return self._reader.rig()

    def _forget(self) -> None:
        """What belongs to the place that is left; the hand stands until another one comes."""
        self._images: dict[float, StereoFrame] = {}
        self._imu: deque[ImuSample] = deque()

    def read_events(self) -> None:
        """Find the notes and events for the timeline; a damaged end has none."""
        found: list[tuple[float, Event]] = []
        try:
            for message in self._reader.messages((Event,)):
                if isinstance(message, Event):
                    found.append((self._clamped(message.t - self._start_t), message))
                if len(found) >= MAX_EVENTS:
                    break
        except FileError as error:
            self._events.append(Event(0.0, "error", str(error)))
        self._timeline = tuple(found)

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
        for track in {self._truth, self._reference, self._reference_wanted}:
            if track is not None:
                track.close()

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

    def keep_state(self) -> None:
        """A replay has no engine whose state could be kept."""

    def set_recorder(self, recorder: Recorder | None) -> None:
        """A replay is not recorded again."""

    def note(self, text: str) -> None:
        self._events.append(Event(self._start_t + self._position, "note", text))

    # --- Player

    @property
    def path(self) -> Path:
        return self._reader.path

    @property
    def events(self) -> Sequence[tuple[float, Event]]:
        """What happened, with its place in s."""
        return self._timeline

    def set_reference(self, path: Path | None) -> None:
        """Show the tracking in ``path`` beside this one. Raises FileError in words."""
        self._reference_wanted = None if path is None else ReferenceTrack(path)
        self.seek(self._position)

    def reference(self) -> ReferenceHand | None:
        return self._reference_pose

    def truth(self, _t: float) -> ReferenceHand | None:
        """The simulated hand at the instant of the latest estimate."""
        return self._true_pose

    # --- the thread

    def _run(self) -> None:
        while not self._stopping.is_set():
            try:
                if self._steps_back:
                    self._seek_back()
                if self._seek_to is None:
                    self._stopping.wait(IDLE_S)
                    continue
                start, self._seek_to = self._seek_to, None
                self._play_from(start)
            except GlovetrackError as error:  # a damaged place; others may still be whole
                self._playing = False
                self._events.append(Event(0.0, "error", str(error)))

    def _seek_back(self) -> None:
        """To the image that is ``_steps_back`` before the one on screen."""
        back, self._steps_back = self._steps_back, 0
        before: list[float] = []
        for reach in LOOK_BACK_S:
            begin = self._start_t + self._shown_at - reach * back
            end = self._start_t + self._shown_at
            found = self._reader.messages((self._steps_by,), start=begin, end=end)
            before = [_arrival(m) - self._start_t for m in found]
            if len(before) >= back or begin <= self._start_t:
                break
        self._seek_to = before[-back] if len(before) >= back else 0.0

    def _play_from(self, start: float) -> None:
        self._forget()
        self._change_reference()
        self._position, self._images_due = start, 1
        begin = self._start_t + start
        for track in (self._truth, self._reference):
            if track is not None:
                track.seek(begin - LEAD_IN_S)
        for message in self._reader.messages(start=begin - LEAD_IN_S):
            place = _arrival(message) - self._start_t
            if place >= start and not self._wait_for(place):
                return
            self._take(message, place >= start)
        self._ended(self.duration)

    def _change_reference(self) -> None:
        """Here and nowhere else, so that no track is closed while it is read."""
        if self._reference is not self._reference_wanted:
            if self._reference is not None:
                self._reference.close()
            self._reference, self._reference_pose = self._reference_wanted, None

    def _take(self, message: Message, due: bool) -> None:
        """``due``: not of the time before the place that was asked for."""
        if isinstance(message, ImuSample):
            self._imu.append(message)
            while self._imu[-1].t - self._imu[0].t > HISTORY_S:
                self._imu.popleft()
        elif isinstance(message, Estimate):
            self._take_estimate(message)
            self._shown(message, due)
        elif isinstance(message, StereoFrame):
            self._images[message.t] = message
            while len(self._images) > IMAGES_WAITING:
                self._images.pop(next(iter(self._images)))
        elif isinstance(message, BlobFrame):
            self._take_blobs(message)
            self._shown(message, due)
        elif isinstance(message, Calibration):
            self._calibration = message
        elif isinstance(message, Status):
            self._status = message
        elif isinstance(message, Event) and due:
            self._events.append(message)

    def _take_estimate(self, estimate: Estimate) -> None:
        self._estimate = estimate
        if self._truth is not None:
            self._truth.advance(estimate.t)
            self._true_pose = self._truth.pose(estimate.t)
        if self._reference is not None:
            self._reference.advance(estimate.t)
            self._reference_pose = self._reference.pose(estimate.t)

    def _take_blobs(self, blobs: BlobFrame) -> None:
        image = self._images.pop(blobs.t, None)
        if image is None:
            image = StereoFrame(blobs.t, blobs.t_arrival, None, None, blobs.pose, blobs.index)
        tracking = self._estimate.tracking if self._estimate else Tracking.SEARCHING
        self._frame = (image, blobs, FrameResult.nothing(blobs.t, tracking, self._markers))

    def _shown(self, message: Message, due: bool) -> None:
        if due and isinstance(message, self._steps_by):
            self._shown_at = _arrival(message) - self._start_t
            self._images_due = max(0, self._images_due - 1)


def _arrival(message: Message) -> float:
    return float(getattr(message, "t_arrival", message.t))


def open_replay(path: Path, progress: JobProgress) -> EngineSetup:
    """Open a session file for the window. Raises FileError in words."""
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
        truth=engine.truth if engine.has_truth else None,
        simulated=info.simulated,
        player=engine,
    )
