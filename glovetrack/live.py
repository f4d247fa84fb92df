"""Live tracking: devices in, an iterator of estimates out."""

from __future__ import annotations

import time
import weakref
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import TracebackType

import numpy as np

from glovetrack.devices import (
    ConnectedGlove,
    Devices,
    glove_devices,
    with_camera,
)
from glovetrack.recorded import RecordedEvent
from tracker.base.channels import Backlog, Closed
from tracker.base.clock import ClockAnchor, monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, notice
from tracker.base.numeric_threads import one_numeric_thread
from tracker.engine.hands import Hands
from tracker.engine.kinds import WITHOUT_CAMERA, settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.live.runner import LiveTracker as Runner
from tracker.messages import Array, Tracking, Validity
from tracker.messages import Estimate as Message
from tracker.session.description import SessionInfo, describe, of_hands
from tracker.session.writer import SessionRecorder
from tracker.streaming.attach import attach
from tracker.streaming.publisher import Names
from tracker.streaming.registry import StreamSettings, open_streams, with_streams
from tracker.vision.colours import ColourProfile, parse_profile, profile_to_toml
from tracker.vision.detector import Detector

QUEUED = 500
"""Estimates that wait to be read; beyond that the oldest are discarded and counted."""


@dataclass(frozen=True, eq=False)
class Estimate:
    """A hand at ``t`` (s of the computer's monotonic clock).

    ``tracking`` is ``searching``, ``tracking``, ``coasting`` or ``lost``. Positions are in the
    global frame G (z up), in m, angles in rad; lost values are NaN.
    """

    side: str
    t: float
    t_unix_ns: int
    tracking: str
    keypoint_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    message: Message

    def __repr__(self) -> str:
        return f"<Estimate of the {self.side} hand, t = {self.t:.3f} s, {self.tracking}>"

    @property
    def keypoints(self) -> Mapping[str, Array]:
        """``p_G`` (3,) m by keypoint name."""
        return dict(zip(self.keypoint_names, self.message.keypoints, strict=True))

    @property
    def sd(self) -> Mapping[str, float]:
        """Standard deviation of each position, m."""
        return dict(zip(self.keypoint_names, map(float, self.message.keypoint_sd), strict=True))

    @property
    def state(self) -> Mapping[str, str]:
        """``measured``, ``inferred`` or ``lost`` for each keypoint."""
        names = (Validity(int(s)).name.lower() for s in self.message.keypoint_state)
        return dict(zip(self.keypoint_names, names, strict=True))

    @property
    def angles(self) -> Mapping[str, float]:
        """Joint angles by name, rad."""
        return dict(zip(self.joint_names, map(float, self.message.angles), strict=True))


class LiveTracker:
    """Tracks on live devices in a ``with``; iterating over it gives each new estimate.

    ::

        with LiveTracker.simulated(seed=1) as live:
            for estimate in live:
                print(estimate.t, estimate.keypoints["index_tip"])

    Estimates of all hands are in one stream; ``estimate.side`` is the hand of each. An estimate
    that is not read in time is discarded, and counted in `discarded`. While the tracker runs,
    BLAS uses one thread in this process.
    """

    def __init__(self, devices: Devices, engine: str = "", colours: str = "") -> None:
        """``engine``: ``chain`` with a camera and ``inertial`` without by default; ``colours``: the
        name or path of a colour profile. Raises ConfigError and FileError."""
        self._devices = devices
        self._end_devices = weakref.finalize(self, devices.end)
        try:
            self._set_up(engine, colours)
        except BaseException:  # Ctrl+C too must not leave devices running
            self._end_devices()
            raise

    def _set_up(self, engine: str, colours: str) -> None:
        devices = self._devices
        profile = parse_profile(library.text("colours", colours or library.DEFAULT_COLOURS))
        engine = engine or ("chain" if devices.rig is not None else WITHOUT_CAMERA)
        settings = Settings(engine=engine)
        self._anchor = ClockAnchor(time.time_ns(), time.monotonic_ns())
        infos = [self._about(glove, settings, profile) for glove in devices.gloves]
        self._info = of_hands(infos)
        self._names = {i.side: (i.keypoint_names, i.hand.joint_names) for i in infos}
        self._queue: Backlog[Estimate] = Backlog(QUEUED)
        self._tracker = self._assembled(infos, profile, settings)
        self._open = ExitStack()
        self._entered = False

    @classmethod
    def simulated(
        cls, seed: int = 1, *, fps: float = 30.0, hands: str = "right", camera: bool = True,
        engine: str = "",
    ) -> LiveTracker:  # fmt: skip
        """On a simulated wearer, glove and camera, which run in processes of their own.

        ``hands``: ``right``, ``left`` or ``both``; without a ``camera`` the hand has no position.
        """
        from glovetrack.simulated_devices import simulated_devices  # deferred: the simulator

        return cls(simulated_devices(seed, fps, hands, camera), engine)

    @classmethod
    def from_devices(
        cls, port: str = "", *, camera: str | int | None = None, calibration: str | Path = "",
        glove: str = library.DEFAULT_GLOVE, hand: str = "", engine: str = "", colours: str = "",
    ) -> LiveTracker:  # fmt: skip
        """On a real glove and, with its ``calibration`` file, a real stereo camera.

        ``port``: the glove's serial port, else the first one where a glove answers; ``camera``: its
        number, the address of a stream or ``driver://id`` of a plug-in; ``glove``, ``hand``,
        ``colours``: names or paths of files. Raises DeviceError where no glove answers, ConfigError
        where a camera has no calibration.
        """
        devices = glove_devices(port, glove, hand)
        if camera is not None:
            devices = with_camera(devices, camera, calibration)
        return cls(devices, engine, colours)

    def __enter__(self) -> LiveTracker:
        """Start the devices and the tracker. Raises RuntimeError if they were started before."""
        if self._entered or not self._end_devices.alive:
            raise RuntimeError("a LiveTracker can be entered once; create another one")
        self._entered = True
        self._open.enter_context(one_numeric_thread())
        self._open.callback(self._end_devices)
        self._open.callback(self._tracker.stop)
        for side in self._names:
            self._tracker.hand(side).subscribe(partial(self._put, side))
        try:
            self._devices.begin()
            self._tracker.start()
        except BaseException:  # a `with` does not close what was not entered
            self.close()
            raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Stop tracking, finish a recording, free the devices. May be called again."""
        self._queue.close()
        self._open.close()
        self._end_devices()

    def __iter__(self) -> Iterator[Estimate]:
        """Each estimate once, in order of time, until the tracker is closed."""
        while True:
            try:
                estimate = self._queue.get(None)
            except Closed:
                return
            if estimate is not None:
                yield estimate

    def next(self, timeout: float = 1.0) -> Estimate | None:
        """Returns the next estimate; None if none arrives within ``timeout`` s or after `close`."""
        try:
            return self._queue.get(timeout)
        except Closed:
            return None

    @property
    def discarded(self) -> int:
        """Estimates that were not read in time."""
        return self._queue.dropped

    def latest(self, side: str = "") -> Estimate | None:
        """Returns the latest estimate; None before the first packet. With two hands, ``side`` is
        required."""
        (first, *others) = self._names
        if others and not side:
            raise ConfigError(notice("api.two_hands"))
        chosen = side or first
        message = self._tracker.hand(chosen).latest_estimate()
        return None if message is None else self._named(chosen, message)

    def note(self, text: str) -> None:
        """A note, stamped now, for the recording and the events."""
        self._tracker.note(text)

    def take_events(self) -> tuple[RecordedEvent, ...]:
        """What happened since the last call, at s of the monotonic clock."""
        return tuple(RecordedEvent.of(e, e.t) for e in self._tracker.drain_events())

    def publish(
        self,
        streams: str | StreamSettings,
        *,
        host: str = "",
        joints: str = "",
        say: Callable[[str], None] = lambda text: None,
    ) -> None:
        """Send every estimate to ``streams`` until the tracker is closed.

        ``streams``: as on the command line (``"udp,vmc:39541"``) or settings. ``host`` and
        ``joints`` (``own`` or ``openxr``) replace those of the settings. ``say`` is called with a
        message when a stream fails or recovers. Raises ConfigError for an unknown stream and
        StreamError for one that cannot be opened.
        """
        settings, named = StreamSettings(), streams
        if isinstance(streams, StreamSettings):
            settings, named = streams, ""
        settings = with_streams(settings, str(named), host, joints)
        infos = self._info.hands

        def report(what: Notice) -> None:
            say(str(what))

        names = [Names.of(info.hand, info.glove, settings.joints, self._anchor) for info in infos]
        for publishers in open_streams(settings, names).values():
            for info, publisher in zip(infos, publishers, strict=True):
                attachment = attach(self._tracker.hand(info.side), [publisher], report=report)
                self._open.callback(attachment.close)

    @contextmanager
    def recording(self, path: str | Path) -> Iterator[Path]:
        """Record for the time of a ``with``; the file is whole after it.

        Raises FileError where the file exists or cannot be written.
        """
        info = replace(self._info, anchor=self._anchor.at(monotonic()))
        recorder = SessionRecorder(Path(path), info)
        self._tracker.set_recorder(recorder)
        try:
            yield recorder.path
        finally:
            self._tracker.set_recorder(None, timeout=None)

    # ---- inside

    def _put(self, side: str, message: Message) -> None:
        self._queue.put(self._named(side, message))

    def _named(self, side: str, message: Message) -> Estimate:
        word = Tracking(message.tracking).name.lower()
        unix = self._anchor.wall(message.t)
        return Estimate(side, message.t, unix, word, *self._names[side], message)

    def _about(
        self, glove: ConnectedGlove, settings: Settings, profile: ColourProfile
    ) -> SessionInfo:
        return describe(
            glove.hand_text,
            glove.glove_text,
            self._anchor,
            rig=self._devices.rig,
            colours_text=profile_to_toml(profile),
            settings_text=settings_text(settings),
            engine=settings.engine,
            simulated=self._devices.simulated,
        )

    def _assembled(
        self, infos: list[SessionInfo], profile: ColourProfile, settings: Settings
    ) -> Runner:
        rig = self._devices.rig
        make = {i.side: partial(Pipeline, i.hand, i.glove, rig, settings) for i in infos}
        hands = Hands(make)
        pipeline = hands.pipelines[infos[0].side]
        size = float(np.mean(infos[0].glove.marker_size))

        def make_detector(colours: ColourProfile) -> Detector:
            return Detector(colours, size, pipeline.rig.fx)

        gloves = {i.side: w.source for i, w in zip(infos, self._devices.gloves, strict=True)}
        return Runner(hands, profile, make_detector, gloves, self._devices.camera)
