"""Poses of a tracker on the hand, live: what is recorded gives the same hand again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tests.live.test_loop import Clock
from tests.live.test_runner import Tape, sim
from tests.room_tracker import RoomTracker, in_order
from tracker.engine.hands import Hands, Sided
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.live.journal import Journal
from tracker.live.loop import LiveLoop
from tracker.live.reference import ReferenceEngine
from tracker.live.telemetry import Telemetry
from tracker.messages import EngineState, Estimate, ImuSample, Tracking, WristPose
from tracker.simulation.scenario import Simulation

__all__ = ["sim"]  # a fixture


def inertial(sim: Simulation) -> Pipeline:
    return Pipeline(sim.hand, sim.glove, None, Settings(engine="inertial"))


def test_a_recording_of_a_placed_hand_is_tracked_again_bit_for_bit(sim: Simulation) -> None:
    """Begun in the middle; two poses carry the stamp of a packet, and one the other hand's side."""
    clock, tape = Clock(), Tape()
    loop = LiveLoop(Hands({"right": lambda: inertial(sim)}), Journal(clock), Telemetry(), clock)
    messages = list(in_order(sim, RoomTracker().poses(sim)))
    arrivals = [m.t_arrival for m in messages if isinstance(m, ImuSample)]
    for k, m in enumerate(messages):
        clock.now = max(clock.now, m.t_arrival)
        if k == 120:
            loop.set_recorder(tape)
        if isinstance(m, ImuSample):
            loop.feed(Sided(m, "right"))
        elif k in (140, 141):
            loop.feed(replace(m, t_arrival=max(a for a in arrivals if a <= m.t_arrival)))
        else:
            loop.feed(m)
            loop.feed(replace(m, side="left"))
    loop.set_recorder(None)
    began = tape.messages[0]
    assert isinstance(began, EngineState)
    pipeline, again = inertial(sim), []
    pipeline.set_state(began.state)
    fed = [m for m in tape.messages if isinstance(m, ImuSample | WristPose)]
    assert len({m.t_arrival for m in fed}) == len(fed)
    for message in sorted(fed, key=lambda m: m.t_arrival):
        if isinstance(message, ImuSample):
            again.append(pipeline.feed_imu(message))
        else:
            assert message.side == "right"
            pipeline.feed_wrist(message)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    assert len(recorded) == len(again) > 50 and recorded[-1].tracking == Tracking.TRACKING
    for a, b in zip(recorded, again, strict=True):
        np.testing.assert_array_equal(a.keypoints, b.keypoints)


def test_a_second_engine_is_placed_too(sim: Simulation) -> None:
    reference = ReferenceEngine(Hands({"right": lambda: inertial(sim)}))
    for m in in_order(sim, RoomTracker().poses(sim, end=1.0)):
        reference._feed(Sided(m, "right") if isinstance(m, ImuSample) else m)
        if m.t > 0.95:
            break
    estimate = reference.estimate("right")
    reference.close()
    assert estimate is not None and estimate.tracking == Tracking.TRACKING
