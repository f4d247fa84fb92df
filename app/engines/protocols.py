"""The interfaces of engines and devices that the window uses.

Every engine, live or replayed, is a `WindowEngine` whose hands are `TrackedHand`. A live one is a
`LiveEngine` too, whose hands take commands (`CommandedHand`); a recording has a `Player`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeAlias, TypeVar

import numpy as np

from tracker.base.callbacks import ignore
from tracker.base.notices import Notice
from tracker.fusion.engine import Engine
from tracker.live.history import SearchedImage
from tracker.live.recording import Recorder
from tracker.live.work_priority import WorkPriority
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    WristPose,
)
from tracker.sensors.camera import UnfitImages
from tracker.sensors.camera_controls import CameraReport, Control, Locks
from tracker.sensors.camera_fixed import FixedSetting
from tracker.sensors.glove_report import GloveReport
from tracker.vision.colours import ColourProfile

T = TypeVar("T")

if TYPE_CHECKING:  # a window without a demo does not load the simulator
    from tracker.simulation.posture_requests import PostureRequest
    from tracker.simulation.scenario import Simulation

    Plan: TypeAlias = Callable[[Simulation, float], Sequence[PostureRequest]]
    """The postures for a simulated wearer to take from a time (s) on, at which the wearer can
    begin."""


@dataclass(frozen=True)
class ReferenceHand:
    """A hand to show next to the tracked one: another tracking, or the simulated hand itself.

    Keypoints (K, 3) m, segment rotations R (S, 3, 3) and origins p (S, 3) m; NaN where unknown.
    """

    keypoints: Array
    R_GB: Array
    p_GB: Array

    @property
    def is_whole(self) -> bool:
        """Whether all segments are known."""
        return bool(np.isfinite(self.R_GB).all() and np.isfinite(self.p_GB).all())


@dataclass(frozen=True)
class RecordingRequest:
    """The file that the user wants to record."""

    path: Path
    participant: str
    task: str


class RecordedFile(Recorder, Protocol):
    """A file that is being recorded, see `app.engines.recording.PausableRecorder`."""

    paused: bool

    @property
    def written(self) -> int: ...

    @property
    def broken(self) -> bool: ...

    @property
    def problem(self) -> str: ...

    @property
    def figures(self) -> Mapping[str, float]: ...

    @property
    def closed(self) -> bool: ...

    def wait(self, longest: float) -> bool: ...


class TrackedHand(Protocol):
    """The latest data of one hand, see `tracker.live.runner.HandOfTracker`."""

    def latest_estimate(self) -> Estimate | None: ...

    def latest_frame(
        self, t: float | None = None
    ) -> tuple[StereoFrame, BlobFrame, FrameResult] | None: ...

    def recent_imu(self) -> Sequence[ImuSample]: ...

    def recent_estimates(self) -> Sequence[Estimate]: ...

    def recent_images(self) -> Sequence[SearchedImage]: ...

    def calibration(self) -> Calibration | None: ...

    def status(self) -> Status: ...


class CommandedHand(Protocol):
    """Requests to a live engine for one hand."""

    def command(self, work: Callable[[Engine], T], answer: Callable[[T], None] = ignore) -> None:
        """Run ``work`` on the engine's own thread, and pass its result to ``answer`` in another
        thread than the caller's.

        ``work`` may be sent to another process: a function of a module, or a `partial` of one.
        """

    def reset_pose(self) -> None:
        """Align the hand: the wearer holds it flat now."""

    def place(self, pose: WristPose) -> None:
        """Take the pose of a tracker on the hand, which another system measured."""

    def hold(self, pose: str) -> None:
        """The wearer holds this pose of `tracker.hand.poses.POSES` from now on."""

    def let_go(self, pose: str, held: bool) -> None:
        """The pose is over; ``held``: the engine may learn from it."""

    def follow(self, follower: Callable[[Estimate, float], None]) -> None:
        """Send each estimate to ``follower``, for example a robot, until `unfollow`."""

    def unfollow(self) -> None: ...

    def subscribe(self, subscriber: Callable[[Estimate], None]) -> Callable[[], None]:
        """Call ``subscriber`` with each estimate that is shown; the returned function ends that."""

    def record(self, message: Message) -> None:
        """Add a message to the recording, if there is one."""

    def set_figures(self, figures: Mapping[str, float]) -> None:
        """Add figures of the window to the status, in place of those of the last call."""

    def set_reference(self, name: str | None) -> None:
        """Track with a second engine for comparison; None ends that."""

    def reference_estimate(self) -> Estimate | None: ...


class SimulatedWearer(Protocol):
    """A simulated wearer who does what the guidance shows; empty names end it."""

    def show(self, pose: str) -> None:
        """Take a pose of `tracker.hand.poses.POSES`."""

    def show_gesture(self, gesture: str) -> None:
        """Make a gesture of `tracker.simulation.gestures`."""

    def follow(self, plan: Plan, name: str) -> None:
        """Carry out the postures of a plan, which the recording calls ``name``."""


class WindowEngine(Protocol):
    """The interface of every engine to the window."""

    def start(self) -> None: ...

    def stop(self, timeout: float | None = None) -> None: ...

    def drain_events(self) -> list[Event]: ...

    @property
    def profile(self) -> ColourProfile:
        """The colours searched for now; they may adapt to the light."""

    def set_profile(self, profile: ColourProfile) -> None: ...

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None: ...


class LiveEngine(WindowEngine, Protocol):
    """What a live engine offers besides, see `tracker.live.runner.LiveTracker`."""

    @property
    def failure(self) -> Notice | None:
        """Why it has stopped on its own; None while it runs."""

    @property
    def work_priority(self) -> WorkPriority:
        """To be given by whatever paints."""

    def set_engine(self, name: str) -> None: ...

    def set_recorder(self, recorder: RecordedFile | None) -> None: ...

    def keep_state(self) -> None: ...


class Player(Protocol):
    """Moves through a recorded session; times are s from its start."""

    @property
    def path(self) -> Path: ...

    @property
    def tracked(self) -> bool:
        """Whether the session contains a tracked hand."""

    @property
    def cut_off(self) -> bool:
        """Whether the session has no end, so that its contents can be recovered."""

    @property
    def duration(self) -> float: ...

    @property
    def position(self) -> float: ...

    @property
    def playing(self) -> bool: ...

    def seek(self, position: float) -> None: ...

    def pause_at(self, position: float) -> None: ...

    def play(self, on: bool) -> None: ...

    def set_speed(self, speed: float) -> None: ...

    def set_loop(self, on: bool) -> None: ...

    def set_range(self, start: float, stop: float) -> None: ...

    def step(self, images: int) -> None: ...

    @property
    def range(self) -> tuple[float, float]: ...

    @property
    def events(self) -> Sequence[tuple[float, Event]]: ...

    def set_reference(self, path: Path | None, shift: float = 0.0) -> None: ...

    def reference(self, side: str) -> ReferenceHand | None: ...

    @property
    def is_compared(self) -> bool:
        """Whether another tracking is compared, even where it has no hand."""


class GroundTruth(Protocol):
    """The real pose of a simulated or recorded hand; ``is_measured``: by a laboratory."""

    is_measured: bool

    def at(self, t: float) -> ReferenceHand | None: ...


class CameraDevice(Protocol):
    """A camera that is open."""

    @property
    def fps(self) -> float:
        """Images per second that it should deliver."""

    @property
    def unfit(self) -> UnfitImages | None:
        """The latest images that do not match the camera's calibration."""


class CameraControls(Protocol):
    """Exposure, gain and white balance of the camera in use."""

    def controls(self) -> tuple[Control, ...]: ...

    def reports(self) -> tuple[CameraReport, ...]: ...

    def fixed(self) -> tuple[FixedSetting, ...]: ...

    def request_locks(self, locks: Locks) -> None: ...


class GloveDevice(Protocol):
    """A glove that is open: its settings and its motors."""

    def report(self) -> GloveReport: ...

    def request_rate(self, rate_hz: int) -> None: ...

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool:
        """Drive a motor with an amplitude of 0..255; returns whether the command was sent."""
