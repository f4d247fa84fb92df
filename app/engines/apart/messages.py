"""The messages between the window and the process that tracks."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from app.engines.engine import CameraPart, GlovePart
from tracker.base.clock import ClockAnchor
from tracker.base.notices import Notice, failure
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.live.history import SearchedImage
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Status,
    StereoFrame,
)
from tracker.sensors.camera import UnfitImages
from tracker.sensors.glove_report import GloveReport
from tracker.streaming.apart_estimate import packed, unpacked
from tracker.vision.colours import ColourProfile

ARRIVAL = struct.Struct("<d")
LISTENER = "listener {} {}"
"""The target of `EngineRequest` for a listener: side of its hand and name."""
ENDED = "engine.process_ended"
"""The code of the notice that the process has ended by itself."""


@dataclass(frozen=True)
class EngineRequest:
    """A call of ``method`` of ``target``; ``number`` 0: no answer is expected.

    ``waits``: it may take long, so it is carried out beside other requests. ``urgent``: it takes no
    time and goes before them.
    """

    number: int
    target: str
    method: str
    args: tuple[Any, ...] = ()
    kwargs: Mapping[str, Any] = field(default_factory=dict)
    waits: bool = False
    urgent: bool = False


@dataclass(frozen=True)
class Answered:
    """The result of a call, or what it has raised."""

    number: int
    result: Any = None
    error: Exception | None = None


@dataclass(frozen=True)
class Progressed:
    """How far the engine is built, 0..1, and with what it is busy."""

    fraction: float
    text: str


@dataclass(frozen=True, eq=False)
class HandFacts:
    """What does not change while the engine is open, for one hand; see `EngineSetup`.

    ``camera`` and ``connection`` are without their devices; ``device`` is the first report of a
    glove that is connected.
    """

    name: str
    hand: HandModel
    glove: GloveModel
    camera: CameraPart
    connection: GlovePart
    profile: ColourProfile
    device: GloveReport | None
    has_controls: bool  # of the camera
    fps: float | None  # of the camera; None without one
    simulated: bool
    application: tuple[str, Mapping[str, Any]]
    missing: str
    anchor: ClockAnchor | None


@dataclass(frozen=True, eq=False)
class Opened:
    """The engine is built. For a simulated one: when (s of the monotonic clock) the motion begins,
    and the pickled specification of the scene."""

    hands: tuple[HandFacts, ...]
    begins: float = 0.0
    scene: bytes = b""


class Estimated(NamedTuple):
    """An estimate that is shown, as soon as it exists, of the hand of this number. ``t_arrival``
    (s) of its packet, or of its image while packets are missing; None if there is neither."""

    hand: int
    estimate: Estimate
    t_arrival: float | None

    def packed(self) -> bytes:
        """As bytes, which begin with `tracker.streaming.apart_estimate.MARK`."""
        arrival = math.nan if self.t_arrival is None else self.t_arrival
        return packed(self.hand, self.estimate, self.estimate.seq) + ARRIVAL.pack(arrival)

    @staticmethod
    def unpacked(data: bytes) -> Estimated:
        """From the bytes of `packed`."""
        (arrival,) = ARRIVAL.unpack_from(data, len(data) - ARRIVAL.size)
        return Estimated(*unpacked(data), None if math.isnan(arrival) else arrival)


class NewFrame(NamedTuple):
    """The result of an image whose pixels the window may have; ``t`` s of its exposure."""

    t: float
    blobs: BlobFrame
    result: FrameResult


class Pixels(NamedTuple):
    """An image whose pixels are in shared memory: ``shapes`` of left and right, () where dark."""

    frame: StereoFrame
    shapes: tuple[tuple[int, ...], tuple[int, ...]]


@dataclass(frozen=True, eq=False)
class HandUpdate:
    """What is new of one hand since the last message; None: no change."""

    imu: tuple[ImuSample, ...]
    images: tuple[SearchedImage, ...]
    frames: tuple[NewFrame, ...]
    calibration: Calibration | None
    status: Status | None
    reference: Estimate | None  # of a second engine
    device: GloveReport | None
    listeners: Mapping[str, object]  # of each that has some, `RemoteListener.news`


@dataclass(frozen=True)
class FileUpdate:
    """The state of a recording; see `app.engines.recording.PausableRecorder`."""

    written: int
    broken: bool
    problem: str
    closed: bool
    figures: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class EngineUpdate:
    """What is new since the last message. ``profile`` are the colours after ``profiles`` changes by
    the user, None: unchanged."""

    hands: Mapping[str, HandUpdate]
    pixels: Pixels | None
    events: tuple[Event, ...]
    failure: Notice | None
    profile: ColourProfile | None
    profiles: int
    files: Mapping[int, FileUpdate]
    unfit: UnfitImages | None


class Received(NamedTuple):
    """News, and the name of the memory of the pixels from these news on; empty: as before."""

    news: EngineUpdate
    memory: str


@dataclass(frozen=True)
class Taken:
    """The news were read; the next may follow after ``pause`` s."""

    pause: float


@dataclass(frozen=True)
class Failed:
    """Why tracking cannot continue."""

    why: Notice


def thread_failed(thread: str, error: Exception) -> Notice:
    """The notice of a thread that has ended by ``error``."""
    return failure("thread.failed", thread=thread, type=type(error).__name__, why=str(error))


@dataclass(frozen=True)
class Logged:
    """A record of the process's log."""

    name: str
    level: int
    text: str
