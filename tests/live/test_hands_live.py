"""Two hands in one live loop, without threads: tracked, recorded, with one that disconnects."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from tests.engine.test_hands import simulated, two
from tracker.base.clock import ClockAnchor
from tracker.base.config import to_toml
from tracker.engine.hands import Sided
from tracker.glove.library import text
from tracker.live.inbox import DetectedFrame, GuidedCommand, Inbox
from tracker.live.journal import Journal
from tracker.live.loop import LiveLoop
from tracker.live.telemetry import Telemetry
from tracker.messages import Estimate, ImuSample, StereoFrame, Tracking, Validity
from tracker.offline.track import track
from tracker.session.description import describe, of_hands
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify
from tracker.session.writer import SessionRecorder
from tracker.simulation.two_hands import SidedMessage as Simulated
from tracker.simulation.two_hands import TwoHandsSimulation

SIDES = ("left", "right")
FILES = {
    "left": ("reference-left", "vist-small-left"),
    "right": ("reference-right", "vist-small"),
}
START = 100.0  # s of the clock at the start of the simulation


class Live:
    """A loop with a simulation, driven message by message."""

    def __init__(self, sim: TwoHandsSimulation) -> None:
        self.sim, self.now = sim, 0.0
        self.journal = Journal(lambda: self.now)
        self.inbox = Inbox(lambda: self.now)
        self.loop = LiveLoop(
            two(sim), self.journal, Telemetry(), lambda: self.now, inbox=self.inbox
        )

    def feed(self, sided: Simulated) -> None:
        side, message = sided
        self.now = max(self.now, message.t_arrival)
        if isinstance(message, ImuSample):
            self.loop.feed(Sided(message, side))
        else:
            image = StereoFrame(message.t, message.t_arrival, None, None)
            self.loop.feed(DetectedFrame(image, message))

    def feed_waiting(self, image: Simulated, packets: Sequence[Simulated]) -> int:
        """Feeds an image while these packets wait; returns how many passed the second hand's part
        of it, and feeds the others after it."""
        for side, message in packets:
            self.now = max(self.now, message.t_arrival)
            self.inbox.put(Sided(message, side))
        self.feed(image)
        rest = 0
        while (item := self.inbox.get(0.0)) is not None:
            self.loop.feed(item)
            rest += 1
        return len(packets) - rest

    def record(self, path: Path) -> None:
        settings = next(iter(self.loop.hands.pipelines.values())).settings
        anchor = ClockAnchor(10**18, 0).at(self.now)
        infos = [
            describe(
                text("hands", FILES[side][0]),
                text("gloves", FILES[side][1]),
                anchor,
                rig=self.sim.rig,
                settings_text=to_toml(settings),
            )
            for side in SIDES
        ]
        self.loop.set_recorder(SessionRecorder(path, of_hands(infos)))


def keypoints(path: Path, side: str) -> np.ndarray:
    """(n, K, 3) m of each estimate of a hand."""
    with SessionReader(path, side=side) as reader:
        return np.array([m.keypoints for m in reader.messages((Estimate,))])


@pytest.fixture(scope="module")
def sim() -> TwoHandsSimulation:
    return simulated(3, 3.0)


@pytest.mark.long
def test_a_live_recording_of_both_is_tracked_again_bit_for_bit(tmp_path, sim) -> None:
    live, path = Live(sim), tmp_path / "live.mcap"
    for message in sim.messages():
        if live.now >= 1.0 and not live.journal.recording:
            live.record(path)
        live.feed(message)
    live.loop.feed(GuidedCommand("flat", True, "left"))
    live.loop.set_recorder(None)
    assert all(hand.tracking == Tracking.TRACKING for hand in live.loop.seen.values())
    assert is_ok(verify(path))
    track(path, tmp_path / "again.mcap")
    for side in SIDES:
        was, again = (keypoints(file, side) for file in (path, tmp_path / "again.mcap"))
        assert len(was) > 150
        np.testing.assert_array_equal(was, again)
    events = [e for e in live.journal.drain_events() if e.kind in ("guided", "tracking")]
    assert events[-1].data == {"pose": "flat", "phase": "begin", "hand": "left"}
    tracked = [e.notice.values["side"] for e in events if e.code == "tracking.side_tracked"]
    assert set(tracked) == {"left", "right"}


@pytest.mark.long
def test_packets_pass_between_the_parts_of_an_image_and_nothing_changes(tmp_path, sim) -> None:
    """The hand that sends first gets its packets before the other hand's part of an image; tracked
    again, with both parts before them, the estimates are the same bit for bit."""
    live, path, passed = Live(sim), tmp_path / "live.mcap", 0
    messages = list(sim.messages())
    while messages:
        if live.now >= 1.0 and not live.journal.recording:
            live.record(path)
        first = messages.pop(0)
        if isinstance(first[1], ImuSample):
            live.feed(first)
            continue
        waiting = []
        while messages and len(waiting) < 3 and isinstance(messages[0][1], ImuSample):
            waiting.append(messages.pop(0))
        passed += live.feed_waiting(first, waiting)
    live.loop.set_recorder(None)
    assert passed > 100
    assert all(hand.tracking == Tracking.TRACKING for hand in live.loop.seen.values())
    track(path, tmp_path / "again.mcap")
    for side in SIDES:
        was, again = (keypoints(file, side) for file in (path, tmp_path / "again.mcap"))
        assert len(was) > 150
        np.testing.assert_array_equal(was, again)


def test_images_are_searched_around_the_markers_of_both_hands(sim) -> None:
    live = Live(sim)
    for message in sim.messages():
        live.feed(message)
        predicted = live.loop.predicted
        hands = [hand.predicted for hand in live.loop.seen.values()]
        if all(hand is not None for hand in hands):
            assert predicted is not None
            assert len(predicted.p_G) == sum(len(h.p_G) for h in hands if h is not None)
            return
        assert predicted is None
    pytest.fail("never were both tracked")


def without(side: str, begin: float, end: float, message: Simulated) -> bool:
    """Whether a message is sent while that glove is unplugged from ``begin`` to ``end`` (s)."""
    return not (message.side == side and begin <= message.message.t_arrival < end)


def test_unplugging_one_glove_does_not_affect_the_other_hand(sim) -> None:
    live = Live(sim)
    present = partial(without, "left", 1.5, 2.2)
    for message in sim.messages():
        if present(message):
            live.feed(message)
        if isinstance(message.message, ImuSample) and 1.5 < live.now < 2.2:
            assert live.loop.seen["right"].tracking == Tracking.TRACKING
    for side in SIDES:
        estimate = live.loop.seen[side].estimate
        assert estimate is not None and estimate.tracking == Tracking.TRACKING
        off = estimate.keypoints - sim.hands[side].truth(estimate.t).keypoints
        measured = estimate.keypoint_state == Validity.MEASURED
        assert measured.sum() >= 8
        assert np.linalg.norm(off[measured], axis=1).mean() < 0.01  # m, of hands that are tracked
    assert live.loop.status("left").values["imu_lost"] > 50
    assert live.loop.status("right").values["imu_lost"] == 0


def test_a_missing_glove_does_not_delay_the_search_for_the_other_hand(sim) -> None:
    live = Live(sim)
    for message in sim.messages():
        if message.side != "left":
            live.feed(message)
    right = live.loop.seen["right"]
    assert right.tracking == Tracking.TRACKING
    assert live.loop.seen["left"].tracking != Tracking.TRACKING
    assert live.loop.seen["left"].has_no_packets and live.loop.predicted is right.predicted
