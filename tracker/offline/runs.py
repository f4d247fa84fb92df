"""A session's messages through a pipeline into a new session: as live, or smoothed as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from tracker.messages import BlobFrame, Calibration, Estimate, ImuSample, Tracking
from tracker.offline.report import Counter, TrackReport, TruthCheck
from tracker.offline.smooth import Smoother
from tracker.pipeline import Pipeline
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

    def estimate(self, sample: ImuSample, estimate: Estimate) -> None:
        self._recorder.write(estimate)
        if self._check is not None:
            self._check.add(estimate)
        self._counter.count(sample, estimate.tracking)

    def calibration(self, calibration: Calibration) -> None:
        self._recorder.write(calibration)


class LiveRun:
    """The estimates of a live run, bit for bit."""

    def __init__(self, pipeline: Pipeline, output: Output) -> None:
        self._pipeline, self._output = pipeline, output
        self._next_calibration = -np.inf

    def feed(self, message: ImuSample | BlobFrame) -> None:
        self._output.message(message)
        if isinstance(message, BlobFrame):
            self._pipeline.feed_frame(message)
        else:
            self._feed_imu(message)
        self._pipeline.take_results()

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
