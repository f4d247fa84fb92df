"""Everything that live tracking does with one message after another; no thread, no device.

Messages enter the pipeline in one order, that of their ``t_arrival`` after `ArrivalOrder`, so that
a session read back in that order gives the same states bit for bit.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tracker.applications.stage import ApplicationStage
from tracker.clock import nanoseconds, seconds
from tracker.errors import GlovetrackError
from tracker.fusion.chain.guided.events import began, ended
from tracker.gestures.recogniser import GestureRecogniser, gesture_event
from tracker.live.applications import ApplicationThread
from tracker.live.frame_results import FrameResults
from tracker.live.imu_history import ImuHistory
from tracker.live.inbox import DetectedFrame, EngineCommand, GuidedCommand, Item
from tracker.live.journal import Journal
from tracker.live.load import LoadWatch
from tracker.live.recording import Recorder, RecordingThread
from tracker.live.reference import ReferenceEngine
from tracker.live.telemetry import Telemetry, counted_since
from tracker.messages import (
    BlobFrame,
    Calibration,
    EngineState,
    Estimate,
    FrameResult,
    ImuSample,
    Status,
    StereoFrame,
    Tracking,
)
from tracker.online.colour_watch import ColourWatch
from tracker.pipeline import Pipeline
from tracker.vision.region_prediction import RegionPrediction

Used = tuple[StereoFrame, BlobFrame, FrameResult]
SILENCE = 0.1  # s without packets after which the screen follows the images alone
SURE_SHARE = 0.5  # of the markers expected; with fewer the whole image is searched
TRACKING_WORDS = {
    Tracking.SEARCHING: "Looking for the hand.",
    Tracking.TRACKING: "The hand is tracked.",
    Tracking.COASTING: "The hand is out of sight; its place is extrapolated.",
    Tracking.LOST: "The hand's place is lost; finger angles go on.",
}


Follower = Callable[[Estimate, float], None]
"""Hears of each estimate of a packet, and when (s) that came; at once, so it must not wait."""


class ArrivalOrder:
    """Makes stamps of arrival tell the order of feeding: IMU first where two are equal.

    A stamp is taken and its message fed under one lock: else another's stamp could come between.
    """

    def __init__(self) -> None:
        self._last_ns = -1

    def imu(self, sample: ImuSample) -> ImuSample:
        """The packet, to be fed next, with a stamp later than all before."""
        stamp = max(nanoseconds(sample.t_arrival), self._last_ns + 1)
        self._last_ns = stamp
        arrival = seconds(stamp)
        return sample if arrival == sample.t_arrival else replace(sample, t_arrival=arrival)

    def blobs(self, frame: BlobFrame) -> BlobFrame:
        """The image's blobs, to be fed next, with a stamp not earlier than any before."""
        self._last_ns = max(nanoseconds(frame.t_arrival), self._last_ns)
        return replace(frame, t_arrival=seconds(self._last_ns))

    def mark(self) -> float:
        """An instant (s) between what was fed and what will be."""
        self._last_ns += 1
        return seconds(self._last_ns)


class LiveLoop:
    """`feed` is for one thread; everything else may be called from any.

    ``estimate``, ``calibration``, ``frames.latest`` and ``predicted`` are the latest there are,
    None before the first.
    """

    def __init__(
        self,
        pipeline: Pipeline,
        journal: Journal,
        telemetry: Telemetry,
        clock: Callable[[], float],
        order: ArrivalOrder | None = None,
    ) -> None:
        self.pipeline = pipeline
        self.journal, self.telemetry, self.clock = journal, telemetry, clock
        self.estimate: Estimate | None = None
        self.calibration: Calibration | None = None
        self.frames = FrameResults()
        self.history = ImuHistory(telemetry)
        self.load = LoadWatch()
        self.colours = ColourWatch(len(pipeline.glove.markers))
        self.predicted: RegionPrediction | None = None  # for the vision thread
        self.on_used: Callable[[Used], object] = lambda used: None  # each image, once
        self._order = order or ArrivalOrder()
        names = pipeline.glove.keypoint_names(pipeline.hand)
        self.gestures = GestureRecogniser(pipeline.hand, names)
        self.stage = ApplicationStage(pipeline.hand, pipeline.glove, journal.record)
        self.applications = ApplicationThread(self.stage, telemetry, clock)
        self.followers: tuple[Follower, ...] = ()
        self._reference: ReferenceEngine | None = None
        self._pipeline_lock = threading.RLock()
        self._finishing: list[RecordingThread] = []
        self._next_report = 0.0
        self._at_start: dict[str, float] = {}  # figures when the recording began

    # ---- one message after another

    def feed(self, item: Item) -> None:
        """Do all there is to do about a message."""
        started = self.clock()
        if isinstance(item, ImuSample):
            self._feed_imu(item)
        elif isinstance(item, EngineCommand):
            self._execute(item)
        elif isinstance(item, GuidedCommand):
            self._guide(item)
        else:
            self._feed_frame(item)
        self.telemetry.took("filter", self.clock() - started)
        self._take_results()
        self._report()

    def _feed_imu(self, sample: ImuSample) -> None:
        with self._pipeline_lock:  # a recording holds a packet and its estimate, or neither
            sample = self._order.imu(sample)
            self.history.add(sample)
            self.journal.record(sample)
            self._show(self.pipeline.feed_imu(sample), record=True)
            assert self.estimate is not None
            self.applications.put(self.estimate, sample.t_arrival)
            for follow in self.followers:
                follow(self.estimate, sample.t_arrival)
        self._feed_reference(sample)
        now = self.clock()
        self.telemetry.took("imu", now - sample.t_arrival)
        self.load.packet(now, now - sample.t)

    def _feed_frame(self, found: DetectedFrame) -> None:
        with self._pipeline_lock:
            blobs = self._order.blobs(found.blobs)
            self.frames.wait_for(DetectedFrame(found.frame, blobs))
            self.journal.record(blobs)
            self.pipeline.feed_frame(blobs)
        self._feed_reference(blobs)
        if self.estimate is not None:
            self.colours.look(blobs, self.estimate.tracking)
        if self.history.silent(blobs.t_arrival, SILENCE):
            self._show(self.pipeline.predict(blobs.t), record=False)
        now = self.clock()
        self.load.image(now, now - found.frame.t_arrival, found.missed)

    def _feed_reference(self, message: ImuSample | BlobFrame) -> None:
        reference = self._reference
        if reference is not None:
            reference.put(message)

    def _execute(self, command: EngineCommand) -> None:
        try:
            with self._pipeline_lock:
                command.work(self.pipeline.engine)
                self.record_state()
        except GlovetrackError as error:
            self.journal.say("error", str(error))
        self._next_report = 0.0  # what it changed is shown at once

    def _guide(self, command: GuidedCommand) -> None:
        """Tell the engine of a guided pose, and the recording, between the same two messages."""
        with self._pipeline_lock:
            t = self._order.mark()
            if command.begins:
                event = began(command.pose, t)
            else:
                event = ended(command.pose, t, command.held)
            self.journal.add(event)
            self.pipeline.feed_event(event)

    def _show(self, estimate: Estimate, record: bool) -> None:
        before, self.estimate = self.estimate, estimate
        self.telemetry.tick("estimate", self.clock())
        if record:
            self.journal.record(estimate)
            for phase in self.gestures.feed(estimate):
                self.journal.record(gesture_event(phase, self.gestures.side))
        if before is None or before.tracking != estimate.tracking:
            self.journal.say("tracking", TRACKING_WORDS[estimate.tracking])

    def _take_results(self) -> None:
        pipeline, frames = self.pipeline, self.frames
        for text in pipeline.take_words():
            self.journal.say("device", text)
        for text in self.colours.take_words():
            self.journal.say("tracking", text)
        for text in self.load.take_words():
            self.journal.say("load", text)
        for result in pipeline.take_results():
            found = frames.match(result)
            if found is not None:
                self.on_used((found.frame, found.blobs, result))
                self.telemetry.set("stereo_points", result.stereo_points)
                self.telemetry.took("total", self.clock() - found.frame.t_arrival)
                self._predict_regions(result)
        frames.forget_old()
        if self.estimate is not None and self.estimate.tracking == Tracking.SEARCHING:
            frames.show_unmatched(len(pipeline.glove.markers))

    def _predict_regions(self, result: FrameResult) -> None:
        """Tell the vision thread where markers are, as long as that is sure."""
        matched = np.count_nonzero((result.match_left >= 0) | (result.match_right >= 0))
        estimate, expected = self.estimate, float(result.visible.sum())
        before, self.predicted = self.predicted, None
        if estimate is None or estimate.tracking != Tracking.TRACKING:
            return
        if matched >= SURE_SHARE * expected:
            self.predicted = self.pipeline.region_prediction(estimate.t, before)

    def _report(self) -> None:
        """Once a second: calibration and status, for the screen and the file."""
        now = self.clock()
        if now < self._next_report:
            return
        self._next_report = now + 1.0
        self.calibration = self.pipeline.calibration()
        if self.estimate is not None and self.estimate.tracking != Tracking.SEARCHING:
            self.journal.record(self.calibration)
        self._record_status()

    def _record_status(self) -> None:
        """A file counts what was lost since it began, not since the engine did."""
        if self.journal.recording:
            status = self.status()
            own = counted_since(self._at_start, status.values)
            self.journal.record(replace(status, values=own))

    # ---- from any thread

    def status(self) -> Status:
        """How tracking and the devices are, now."""
        now = self.clock()
        tracking = self.estimate.tracking if self.estimate is not None else Tracking.SEARCHING
        return Status(now, tracking, self.telemetry.values(now))

    def figures(self) -> dict[str, float]:
        """Whether the camera is still as it was calibrated, and how late its images are."""
        rig, timing = self.pipeline.rig_state, self.pipeline.timing
        out = {
            "stereo_swapped": float(rig.swapped),
            "camera_moved": float(rig.moved),
            "camera_jumps": rig.jumps,
            "stereo_refused": rig.refused,
            "camera_offset_applied_ms": 1e3 * timing.applied,
        }
        if math.isfinite(rig.row_shift_px):
            out["stereo_row_shift_px"] = rig.row_shift_px
        if math.isfinite(timing.offset.value):
            out["camera_offset_ms"] = 1e3 * timing.offset.value
            out["camera_offset_sd_ms"] = 1e3 * timing.offset.sd
        return out

    def set_engine(self, name: str) -> None:
        """Track with another engine from the next message on; it looks for the hand anew.

        Raises ConfigError for an unknown name.
        """
        if name == self.pipeline.settings.engine:
            return
        pipeline = self._pipeline_with(name)
        with self._pipeline_lock:
            self.pipeline = pipeline
            self.record_state()
        self.journal.say("tracking", f"The engine is now {name}.")

    def set_reference(self, name: str | None, wait: bool = False) -> None:
        """Let a second engine see the same messages, to be compared with; None ends it.

        ``wait`` until the one before has ended. Raises ConfigError for an unknown name.
        """
        reference = ReferenceEngine(self._pipeline_with(name)) if name else None
        before, self._reference = self._reference, reference
        if before is not None:
            before.close(wait)

    def reference_estimate(self) -> Estimate | None:
        """The second engine's hand; None where there is none."""
        reference = self._reference
        return reference.estimate if reference is not None else None

    def _pipeline_with(self, engine: str) -> Pipeline:
        p = self.pipeline
        return Pipeline(p.hand, p.glove, p.calibrated_rig, replace(p.settings, engine=engine))

    def set_recorder(self, recorder: Recorder | None, patience: float | None = None) -> None:
        """Record into ``recorder`` from now on; the last one is finished and closed.

        That is waited for ``patience`` s, then it goes on by itself; None waits to the end, also of
        those before.
        """
        with self._pipeline_lock:
            self._record_status()
            before = self.journal.detach()
        self._finishing += [before] if before is not None else []
        self._finishing = [r for r in self._finishing if not r.finish(patience)]
        if recorder is not None:
            with self._pipeline_lock:
                self._at_start = self.telemetry.values(self.clock())
                self.journal.open(recorder)
                self.stage.begin_anew()
                self.record_state()
                self._record_status()
            self.journal.say("recording", "Recording.")

    def record_state(self) -> None:
        """Record what no message tells: tracked again, the session goes on as it did live."""
        with self._pipeline_lock:
            if self.journal.recording:
                p = self.pipeline
                self.journal.record(
                    EngineState(self._order.mark(), p.settings.engine, p.get_state())
                )
