"""The live streams of the window: which are open, on which engine, and their statistics.

Each stream is attached to the engine separately, so that it can be switched without the others.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.connections import Connections, remembered
from app.jobs.openings import Openings
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore, sessions_folder
from app.words import shown, tr
from tracker.base.files import free_path
from tracker.base.notices import Notice, warning
from tracker.messages import Event, Validity
from tracker.streaming.apart import ApartStream, StreamsProcess, feed
from tracker.streaming.attach import Attachment, attach
from tracker.streaming.connection import HOST, key_of
from tracker.streaming.haptics import HapticPublisher, Sphere
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import (
    JOINTS,
    StreamKind,
    StreamSettings,
    open_stream,
    stream_kinds,
)
from tracker.streaming.streams import StreamCounts, delivery, of_all_hands

HAPTICS = "haptics"
TOUCHING = "index_tip"


@dataclass(frozen=True)
class HapticRule:
    """Fingertips inside the sphere vibrate. ``center`` in m in G; empty if not placed."""

    on: bool = False
    radius: float = 0.03  # m
    center: tuple[float, ...] = ()


class HandsOutput:
    """One stream, of all hands; sends once it is attached to the hands' engines."""

    def __init__(self, setup: EngineSetup, publishers: Sequence[Publisher]) -> None:
        self._setup, self._publishers = setup, publishers
        self._attached: list[Attachment] = []
        self.title = publishers[0].name

    def attach(self, report: Callable[[Notice], None]) -> None:
        """Send every estimate from now on; ``report`` is called in another thread."""
        self._attached = [
            attach(hand.tracked, [publisher], report=report)
            for hand, publisher in zip(self._setup.hands, self._publishers, strict=True)
        ]

    def counts(self) -> StreamCounts:
        return of_all_hands([part.counts()[0] for part in self._attached])

    def test(self) -> Notice:
        """Whether a program receives it; may take a second."""
        return delivery(self._publishers[0], self.counts().sent)

    def close(self) -> None:
        """Waits until pending data have been sent."""
        for part in self._attached or self._publishers:
            part.close()


class ApartOutput:
    """As `HandsOutput`, but sent by the process of the streams."""

    def __init__(self, stream: ApartStream, feed: Feed) -> None:
        self._stream, self._feed = stream, feed
        self._fed = False
        self.title = stream.titles[0]

    def attach(self, report: Callable[[Notice], None]) -> None:
        """Send every estimate from now on; ``report`` is called in another thread."""
        self._fed = True
        self._feed.begin()
        self._stream.start(report)

    def counts(self) -> StreamCounts:
        return of_all_hands(self._stream.counts())

    def test(self) -> Notice:
        """Whether a program receives it; may take a second."""
        return self._stream.test()

    def close(self) -> None:
        """Waits until pending data have been sent."""
        self._stream.close()
        if self._fed:
            self._fed = False
            self._feed.end()


class Feed:
    """Passes the estimates of an engine's hands to the process while any stream needs them."""

    def __init__(self, setup: EngineSetup, process: StreamsProcess) -> None:
        self._setup, self._process = setup, process
        self._lock, self._users = threading.Lock(), 0
        self._ends: list[Callable[[], None]] = []

    def begin(self) -> None:
        with self._lock:
            self._users += 1
            if self._users == 1:
                self._ends = self._begun()

    def _begun(self) -> list[Callable[[], None]]:
        """Begin; returns functions that end it."""
        hands, live = self._setup.hands, self._setup.live
        if live is not None and live.apart is not None:
            return [live.apart.pass_on(self._process.open_line(), [hand.side for hand in hands])]
        return [feed(hand.tracked, self._process.line, k) for k, hand in enumerate(hands)]

    def end(self) -> None:
        with self._lock:
            self._users -= 1
            ending, self._ends = (self._ends, []) if not self._users else ([], self._ends)
        for end in ending:
            end()


class ProcessOfStreams:
    """The process that sends streams, started when the first one is opened, and its feed.

    Called in threads of jobs.
    """

    def __init__(self) -> None:
        self._process: StreamsProcess | None = None
        self._feed: tuple[EngineSetup, Feed] | None = None
        self._starting = threading.Lock()

    def for_engine(self, setup: EngineSetup) -> tuple[StreamsProcess, Feed]:
        """The process, and what feeds it with this engine's hands."""
        with self._starting:
            if self._process is None or self._process.ended:
                self._process, self._feed = StreamsProcess(), None
            if self._feed is None or self._feed[0].engine is not setup.engine:
                self._feed = setup, Feed(setup, self._process)
            return self._process, self._feed[1]

    def close(self) -> None:
        if self._process is not None:
            self._process.close()
            self._process = None


class Outputs(Connections[StreamKind[Any], StreamSettings]):
    """Follows the session: streams that are switched on are open while an engine runs."""

    tested = Signal(str, object)  # the name of an output, and a Notice of whether it is received

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        settings = StreamSettings(store.value.streams)
        super().__init__(stream_kinds(), settings, store, "streams", parent)
        self._host, self._tasks = host, tasks
        self.rule = remembered(HapticRule, store.value.haptics)
        self.apart = False
        """Whether streams are sent by a process of their own, which takes a second to start."""
        self._process = ProcessOfStreams()
        self._openings: Openings[HandsOutput | ApartOutput] = Openings(tasks, self.changed.emit)
        self.problems = self._openings.problems
        self.wanted.connect(lambda name: self._apply(name))
        host.running_changed.connect(lambda _on: self._apply())
        host.closed.connect(lambda: self._apply())

    # --- requests of the user

    def use(self, requested: StreamSettings) -> None:
        """Enable the streams of the command line; they are not stored unless a setting is
        changed."""
        for name in requested.on:
            kind = self.kinds[name]
            options = requested.options(kind)
            always = [option for option in ("port", "file") if kind.has(option)]
            asked_for = [o for o in kind.fields if o != HOST and key_of(name, o) in requested.table]
            changes = {key_of(name, o): getattr(options, o) for o in (*always, *asked_for)}
            self.settings = self.settings.changed(**{name: True, **changes})
        for key in (HOST, JOINTS):
            if key in requested.table:
                self.settings = self.settings.changed(**{key: requested.table[key]})

    def set_joints(self, joints: str) -> None:
        """Send our keypoints or OpenXR's joints; running streams are opened again with them."""
        self._change(self._on(), joints=joints)

    def file(self, name: str) -> Path:
        """Where a stream writes to: as chosen, or next to the recordings."""
        kind = self.kinds[name]
        chosen: str = self.settings.options(kind).file
        return Path(chosen) if chosen else sessions_folder(self._store.value) / kind.default_file

    def set_rule(self, rule: HapticRule) -> None:
        """Sets another sphere, or none; one without a position is placed at the index fingertip."""
        if rule.on and not rule.center:
            rule = replace(rule, center=self.fingertip())
        if rule.on and not rule.center:
            rule = replace(rule, on=False)
            self._host.error.emit(
                self.tr("The sphere was not placed: the index fingertip is not visible.")
            )
        self.rule = rule
        self._store.update(haptics={**asdict(rule), "center": list(rule.center)})
        self._apply(HAPTICS)

    def fingertip(self) -> tuple[float, ...]:
        """Position of the index fingertip, m in G; empty if unknown."""
        setup = self._host.setup
        estimate = setup.tracked.latest_estimate() if setup is not None else None
        if setup is None or estimate is None:
            return ()
        row = setup.glove.keypoint_names(setup.hand).index(TOUCHING)
        if estimate.keypoint_state[row] == Validity.LOST:
            return ()
        return tuple(float(x) for x in estimate.keypoints[row])

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> None:
        """Run one motor as a test."""
        setup = self._host.setup
        glove = setup.connection.device if setup is not None else None
        if glove is not None:
            glove.vibrate(channel, amplitude, duration_ms)

    @property
    def can_vibrate(self) -> bool:
        setup = self._host.setup
        has_motors = setup is not None and setup.connection.device is not None
        return has_motors and self._host.running

    def is_on(self, name: str) -> bool:
        return self.rule.on if name == HAPTICS else super().is_on(name)

    def counts(self, name: str) -> StreamCounts | None:
        """Statistics of an open stream; None if it is not open."""
        output = self._openings.get(name)
        return output.counts() if output is not None else None

    def late(self) -> list[float]:
        """s from the instants of the last samples until each open stream has sent their estimates;
        see `StreamCounts`. Without the motors, which are not driven by each estimate."""
        counts = (self.counts(name) for name in self.kinds)
        return [late for found in counts if found is not None for late in found.late]

    def test(self, name: str) -> None:
        """Find out whether a program receives an output; `tested` reports it."""
        output = self._openings.get(name)
        title = tr(self.kinds[name].title)
        if output is None:
            self.tested.emit(name, warning("stream.test_off", stream=title))
            return
        words = self.tr("Testing {}").format(title)
        self._tasks.run(words, lambda _: output.test(), done=lambda n: self.tested.emit(name, n))

    # --- opening and closing

    def _apply(self, *names: str) -> None:
        """Renew streams, all of them without ``names``, and report it once."""
        for name in names or (*self.kinds, HAPTICS):
            self._renew(name)
        self.changed.emit()

    def _renew(self, name: str) -> None:
        """Close a stream and, if an engine runs, reopen it with the current settings."""
        setup = self._wanted_on(name)
        title = tr(self.kinds[name].title) if name in self.kinds else name
        if setup is None:
            self._openings.close(name, self.tr("Closing {}").format(title))
            return
        make, use = partial(self._made, name, setup), partial(self._attach, setup)
        self._openings.renew(name, self.tr("Opening {}").format(title), make, use)

    def _wanted_on(self, name: str) -> EngineSetup | None:
        """The engine that a stream should be attached to."""
        setup = self._host.setup
        if setup is None or not self._host.running or not self.is_on(name):
            return None
        return setup if name != HAPTICS or setup.connection.device is not None else None

    def _made(self, name: str, setup: EngineSetup) -> HandsOutput | ApartOutput:
        """Open one stream. Raises StreamError."""
        if name == HAPTICS:
            sphere = Sphere(np.array(self.rule.center), self.rule.radius)
            return HandsOutput(setup, [_haptic(hand, sphere) for hand in setup.hands])
        kind, options, hands = self._wanted_stream(name, setup)
        if not self.apart:
            return HandsOutput(setup, open_stream(kind, options, hands))
        process, feed = self._process.for_engine(setup)
        return ApartOutput(process.open(kind.name, options, hands), feed)

    def _wanted_stream(
        self, name: str, setup: EngineSetup
    ) -> tuple[StreamKind[Any], Any, list[Names]]:
        """The stream with its options and hands."""
        kind, settings = self.kinds[name], self.settings
        if kind.default_file:
            path = self.file(name)
            path.parent.mkdir(parents=True, exist_ok=True)
            settings = settings.changed(**{key_of(name, "file"): str(free_path(path))})
        hands = [
            Names.of(hand.hand, hand.glove, settings.joints, hand.anchor) for hand in setup.hands
        ]
        return kind, settings.options(kind), hands

    def _attach(self, setup: EngineSetup | None, output: HandsOutput | ApartOutput) -> bool:
        """False if another engine is running by now."""
        now = self._host.setup
        if setup is None or now is None or now.engine is not setup.engine:
            return False
        output.attach(self._report)
        running = self.tr("The stream {} is running.").format(shown(output.title))
        self._host.happened.emit(Event(0.0, "device", running))
        return True

    def _report(self, what: Notice) -> None:
        self._host.happened.emit(Event.of(0.0, "device", what))

    def shut_down(self) -> None:
        """After the last job: close all streams."""
        self._openings.shut_down()
        self._process.close()


def _haptic(setup: EngineSetup, sphere: Sphere) -> Publisher:
    """Drives the motors of the hand's glove, if it is connected."""
    glove = setup.connection.device
    vibrate = glove.vibrate if glove is not None else _no_motors
    return HapticPublisher(Names.of(setup.hand, setup.glove), [sphere], vibrate)


def _no_motors(channel: int, amplitude: int, duration_ms: int) -> bool:
    return False
