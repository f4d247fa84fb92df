"""The state of one of the hands that are tracked live."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.engine.pipeline import SILENCE, Pipeline
from tracker.engine.side_watch import SideWatch
from tracker.gestures.recogniser import GestureRecogniser, gesture_event
from tracker.live.frame_results import FrameResults, ShownFrame
from tracker.live.history import History, ImuHistory
from tracker.live.journal import Journal
from tracker.live.listeners import Listeners
from tracker.live.telemetry import Telemetry
from tracker.messages import BlobFrame, Calibration, Estimate, FrameResult, Status, Tracking
from tracker.vision.region_prediction import RegionPrediction

SURE_SHARE = 0.5  # of the markers expected; with fewer the whole image is searched
NO_PACKETS = 2.0  # s without packets after which whole images are not searched for a lost hand
OF_ONE = {
    Tracking.SEARCHING: notice("tracking.searching"),
    Tracking.TRACKING: notice("tracking.tracked"),
    Tracking.COASTING: warning("tracking.coasting"),
    Tracking.LOST: warning("tracking.lost"),
}


Follower = Callable[[Estimate, float], None]
"""Receives each estimate, and when (s) its packet arrived, or its image while packets are missing;
at once, so it must not wait."""
Subscriber = Callable[[Estimate], None]
"""Receives each estimate that the screen shows, in order of time; it must not wait."""


class LiveHand:
    """Written by the engine's thread, read by any.

    ``estimate``, ``calibration``, ``frames.latest`` and ``predicted`` are the latest, None
    before the first; ``telemetry`` contains figures of this hand only.
    """

    def __init__(
        self,
        pipeline: Pipeline,
        journal: Journal,
        clock: Callable[[], float],
        alone: bool,
    ) -> None:
        self.side, self._alone = pipeline.glove.side, alone
        self._journal, self._clock = journal, clock
        self.telemetry = Telemetry()
        self.estimate: Estimate | None = None
        self._reported: Tracking | None = None
        self.calibration: Calibration | None = None
        self.frames = FrameResults()
        self.history = ImuHistory(self.telemetry)
        self.estimates: History[Estimate] = History()  # those that were shown
        self.predicted: RegionPrediction | None = None  # for the vision thread
        names = pipeline.glove.keypoint_names(pipeline.hand)
        self.gestures = GestureRecogniser(pipeline.hand, names)
        self.listeners = Listeners(partial(journal.report, "error"))
        self.on_used: Callable[[ShownFrame], object] = lambda used: None  # each image, once
        self.followers: tuple[Follower, ...] = ()
        self._subscribers: tuple[Subscriber, ...] = ()  # replaced, never changed
        self._subscribing = threading.Lock()
        self.sides: SideWatch | None = None
        self.watch_side(pipeline)
        self.shown: Mapping[str, float] = {}  # figures of the window for the status
        self._begun = clock()
        self.telemetry.ask(self.history.figures)
        self.telemetry.ask(self._side_figures)

    def watch_side(self, pipeline: Pipeline) -> None:
        """Detects a glove for the other hand, unless there are two: the other hand's blobs would
        be mistaken for its own."""
        self.sides = SideWatch(pipeline) if self._alone else None

    def _side_figures(self) -> dict[str, float]:
        return {"glove_of_other_side": float(self.sides is not None and self.sides.is_other)}

    @property
    def tracking(self) -> Tracking:
        """The state of tracking."""
        return self.estimate.tracking if self.estimate is not None else Tracking.SEARCHING

    @property
    def notice(self) -> Notice:
        """The notice of the state of tracking; with two hands it names the hand."""
        return OF_ONE[self.tracking] if self._alone else of_two(self.tracking, self.side)

    def subscribe(self, subscriber: Subscriber) -> Callable[[], None]:
        """Calls ``subscriber`` with each estimate that is shown; returns a function that ends
        it."""
        with self._subscribing:
            self._subscribers += (subscriber,)

        def unsubscribe() -> None:
            with self._subscribing:
                self._subscribers = tuple(s for s in self._subscribers if s is not subscriber)

        return unsubscribe

    def is_newer(self, estimate: Estimate) -> bool:
        """Returns whether it is of a later instant than the one that is shown."""
        return self.estimate is None or estimate.t > self.estimate.t

    def publish(self, estimate: Estimate, t_arrival: float) -> None:
        """Passes an estimate to listeners and followers, records and shows it.

        ``t_arrival``: s, of the packet, or of the image while packets are missing.
        """
        self.listeners.feed(estimate, t_arrival)
        for follow in self.followers if self.is_newer(estimate) else ():
            follow(estimate, t_arrival)
        is_news = self._show(estimate, by_packet=True)
        self._journal.record(estimate, self.side)
        for phase in self.gestures.feed(estimate):
            self._journal.record(gesture_event(phase, self.side))
        if is_news:
            self._journal.report("tracking", self.notice)

    def follow_images(self, pipeline: Pipeline, blobs: BlobFrame) -> None:
        """Shows and records the hand from images alone while the glove's packets are missing.

        Before the first packet the hand is shown as not found, which is not recorded.
        """
        estimate = pipeline.without_packets(blobs)
        if estimate is not None:
            self.publish(estimate, blobs.t_arrival)
        elif self.history.silent(blobs.t, SILENCE):
            unfound = pipeline.predict(blobs.t)
            if unfound.tracking == Tracking.SEARCHING and self._show(unfound, by_packet=False):
                self._journal.report("tracking", self.notice)

    def _show(self, estimate: Estimate, by_packet: bool) -> bool:
        """Takes over the newest estimate; returns whether the state of tracking has changed.

        Ignores an estimate of an instant before the last one: time never runs backwards on the
        screen and in streams. Before the first packet, images alone do not start a search.
        """
        if not self.is_newer(estimate):
            return False
        self.estimate, state = estimate, estimate.tracking
        self.estimates.add(estimate)
        self.telemetry.tick("estimate", self._clock())
        for subscriber in self._subscribers:
            subscriber(estimate)
        if self._reported is None and not by_packet and state == Tracking.SEARCHING:
            return False
        before, self._reported = self._reported, state
        return before != state

    def take(self, results: list[FrameResult], pipeline: Pipeline) -> None:
        """Matches the results of images with the images."""
        for result in results:
            found = self.frames.match(result)
            if found is not None:
                self.on_used(ShownFrame(found.frame, found.blobs, result))
                self.telemetry.set("stereo_points", result.stereo_points)
                self.telemetry.took("total", self._clock() - found.frame.t_arrival)
                self._predict_regions(result, pipeline)
        self.frames.forget_old()
        if self.estimate is not None and self.estimate.tracking == Tracking.SEARCHING:
            self.frames.show_unmatched(len(pipeline.glove.markers))

    def _predict_regions(self, result: FrameResult, pipeline: Pipeline) -> None:
        """Predicts for the vision thread where markers are, while that is reliable."""
        matched = np.count_nonzero((result.match_left >= 0) | (result.match_right >= 0))
        estimate, expected = self.estimate, float(result.visible.sum())
        before, self.predicted = self.predicted, None
        if estimate is None or estimate.tracking != Tracking.TRACKING:
            return
        if matched >= SURE_SHARE * expected:
            self.predicted = pipeline.ahead.markers(estimate.t, before)

    @property
    def has_no_packets(self) -> bool:
        """Whether its glove is disconnected and it is not in view."""
        if self.tracking in (Tracking.TRACKING, Tracking.COASTING):
            return False
        now = self._clock()
        return now - self._begun > NO_PACKETS and self.history.silent(now, NO_PACKETS)

    def status(self, shared: dict[str, float]) -> Status:
        """Returns the status of this hand and the devices; ``shared``: figures of all hands."""
        now = self._clock()
        return Status(now, self.tracking, {**shared, **self.telemetry.values(now), **self.shown})


def of_two(tracking: Tracking, side: str) -> Notice:
    """The state of tracking of the hand on ``side``, where there is another one."""
    match tracking:
        case Tracking.SEARCHING:
            return notice("tracking.side_searching", side=side)
        case Tracking.TRACKING:
            return notice("tracking.side_tracked", side=side)
        case Tracking.COASTING:
            return warning("tracking.side_coasting", side=side)
        case Tracking.LOST:
            return warning("tracking.side_lost", side=side)


def camera_figures(pipeline: Pipeline) -> dict[str, float]:
    """Returns whether the camera matches its calibration, and the delay of its images."""
    rig, timing = pipeline.rig_state, pipeline.timing
    out = {
        "stereo_swapped": float(rig.swapped),
        "camera_moved": float(rig.moved),
        "camera_jumps": rig.jumps,
        "stereo_refused": rig.refused,
        "camera_offset_applied_ms": 1e3 * timing.applied,
    }
    late = pipeline.pair_offset.estimate
    if math.isfinite(late.value):
        out["right_camera_late_ms"] = 1e3 * late.value
        out["right_camera_late_applied_ms"] = 1e3 * pipeline.pair_offset.applied
    if math.isfinite(drift := pipeline.engine.heading_drift_sd):
        out["heading_sd_deg"] = math.degrees(drift)
    if math.isfinite(rig.row_shift_px):
        out["stereo_row_shift_px"] = rig.row_shift_px
    if math.isfinite(timing.offset.value):
        out["camera_offset_ms"] = 1e3 * timing.offset.value
        out["camera_offset_sd_ms"] = 1e3 * timing.offset.sd
    return out
