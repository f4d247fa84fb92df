"""Threads and channels around one pipeline: the only place of the engine where threads live.

    glove thread ──┐ inbox (Fifo)
                   ├──────────────> engine thread ──> latest estimate, recorder
    camera thread ─┴> vision thread                    (disk thread behind a Fifo)

Messages enter the pipeline in one order, that of their ``t_arrival`` after `_Order`, so that a
session read back in that order gives the same states bit for bit.
"""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from tracker.channels import Closed, Fifo, Latest
from tracker.clock import nanoseconds, seconds
from tracker.errors import GlovetrackError
from tracker.fusion.engine import Engine
from tracker.live.recording import Recorder, RecordingThread
from tracker.live.shadow import Shadow
from tracker.live.telemetry import Telemetry
from tracker.messages import (
    BlobFrame,
    Calibration,
    EngineState,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    Tracking,
)
from tracker.pipeline import Pipeline
from tracker.sensors.image_watch import SilenceWatch
from tracker.sensors.sources import CameraSource, GloveSource, ReportingGlove
from tracker.settings import Settings
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import DetectionHints, Detector, detect_frame
from tracker.vision.region_prediction import RegionPrediction, SearchPlan

WAIT = 0.05  # s that a thread waits before it looks whether it should end
SILENCE = 0.1  # s without packets after which the screen follows the images alone
HISTORY_S = 10.0
SURE_SHARE = 0.5  # of the markers expected; with fewer the whole image is searched
MAX_FRAMES_BEHIND = 3
TRACKING_WORDS = {
    Tracking.SEARCHING: "Looking for the hand.",
    Tracking.TRACKING: "The hand is tracked.",
    Tracking.COASTING: "The hand is out of sight; its place is extrapolated.",
    Tracking.LOST: "The hand's place is lost; finger angles go on.",
}


def monotonic() -> float:
    """Seconds of the host's monotonic clock, a whole number of nanoseconds."""
    return seconds(time.monotonic_ns())


@dataclass(frozen=True, eq=False)
class _Found:
    """An image and what the detector found in it."""

    frame: StereoFrame
    blobs: BlobFrame


@dataclass(frozen=True, eq=False)
class _Command:
    """Something to be done to the engine between two messages."""

    work: Callable[[Engine], None]


class _Order:
    """Makes stamps of arrival tell the order of feeding: IMU first where two are equal."""

    def __init__(self) -> None:
        self._last = -1

    def imu(self, sample: ImuSample) -> ImuSample:
        stamp = max(nanoseconds(sample.t_arrival), self._last + 1)
        self._last = stamp
        arrival = seconds(stamp)
        return sample if arrival == sample.t_arrival else replace(sample, t_arrival=arrival)

    def blobs(self, frame: BlobFrame) -> BlobFrame:
        self._last = max(nanoseconds(frame.t_arrival), self._last)
        return replace(frame, t_arrival=seconds(self._last))

    def mark(self) -> float:
        """An instant between what was fed and what will be."""
        self._last += 1
        return seconds(self._last)


class LiveTracker:
    """Runs one pipeline on live devices until `stop`. Methods may be called from any thread."""

    def __init__(
        self,
        pipeline: Pipeline,
        profile: ColourProfile,
        make_detector: Callable[[ColourProfile], Detector],
        glove: GloveSource,
        camera: CameraSource,
        recorder: Recorder | None = None,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        self._pipeline = pipeline
        self._make_detector, self._detector = make_detector, make_detector(profile)
        self._profile = profile
        self._glove, self._camera, self._clock = glove, camera, clock
        self._stopping = threading.Event()
        self._threads: list[threading.Thread] = []
        self._inbox: Fifo[ImuSample | _Found | _Command] = Fifo(4096)
        self._images: Latest[StereoFrame] = Latest()
        self._events: Fifo[Event] = Fifo(2000)
        self._telemetry = Telemetry()
        self._silence = SilenceWatch("camera")
        self._plan = SearchPlan()
        self._predicted: RegionPrediction | None = None  # of the engine, for the vision thread
        self._order = _Order()
        self._disk: RecordingThread | None = None
        self._shadow: Shadow | None = None
        self._history: deque[ImuSample] = deque()
        self._estimate: Estimate | None = None
        self._frame: tuple[StereoFrame, BlobFrame, FrameResult] | None = None
        self._calibration: Calibration | None = None
        self._waiting: deque[_Found] = deque()
        self._lost_packets = self._skipped = self._behind = 0
        self._counting = threading.Lock()
        self._whole = threading.RLock()
        self._next_slow = 0.0
        if recorder is not None:
            self.set_recorder(recorder)

    # ---- control

    def start(self) -> None:
        """Start all threads. Once only."""
        for name, work in (
            ("glove", self._run_glove),
            ("camera", self._run_camera),
            ("vision", self._run_vision),
            ("engine", self._run_engine),
        ):
            thread = threading.Thread(
                target=self._guarded, args=(name, work), name=f"glovetrack-{name}", daemon=True
            )
            self._threads.append(thread)
            thread.start()

    def stop(self) -> None:
        """End all threads, finish the recording, free the devices. May be called again."""
        self._stopping.set()
        self._inbox.close()
        self._images.close()
        for thread in self._threads:
            thread.join()
        self._threads.clear()
        self.set_shadow(None)
        self.set_recorder(None)
        self._glove.close()
        self._camera.close()

    def set_profile(self, profile: ColourProfile) -> None:
        """Detect with other colours from the next image on."""
        self._profile = profile  # the vision thread makes its detector, which takes a while

    @property
    def profile(self) -> ColourProfile:
        """The colours that are looked for now."""
        return self._profile

    @property
    def settings(self) -> Settings:
        """What is tracked with now."""
        return self._pipeline.settings

    def set_engine(self, name: str) -> None:
        """Track with another engine from the next message on; it looks for the hand anew.

        Raises ConfigError for an unknown name.
        """
        p = self._pipeline
        if name == p.settings.engine:
            return
        pipeline = Pipeline(p.hand, p.glove, p.rig, replace(p.settings, engine=name))
        with self._whole:
            self._pipeline = pipeline
            self._record_state()
        self._say("tracking", f"The engine is now {name}.")

    def set_shadow(self, name: str | None) -> None:
        """Let a second engine see the same messages, to be compared with; None ends it.

        Raises ConfigError for an unknown name.
        """
        p = self._pipeline
        settings = replace(p.settings, engine=name or p.settings.engine)
        shadow = Shadow(Pipeline(p.hand, p.glove, p.rig, settings)) if name else None
        before, self._shadow = self._shadow, shadow
        if before is not None:
            before.close(wait=self._stopping.is_set())

    def shadow_estimate(self) -> Estimate | None:
        """The second engine's hand; None where there is none."""
        shadow = self._shadow
        return shadow.estimate if shadow is not None else None

    def _cast(self, message: ImuSample | BlobFrame) -> None:
        shadow = self._shadow
        if shadow is not None:
            shadow.put(message)

    def command(self, work: Callable[[Engine], None]) -> None:
        """Have ``work`` done to the engine, in its own thread, between two messages.

        A GlovetrackError that it raises is told as an event.
        """
        self._inbox.put(_Command(work))

    def set_recorder(self, recorder: Recorder | None) -> None:
        """Record into ``recorder`` from now on; the last one is finished and closed."""
        with self._whole:
            before, self._disk = self._disk, None
        if before is not None:
            before.finish()
            self._say("recording", "The recording is finished.")
        if recorder is not None:
            with self._whole:
                self._disk = RecordingThread(recorder, self._say)
                self._record_state()
            self._say("recording", "Recording.")

    def keep_state(self) -> None:
        """Record what the engine knows: after a pause in the file, for one."""
        with self._whole:
            self._record_state()

    # ---- what there is to see

    def latest_estimate(self) -> Estimate | None:
        return self._estimate

    def latest_frame(self) -> tuple[StereoFrame, BlobFrame, FrameResult] | None:
        return self._frame

    def recent_imu(self) -> list[ImuSample]:
        """Packets of the last seconds, oldest first."""
        while True:
            try:
                return list(self._history)
            except RuntimeError:  # the engine thread appended meanwhile
                continue

    def calibration(self) -> Calibration | None:
        return self._calibration

    def take_events(self) -> list[Event]:
        return self._events.drain()

    def status(self) -> Status:
        now = self._clock()
        t = self._telemetry
        t.set("frames_dropped", self._images.dropped + self._skipped)
        t.set("imu_lost", self._lost_packets)
        t.set("imu_overflow", self._inbox.overflowed)
        self._set_camera_status()
        if self._disk is not None:
            t.set("pictures_thinned", self._disk.thinned)
        self._set_glove_health()
        tracking = self._estimate.tracking if self._estimate else Tracking.SEARCHING
        return Status(now, tracking, t.values(now))

    def _set_camera_status(self) -> None:
        t, rig, timing = self._telemetry, self._pipeline.rig_state, self._pipeline.timing
        t.set("stereo_swapped", float(rig.swapped))
        t.set("camera_moved", float(rig.moved))
        t.set("camera_jumps", rig.jumps)
        t.set("stereo_refused", rig.refused)
        if math.isfinite(rig.row_shift_px):
            t.set("stereo_row_shift_px", rig.row_shift_px)
        if math.isfinite(timing.offset.value):
            t.set("camera_offset_ms", 1e3 * timing.offset.value)
            t.set("camera_offset_sd_ms", 1e3 * timing.offset.sd)
        t.set("camera_offset_applied_ms", 1e3 * timing.applied)

    def _set_glove_health(self) -> None:
        """Battery and temperature, of a glove that tells them."""
        if not isinstance(self._glove, ReportingGlove):
            return
        figures = self._glove.figures
        if figures.battery_mV is not None:
            self._telemetry.set("battery_v", figures.battery_mV / 1000)
        if figures.temperature_cC is not None:
            self._telemetry.set("temperature_c", figures.temperature_cC / 100)

    # ---- threads

    def _guarded(self, name: str, work: Callable[[], None]) -> None:
        """A thread that fails says so and ends; the others go on."""
        try:
            work()
        except Closed:
            return
        except GlovetrackError as error:
            self._say("error", str(error))
        except Exception as error:  # noqa: BLE001 - the last line of defence of a thread
            self._say("error", f"The {name} thread failed: {type(error).__name__}: {error}.")

    def _run_glove(self) -> None:
        while not self._stopping.is_set():
            for item in self._glove.poll(WAIT):
                if isinstance(item, Event):
                    self._tell(item)
                else:
                    self._inbox.put(item)

    def _run_camera(self) -> None:
        while not self._stopping.is_set():
            frame = self._camera.read(WAIT)
            for event in self._camera.take_events():
                self._tell(event)
            if frame is not None:
                self._telemetry.tick("frame", frame.t_arrival)
                self._record(frame)
                self._images.put(frame)

    def _run_vision(self) -> None:
        while not self._stopping.is_set():
            frame = self._images.get(WAIT)
            self._notice_silence(frame)
            if frame is None:
                continue
            if self._detector.profile is not self._profile:
                self._detector = self._make_detector(self._profile)
            started = self._clock()
            blobs = detect_frame(self._detector, frame, self._hints(frame))
            self._telemetry.took("detect", self._clock() - started)
            if self._behind >= MAX_FRAMES_BEHIND:  # the engine has older ones to do
                self._skipped += 1
                continue
            with self._counting:
                self._behind += 1
            self._inbox.put(_Found(frame, blobs))

    def _hints(self, frame: StereoFrame) -> tuple[DetectionHints, DetectionHints] | None:
        """Where to look for markers; None for the whole image."""
        names = self._profile.hue_names
        return self._plan.hints(self._predicted, self._pipeline.rig, frame.t, frame.pose, names)

    def _notice_silence(self, frame: StereoFrame | None) -> None:
        """A device may hang in a call that never returns: here it is noticed all the same."""
        watch, now = self._silence, self._clock()
        text = watch.look(now) if frame is None else watch.heard(now)
        if text:
            self._say("device", text)

    def _run_engine(self) -> None:
        while not self._stopping.is_set():
            item = self._inbox.get(WAIT)
            if item is None:
                continue
            started = self._clock()
            if isinstance(item, ImuSample):
                self._feed_imu(item)
            elif isinstance(item, _Command):
                self._obey(item)
            else:
                with self._counting:
                    self._behind -= 1
                self._feed_frame(item)
            self._telemetry.took("filter", self._clock() - started)
            self._take_results()
            self._now_and_then()

    # ---- the engine thread's work

    def _obey(self, command: _Command) -> None:
        try:
            with self._whole:
                command.work(self._pipeline.engine)
                self._record_state()
        except GlovetrackError as error:
            self._say("error", str(error))
        self._next_slow = 0.0  # what it changed is shown at once

    def _feed_imu(self, sample: ImuSample) -> None:
        sample = self._order.imu(sample)
        self._remember(sample)
        with self._whole:  # a recording holds a packet and its estimate, or neither of them
            self._record(sample)
            self._show(self._pipeline.feed_imu(sample), record=True)
        self._cast(sample)
        self._telemetry.took("imu", self._clock() - sample.t_arrival)

    def _remember(self, sample: ImuSample) -> None:
        self._telemetry.tick("imu", sample.t_arrival)
        history = self._history
        if history and sample.seq > history[-1].seq + 1 > 0:
            self._lost_packets += sample.seq - history[-1].seq - 1
        history.append(sample)
        while history[-1].t - history[0].t > HISTORY_S:
            history.popleft()

    def _feed_frame(self, found: _Found) -> None:
        blobs = self._order.blobs(found.blobs)
        self._waiting.append(_Found(found.frame, blobs))
        with self._whole:
            self._record(blobs)
            self._pipeline.feed_frame(blobs)
        self._cast(blobs)
        silent = not self._history or blobs.t_arrival - self._history[-1].t_arrival > SILENCE
        if silent:
            self._show(self._pipeline.predict(blobs.t), record=False)

    def _take_results(self) -> None:
        for text in self._pipeline.take_words():
            self._say("device", text)
        for result in self._pipeline.take_results():
            while self._waiting and self._waiting[0].blobs.t < result.t:
                self._waiting.popleft()
            if not self._waiting:
                continue
            found = self._waiting.popleft()
            self._frame = (found.frame, found.blobs, result)
            self._telemetry.set("stereo_points", result.stereo_points)
            self._telemetry.took("total", self._clock() - found.frame.t_arrival)
            self._look_out(result)
        while len(self._waiting) > 30:  # nothing is made of images while searching
            found = self._waiting.popleft()
        if self._waiting and self._estimate and self._estimate.tracking == Tracking.SEARCHING:
            found = self._waiting[-1]
            nothing = FrameResult.nothing(
                found.blobs.t, Tracking.SEARCHING, len(self._pipeline.glove.markers)
            )
            self._frame = (found.frame, found.blobs, nothing)

    def _look_out(self, result: FrameResult) -> None:
        """Tell the vision thread where markers are, as long as that is sure."""
        matched = np.count_nonzero((result.match_left >= 0) | (result.match_right >= 0))
        estimate, expected = self._estimate, float(result.visible.sum())
        self._predicted, before = None, self._predicted
        if estimate is None or estimate.tracking != Tracking.TRACKING:
            return
        if matched >= SURE_SHARE * expected:
            self._predicted = self._pipeline.region_prediction(estimate.t, before)

    def _show(self, estimate: Estimate, record: bool) -> None:
        before = self._estimate
        self._estimate = estimate
        self._telemetry.tick("estimate", self._clock())
        if record:
            self._record(estimate)
        if before is None or before.tracking != estimate.tracking:
            self._say("tracking", TRACKING_WORDS[estimate.tracking])

    def _now_and_then(self) -> None:
        """Once a second: calibration and status, for the screen and the file."""
        now = self._clock()
        if now < self._next_slow:
            return
        self._next_slow = now + 1.0
        self._calibration = self._pipeline.calibration()
        if self._estimate is not None and self._estimate.tracking != Tracking.SEARCHING:
            self._record(self._calibration)
        self._record(self.status())

    # ---- words and disk

    def _say(self, kind: str, text: str) -> None:
        self._tell(Event(self._clock(), kind, text))

    def _tell(self, event: Event) -> None:
        self._events.put(event)
        self._record(event)

    def note(self, text: str) -> None:
        """A timestamped note of the user's."""
        self._say("note", text)

    def _record_state(self) -> None:
        """What no message tells: tracked again, the session goes on from here as it did live."""
        if self._disk is not None:
            pipeline = self._pipeline
            state = EngineState(self._order.mark(), pipeline.settings.engine, pipeline.get_state())
            self._record(state)

    def _record(self, message: Message) -> None:
        disk = self._disk
        if disk is not None:
            disk.put(message)
