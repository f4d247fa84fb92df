"""Opens an engine in a process of its own."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from multiprocessing.connection import Connection

from app.engines.apart.devices import ApartCamera, ApartControls, ApartFile, ApartGlove
from app.engines.apart.hand import ApartHand
from app.engines.apart.messages import Estimated, HandFacts, Opened, Received
from app.engines.apart.pixels import PixelReader
from app.engines.apart.process import EngineProcess, process_ended
from app.engines.apart.source import Source
from app.engines.engine import EngineSetup, LivePart
from app.engines.protocols import RecordedFile, RecordingRequest
from app.platform.tasks import JobProgress
from tracker.base.channels import Fifo
from tracker.base.clock import monotonic
from tracker.base.errors import DeviceError, notice_of
from tracker.base.notices import Notice
from tracker.live.frame_results import MOST_SHOWN
from tracker.live.journal import EVENTS_STORED
from tracker.live.listeners import ListenedHand, Listeners, LiveAccess, local_kinds
from tracker.live.work_priority import WorkPriority
from tracker.messages import Event, StereoFrame
from tracker.vision.colours import ColourProfile


def apart_factory(
    source: Source,
    started: EngineProcess | None = None,
    open_process: Callable[[Source], EngineProcess] = EngineProcess,
) -> Callable[[JobProgress], EngineSetup]:
    """A job that builds the engine of ``source`` in a process; ``started`` is one that began to do
    so already, and is used once; others are made by ``open_process``."""
    waiting = [started] if started is not None else []

    def build(progress: JobProgress) -> EngineSetup:
        process = waiting.pop() if waiting else open_process(source)
        try:
            return apart_setup(process, process.wait_opened(progress))
        except BaseException:  # also Cancelled: no process may remain
            process.kill()
            raise

    return build


def apart_setup(process: EngineProcess, opened: Opened) -> EngineSetup:
    """The engine that ``process`` has built."""
    engine = ApartEngine(process, opened.hands[0].profile)
    facts = {hand.glove.side: hand for hand in opened.hands}
    report = partial(engine.report, "error")
    hands = {side: ApartHand(process, side, Listeners(report)) for side in facts}
    gloves = {
        side: ApartGlove(process, side, hand.device)
        for side, hand in facts.items()
        if hand.device is not None
    }
    fps = opened.hands[0].fps
    parts = Parts(hands, gloves, ApartCamera(fps) if fps is not None else None)
    added = process.source.companions(opened, partial(process.tell, "wearer", "send"))
    controls = ApartControls(process) if opened.hands[0].has_controls else None

    def close() -> None:
        added.close()
        process.close()

    def seen_from(side: str, hand: HandFacts) -> EngineSetup:
        device = gloves.get(side)
        _attach(hands[side], hand, device)
        make_recorder = partial(engine.make_recorder, side)
        return EngineSetup(
            name=hand.name,
            engine=engine,
            tracked=hands[side],
            hand=hand.hand,
            glove=hand.glove,
            camera=replace(hand.camera, device=parts.camera, controls=controls),
            profile=hand.profile,
            close=close,
            connection=replace(hand.connection, device=device),
            live=LivePart(engine, hands[side], make_recorder, added.wearer, engine),
            simulated=hand.simulated,
            truth=added.truths.get(side),
            listeners=hands[side].listeners.by_name,
            application=hand.application,
            missing=hand.missing,
            anchor=hand.anchor,
        )

    setups = [seen_from(side, hand) for side, hand in facts.items()]
    engine.begin(parts)
    return replace(setups[0], others=tuple(setups[1:]))


def _attach(hand: ApartHand, facts: HandFacts, device: ApartGlove | None) -> None:
    """Attach what other packages declare to the hand, here or in the process that tracks."""
    vibrate = device.vibrate if device is not None else None
    live = LiveAccess(hand.record, hand.telemetry, monotonic, hand.work_priority, vibrate)
    hand.listeners.attach(ListenedHand(facts.hand, facts.glove, live), local_kinds())
    hand.listeners.attach_proxies(hand.line_to)


# ---- an engine in another process, as the window sees it

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
        self._events: Fifo[Event] = Fifo(EVENTS_STORED)
        self._failure: Notice | None = None
        self._stopped = False
        self._keys = itertools.count(1)
        self._reader = PixelReader()
        self._images: dict[float, StereoFrame] = {}
        self._parts = Parts({}, {}, None)
        self._hands: list[ApartHand] = []
        self.work_priority = WorkPriority()  # the engine does not compete with this process

    def begin(self, parts: Parts) -> None:
        """Pass on what arrives from now on."""
        self._parts, self._hands = parts, list(parts.hands.values())
        self._process.on_estimate, self._process.on_update = self._take_estimate, self._take
        self._process.on_failure, self._process.on_end = self._fail, self._end
        self._process.begin_updates()

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
        for side, hand_update in news.hands.items():
            self._parts.hands[side].take_update(hand_update, self._images)
            if hand_update.device is not None and side in self._parts.gloves:
                self._parts.gloves[side].news = hand_update.device
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

    def stop(self, timeout: float | None = None) -> None:
        """A process that does not stop in time completes its recording in the background."""
        if self._stopped:
            return
        self._stopped = True
        wait = LONGEST_STOP if timeout is None else STOP_WAIT + timeout
        try:
            self._process.ask("engine", "stop", timeout, wait=wait, parallel=True)
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
