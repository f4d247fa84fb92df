"""An engine in another process, as the window sees it."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from multiprocessing.connection import Connection

from app.engines.apart.devices import ApartCamera, ApartFile, ApartGlove
from app.engines.apart.hand import ApartHand
from app.engines.apart.messages import Estimated, Received
from app.engines.apart.pixels import PixelReader
from app.engines.apart.process import EngineProcess, process_ended
from app.engines.protocols import RecordedFile, RecordingRequest
from tracker.base.channels import Fifo
from tracker.base.clock import monotonic
from tracker.base.errors import DeviceError, notice_of
from tracker.base.notices import Notice
from tracker.live.frame_results import MOST_SHOWN
from tracker.live.journal import EVENTS_KEPT
from tracker.live.right_of_way import RightOfWay
from tracker.messages import Event, StereoFrame
from tracker.vision.colours import ColourProfile

STOP_WAIT = 1.8  # s that the window waits for threads and devices there to stop
OPEN_WAIT = 40.0  # s, longer than the recorder's process has to begin a file
LONGEST_STOP = 100.0  # s, if the end of a recording is waited for


@dataclass(eq=False)
class Parts:
    """What the news are for."""

    hands: Mapping[str, ApartHand]
    gloves: Mapping[str, ApartGlove]
    camera: ApartCamera | None
    files: dict[int, ApartFile] = field(default_factory=dict)


class ApartEngine:
    """`LiveEngine`."""

    def __init__(self, process: EngineProcess, profile: ColourProfile) -> None:
        self._process, self._profile = process, profile
        self._profiles = 0  # changes by the user
        self._events: Fifo[Event] = Fifo(EVENTS_KEPT)
        self._failure: Notice | None = None
        self._stopped = False
        self._keys = itertools.count(1)
        self._reader = PixelReader()
        self._images: dict[float, StereoFrame] = {}
        self._parts = Parts({}, {}, None)
        self._hands: list[ApartHand] = []
        self.right_of_way = RightOfWay()  # the engine does not compete with this process

    def begin(self, parts: Parts) -> None:
        """Pass on what arrives from now on."""
        self._parts, self._hands = parts, list(parts.hands.values())
        self._process.on_estimate, self._process.on_news = self._take_estimate, self._take
        self._process.on_failure, self._process.on_end = self._fail, self._end
        self._process.begin_news()

    # --- what arrives

    def _take_estimate(self, item: Estimated) -> None:
        self._hands[item.hand].take(item)

    def _take(self, received: Received) -> None:
        news = received.news
        if received.memory:
            self._reader.open(received.memory)
        if news.pixels is not None:
            image = self._reader.take(news.pixels)
            newest = list(self._images.items())[1 - MOST_SHOWN :]
            self._images = {**dict(newest), image.t: image}
        for side, hand_news in news.hands.items():
            self._parts.hands[side].take_news(hand_news, self._images)
            if hand_news.device is not None and side in self._parts.gloves:
                self._parts.gloves[side].news = hand_news.device
        for event in news.events:
            self._events.put(event)
        if news.profile is not None and news.profiles == self._profiles:
            self._profile = news.profile
        if self._parts.camera is not None:
            self._parts.camera.unfit = news.unfit
        if news.failure is not None:
            self._fail(news.failure)
        for key, file in list(self._parts.files.items()):
            if key in news.files:
                file.take(news.files[key])
                if file.closed:
                    self._forget(key)

    def _forget(self, key: int) -> None:
        self._parts.files.pop(key, None)
        self._process.tell("files", "forget", key)

    def _fail(self, why: Notice) -> None:
        self._failure = self._failure or why

    def _end(self) -> None:
        """The process has ended."""
        if not self._stopped:
            self._fail(process_ended())
        for file in list(self._parts.files.values()):
            file.end()
        self._reader.close()

    # --- WindowEngine

    def start(self) -> None:
        self._process.ask("engine", "start")

    def stop(self, patience: float | None = None) -> None:
        """A process that does not stop in time completes its recording in the background."""
        if self._stopped:
            return
        self._stopped = True
        wait = LONGEST_STOP if patience is None else STOP_WAIT + patience
        try:
            self._process.ask("engine", "stop", patience, wait=wait, parallel=True)
        except DeviceError as error:
            self._events.put(Event.of(monotonic(), "error", notice_of(error)))
        for hand in self._parts.hands.values():
            hand.listeners.close()

    def drain_events(self) -> list[Event]:
        """Called at each refresh of the window."""
        self._process.refreshed()
        return self._events.drain()

    def report(self, kind: str, what: Notice) -> None:
        """Shows and records a notice of the window's process."""
        event = Event.of(monotonic(), kind, what)
        self._events.put(event)
        for hand in list(self._parts.hands.values())[:1]:
            hand.record(event)

    @property
    def profile(self) -> ColourProfile:
        return self._profile

    def set_profile(self, profile: ColourProfile) -> None:
        self._profiles += 1
        self._profile = profile
        self._process.tell("engine", "set_profile", profile)

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        self._process.tell("engine", "note", text, monotonic() if t is None else t, data)

    # --- LiveEngine

    @property
    def failure(self) -> Notice | None:
        return self._failure

    def set_engine(self, name: str) -> None:
        """Raises ConfigError for an unknown name."""
        self._process.ask("engine", "set_engine", name)

    def make_recorder(self, side: str, request: RecordingRequest) -> ApartFile:
        """Begin a file. Raises GlovetrackError or OSError."""
        key = next(self._keys)
        self._process.ask("files", "open", side, key, request, wait=OPEN_WAIT, parallel=True)
        file = self._parts.files[key] = ApartFile(self._process, key)
        if self._process.ended.is_set():  # meanwhile
            file.end()
        return file

    def set_recorder(self, recorder: RecordedFile | None) -> None:
        """Record into a file of `make_recorder`; None: end the recording, in the background."""
        key = recorder.key if isinstance(recorder, ApartFile) else 0
        self._process.ask_or(None, "engine", "record_into", key)
        if key:
            for hand in self._parts.hands.values():
                hand.listeners.restart()

    def pass_on(self, line: Connection, sides: Sequence[str]) -> Callable[[], None]:
        """See `app.engines.engine.PassesOn`."""
        self._process.ask_or(None, "streams", "begin", line, tuple(sides))
        line.close()
        return partial(self._process.tell, "streams", "end")

    def keep_state(self) -> None:
        self._process.tell("engine", "keep_state")
