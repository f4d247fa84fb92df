"""The threads of live tracking around one `LiveLoop`, and their interface for the window.

    glove thread ──┐ inbox                              (one for each glove)
                   ├──────────────> engine thread ──> latest estimate, recorder
    camera thread ─┴> vision thread <── colours thread (disk thread behind a queue)

A recording and a reference engine bring a thread each (`recording`, `reference`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

from tracker.base.callbacks import ignore
from tracker.base.clock import monotonic
from tracker.base.notices import Notice
from tracker.calibration.colours_follow import ColourFollower
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.engine import Engine
from tracker.live.colours import FollowedColours
from tracker.live.frame_results import ShownFrame
from tracker.live.hand import Follower
from tracker.live.history import SearchedImage
from tracker.live.inbox import (
    CameraReader,
    EngineCommand,
    GloveReader,
    GuidedCommand,
    Inbox,
    ResetCommand,
)
from tracker.live.journal import Journal
from tracker.live.listeners import ListenedHand, Listener, ListenerKind, LiveAccess, Vibrate
from tracker.live.loop import LiveLoop
from tracker.live.recording import Recorder
from tracker.live.telemetry import Telemetry
from tracker.live.threads import ThreadGroup
from tracker.live.vision import Vision
from tracker.live.work_priority import WorkPriority
from tracker.messages import (
    Calibration,
    Estimate,
    Event,
    ImuSample,
    Message,
    Status,
    WristPose,
)
from tracker.sensors.sources import CameraSource, GloveSource
from tracker.session.description import MAIN
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector

T = TypeVar("T")
STOPPING = 1.5  # s to wait for threads and devices; a driver may hang forever
TIMEOUT = 0.3  # s to wait for the end of a recording
WAIT = 0.05  # s between checks whether the engine thread should end


class LiveTracker:
    """Tracks on live devices until `stop`. Methods may be called from any thread.

    `hand` returns the interface of one hand.
    """

    def __init__(
        self,
        hands: Hands,
        profile: ColourProfile,
        make_detector: Callable[[ColourProfile], Detector],
        gloves: Mapping[str, GloveSource],
        camera: CameraSource,
        recorder: Recorder | None = None,
        clock: Callable[[], float] = monotonic,
        turn: Callable[[str], None] = lambda name: None,
    ) -> None:
        """``gloves`` by the side of their hands. ``clock`` gives s; ``turn`` may hold threads back,
        see `ThreadGroup`."""
        self._gloves, self._camera = gloves, camera
        self._journal, telemetry = Journal(clock), Telemetry()
        self._clock, self._inbox = clock, Inbox(clock)
        self._loop = LiveLoop(hands, self._journal, telemetry, clock, inbox=self._inbox)
        self._vision = Vision(profile, make_detector, self._inbox, self._loop)
        side = MAIN if MAIN in hands.pipelines else next(iter(hands.pipelines))
        follower = _follower(profile, hands.pipelines[side])  # one hand determines the colours
        self._colours = FollowedColours(follower, self._vision, self._journal)
        self._loop.seen[side].on_used = self._colours.used.put
        self._glove_readers = {
            side: GloveReader(glove, side, self._inbox, self._journal, len(gloves) > 1)
            for side, glove in gloves.items()
        }
        self._camera_reader = CameraReader(camera, self._vision.images, self._journal, telemetry)
        self._threads = ThreadGroup(self._journal.report, turn)
        for part in (
            self._vision,
            self._loop.load,
            self._loop.colours,
            self._inbox,
            self._journal,
        ):
            telemetry.ask(part.figures)
        for side, reader in self._glove_readers.items():
            self._loop.seen[side].telemetry.ask(reader.figures)
        if recorder is not None:
            self.set_recorder(recorder)

    # ---- control

    def start(self) -> None:
        """Start all threads. Once only."""
        for side, reader in self._glove_readers.items():
            self._threads.start(self._glove_thread(side), reader.step, soon=True)
        self._threads.start("camera", self._camera_reader.step)
        self._threads.start("colours", self._colours.step)
        self._threads.start("vision", self._vision.step)
        self._threads.start("engine", self._feed, soon=True)

    def stop(self, timeout: float | None = None) -> None:
        """Ends all threads, releases the devices, finishes the recording. May be called again.

        Waits at most ``timeout`` s for the recording, which then continues in the background;
        None: waits until it is finished.
        """
        self._threads.request_stop()
        self._inbox.close()
        self._vision.images.close()
        self._colours.used.close()
        devices = {self._glove_thread(side): glove.close for side, glove in self._gloves.items()}
        self._threads.join({**devices, "camera": self._camera.close}, STOPPING)
        self.set_reference(None)
        for hand in self._loop.seen.values():
            hand.listeners.close()
        self._loop.set_recorder(None, timeout)

    def _glove_thread(self, side: str) -> str:
        return "glove" if len(self._gloves) == 1 else f"glove-{side}"

    @property
    def failure(self) -> Notice | None:
        """Why tracking has stopped unexpectedly; None while it runs."""
        return self._threads.failure

    def _feed(self) -> None:
        item = self._inbox.get(WAIT)
        if item is not None:
            begun = self._clock()
            self._loop.feed(item)
            self._inbox.took(item, self._clock() - begun)

    def set_profile(self, profile: ColourProfile) -> None:
        """Uses other colours from the next image on."""
        self._vision.profile = profile

    @property
    def profile(self) -> ColourProfile:
        """The colours in use."""
        return self._vision.profile

    @property
    def work_priority(self) -> WorkPriority:
        """The priority of live tracking over other work in Python."""
        return self._loop.priority

    @property
    def settings(self) -> Settings:
        """The settings in use."""
        return next(iter(self._loop.hands.pipelines.values())).settings

    def set_engine(self, name: str) -> None:
        """Switches to another engine with the next message; it starts by searching for the hands.

        Raises ConfigError for an unknown name.
        """
        self._loop.set_engine(name)

    def set_reference(self, name: str | None) -> None:
        """Feeds the same messages to a second engine, for comparison; None ends it.

        Raises ConfigError for an unknown name.
        """
        self._loop.reference.use(name, wait=self._threads.stopping)

    def set_recorder(self, recorder: Recorder | None, timeout: float | None = TIMEOUT) -> None:
        """Starts recording into ``recorder``; the previous recording is finished and closed.

        Waits for that at most ``timeout`` s; None: until it is finished, as `stop` does.
        """
        self._loop.set_recorder(recorder, timeout)

    def keep_state(self) -> None:
        """Records the engine's state, for example after a pause in the file."""
        self._loop.record_state()

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        """Adds a note of the user, stamped ``t`` (s of the monotonic clock), or now.

        ``data``: see `tracker.session.notes`.
        """
        self._journal.note(text, t, data or {})

    def drain_events(self) -> list[Event]:
        """What happened since the last call."""
        return self._journal.drain_events()

    def hand(self, side: str) -> HandOfTracker:
        """Returns the interface of one hand."""
        return HandOfTracker(self, self._loop, self._inbox, side)


def _follower(profile: ColourProfile, pipeline: Pipeline) -> ColourFollower:
    """For the pipeline's glove and camera; not used by a pipeline without a camera."""
    glove, rig = pipeline.glove, pipeline.calibrated_rig
    size = float(glove.marker_size.mean()) if glove.markers else 0.012
    return ColourFollower(profile, glove, size, rig.fx if rig is not None else 640.0)


class HandRequests:
    """What may be asked of one hand: requests to its engine, and messages for its recording."""

    def __init__(self, loop: LiveLoop, inbox: Inbox, side: str) -> None:
        self._loop, self._inbox, self.side = loop, inbox, side
        self._hand = loop.seen[side]

    def command(self, work: Callable[[Engine], T], answer: Callable[[T], None] = ignore) -> None:
        """Calls ``work`` with the hand's engine, in the engine thread, between two messages.

        ``answer`` is called there with the result. A GlovetrackError that it raises is reported as
        an event.
        """

        def answered(engine: Engine) -> None:
            answer(work(engine))

        self._inbox.put(EngineCommand(answered, self.side))

    def follow(self, follower: Follower) -> None:
        """Passes each estimate to ``follower`` from now on."""
        self._hand.followers = (follower,)

    def unfollow(self) -> None:
        """Ends what `follow` began."""
        self._hand.followers = ()

    def record(self, message: Message) -> None:
        """Records a message of another part; does nothing while no recording is running."""
        self._loop.journal.record(message)

    def set_figures(self, figures: Mapping[str, float]) -> None:
        """Adds figures of the window to the status, in place of those of the last call."""
        self._hand.shown = figures

    def hold(self, pose: str) -> None:
        """Begins a guided pose of `tracker.hand.poses`."""
        self._inbox.put(GuidedCommand(pose, True, self.side))

    def let_go(self, pose: str, held: bool) -> None:
        """Ends a guided pose; ``held``: it was not skipped."""
        self._inbox.put(GuidedCommand(pose, False, self.side, held))

    def reset_pose(self) -> None:
        """Aligns the hand with a flat one, fingers straight ahead, which the wearer holds."""
        self._inbox.put(ResetCommand(self.side))

    def place(self, pose: WristPose) -> None:
        """Feeds the pose of a tracker on the hand, which another system measured."""
        self._inbox.put(pose)


class HandOfTracker(HandRequests):
    """One hand of a `LiveTracker`. Methods may be called from any thread."""

    def __init__(self, tracker: LiveTracker, loop: LiveLoop, inbox: Inbox, side: str) -> None:
        super().__init__(loop, inbox, side)
        self._tracker = tracker

    def subscribe(self, subscriber: Callable[[Estimate], None]) -> Callable[[], None]:
        """Calls ``subscriber``, which must not block, with each estimate, in order of time; returns
        a function that ends it."""
        return self._hand.subscribe(subscriber)

    @property
    def work_priority(self) -> WorkPriority:
        """The priority of tracking over other work in Python."""
        return self._loop.priority

    def latest_estimate(self) -> Estimate | None:
        """Returns the latest estimate; None before the first packet."""
        return self._hand.estimate

    def attach_listeners(
        self, vibrate: Vibrate | None = None, kinds: Iterable[ListenerKind] | None = None
    ) -> Mapping[str, Listener]:
        """Attach a listener of each of the ``kinds``, by default of all that packages declare, and
        return them by name.

        To be called once, before `LiveTracker.start`; ``vibrate`` drives the glove's motors.
        """
        loop, telemetry = self._loop, self._hand.telemetry
        live = LiveAccess(loop.journal.record, telemetry, loop.clock, loop.priority, vibrate)
        pipeline = loop.hands.pipelines[self.side]
        self._hand.listeners.attach(ListenedHand(pipeline.hand, pipeline.glove, live), kinds)
        return self._hand.listeners.by_name

    def set_reference(self, name: str | None) -> None:
        """Sets that of all hands, see `LiveTracker.set_reference`."""
        self._tracker.set_reference(name)

    def reference_estimate(self) -> Estimate | None:
        """Returns the second engine's estimate; None without a second engine."""
        return self._loop.reference.estimate(self.side)

    def latest_frame(self, t: float | None = None) -> ShownFrame | None:
        """Returns the last image that the filter has used or searched; or that of ``t`` (s), None
        if it is not stored any more."""
        return self._hand.frames.latest if t is None else self._hand.frames.of(t)

    def recent_imu(self) -> list[ImuSample]:
        """Returns the packets of the last seconds, oldest first."""
        return self._hand.history.recent()

    def recent_estimates(self) -> list[Estimate]:
        """Returns the estimates of the last seconds that were shown, oldest first."""
        return self._hand.estimates.recent()

    def recent_images(self) -> list[SearchedImage]:
        """Returns the results of the images of the last seconds, oldest first."""
        return self._hand.frames.history.recent()

    def calibration(self) -> Calibration | None:
        """Returns the estimated parameters, at most a second old."""
        return self._hand.calibration

    def status(self) -> Status:
        """Returns the current status of this hand and of the devices."""
        return self._loop.status(self.side)
