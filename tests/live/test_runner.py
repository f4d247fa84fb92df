"""The live tracker with a simulated glove and camera as direct objects."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator, Sequence

import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.live.runner import TIMEOUT, LiveTracker
from tracker.messages import (
    BlobFrame,
    EngineState,
    Estimate,
    Event,
    ImuSample,
    Message,
    StereoFrame,
    Tracking,
)
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import ColourProfile, load_profile
from tracker.vision.detector import Detector


class Stream:
    """Delivers simulated messages as fast as requested, in their order."""

    def __init__(self, sim: Simulation) -> None:
        self._lock = threading.Condition()
        self._messages = sim.feed(images=True)
        self._next = next(self._messages, None)
        self.last_t = 0.0  # s, of the IMU samples taken

    def take(self, kind: type, timeout: float) -> ImuSample | StereoFrame | None:
        with self._lock:
            self._lock.wait_for(lambda: isinstance(self._next, kind), timeout)
            if not isinstance(self._next, kind):
                return None
            out, self._next = self._next, next(self._messages, None)
            if isinstance(out, ImuSample):
                self.last_t = out.t
            self._lock.notify_all()
            return out

    @property
    def done(self) -> bool:
        return self._next is None


class Glove:
    def __init__(self, stream: Stream) -> None:
        self._stream, self.closed = stream, False

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        sample = self._stream.take(ImuSample, timeout)
        return [sample] if sample else []

    def close(self) -> None:
        self.closed = True


class Camera:
    def __init__(self, stream: Stream) -> None:
        self._stream, self.closed = stream, False

    def read(self, timeout: float) -> StereoFrame | None:
        return self._stream.take(StereoFrame, timeout)

    def drain_events(self) -> Sequence[Event]:
        return []

    def close(self) -> None:
        self.closed = True


class BrokenCamera(Camera):
    def read(self, timeout: float) -> StereoFrame | None:
        raise ZeroDivisionError


class Tape:
    """A recorder in memory; ``limit`` messages fit on its disk."""

    def __init__(self, limit: int = 10**9) -> None:
        self.messages: list[Message] = []
        self.closed, self._limit = False, limit

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        if len(self.messages) >= self._limit:
            raise FileError("The disk is full.")
        self.messages.append(message)
        return True

    def flush(self) -> None:
        pass

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 1, duration=2.0), 1, fps=30)


@pytest.fixture
def profile() -> ColourProfile:
    return load_profile(RESOURCES / "colours" / "fabric-default.toml")


@pytest.fixture(autouse=True)
def no_thread_is_left() -> Iterator[None]:
    yield
    assert not [t.name for t in threading.enumerate() if t.name.startswith("glovetrack-")]


def live(
    sim: Simulation,
    profile: ColourProfile,
    tape: Tape | None,
    glove: type[Glove] = Glove,
    camera: type[Camera] = Camera,
) -> tuple[LiveTracker, Stream]:
    stream = Stream(sim)
    tracker = LiveTracker(
        Hands({"right": lambda: Pipeline(sim.hand, sim.glove, sim.rig)}),
        profile,
        lambda p: Detector(p, fx=sim.rig.fx),
        {"right": glove(stream)},
        camera(stream),
        tape,
    )
    return tracker, stream


def reached(tracker: LiveTracker, t: float) -> bool:
    """Whether there is an estimate of ``t`` s."""
    estimate = tracker.hand("right").latest_estimate()
    return estimate is not None and estimate.t >= t


def run_to_the_end(tracker: LiveTracker, stream: Stream) -> None:
    tracker.start()
    deadline = time.monotonic() + 100
    while not stream.done and time.monotonic() < deadline:
        time.sleep(0.01)
    while not reached(tracker, stream.last_t) and time.monotonic() < deadline:
        time.sleep(0.01)
    last = -1
    while last != len(tracker.hand("right").recent_imu()):  # until the inbox is empty
        last = len(tracker.hand("right").recent_imu())
        time.sleep(0.2)


def test_a_recording_gives_the_same_states_again(sim: Simulation, profile: ColourProfile) -> None:
    tape = Tape()
    tracker, stream = live(sim, profile, tape)
    run_to_the_end(tracker, stream)
    estimate, status = tracker.hand("right").latest_estimate(), tracker.hand("right").status()
    tracker.stop()
    tracker.stop()
    assert tape.closed and estimate is not None and estimate.tracking == Tracking.TRACKING
    assert status.values["latency_detect_ms"] > 0 and status.values["imu_lost"] == 0

    fed = [m for m in tape.messages if isinstance(m, ImuSample | BlobFrame)]
    order = sorted(fed, key=lambda m: (m.t_arrival, isinstance(m, BlobFrame)))
    assert all(a is b for a, b in zip(fed, order, strict=True))
    again = Pipeline(sim.hand, sim.glove, sim.rig)
    estimates = []
    for message in order:
        if isinstance(message, ImuSample):
            estimates.append(again.feed_imu(message))
        else:
            again.feed_frame(message)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    assert len(recorded) == len(estimates) > 150
    for a, b in zip(recorded, estimates, strict=True):
        assert np.array_equal(a.keypoints, b.keypoints, equal_nan=True)


def test_a_full_disk_stops_the_recording_but_not_tracking(
    sim: Simulation, profile: ColourProfile
) -> None:
    tape = Tape(limit=50)
    tracker, stream = live(sim, profile, tape)
    run_to_the_end(tracker, stream)
    events = tracker.drain_events()
    estimate = tracker.hand("right").latest_estimate()
    tracker.stop()
    assert tape.closed and estimate is not None and estimate.t > 1.5
    assert [e.code for e in events if e.kind == "error"] == ["recording.ended"]


class SlowTape(Tape):
    """Closing it blocks until released."""

    def __init__(self) -> None:
        super().__init__()
        self.let_go = threading.Event()

    def close(self) -> None:
        self.let_go.wait(120)
        super().close()


def test_closing_a_recording_has_a_timeout(sim: Simulation, profile: ColourProfile) -> None:
    slow = SlowTape()
    tracker, stream = live(sim, profile, slow)
    run_to_the_end(tracker, stream)
    began = time.monotonic()
    tracker.set_recorder(None)
    assert time.monotonic() - began < TIMEOUT + 60.0  # not the 120 s that closing would take
    assert not slow.closed
    slow.let_go.set()
    tracker.stop()  # waits for the end
    assert slow.closed
    codes = [e.code for e in tracker.drain_events() if e.kind == "recording"]
    assert codes[-1] == "recording.finished"


def test_devices_are_not_blocked_by_a_slow_disk(sim: Simulation, profile: ColourProfile) -> None:
    freed: list[bool] = []

    class Freed(Camera):
        def close(self) -> None:
            freed.append(True)

    slow = SlowTape()
    tracker, stream = live(sim, profile, slow, camera=Freed)
    run_to_the_end(tracker, stream)
    began = time.monotonic()
    tracker.stop(TIMEOUT)
    assert time.monotonic() - began < TIMEOUT + 60.0
    assert freed and not slow.closed
    slow.let_go.set()
    tracker.stop()  # waits for the end
    assert slow.closed


def test_a_failing_device_is_reported(sim: Simulation, profile: ColourProfile) -> None:
    tracker, _ = live(sim, profile, None, camera=BrokenCamera)
    tracker.start()
    reported, deadline = list(tracker.drain_events()), time.monotonic() + 60
    while "thread.failed" not in [e.code for e in reported]:
        assert time.monotonic() < deadline
        time.sleep(0.01)
        reported += tracker.drain_events()
    tracker.stop()


def test_the_engine_can_be_changed_while_running(sim: Simulation, profile: ColourProfile) -> None:
    tracker, stream = live(sim, profile, None)
    tracker.start()
    deadline = time.monotonic() + 60
    while tracker.hand("right").latest_estimate() is None and time.monotonic() < deadline:
        time.sleep(0.01)
    tracker.set_engine("madgwick")
    while not stream.done and time.monotonic() < deadline:
        time.sleep(0.01)
    while not reached(tracker, stream.last_t) and time.monotonic() < deadline:
        time.sleep(0.01)
    estimate, events = tracker.hand("right").latest_estimate(), tracker.drain_events()
    tracker.stop()
    assert tracker.settings.engine == "madgwick"
    assert notice("engine.changed", engine="madgwick") in [e.notice for e in events]
    assert estimate is not None and estimate.t > 1.5


def test_a_recording_started_while_tracking_contains_the_engines_state(
    sim: Simulation, profile: ColourProfile
) -> None:
    tape = Tape()
    tracker, stream = live(sim, profile, None)
    tracker.start()
    hand = tracker.hand("right")
    while not hand.latest_estimate() or hand.latest_estimate().t < 1.0:
        time.sleep(0.01)
    tracker.set_recorder(tape)
    while not stream.done:
        time.sleep(0.01)
    tracker.stop()
    began = tape.messages[0]
    assert isinstance(began, EngineState) and began.engine == "chain"
    again, estimates = Pipeline(sim.hand, sim.glove, sim.rig), []
    again.set_state(began.state)
    for m in tape.messages:
        if isinstance(m, ImuSample | BlobFrame):
            assert m.t_arrival >= began.t
        if isinstance(m, ImuSample):
            estimates.append(again.feed_imu(m))
        elif isinstance(m, BlobFrame):
            again.feed_frame(m)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    assert len(recorded) == len(estimates) > 20
    for a, b in zip(recorded, estimates, strict=True):
        assert np.array_equal(a.keypoints, b.keypoints, equal_nan=True)
