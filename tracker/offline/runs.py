"""A session's messages through a pipeline into a new session: as live, or smoothed as a whole."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from tracker.errors import FileError
from tracker.messages import BlobFrame, Calibration, EngineState, Estimate, ImuSample, Tracking
from tracker.offline.report import Counter, TrackReport, TruthCheck
from tracker.offline.smooth import Smoother
from tracker.pipeline import Pipeline
from tracker.session import engine_state
from tracker.session.writer import SessionRecorder

CALIBRATION_PERIOD = 1.0  # s between two calibrations in the file


class Run(Protocol):
    """What `track` feeds; ``progress`` of `finish` hears the share of the rest that is done."""

    def feed(self, message: ImuSample | BlobFrame) -> None: ...

    def finish(self, progress: Callable[[float], None]) -> None: ...


class Output:
    """The new session and what is counted on the way into it."""

    def __init__(
        self, recorder: SessionRecorder, with_sensors: bool, check: TruthCheck | None
    ) -> None:
        self._recorder, self._with_sensors, self._check = recorder, with_sensors, check
        self._counter = Counter()

    @property
    def report(self) -> TrackReport:
        return self._counter.report

    def message(self, message: ImuSample | BlobFrame) -> None:
        """A message as it was fed; before its estimate."""
        if self._with_sensors:
            self._recorder.write(message)
        self.report.frames += isinstance(message, BlobFrame)

    def state(self, state: EngineState) -> None:
        """What the engine went on from: part of what it takes to track again."""
        if self._with_sensors:
            self._recorder.write(state)

    def estimate(self, sample: ImuSample, estimate: Estimate) -> None:
        self._recorder.write(estimate)
        if self._check is not None:
            self._check.add(estimate)
        self._counter.count(sample, estimate.tracking)

    def calibration(self, calibration: Calibration) -> None:
        self._recorder.write(calibration)


class LiveRun:
    """The estimates of a live run, bit for bit.

    ``states``, in order of time, are what the engine knew at some instants; it goes on from each.
    """

    def __init__(
        self,
        make_pipeline: Callable[[str], Pipeline],
        engine: str,
        output: Output,
        states: Sequence[EngineState] = (),
    ) -> None:
        """``make_pipeline`` builds one with the engine of that name."""
        self._make_pipeline, self._pipeline = make_pipeline, make_pipeline(engine)
        self._output, self._states = output, deque(states)
        self._next_calibration = -np.inf

    def feed(self, message: ImuSample | BlobFrame) -> None:
        while self._states and self._states[0].t <= message.t_arrival:
            self._go_on_from(self._states.popleft())
        self._output.message(message)
        if isinstance(message, BlobFrame):
            self._pipeline.feed_frame(message)
        else:
            self._feed_imu(message)
        self._pipeline.take_results()

    def _go_on_from(self, known: EngineState) -> None:
        pipeline = self._make_pipeline(known.engine)
        if not engine_state.fits(known.state, pipeline.get_state()):
            raise FileError("The state of tracking in the recording is not that of its engine.")
        pipeline.set_state(known.state)
        self._pipeline = pipeline
        self._output.state(known)

    def _feed_imu(self, sample: ImuSample) -> None:
        estimate = self._pipeline.feed_imu(sample)
        self._output.estimate(sample, estimate)
        if sample.t >= self._next_calibration:
            self._next_calibration = sample.t + CALIBRATION_PERIOD
            if estimate.tracking != Tracking.SEARCHING:
                self._output.calibration(self._pipeline.calibration())

    def finish(self, progress: Callable[[float], None]) -> None:
        if self._output.report.estimates:
            self._output.calibration(self._pipeline.calibration())


class SmoothRun:
    """Estimates that know the whole session; all are written at the end."""

    def __init__(self, smoother: Smoother, output: Output) -> None:
        self._smoother, self._output = smoother, output

    def feed(self, message: ImuSample | BlobFrame) -> None:
        self._smoother.feed(message)

    def finish(self, progress: Callable[[float], None]) -> None:
        calibration = self._smoother.calibration()
        for message, estimate in self._smoother.results(progress):
            self._output.message(message)
            if isinstance(message, ImuSample) and estimate is not None:
                self._output.estimate(message, estimate)
        if self._output.report.estimates:
            self._output.calibration(calibration)
