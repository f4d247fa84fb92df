"""Live tracking recorded by another process from the middle on, tracked again."""

from __future__ import annotations

import time

from tests.fixtures import RESOURCES
from tests.live.test_runner import Camera, Glove, Stream, profile, sim
from tracker.base.clock import ClockAnchor
from tracker.base.config import to_toml
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.live.runner import LiveTracker
from tracker.messages import BlobFrame, Estimate, ImuSample, StereoFrame
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader
from tracker.session.recording.process import RecorderProcesses
from tracker.session.verify import is_ok, verify
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector

__all__ = ["profile", "sim"]  # fixtures


def about(sim: Simulation, tracker: LiveTracker) -> SessionInfo:
    return SessionInfo(
        hand=sim.hand,
        glove=sim.glove,
        hand_text=(RESOURCES / "hands" / "reference-right.toml").read_text(),
        glove_text=(RESOURCES / "gloves" / "vist-small.toml").read_text(),
        anchor=ClockAnchor(10**18, 0),
        rig=sim.rig,
        colours_text=(RESOURCES / "colours" / "fabric-default.toml").read_text(),
        settings_text=to_toml(tracker.settings),
    )


def until(t: float, tracker: LiveTracker, stream: Stream) -> None:
    deadline = time.monotonic() + 100
    while not stream.done and time.monotonic() < deadline:
        estimate = tracker.hand("right").latest_estimate()
        if estimate is not None and estimate.t >= t:
            return
        time.sleep(0.01)


def test_a_recording_started_in_the_middle_is_bit_identical(
    tmp_path, sim: Simulation, profile: ColourProfile
) -> None:
    stream, recorded, again = Stream(sim), tmp_path / "a.mcap", tmp_path / "b.mcap"
    tracker = LiveTracker(
        Hands({"right": lambda: Pipeline(sim.hand, sim.glove, sim.rig)}),
        profile,
        lambda p: Detector(p, fx=sim.rig.fx),
        {"right": Glove(stream)},
        Camera(stream),
        clock=lambda: 2.0,
    )
    processes = RecorderProcesses()
    recorder = processes.record(
        recorded, about(sim, tracker)
    )  # the stream does not wait for a process
    tracker.start()
    try:
        until(0.8, tracker, stream)
        tracker.set_recorder(recorder)
        until(1e9, tracker, stream)
    finally:
        tracker.stop()
        processes.close()
    assert not [e.text for e in tracker.drain_events() if e.kind == "error"]
    assert is_ok(verify(recorded))
    with SessionReader(recorded) as reader:
        kinds = [type(m) for m in reader.messages()]
    assert kinds.count(ImuSample) == kinds.count(Estimate) > 30
    assert StereoFrame in kinds and BlobFrame in kinds
    track(recorded, again)
    found = compare(recorded, again)
    assert found["identical"] and found["compared"] == kinds.count(Estimate)
