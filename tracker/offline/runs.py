"""A session's messages through a pipeline into a new session: as live, or smoothed as a whole."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from extensions.movement.report.command import Counter, StatusClock, TrackReport, TruthCheck
from tracker.engine.pipeline import ANOTHER, Pipeline
from tracker.engine.side_watch import SideWatch
from tracker.engine.two_hands import Sided
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
)
from tracker.offline.own_colours import OwnColours
from tracker.offline.smooth import Smoother
from tracker.online.camera_tilt import CameraTilt
from tracker.online.colour_watch import ColourWatch
from tracker.session.decode_sensors import Sensed
from tracker.session.images import PackedFrame
from tracker.session.state_check import require_match
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import StereoRig

CALIBRATION_PERIOD = 1.0  # s between two calibrations in the file


Fed = Sensed | Event
"""What a run is fed with: of events those count that tell of guided poses and pose resets."""


def arrival(message: Fed | Sided) -> float:
    """When a message came, s."""
    return message.t if isinstance(message, Event) else message.t_arrival


class SessionRun(Protocol):
    """What `track` feeds; ``progress`` of `finish` hears the share of the rest that is done."""

    @property
    def engines(self) -> dict[str, Engine]:
        """By the hand's side."""

    def feed(self, message: Fed | Sided) -> None: ...

    def finish(self, progress: Callable[[float], None]) -> None: ...


class Output:
    """The new session and what is counted on the way into it."""

    def __init__(
        self,
        recorder: SessionRecorder,
        with_sensors: bool,
        check: TruthCheck | None,
        side: str,
    ) -> None:
        """``side``: the hand that this is for."""
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
        if isinstance(message, BlobFrame):
            self._frame(message)
        elif isinstance(message, Event) and guided_of(message) is None and not is_reset(message):
            return
        elif self._with_sensors:
            self._recorder.write(message, side=self._side)

    def _frame(self, frame: BlobFrame) -> None:
        """Where the camera was taken to be is part of what estimates mean.

        A camera that only its own IMU tells of keeps the static transform that it starts from
        where its samples are copied: the file is to be tracked again as it was.
        """
        if self._with_sensors:
            self._recorder.write(frame if self._moving else replace(frame, pose=None))
        if frame.pose is not None:
            self._recorder.write_camera(frame.t, frame.t_arrival, frame.pose, exact=self._moving)
        self._status.frame(frame)
        self.report.frames += 1

    def state(self, state: EngineState) -> None:
        """What the engine went on from: part of what it takes to track again."""
        if self._with_sensors:
            self._recorder.write(state)

    def rig(self, rig: StereoRig, t: float) -> None:
        """The camera as it is from ``t`` on."""
        self._recorder.write_rig(rig, t)

    def between(self, estimate: Estimate) -> None:
        """An estimate of an image, while packets are missing."""
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
        for text in pipeline.take_source_words():
            self._recorder.write(Event(t, "device", text))

    def say(self, event: Event) -> None:
        """A sentence about the session, for its log and the report."""
        self._recorder.write(event)
        self.report.words.append(event.text)


class NoOutput(Output):
    """For what is tracked only to know where it stands afterwards."""

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

    def say(self, event: Event) -> None: ...


class WordsAlone(NoOutput):
    """For what is tracked beside another run, to whose output only what is said goes."""

    def __init__(self, output: Output) -> None:
        super().__init__()
        self._words = output

    def say(self, event: Event) -> None:
        self._words.say(event)


class LiveRun:
    """The estimates of a live run, bit for bit.

    ``changes`` are, in order of time, what no message tells: what the engine knew at an instant,
    from which it goes on, and calibrations of the camera.
    """

    def __init__(
        self,
        make_pipeline: Callable[[str, StereoRig | None], Pipeline],
        engine: str,
        rig: StereoRig | None,
        output: Output,
        changes: Sequence[tuple[float, EngineState | StereoRig]] = (),
        colours: OwnColours | None = None,
    ) -> None:
        """``make_pipeline`` builds one with the engine of that name and that camera, if any;
        ``colours`` are those that the images are searched with, where they are."""
        self._make_pipeline, self._pipeline = make_pipeline, make_pipeline(engine, rig)
        self._output, self._changes = output, deque(changes)
        self._sides = SideWatch(self._pipeline)
        self._next_calibration = -np.inf
        self._camera_tells = False  # of its rotation, by an IMU of its own
        self._colours, self._tracking = colours, Tracking.SEARCHING
        self._watch = ColourWatch(len(self._pipeline.glove.markers))

    @property
    def engines(self) -> dict[str, Engine]:
        return {self._pipeline.glove.side: self._pipeline.engine}

    def feed(self, message: Fed | Sided) -> None:
        message = message.sample if isinstance(message, Sided) else message
        while self._changes and self._changes[0][0] <= arrival(message):
            self._change(*self._changes.popleft())
        self._camera_tells |= isinstance(message, CameraImuSample)
        self._output.message(self._posed(message))
        if isinstance(message, PackedFrame):
            return
        if isinstance(message, BlobFrame):
            self._feed_frame(message)
        elif isinstance(message, CameraImuSample):
            self._pipeline.feed_camera_imu(message)
        elif isinstance(message, Event):
            self._pipeline.feed_event(message)
        else:
            self._feed_imu(message)
        self._look(message, self._pipeline.take_results())

    def _look(self, message: Fed, results: list[FrameResult]) -> None:
        """What the images say of the colours."""
        if self._colours is not None:
            self._colours.used(results)
        if not isinstance(message, BlobFrame):
            return
        self._watch.look(message, self._tracking)
        texts = [ANOTHER for r in results if r.another] + self._watch.take_words()
        events = [Event(message.t, "tracking", text) for text in texts]
        if self._colours is not None:
            self._colours.looked(message, self._tracking)
            events += self._colours.take_words()
        for event in events:
            self._output.say(event)

    def _posed(self, message: Fed) -> Fed:
        """A frame with the pose that the pipeline gives it."""
        if self._camera_tells and isinstance(message, BlobFrame) and message.pose is None:
            exposed = message.t - self._pipeline.timing.applied
            return replace(message, pose=self._pipeline.camera_pose(exposed))
        return message

    def _change(self, t: float, what: EngineState | StereoRig) -> None:
        before = self._pipeline
        if isinstance(what, StereoRig):
            self._pipeline = self._make_pipeline(before.settings.engine, what)
            self._pipeline.set_state(before.get_state())
            self._output.rig(what, t)
            return
        self._pipeline = self._make_pipeline(what.engine, before.calibrated_rig)
        self._sides = SideWatch(self._pipeline)
        require_match(what.state, self._pipeline.get_state(), what.engine)
        self._pipeline.set_state(what.state)
        self._output.state(what)

    def _feed_frame(self, frame: BlobFrame) -> None:
        self._pipeline.feed_frame(frame)
        self._sides.frame(frame)
        estimate = self._pipeline.without_packets(frame)
        if estimate is not None:
            self._tracking = estimate.tracking
            self._output.source(frame.t, self._pipeline)
            self._output.between(estimate)

    def _feed_imu(self, sample: ImuSample) -> None:
        estimate = self._pipeline.feed_imu(sample)
        self._output.source(sample.t, self._pipeline)
        self._sides.packet(sample, estimate.tracking)
        for text in self._sides.take_words():
            self._output.say(Event(sample.t, "device", text))
        self._tracking = estimate.tracking
        self._output.estimate(sample, estimate)
        if sample.t >= self._next_calibration:
            self._next_calibration = sample.t + CALIBRATION_PERIOD
            if estimate.tracking != Tracking.SEARCHING:
                self._output.calibration(self._pipeline.calibration())

    def finish(self, progress: Callable[[float], None]) -> None:
        if self._output.report.estimates:
            self._output.calibration(self._pipeline.calibration())

    def state(self, t: float) -> EngineState:
        """What the engine knows after all that was fed, to go on from at ``t`` s."""
        return EngineState(t, self._pipeline.settings.engine, self._pipeline.get_state())


class SmoothRun:
    """Estimates that know the whole session; all are written at the end.

    Where images are searched a live run is the ``guide``: it is fed as well, and what it makes of
    them decides the colours that later ones are searched with.
    """

    def __init__(
        self,
        smoother: Smoother,
        output: Output,
        camera: CameraTilt,
        guide: LiveRun | None = None,
    ) -> None:
        self._smoother, self._output, self._camera = smoother, output, camera
        self._guide = guide

    @property
    def engines(self) -> dict[str, Engine]:
        return {self._smoother.side: self._smoother.engine}

    def feed(self, message: Fed | Sided) -> None:
        message = message.sample if isinstance(message, Sided) else message
        if self._guide is not None:
            self._guide.feed(message)
        if isinstance(message, PackedFrame):
            self._output.message(message)
            return
        if isinstance(message, CameraImuSample):
            self._output.message(message)
            self._camera.feed(message)
            return
        if isinstance(message, Event):
            self._output.message(message)
            self._smoother.feed(message)
            return
        if isinstance(message, BlobFrame) and message.pose is None:
            message = replace(message, pose=self._camera.pose(message.t))
        self._smoother.feed(message)

    def finish(self, progress: Callable[[float], None]) -> None:
        calibration = self._smoother.calibration()
        for message, estimate in self._smoother.results(progress):
            if not isinstance(message, Event):  # written as they came
                self._output.message(message)
            if isinstance(message, ImuSample) and estimate is not None:
                self._output.estimate(message, estimate)
        if self._output.report.estimates:
            self._output.calibration(calibration)
