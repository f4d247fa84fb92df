"""Live tracking of one message after another; no thread, no device.

Messages enter the pipeline in the order of their ``t_arrival`` after `ArrivalOrder`, so that a
session that is read in that order gives the same states, bit for bit.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial

from tracker.base.clock import nanoseconds, next_instant, seconds
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, notice
from tracker.engine.hands import Hands, Sided
from tracker.engine.side_watch import ExchangeWatch
from tracker.fusion.chain.guided.events import began, ended
from tracker.fusion.chain.pose_reset import reset_event
from tracker.live.hand import LiveHand, camera_figures
from tracker.live.inbox import (
    DetectedFrame,
    EngineCommand,
    GuidedCommand,
    Inbox,
    Item,
    MotorCommand,
    ResetCommand,
)
from tracker.live.journal import Journal
from tracker.live.load import LoadWatch
from tracker.live.recording import Recorder, RecordingThread
from tracker.live.reference import ReferenceSlot
from tracker.live.telemetry import Telemetry, counted_since
from tracker.live.work_priority import WorkPriority
from tracker.messages import (
    BlobFrame,
    EngineState,
    Event,
    ImuSample,
    Status,
    Tracking,
    WristPose,
)
from tracker.online.colour_watch import ColourWatch
from tracker.online.hue_names import hue_names_event
from tracker.vision.region_prediction import RegionPrediction, together
from tracker.vision.rig import StereoRig

BEST = (Tracking.SEARCHING, Tracking.LOST, Tracking.COASTING, Tracking.TRACKING)
"""In ascending order."""

MOST_BETWEEN = 3  # packets of one hand between its part of an image and the other hand's

REPEAT_AFTER = 5.0  # s for which a notice of one hand is not repeated by the other


class ArrivalOrder:
    """Makes stamps of arrival follow the order of feeding: IMU first if two are equal.

    A stamp is set and its message fed under one lock, so that no other stamp is set in between.
    """

    def __init__(self) -> None:
        self._last_ns = -1

    def imu(self, sample: ImuSample) -> ImuSample:
        """Returns the packet, to be fed next, with a stamp later than all before."""
        stamp = max(nanoseconds(sample.t_arrival), next_instant(self._last_ns))
        self._last_ns = stamp
        arrival = seconds(stamp)
        return sample if arrival == sample.t_arrival else replace(sample, t_arrival=arrival)

    def blobs(self, frame: BlobFrame) -> BlobFrame:
        """Returns the blobs, to be fed next, with a stamp not earlier than any before."""
        self._last_ns = max(nanoseconds(frame.t_arrival), self._last_ns)
        return replace(frame, t_arrival=seconds(self._last_ns))

    def wrist(self, pose: WristPose) -> WristPose:
        """Returns the pose, to be fed next, with a stamp later than all before."""
        self._last_ns = max(nanoseconds(pose.t_arrival), next_instant(self._last_ns))
        return replace(pose, t_arrival=seconds(self._last_ns))

    def mark(self) -> float:
        """Returns an instant (s) between the messages before and after."""
        self._last_ns = next_instant(self._last_ns)
        return seconds(self._last_ns)


class RepeatFilter:
    """What the pipelines of both hands report on the one camera: the same notice is not repeated
    within ``timeout`` s, whatever its numbers are."""

    def __init__(self, timeout: float) -> None:
        self._period = timeout
        self._last: dict[tuple[object, ...], float] = {}

    def is_new(self, what: Notice, now: float) -> bool:
        """Whether it was not reported shortly before ``now`` (s)."""
        names = (value for value in what.values.values() if isinstance(value, str))
        subject = (what.code, *names)
        last, self._last[subject] = self._last.get(subject, float("-inf")), now
        return now - last >= self._period


def _guided_event(command: GuidedCommand, t: float) -> Event:
    """The beginning or end of a guided pose."""
    return began(command.pose, t) if command.begins else ended(command.pose, t, command.held)


class LiveLoop:
    """`feed` is for one thread; everything else may be called from any.

    ``seen`` contains the state of each hand by its side, the left one first. ``telemetry`` contains
    the figures of all hands. ``priority`` is entered for each message.
    """

    def __init__(
        self,
        hands: Hands,
        journal: Journal,
        telemetry: Telemetry,
        clock: Callable[[], float],
        order: ArrivalOrder | None = None,
        inbox: Inbox | None = None,
    ) -> None:
        """``inbox``: where messages wait that are fed next."""
        self.hands, self._inbox = hands, inbox or Inbox(clock)
        self.journal, self.telemetry, self.clock = journal, telemetry, clock
        self.priority = WorkPriority()
        pipelines, alone = hands.pipelines, len(hands.pipelines) == 1
        self.seen = {side: LiveHand(p, journal, clock, alone) for side, p in pipelines.items()}
        self.load = LoadWatch()
        self.colours = ColourWatch(sum(len(p.glove.markers) for p in pipelines.values()))
        self._order = order or ArrivalOrder()
        self.reference = ReferenceSlot(lambda name: self.hands.with_engine(name))
        self._pipeline_lock = threading.RLock()
        self._finishing: list[RecordingThread] = []
        self._next_report = 0.0
        self._at_start: dict[str, Mapping[str, float]] = {}  # figures when the recording began
        self._repeats = RepeatFilter(0.0 if alone else REPEAT_AFTER)
        self._exchange = _exchange_watch(hands)
        for side, hand in self.seen.items():
            hand.telemetry.ask(partial(_camera_figures, self, side))

    # ---- one message after another

    def feed(self, item: Item) -> None:
        """Processes a message completely."""
        with self.priority:
            self._feed(item)

    def _feed(self, item: Item) -> None:
        started = self.clock()
        if isinstance(item, Sided):
            self._feed_imu(item)
        elif isinstance(item, WristPose):
            self._feed_wrist(item)
        elif isinstance(item, EngineCommand):
            self._execute(item)
        elif isinstance(item, GuidedCommand):  # between the same two messages as in the recording
            with self._pipeline_lock:
                self._request(_guided_event(item, self._order.mark()), item.side)
        elif isinstance(item, MotorCommand):
            with self._pipeline_lock:
                event = replace(item.event, t=self._order.mark())
                self._request(event, item.side, listed=False)  # a contact runs a motor at 20 Hz
        elif isinstance(item, ResetCommand):
            with self._pipeline_lock:
                self._request(reset_event(self._order.mark()), item.side)
        else:
            self._feed_frame(item)
        self.telemetry.took("filter", self.clock() - started)
        self._process_results()
        self._report()

    def _feed_imu(self, packet: Sided) -> None:
        side, hand = packet.side, self.seen[packet.side]
        with self._pipeline_lock:  # a recording contains a packet and its estimate, or neither
            sample = self._order.imu(packet.sample)
            hand.history.add(sample)
            self.journal.record(sample, side)
            estimate = self.hands.feed_imu(side, sample)
            hand.publish(estimate, sample.t_arrival)
        found: Mapping[str, tuple[str, ...]] = {}  # names of hues, by side
        if hand.sides is not None:
            hand.sides.packet(sample, estimate.tracking)
            found = {side: names} if (names := hand.sides.take_names()) else {}
        if self._exchange is not None:
            self._exchange.packet(side, sample, estimate.tracking)
            found = self._exchange.take_names()
        for k, (of, names) in enumerate(found.items()):
            hues = self.hands.pipelines[of].glove.hues
            with self._pipeline_lock:
                event = hue_names_event(hues, names, self._order.mark())
                self._request(event, of, listed=k == 0)
        self.reference.put(Sided(sample, side))
        now = self.clock()
        hand.telemetry.took("imu", now - sample.t_arrival)
        self.load.packet(now, now - sample.t)

    def _feed_wrist(self, pose: WristPose) -> None:
        if pose.side not in self.seen:
            return
        with self._pipeline_lock:
            pose = self._order.wrist(pose)
            self.journal.record(pose, pose.side)
            self.hands.feed_wrist(pose)
        self.reference.put(pose)

    def _feed_frame(self, found: DetectedFrame) -> None:
        with self._pipeline_lock:
            blobs = self._order.blobs(found.blobs)
            for hand in self.seen.values():
                hand.frames.wait_for(DetectedFrame(found.frame, blobs))
            self.journal.record(blobs)
            self.reference.put(blobs)
            if self._exchange is not None:
                self._exchange.frame(blobs)
            self._feed_parts(blobs)
        if any(hand.estimate is not None for hand in self.seen.values()):
            self.colours.look(blobs, _best(hand.tracking for hand in self.seen.values()))
        now = self.clock()
        self.load.image(now, now - found.frame.t_arrival, found.missed)

    def _feed_parts(self, blobs: BlobFrame) -> None:
        """Feeds an image to one hand after the other; in between, the first one's packets need not
        wait for the second one's part."""
        feeds = self.hands.feeds(blobs)
        for k, side in enumerate(self._inbox.in_order(feeds)):
            feeds[side]()
            hand = self.seen[side]
            hand.follow_images(self.hands.pipelines[side], blobs)
            if hand.sides is not None:
                hand.sides.frame(blobs)
            if k + 1 < len(feeds):
                self._feed_waiting(side)

    def _feed_waiting(self, side: str) -> None:
        """Processes packets of a hand that wait, before its other messages."""
        for _ in range(MOST_BETWEEN):
            packet = self._inbox.packet_of(side)
            if packet is None:
                return
            self._feed(packet)

    def _execute(self, command: EngineCommand) -> None:
        try:
            with self._pipeline_lock:
                command.work(self.hands.pipelines[command.side].engine)
                self.record_state()
        except GlovetrackError as error:
            self.journal.report("error", error.notice)
        self._next_report = 0.0  # its effect is shown immediately

    def _request(self, event: Event, side: str, listed: bool = True) -> None:
        """Feeds and records a request to one hand; with two hands, the event names the hand.
        ``listed``: also in the log."""
        if len(self.seen) > 1:
            event = replace(event, data={**event.data, "hand": side})
        if listed:
            self.journal.add(event)
        else:
            self.journal.record(event)
        self.hands.feed_event(event)

    def _process_results(self) -> None:
        for side, pipeline in self.hands.pipelines.items():
            for found in pipeline.drain_notices():
                if self._repeats.is_new(found, self.clock()):
                    self.journal.report("device", found)
            hand = self.seen[side]
            hand.take(self.hands.take_results(side), pipeline)
            self.journal.report_all("error", hand.sides)
        self.journal.report_all("error", self._exchange)
        self.journal.report_all("tracking", self.colours)
        self.journal.report_all("load", self.load)

    def _report(self) -> None:
        """Once a second, updates and records calibration and status."""
        now = self.clock()
        if now < self._next_report:
            return
        self._next_report = now + 1.0
        for side, hand in self.seen.items():
            hand.calibration = self.hands.pipelines[side].calibration()
            if hand.estimate is not None and hand.tracking != Tracking.SEARCHING:
                self.journal.record(hand.calibration, side)
        self._record_status()

    def _record_status(self) -> None:
        """Records the status; its counts begin with the recording, not with the engine."""
        if self.journal.recording:
            for side in self.seen:
                status = self.status(side)
                own = counted_since(self._at_start[side], status.values)
                self.journal.record(replace(status, values=own), side)

    # ---- from any thread

    @property
    def rig(self) -> StereoRig:
        """The camera of all hands."""
        return next(iter(self.hands.pipelines.values())).rig

    @property
    def predicted(self) -> RegionPrediction | None:
        """The regions of all hands' markers; None while a hand in view is not found yet."""
        present = [hand.predicted for hand in self.seen.values() if not hand.has_no_packets]
        known = [p for p in present if p is not None]
        return together(known) if known and len(known) == len(present) else None

    def status(self, side: str) -> Status:
        """Returns the current status of a hand and of the devices."""
        return self.seen[side].status(self.telemetry.values(self.clock()))

    def set_engine(self, name: str) -> None:
        """Switches to another engine with the next message; it starts by searching for the hands.

        Raises ConfigError for an unknown name.
        """
        if self.hands.engine == name:
            return
        hands = self.hands.with_engine(name)
        with self._pipeline_lock:
            self.hands, self._exchange = hands, _exchange_watch(hands)
            for side, hand in self.seen.items():
                hand.watch_side(hands.pipelines[side])
            self.record_state()
        self.journal.report("tracking", notice("engine.changed", engine=name))

    def set_recorder(self, recorder: Recorder | None, timeout: float | None = None) -> None:
        """Starts recording into ``recorder``; the previous recording is finished and closed.

        Waits for that at most ``timeout`` s, after which it continues in the background. None:
        waits until this and all earlier recordings are finished.
        """
        with self._pipeline_lock:
            self._record_status()
            before = self.journal.detach()
        self._finishing += [before] if before is not None else []
        self._finishing = [r for r in self._finishing if not r.finish(timeout)]
        if recorder is not None:
            with self._pipeline_lock:
                self._at_start = {side: self.status(side).values for side in self.seen}
                self.journal.open(recorder)
                for hand in self.seen.values():
                    hand.listeners.restart()
                self.record_state()
                self._record_status()
            self.journal.report("recording", notice("recording.started"))

    def record_state(self) -> None:
        """Records the engine's state, so that tracking the session again gives the live results."""
        with self._pipeline_lock:
            if self.journal.recording:
                state = self.hands.get_state()
                self.journal.record(EngineState(self._order.mark(), self.hands.engine, state))


def _best(states: Iterable[Tracking]) -> Tracking:
    """Returns the best state of the hands: the colours fit if any hand is found."""
    return max(states, key=BEST.index)


def _camera_figures(loop: LiveLoop, side: str) -> dict[str, float]:
    """Returns the figures of the hand's current pipeline, which changes with the engine."""
    return camera_figures(loop.hands.pipelines[side])


def _exchange_watch(hands: Hands) -> ExchangeWatch | None:
    """Returns a watch for exchanged gloves; None for one glove."""
    return None if hands.alone else ExchangeWatch(hands)
