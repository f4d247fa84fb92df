"""An engine and the devices behind it, live, simulated or replayed, as the window gets them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from app.engines.protocols import (
    CameraControls,
    CameraDevice,
    CommandedHand,
    GloveDevice,
    GroundTruth,
    LiveEngine,
    Player,
    RecordedFile,
    RecordingRequest,
    SimulatedWearer,
    TrackedHand,
    WindowEngine,
)
from tracker.base.callbacks import ignore
from tracker.base.clock import ClockAnchor
from tracker.base.notices import Notice
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.live.listeners import Listener
from tracker.messages import StereoFrame
from tracker.session.description import MAIN
from tracker.vision.colours import ColourProfile
from tracker.vision.rig import StereoRig

if TYPE_CHECKING:
    from tracker.simulation.posture_requests import PostureRequest


class PassesOn(Protocol):
    """Sends estimates into a pipe itself."""

    def pass_on(self, line: Connection, sides: Sequence[str]) -> Callable[[], None]:
        """Send the estimates of the hands of these sides; returns a function that ends it."""


@dataclass(frozen=True, eq=False)
class LivePart:
    """What a live engine offers besides what every engine does, for one hand.

    ``wearer`` is a simulated one who follows the guidance; a real one reads it on the screen.
    ``apart`` sends estimates to the streams' process itself; None: the window has to.
    """

    engine: LiveEngine
    hand: CommandedHand
    make_recorder: Callable[[RecordingRequest], RecordedFile]
    wearer: SimulatedWearer | None = None
    apart: PassesOn | None = None


@dataclass(frozen=True, eq=False)
class CameraPart:
    """The camera and its calibration; ``device`` and ``controls`` while it is open."""

    rig: StereoRig
    present: bool = True
    calibrated: bool = True  # False: ``rig`` is an ideal one in its place
    name: str = ""  # with its serial number; colours tuned for it are stored under this name
    calibration_file: str = ""  # empty without one
    device: CameraDevice | None = None
    controls: CameraControls | None = None
    true_rig: StereoRig | None = None  # the camera behind a simulation's images

    def without_devices(self) -> CameraPart:
        """The same without what is open."""
        return replace(self, device=None, controls=None)

    def is_single(self, frame: StereoFrame | None = None) -> bool:
        """Whether it has one lens, by its calibration, or without one by its images."""
        if self.calibrated:
            return self.rig.one_camera
        return frame is not None and frame.right is None


@dataclass(frozen=True, eq=False)
class GlovePart:
    """The connection to a glove; ``device`` while it is open.

    ``file`` is the name of its glove file, ``own_file`` that of the copy with measured values of
    this glove, which may be the same (`app.storage.own_gloves`); empty in a replay.
    """

    present: bool = True
    number: int | None = None  # by which it is recognized
    firmware_advice: Notice | None = None  # about a newer firmware
    device: GloveDevice | None = None
    file: str = ""
    own_file: str = ""

    def without_device(self) -> GlovePart:
        """The same without what is open."""
        return replace(self, device=None)


@dataclass(frozen=True, eq=False)
class EngineSetup:
    """An engine and what it works with, seen from one hand.

    ``tracked``, ``hand``, ``glove`` and what belongs to them are of that hand; ``others`` are the
    same engine seen from the other hands. Either ``live`` or ``player`` is there. ``close`` frees
    what `WindowEngine.stop` does not. An engine is started once; to start again the window builds
    another one.
    """

    name: str
    engine: WindowEngine
    tracked: TrackedHand
    hand: HandModel
    glove: GloveModel
    camera: CameraPart
    profile: ColourProfile
    close: Callable[[], None]
    connection: GlovePart = field(default_factory=GlovePart)
    live: LivePart | None = None
    player: Player | None = None
    simulated: bool = False
    truth: GroundTruth | None = None
    listeners: Mapping[str, Listener] = field(default_factory=dict)  # of the hand, by name
    application: tuple[str, Mapping[str, Any]] = ("", {})  # what a simulated wearer uses, and how
    missing: str = ""  # sentences that say which devices are missing, and why
    others: tuple[EngineSetup, ...] = ()
    anchor: ClockAnchor | None = None  # of the session's clock

    @property
    def side(self) -> str:
        """The side of the hand that it is seen from."""
        return self.glove.side

    def seen_from(self, side: str) -> EngineSetup:
        """The same engine seen from the hand of this side, if there is one."""
        found = next((hand for hand in self.hands if hand.side == side), self)
        if found is self:
            return self
        rest = (replace(hand, others=()) for hand in self.hands if hand is not found)
        return replace(found, others=tuple(rest))

    @property
    def hands(self) -> tuple[EngineSetup, ...]:
        """The engine seen from each hand, this one first."""
        return self, *self.others

    def with_profile(self, profile: ColourProfile) -> EngineSetup:
        """The same with other colours, for all hands."""
        others = tuple(other.with_profile(profile) for other in self.others)
        return replace(self, profile=profile, others=others)

    @property
    def whole(self) -> bool:
        """Glove and calibrated camera: the hand has a position, and any engine may track it."""
        return self.connection.present and self.camera.present and self.camera.calibrated

    @property
    def comparable(self) -> CommandedHand | None:
        """The hand that a second engine can track for comparison: of a live, whole setup."""
        return self.live.hand if self.live is not None and self.whole else None


def seen_from_main(setups: Sequence[EngineSetup]) -> EngineSetup:
    """One engine's setups, of one hand or of both, seen from the main one."""
    main = next((setup for setup in setups if setup.side == MAIN), setups[0])
    return replace(main, others=tuple(setup for setup in setups if setup is not main))


Send = Callable[["PostureRequest", str], None]
"""Sends a posture, and its name, to the simulated wearer."""


class Built(NamedTuple):
    """An engine; for a simulated one how to request postures, when (s) the motion begins, and the
    pickled specification of the scene."""

    setup: EngineSetup
    send: Send = ignore
    begins: float = 0.0
    scene: bytes = b""
