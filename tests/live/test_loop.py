"""The live loop without threads: recordings determine the order in which the engine was fed."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np
import pytest

from tests.live.test_runner import Tape, sim
from tracker.base.errors import ConfigError
from tracker.engine.hands import Hands, Sided
from tracker.engine.pipeline import SILENCE, Pipeline
from tracker.glove.model import GloveModel, ImuVibration
from tracker.live.inbox import DetectedFrame, EngineCommand, Inbox, MotorCommand
from tracker.live.journal import Journal
from tracker.live.loop import ArrivalOrder, LiveLoop
from tracker.live.telemetry import Telemetry
from tracker.messages import (
    BlobFrame,
    EngineState,
    Estimate,
    Event,
    ImuSample,
    Message,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.sensors.motor_events import motor_event, motor_of
from tracker.simulation.scenario import Simulation

__all__ = ["sim"]  # a fixture

IN_TIME = 0.5  # s, far more than beginning a recording takes that nothing holds up


class Clock:
    """Time according to the messages."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


class RecordingBegunBetween(ArrivalOrder):
    """Once ``begin`` is set, makes another thread run it as soon as the next message is stamped."""

    def __init__(self) -> None:
        super().__init__()
        self.begin: threading.Thread | None = None

    def imu(self, sample: ImuSample) -> ImuSample:
        return self._interrupted(super().imu(sample))

    def blobs(self, frame: BlobFrame) -> BlobFrame:
        return self._interrupted(super().blobs(frame))

    def _interrupted(self, message):
        if self.begin is not None and self.begin.ident is None:
            self.begin.start()
            self.begin.join(IN_TIME)  # impossible if stamp and feeding are under one lock
        return message


def messages_of(sim: Simulation) -> list[ImuSample | BlobFrame]:
    return [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]


def item(message: ImuSample | BlobFrame) -> Sided | DetectedFrame:
    if isinstance(message, ImuSample):
        return Sided(message, "right")
    image = StereoFrame(message.t, message.t_arrival, None, None)
    return DetectedFrame(image, message)


def loop_on(sim: Simulation, order: ArrivalOrder | None = None) -> tuple[LiveLoop, Clock]:
    clock = Clock()
    hands = Hands({"right": lambda: Pipeline(sim.hand, sim.glove, sim.rig)})
    return LiveLoop(hands, Journal(clock), Telemetry(), clock, order), clock


def feed(loop: LiveLoop, clock: Clock, messages: list[ImuSample | BlobFrame]) -> None:
    for message in messages:
        clock.now = max(clock.now, message.t_arrival)
        loop.feed(item(message))


def tracked_again(sim: Simulation, messages: list[Message]) -> list[Estimate]:
    """As from a file: from the recorded state on, in the order of timestamps."""
    began = messages[0]
    assert isinstance(began, EngineState)
    pipeline, estimates = Pipeline(sim.hand, sim.glove, sim.rig), []
    fed = [m for m in messages if isinstance(m, ImuSample | BlobFrame)]
    pipeline.set_state(began.state)
    for m in sorted(fed, key=lambda m: (m.t_arrival, isinstance(m, BlobFrame))):
        assert m.t_arrival >= began.t, "before the state that holds what was fed before it"
        if isinstance(m, ImuSample):
            estimates.append(pipeline.feed_imu(m))
        else:
            pipeline.feed_frame(m)
            estimates += [e for e in [pipeline.without_packets(m)] if e is not None]
    return estimates


@pytest.mark.parametrize("kind", [ImuSample, BlobFrame])
def test_a_recording_started_between_stamp_and_feeding_is_tracked_again_alike(sim, kind):
    order, tape = RecordingBegunBetween(), Tape()
    loop, clock = loop_on(sim, order)
    messages = messages_of(sim)
    middle = next(i for i, m in enumerate(messages) if m.t > 1.0 and isinstance(m, kind))
    feed(loop, clock, messages[:middle])
    order.begin = threading.Thread(target=loop.set_recorder, args=(tape,))
    feed(loop, clock, messages[middle : middle + 1])
    order.begin.join()
    feed(loop, clock, messages[middle + 1 :])
    loop.set_recorder(None)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    again = tracked_again(sim, tape.messages)
    assert len(recorded) == len(again) > 50
    for a, b in zip(recorded, again, strict=True):
        np.testing.assert_array_equal(a.keypoints, b.keypoints)


def test_commands_to_motors_are_recorded_and_tracked_again_alike(sim):
    """The glove's file contains the noise of its motor."""
    noise = ImuVibration(np.array([0.2]), np.array([2.0]))
    imus = tuple(replace(imu, vibration=noise) for imu in sim.glove.imus)
    glove, tape, clock = replace(sim.glove, imus=imus), Tape(), Clock()
    hands = Hands({"right": lambda: Pipeline(sim.hand, glove, sim.rig)})
    loop = LiveLoop(hands, Journal(clock), Telemetry(), clock)
    loop.set_recorder(tape)
    messages = messages_of(sim)
    middle = next(i for i, m in enumerate(messages) if m.t > 0.9)
    feed(loop, clock, messages[:middle])
    loop.feed(MotorCommand(motor_event(0, 255, 300, clock.now), "right"))
    feed(loop, clock, messages[middle:])
    loop.set_recorder(None)
    shaken, calm = (again(sim, glove, tape.messages, fed) for fed in (True, False))
    for a, b in zip([m for m in tape.messages if isinstance(m, Estimate)], shaken, strict=True):
        np.testing.assert_array_equal(a.keypoint_sd, b.keypoint_sd)
    assert any(np.any(a.keypoint_sd != b.keypoint_sd) for a, b in zip(shaken, calm, strict=True))


def again(sim: Simulation, glove: GloveModel, messages: list[Message], motors: bool):
    """The estimates of a pipeline that is fed the recorded messages."""
    pipeline, found = Pipeline(sim.hand, glove, sim.rig), []
    fed = [m for m in messages if isinstance(m, ImuSample | BlobFrame)]
    fed += [m for m in messages if isinstance(m, Event) and motors and motor_of(m)]
    for m in sorted(fed, key=lambda m: (getattr(m, "t_arrival", m.t), isinstance(m, BlobFrame))):
        if isinstance(m, ImuSample):
            found.append(pipeline.feed_imu(m))
        elif isinstance(m, BlobFrame):
            pipeline.feed_frame(m)
        else:
            pipeline.feed_event(m)
    return found


def unplugged(messages: list, start: float, stop: float) -> list:
    """Without the packets between two times (s)."""
    return [m for m in messages if not (isinstance(m, ImuSample) and start < m.t < stop)]


@pytest.mark.parametrize("begun", [0.5, 1.25])
def test_the_output_without_packets_is_recorded(sim, begun):
    tape, shown = Tape(), []
    loop, clock = loop_on(sim)
    messages = unplugged(messages_of(sim), 1.2, 1.7)
    first = next(i for i, m in enumerate(messages) if m.t > begun)
    feed(loop, clock, messages[:first])
    loop.set_recorder(tape)
    end = loop.seen["right"].subscribe(shown.append)
    feed(loop, clock, messages[first:])
    end()
    loop.set_recorder(None)
    recorded = [m for m in tape.messages if isinstance(m, Estimate)]
    assert [e.t for e in recorded] == [e.t for e in shown]
    assert [e.t for e in shown] == sorted({e.t for e in shown})
    packets = {m.t for m in messages if isinstance(m, ImuSample)}
    by_images = [e for e in recorded if e.t not in packets]
    assert len(by_images) > 5 and all(1.2 + SILENCE < e.t < 1.75 for e in by_images)
    assert by_images[0].tracking == Tracking.TRACKING
    assert all((e.keypoint_state < Validity.MEASURED).all() for e in by_images)
    assert all((e.angle_state < Validity.MEASURED).all() for e in by_images)
    codes = [m.code for m in tape.messages if isinstance(m, Event) and m.kind == "device"]
    assert codes == ["glove.packets_missing", "glove.packets_back"]
    again = tracked_again(sim, tape.messages)
    assert [a.t for a in again] == [e.t for e in recorded]
    for a, b in zip(recorded, again, strict=True):
        np.testing.assert_array_equal(a.keypoints, b.keypoints)
        np.testing.assert_array_equal(a.keypoint_state, b.keypoint_state)


def test_time_is_monotonic_with_late_images_or_packets(sim):
    """Stalls of the computer: images are fed long after their exposure, packets in bursts."""
    loop, clock = loop_on(sim)
    shown: list[Estimate] = []
    loop.seen["right"].subscribe(shown.append)
    rng = np.random.default_rng(3)
    late = {}
    for m in messages_of(sim):
        stall = np.floor(m.t / 0.4)  # all of 0.4 s may be late, images and packets independently
        key = stall, isinstance(m, ImuSample)
        late.setdefault(key, rng.uniform(0.0, 0.36) * (rng.random() < 0.7))
        arrival = max(m.t_arrival, stall * 0.4 + late[key])
        late[m] = replace(m, t_arrival=arrival)
    messages = sorted((v for k, v in late.items() if not isinstance(k, tuple)), key=arrival_of)
    feed(loop, clock, messages)
    assert len(shown) > 100
    assert [e.t for e in shown] == sorted({e.t for e in shown})


def arrival_of(message: ImuSample | BlobFrame) -> float:
    return message.t_arrival


def test_one_thread_is_sufficient_to_track_a_hand(sim):
    loop, clock = loop_on(sim)
    messages = messages_of(sim)
    feed(loop, clock, messages)
    hand = loop.seen["right"]
    assert hand.estimate is not None and hand.estimate.tracking == Tracking.TRACKING
    assert hand.estimate.t == max(m.t for m in messages if isinstance(m, ImuSample))
    latest = hand.frames.latest
    assert latest is not None and latest[0].t == latest[1].t == latest[2].t
    assert loop.predicted is not None and hand.calibration is not None
    assert loop.status("right").values["stereo_points"] > 0


def test_without_packets_no_hand_is_searched_for(sim):
    """A camera alone finds none; once the glove sends, a missing hand is reported as usual."""
    loop, clock = loop_on(sim)
    messages = messages_of(sim)
    feed(loop, clock, [m for m in messages if isinstance(m, BlobFrame)][:20])
    assert loop.journal.drain_events() == []
    loop, clock = loop_on(sim)
    first = next(m for m in messages if isinstance(m, BlobFrame))
    feed(loop, clock, [first, *(m for m in messages if m.t < 1.0)])
    codes = [e.code for e in loop.journal.drain_events() if e.kind == "tracking"]
    assert codes[:2] == ["tracking.searching", "tracking.tracked"]


def test_timestamps_determine_the_order_of_feeding(sim):
    order, messages = ArrivalOrder(), messages_of(sim)
    sample = next(m for m in messages if isinstance(m, ImuSample))
    image = next(m for m in messages if isinstance(m, BlobFrame))
    stamps = [order.imu(sample).t_arrival, order.mark(), order.imu(sample).t_arrival]
    assert stamps == sorted(set(stamps)), "each after the one before"
    late = order.imu(sample)
    later = order.blobs(image)
    assert later.t_arrival >= late.t_arrival
    assert order.imu(sample).t_arrival > later.t_arrival


def test_an_unknown_reference_leaves_the_running_one(sim):
    loop, clock = loop_on(sim)
    loop.reference.use("madgwick")
    with pytest.raises(ConfigError):
        loop.reference.use("none such")
    feed(loop, clock, messages_of(sim)[:1])
    loop.reference.use(None, wait=True)
    assert loop.reference.estimate("right") is None


def test_the_queue_is_limited_for_images_and_not_for_packets(sim):
    inbox, messages = Inbox(), messages_of(sim)
    for message in messages[:40]:
        waiting = item(message)
        if isinstance(waiting, DetectedFrame):
            inbox.put_frame(waiting)
        else:
            inbox.put(waiting)
    inbox.put(EngineCommand(lambda engine: None, "right"))
    images = sum(isinstance(m, BlobFrame) for m in messages[:40])
    assert inbox.skipped == images - 3 > 0
    taken = [inbox.get(0.0) for _ in range(40 - inbox.skipped + 1)]
    assert sum(isinstance(i, Sided) for i in taken) == 40 - images
    assert all(isinstance(i, Sided) for i in taken[:8]), "packets go before images"
    assert sum(isinstance(i, DetectedFrame) for i in taken) == 3
    inbox.put_frame(item(next(m for m in messages if isinstance(m, BlobFrame))))
    assert isinstance(inbox.get(0.0), DetectedFrame), "there is room again"


@pytest.mark.parametrize("behind", [3, 12, 60])
def test_images_are_not_starved_by_packets_that_wait(sim, behind):
    """An engine that is as fast as the packets arrive never has an empty queue."""
    inbox, messages, fed = Inbox(), messages_of(sim), []
    for message in messages:
        waiting = item(message)
        if isinstance(waiting, DetectedFrame):
            inbox.put_frame(waiting)
            continue
        inbox.put(waiting)
        if inbox.figures()["engine_waiting"] > behind:
            fed.append(inbox.get(0.0))
    images = [x.frame for x in fed if isinstance(x, DetectedFrame)]
    packets = [x.sample for x in fed if isinstance(x, Sided)]
    assert [p.t for p in packets] == sorted(p.t for p in packets)
    seen = np.array([f.t for f in images])
    assert len(seen) > 3 and np.diff(seen).max() < 0.5
    for image in images:
        place = next(
            k for k, x in enumerate(fed) if isinstance(x, DetectedFrame) and x.frame is image
        )
        after = [x for x in fed[place:] if isinstance(x, Sided)]
        assert not after or image.t_arrival <= after[0].sample.t_arrival + 0.011


def test_rendering_waits_while_a_message_is_processed(sim) -> None:
    loop, _clock = loop_on(sim)
    taken: list[bool] = []
    loop.seen["right"].followers = (lambda *_: taken.append(loop.priority.has_urgent_work),)
    for message in messages_of(sim)[:20]:
        loop.feed(item(message))
        assert not loop.priority.has_urgent_work
    assert taken and all(taken)
