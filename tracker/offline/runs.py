"""A session's messages through its hands' pipelines into a new session, as live."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from tracker.base.notices import plain
from tracker.engine.hands import Hands, Sided
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.guided.events import guided_of
from tracker.fusion.chain.pose_reset import is_reset
from tracker.fusion.engine import Engine
from tracker.gestures.recogniser import GestureRecogniser, gesture_event
from tracker.messages import (
    BlobFrame,
    Calibration,
    CameraImuSample,
    EngineState,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Tracking,
    WristPose,
)
from tracker.offline.own_colours import OwnColours
from tracker.offline.run_watch import RunWatch, run_watch
from tracker.offline.track_report import Counter, StatusClock, TrackReport, TruthCheck
from tracker.online.hue_names import hue_names_of
from tracker.session.decode_sensors import Sensed
from tracker.session.images import PackedFrame
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.message_check import sound
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics
from tracker.session.state_check import require_match
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import StereoRig

CALIBRATION_PERIOD = 1.0  # s between two calibrations in the file


Fed = Sensed | Event
"""The messages that a run is fed with; only events of guided poses and pose resets are used."""


def arrival(message: Fed | Sided) -> float:
    """Returns the arrival of a message, s."""
    return message.t if isinstance(message, Event) else message.t_arrival


class SessionRun(Protocol):
    """What `track` feeds; ``progress`` of `finish` hears the share of the rest that is done."""

    @property
    def engines(self) -> dict[str, Engine]:
        """By the hand's side."""

    def feed(self, message: Fed | Sided) -> None: ...

    def finish(self, progress: Callable[[float], None]) -> None: ...


class TrueHands:
    """Copies what a session knows about its hands beside its estimates: the true poses of simulated
    ones, and the measurements of a laboratory, so that the new estimates can be compared with them.

    Not of hands whose keypoints differ in the new session.
    """

    def __init__(self, reader: SessionReader, recorder: SessionRecorder) -> None:
        self._recorder, self._wall = recorder, reader.anchor.wall
        self._kinds: dict[str, str] = {}
        for old, new in zip(reader.info.hands, recorder.info.hands, strict=True):
            if old.keypoint_names == new.keypoint_names:
                self._add(reader, old.side)
        stored = ordered(reader.source, frozenset(self._kinds)) if self._kinds else iter(())
        self._messages = sound(stored, reader.source.left_out)
        self._next: RawMessage | None = next(self._messages, None)

    def _add(self, reader: SessionReader, side: str) -> None:
        for topic in (topics.truth, topics.reference):
            self._kinds[topic(side, "keypoints")] = motion.POSES
            self._kinds[topic(side, "joint_states")] = motion.JOINTS
        about = topics.reference_about(side)
        if about in reader.attachments:
            data, when = reader.attachments[about].encode(), reader.span_ns[0]
            self._recorder.attach(about, "application/json", data, when)

    def until(self, t: float) -> None:
        """Write what was recorded before ``t`` s."""
        end = self._wall(t)
        while self._next is not None and self._next.log_time < end:
            self._recorder.copy(self._next, self._kinds[self._next.topic])
            self._next = next(self._messages, None)


class Output:
    """Writes the new session and counts what is written."""

    def __init__(
        self,
        recorder: SessionRecorder,
        with_sensors: bool,
        check: TruthCheck | None,
        side: str,
        true_hands: TrueHands | None = None,
    ) -> None:
        """``side``: the hand that this is for; ``true_hands``: of the session, all of them."""
        self._true_hands = true_hands
        self._recorder, self._with_sensors, self._check = recorder, with_sensors, check
        self._side, self._moving = side, recorder.info.moving_camera
        (info,) = (h for h in recorder.info.hands if h.side == side)
        self._gestures = GestureRecogniser(info.hand, info.keypoint_names)
        self._counter = Counter()
        self._status = StatusClock()

    @property
    def report(self) -> TrackReport:
        return self._counter.report

    def message(self, message: Fed) -> None:
        """A message as it was fed; before its estimate."""
        if isinstance(message, PackedFrame):
            self._recorder.write_packed(message)
            return
        if isinstance(message, BlobFrame | ImuSample):
            self._recorder.arrived(message.t_arrival)
        if isinstance(message, BlobFrame):
            self._frame(message)
        elif isinstance(message, Event) and not _is_request(message):
            return
        elif self._with_sensors:
            self._recorder.write(message, side=self._side)

    def _frame(self, frame: BlobFrame) -> None:
        """Writes the assumed pose of the camera, on which estimates depend.

        If the samples of the camera's own IMU are copied, a camera without another source keeps
        its initial static transform: tracking the file again must give the same results.
        """
        if self._with_sensors:
            self._recorder.write(frame if self._moving else replace(frame, pose=None))
        if frame.pose is not None:
            self._recorder.write_camera(frame.t, frame.t_arrival, frame.pose, exact=self._moving)
        self._status.frame(frame)
        self.report.frames += 1

    def state(self, state: EngineState) -> None:
        """Writes a state from which the engine continued, for tracking the session again."""
        if self._with_sensors:
            self._recorder.write(state)

    def rig(self, rig: StereoRig, t: float) -> None:
        """Writes the calibration of the camera that applies from ``t`` on."""
        self._recorder.write_rig(rig, t)

    def between(self, estimate: Estimate) -> None:
        """An estimate of an image, while packets are missing."""
        if self._true_hands is not None:
            self._true_hands.until(estimate.t)
        self._recorder.write(estimate, side=self._side)
        for phase in self._gestures.feed(estimate):
            self._recorder.write(gesture_event(phase, self._gestures.side))
        if self._check is not None:
            self._check.add(estimate)

    def estimate(self, sample: ImuSample, estimate: Estimate) -> None:
        self.between(estimate)
        self._counter.count(sample, estimate.tracking)
        status = self._status.packet(sample, estimate.tracking, self.report)
        if status is not None:
            self._recorder.write(status, side=self._side)

    def calibration(self, calibration: Calibration) -> None:
        self._recorder.write(calibration, side=self._side)

    def source(self, t: float, pipeline: Pipeline) -> None:
        """Record what the hand follows from ``t`` (s) on, where that has changed."""
        for found in pipeline.source_notices.drain():
            self._recorder.write(Event.of(t, "device", found))

    def write_event(self, event: Event) -> None:
        """An event about the session, for its log and the report."""
        self._recorder.write(event)
        self.report.notices.append(event.notice or plain(event.text))


def _is_request(event: Event) -> bool:
    """Whether estimates after it depend on an event."""
    known = is_reset(event) or guided_of(event) is not None
    return known or hue_names_of(event) is not None


class NoOutput(Output):
    """For a run of which only the final state is used."""

    def __init__(self) -> None:
        self._report = TrackReport()

    @property
    def report(self) -> TrackReport:
        return self._report

    def message(self, message: Fed) -> None: ...

    def state(self, state: EngineState) -> None: ...

    def rig(self, rig: StereoRig, t: float) -> None: ...

    def between(self, estimate: Estimate) -> None: ...

    def estimate(self, sample: ImuSample, estimate: Estimate) -> None: ...

    def calibration(self, calibration: Calibration) -> None: ...

    def source(self, t: float, pipeline: Pipeline) -> None: ...

    def write_event(self, event: Event) -> None: ...


class EventsOnly(NoOutput):
    """For a run parallel to another one: only events go to the other one's output."""

    def __init__(self, output: Output) -> None:
        super().__init__()
        self._output = output

    def write_event(self, event: Event) -> None:
        self._output.write_event(event)


class LiveRun:
    """The estimates of a live run of all hands, bit for bit.

    ``make`` builds them with the engine of that name and that camera; ``outputs`` are by side, and
    that of ``main`` receives what belongs to no side. ``changes`` are, in order of time, what
    messages do not contain: states of the engines, from which they continue, and calibrations of
    the camera.
    """

    def __init__(
        self,
        make: Callable[[str, StereoRig | None], Hands],
        engine: str,
        rig: StereoRig | None,
        outputs: Mapping[str, Output],
        main: str,
        changes: Sequence[tuple[float, EngineState | StereoRig]] = (),
        colours: OwnColours | None = None,
    ) -> None:
        """``colours``, where images are searched, follow the main hand."""
        self._make, self._hands, self._rig = make, make(engine, rig), rig
        self._outputs, self._main, self._changes = outputs, main, deque(changes)
        self._next_calibration = dict.fromkeys(outputs, -np.inf)
        self._has_camera_imu = False
        self._colours, self._tracking = colours, dict.fromkeys(outputs, Tracking.SEARCHING)
        self._corrects = not self._changes  # names of hues; those of a live run are events
        self._watch: RunWatch = run_watch(self._hands, self._corrects)

    @property
    def engines(self) -> dict[str, Engine]:
        return {side: pipeline.engine for side, pipeline in self._hands.pipelines.items()}

    def feed(self, message: Fed | Sided) -> None:
        while self._changes and self._changes[0][0] <= arrival(message):
            self._change(*self._changes.popleft())
        if isinstance(message, Sided):
            self._feed_imu(message.side, message.sample)
            return
        self._has_camera_imu |= isinstance(message, CameraImuSample)
        if isinstance(message, WristPose):
            self._feed_wrist(message)
            return
        self._outputs[self._main].message(self._posed(message))
        if isinstance(message, BlobFrame):
            self._feed_frame(message)
        elif isinstance(message, CameraImuSample):
            self._hands.feed_camera_imu(message)
        elif isinstance(message, Event):
            self._hands.feed_event(message)
        elif not isinstance(message, PackedFrame):
            raise TypeError("a packet of a session has a side")

    def _feed_wrist(self, pose: WristPose) -> None:
        self._outputs[pose.side].message(pose)
        self._hands.feed_wrist(pose)

    def _used(self, side: str) -> list[FrameResult]:
        """What the engine of that side has made of images."""
        results = self._hands.take_results(side)
        if self._colours is not None and side == self._main:
            self._colours.used(results)
        return results

    def _look(self, frame: BlobFrame) -> None:
        """Adapts the colours to an image; without a tracked hand no hand is in view."""
        results, output = [self._used(side) for side in self._outputs], self._outputs[self._main]
        for event in self._watch.look(frame, self._tracking[self._main], results[0]):
            output.write_event(event)
        if self._colours is not None:
            unknown = (Tracking.SEARCHING, Tracking.LOST)
            tracked = [t for t in self._tracking.values() if t not in unknown]
            self._colours.looked(frame, tracked[0] if tracked else Tracking.LOST)
            for event in self._colours.drain_events():
                output.write_event(event)

    def _posed(self, message: Fed) -> Fed:
        """A frame with the pose that the main hand's pipeline gives it."""
        if self._has_camera_imu and isinstance(message, BlobFrame) and message.pose is None:
            pipeline = self._hands.pipelines[self._main]
            pose = pipeline.camera_pose(message.t - pipeline.timing.applied)
            return replace(message, pose=pose)
        return message

    def _change(self, t: float, what: EngineState | StereoRig) -> None:
        output = self._outputs[self._main]
        if isinstance(what, StereoRig):
            before, self._rig = self._hands, what
            self._hands = self._make(before.engine, what)
            self._hands.set_state(before.get_state())
            output.rig(what, t)
            return
        self._hands = self._make(what.engine, self._rig)
        self._watch = run_watch(self._hands, self._corrects)
        require_match(what.state, self._hands.get_state(), what.engine)
        self._hands.set_state(what.state)
        output.state(what)

    def _feed_frame(self, frame: BlobFrame) -> None:
        self._hands.feed_frame(frame)
        self._watch.frame(frame)
        for side, output in self._outputs.items():
            estimate = self._hands.pipelines[side].without_packets(frame)
            if estimate is not None:
                self._tracking[side] = estimate.tracking
                output.source(frame.t, self._hands.pipelines[side])
                output.between(estimate)
        self._look(frame)

    def _feed_imu(self, side: str, sample: ImuSample) -> None:
        output = self._outputs[side]
        output.message(sample)
        estimate = self._hands.feed_imu(side, sample)
        output.source(sample.t, self._hands.pipelines[side])
        for of, event in self._watch.packet(side, sample, estimate.tracking):
            self._outputs[of].write_event(event)
        self._tracking[side] = estimate.tracking
        output.estimate(sample, estimate)
        if sample.t >= self._next_calibration[side]:
            self._next_calibration[side] = sample.t + CALIBRATION_PERIOD
            if estimate.tracking != Tracking.SEARCHING:
                output.calibration(self._hands.pipelines[side].calibration())
        self._used(side)

    def finish(self, progress: Callable[[float], None]) -> None:
        for side, output in self._outputs.items():
            if output.report.estimates:
                output.calibration(self._hands.pipelines[side].calibration())

    def state(self, t: float) -> EngineState:
        """Returns the state of the engines after all messages, to continue from at ``t`` s."""
        return EngineState(t, self._hands.engine, self._hands.get_state())
