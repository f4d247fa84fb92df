"""The threads of live tracking around one `LiveLoop`, and what the window may ask of them.

    glove thread ──┐ inbox
                   ├──────────────> engine thread ──> latest estimate, recorder
    camera thread ─┴> vision thread <── colours thread (disk thread behind a queue)

A recording and a reference engine bring a thread each (`recording`, `reference`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from tracker.applications.stage import ApplicationStage
from tracker.calibration.colours_follow import ColourFollower
from tracker.clock import monotonic
from tracker.fusion.engine import Engine
from tracker.live.colours import FollowedColours
from tracker.live.devices import CameraReader, GloveReader
from tracker.live.inbox import EngineCommand, GuidedCommand, Inbox
from tracker.live.journal import Journal
from tracker.live.loop import Follower, LiveLoop
from tracker.live.recording import Recorder
from tracker.live.telemetry import Telemetry
from tracker.live.threads import ThreadGroup
from tracker.live.vision import Vision
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Message,
    Status,
    StereoFrame,
)
from tracker.pipeline import Pipeline
from tracker.sensors.sources import CameraSource, GloveSource
from tracker.settings import Settings
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector

PATIENCE = 0.3  # s that the end of a recording is waited for
WAIT = 0.05  # s that the engine thread waits before it looks whether it should end


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
        turn: Callable[[str], None] = lambda name: None,
    ) -> None:
        """``clock`` gives s; ``turn`` may hold threads back, see `ThreadGroup`."""
        self._glove, self._camera = glove, camera
        self._journal, telemetry = Journal(clock), Telemetry()
        self._loop = LiveLoop(pipeline, self._journal, telemetry, clock)
        self._inbox = Inbox()
        self._vision = Vision(profile, make_detector, self._inbox, self._loop)
        self._colours = FollowedColours(_follower(profile, pipeline), self._vision, self._journal)
        self._loop.on_used = self._colours.used.put
        self._glove_reader = GloveReader(glove, self._inbox, self._journal)
        self._camera_reader = CameraReader(camera, self._vision.images, self._journal, telemetry)
        self._threads = ThreadGroup(self._journal.say, turn)
        for part in (
            self._vision,
            self._loop,
            self._loop.history,
            self._loop.load,
            self._loop.colours,
            self._loop.applications,
            self._inbox,
            self._journal,
            self._glove_reader,
        ):
            telemetry.ask(part.figures)
        if recorder is not None:
            self.set_recorder(recorder)

    # ---- control

    def start(self) -> None:
        """Start all threads. Once only."""
        self._threads.start("glove", self._glove_reader.step)
        self._threads.start("camera", self._camera_reader.step)
        self._threads.start("vision", self._vision.step)
        self._threads.start("engine", self._feed)
        self._threads.start("colours", self._colours.step)

    def stop(self, patience: float | None = None) -> None:
        """End all threads, free the devices, finish the recording. May be called again.

        The recording's end is waited for ``patience`` s, then it goes on by itself; None waits for
        as long as the disk takes.
        """
        self._threads.tell_to_stop()
        self._inbox.close()
        self._vision.images.close()
        self._colours.used.close()
        self._threads.join()
        self.set_reference(None)
        self._loop.applications.close()
        self._glove.close()
        self._camera.close()
        self._loop.set_recorder(None, patience)

    def _feed(self) -> None:
        item = self._inbox.get(WAIT)
        if item is not None:
            self._loop.feed(item)

    def set_profile(self, profile: ColourProfile) -> None:
        """Detect with other colours from the next image on."""
        self._vision.profile = profile

    @property
    def profile(self) -> ColourProfile:
        """The colours that are looked for now."""
        return self._vision.profile

    @property
    def settings(self) -> Settings:
        """What is tracked with now."""
        return self._loop.pipeline.settings

    def set_engine(self, name: str) -> None:
        """Track with another engine from the next message on; it looks for the hand anew.

        Raises ConfigError for an unknown name.
        """
        self._loop.set_engine(name)

    @property
    def stage(self) -> ApplicationStage:
        """Where an application of the tracked hand runs."""
        return self._loop.stage

    def set_reference(self, name: str | None) -> None:
        """Let a second engine see the same messages, to be compared with; None ends it.

        Raises ConfigError for an unknown name.
        """
        self._loop.set_reference(name, wait=self._threads.stopping)

    def command(self, work: Callable[[Engine], None]) -> None:
        """Have ``work`` done to the engine, in its own thread, between two messages.

        A GlovetrackError that it raises is told as an event.
        """
        self._inbox.put(EngineCommand(work))

    def set_recorder(self, recorder: Recorder | None) -> None:
        """Record into ``recorder`` from now on; the last one is finished and closed.

        A disk that is far behind is waited for `PATIENCE` s only; `stop` waits to the end.
        """
        self._loop.set_recorder(recorder, PATIENCE)

    def keep_state(self) -> None:
        """Record what the engine knows: after a pause in the file, for one."""
        self._loop.record_state()

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None:
        """A note of the user's, stamped ``t`` (s of the monotonic clock), or now.

        ``data``: see `tracker.session.notes`.
        """
        self._journal.note(text, t, data or {})

    def follow(self, follower: Follower | None) -> None:
        """Have each estimate heard by ``follower`` from now on, or by nobody."""
        self._loop.followers = (follower,) if follower is not None else ()

    def record(self, message: Message) -> None:
        """Record what another part has made of the hand; nothing where no recording runs."""
        self._journal.record(message)

    def hold(self, pose: str) -> None:
        """The wearer is asked from now on to hold a pose of `tracker.hand.poses`."""
        self._inbox.put(GuidedCommand(pose, begins=True))

    def let_go(self, pose: str, held: bool) -> None:
        """The pose is over; ``held``: it was not skipped."""
        self._inbox.put(GuidedCommand(pose, begins=False, held=held))

    # ---- what there is to see

    def latest_estimate(self) -> Estimate | None:
        """The hand as it is; None before the first packet."""
        return self._loop.estimate

    def reference_estimate(self) -> Estimate | None:
        """The second engine's hand; None where there is none."""
        return self._loop.reference_estimate()

    def latest_frame(self) -> tuple[StereoFrame, BlobFrame, FrameResult] | None:
        """The last image that the filter has used, or looked for the hand in."""
        return self._loop.frames.latest

    def recent_imu(self) -> list[ImuSample]:
        """Packets of the last seconds, oldest first."""
        return self._loop.history.recent()

    def calibration(self) -> Calibration | None:
        """Estimated parameters, at most a second old."""
        return self._loop.calibration

    def take_events(self) -> list[Event]:
        """What happened since the last call."""
        return self._journal.take_events()

    def status(self) -> Status:
        """How tracking and the devices are, now."""
        return self._loop.status()


def _follower(profile: ColourProfile, pipeline: Pipeline) -> ColourFollower:
    """For the pipeline's glove and camera; a pipeline without a camera never asks it."""
    glove, rig = pipeline.glove, pipeline.calibrated_rig
    size = float(glove.marker_size.mean()) if glove.markers else 0.012
    return ColourFollower(profile, glove, size, rig.fx if rig is not None else 640.0)
