"""What the window needs of an engine: live, simulated or replayed, they all look like this."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

from app.engines.guide import PoseGuide
from tracker.base.clock import ClockAnchor
from tracker.fusion.engine import Engine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.live.history import SearchedImage
from tracker.live.listeners import Listener
from tracker.live.recording import Recorder
from tracker.live.right_of_way import RightOfWay
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
)
from tracker.sensors.camera import UnfitImages
from tracker.sensors.camera_controls import CameraReport, Control, Locks
from tracker.sensors.glove_report import GloveReport
from tracker.session.description import MAIN
from tracker.vision.colours import ColourProfile
from tracker.vision.rig import StereoRig


class TrackedHand(Protocol):
    """What there is to see of one hand, see `tracker.live.runner.HandOfTracker`."""

    def latest_estimate(self) -> Estimate | None: ...

    def latest_frame(
        self, t: float | None = None
    ) -> tuple[StereoFrame, BlobFrame, FrameResult] | None: ...

    def recent_imu(self) -> Sequence[ImuSample]: ...

    def recent_estimates(self) -> Sequence[Estimate]: ...

    def recent_images(self) -> Sequence[SearchedImage]: ...

    def calibration(self) -> Calibration | None: ...

    def status(self) -> Status: ...


class LiveEngine(Protocol):
    """The part of `tracker.live.runner.LiveTracker` that the window talks to."""

    def start(self) -> None: ...

    def stop(self, patience: float | None = None) -> None: ...

    def take_events(self) -> list[Event]: ...

    @property
    def failure(self) -> str:
        """Why it has ended by itself, in a sentence; empty while it runs."""

    @property
    def profile(self) -> ColourProfile:
        """The colours that are looked for now; they may follow the light by themselves."""

    def set_profile(self, profile: ColourProfile) -> None: ...

    def set_engine(self, name: str) -> None: ...

    def set_recorder(self, recorder: Recorder | None) -> None: ...

    def keep_state(self) -> None: ...

    def note(
        self, text: str, t: float | None = None, data: Mapping[str, object] | None = None
    ) -> None: ...


class ReferenceTracking(Protocol):
    """Tracks with a second engine beside the first, to be compared with."""

    def set_reference(self, name: str | None) -> None: ...

    def reference_estimate(self) -> Estimate | None: ...


class FollowedHand(Protocol):
    """Tells a robot of each estimate, and records what it does."""

    def follow(self, follower: Callable[[Estimate, float], None] | None) -> None: ...

    def record(self, message: Message) -> None: ...


class CameraControls(Protocol):
    """Exposure, gain and white balance of the camera in use."""

    def controls(self) -> tuple[Control, ...]: ...

    def reports(self) -> tuple[CameraReport, ...]: ...

    def want(self, locks: Locks) -> None: ...


class GloveSettings(Protocol):
    """What a glove that is open is set to, and what of that may be changed."""

    def report(self) -> GloveReport: ...

    def want_rate(self, rate_hz: int) -> None: ...


class Player(Protocol):
    """Moves through a recorded session; times are s from its start."""

    @property
    def path(self) -> Path: ...

    @property
    def tracked(self) -> bool:
        """Whether the session holds a tracked hand."""

    @property
    def duration(self) -> float: ...

    @property
    def position(self) -> float: ...

    @property
    def playing(self) -> bool: ...

    def seek(self, position: float) -> None: ...

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
        """Whether another tracking is shown beside, even where it has no hand."""


@dataclass(frozen=True)
class ReferenceHand:
    """A hand to show beside the tracked one: another tracking, or the simulated hand as it is.

    Keypoints (K, 3) m, segment rotations R (S, 3, 3) and origins p (S, 3) m.
    """

    keypoints: Array
    R_GB: Array
    p_GB: Array


@dataclass(frozen=True)
class RecordingRequest:
    """What the user wants on disk."""

    path: Path
    participant: str
    task: str


@dataclass(frozen=True, eq=False)
class EngineSetup:
    """An engine and what it works with. ``close`` frees what `LiveEngine.stop` does not.

    An engine is started once; to start again the window builds another one. It is seen from one
    hand: ``tracked``, ``hand``, ``glove`` and what belongs to them. Where it tracks others,
    ``others`` are the same engine seen from them.
    """

    name: str
    engine: LiveEngine
    tracked: TrackedHand
    hand: HandModel
    glove: GloveModel
    rig: StereoRig
    profile: ColourProfile
    anchor: ClockAnchor
    close: Callable[[], None]
    make_recorder: Callable[[RecordingRequest], Recorder] | None = None
    truth: Callable[[float], ReferenceHand | None] | None = None
    simulated: bool = False
    player: Player | None = None  # of a recorded session
    cut_off: bool = False  # the session has no end: what it holds can be recovered
    command: Callable[[Callable[[Engine], None]], None] | None = None  # in the engine's own thread
    reference_tracking: ReferenceTracking | None = None
    camera_controls: CameraControls | None = None  # of a device that is open
    glove_settings: GloveSettings | None = None  # of a glove that is open
    calibration_file: str = ""  # of the camera; empty where there is none
    camera: str = ""  # the camera's name and serial number; what is tuned for it is kept by them
    image_rate: Callable[[], float] | None = None  # images a second that the camera should give
    listeners: Mapping[str, Listener] = field(default_factory=dict)  # of the hand, by name
    application: tuple[str, Mapping[str, Any]] = ("", {})  # what a simulated wearer uses, and how
    guide: PoseGuide | None = None  # tells the engine of guided poses
    reset_pose: Callable[[], None] | None = None  # of a live engine: the hand is held flat now
    followed: FollowedHand | None = None  # of a live engine
    right_of_way: RightOfWay | None = None  # of a live engine, to be given by what paints
    vibrate: Callable[[int, int, int], bool] | None = None  # channel, amplitude 0..255, ms
    glove_id: int | None = None  # the number by which it is known again
    has_glove: bool = True
    has_camera: bool = True
    camera_calibrated: bool = True  # False: ``rig`` is an ideal one that stands for it
    firmware_advice: str = ""  # what to say of the glove's firmware, if anything
    missing: str = ""  # sentences that say what of the rig is not there, and why
    unfit_images: Callable[[], UnfitImages | None] | None = None  # that come and have no use
    others: tuple[EngineSetup, ...] = ()

    @property
    def side(self) -> str:
        """Of the hand that it is seen from."""
        return self.glove.side

    def seen_from(self, side: str) -> EngineSetup:
        """The same engine seen from the hand of this side, where there is one."""
        found = next((hand for hand in self.hands if hand.side == side), self)
        if found is self:
            return self
        rest = (replace(hand, others=()) for hand in self.hands if hand is not found)
        return replace(found, others=tuple(rest))

    @property
    def hands(self) -> tuple[EngineSetup, ...]:
        """The engine as it is seen from each hand, this one first."""
        return self, *self.others

    def with_profile(self, profile: ColourProfile) -> EngineSetup:
        """The same with other colours, of all hands."""
        others = tuple(other.with_profile(profile) for other in self.others)
        return replace(self, profile=profile, others=others)

    @property
    def whole(self) -> bool:
        """Glove and calibrated camera: the hand has a place, and any engine may track it."""
        return self.has_glove and self.has_camera and self.camera_calibrated


def one_camera(setup: EngineSetup, frame: StereoFrame | None) -> bool:
    """Whether there is one camera alone, by its calibration, or without one by its images."""
    if setup.camera_calibrated:
        return setup.rig.one_camera
    return frame is not None and frame.right is None


def seen_from_main(setups: Sequence[EngineSetup]) -> EngineSetup:
    """One engine's setups, of one hand or of both, seen from the main one."""
    main = next((setup for setup in setups if setup.side == MAIN), setups[0])
    return replace(main, others=tuple(setup for setup in setups if setup is not main))
