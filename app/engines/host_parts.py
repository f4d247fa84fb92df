"""Parts of `app.engines.engine_host.EngineHost`, so that a panel states which of them it uses.

A panel that uses several parts declares a protocol that has them as bases.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeVar

from PySide6.QtCore import SignalInstance

from app.engines.engine import EngineSetup
from app.engines.notes import Notes
from app.engines.recording import Recording
from app.engines.snapshot import Snapshot
from tracker.base.callbacks import ignore
from tracker.fusion.engine import Engine
from tracker.vision.colours import ColourProfile

T = TypeVar("T")


class ErrorSignal(Protocol):
    """Messages to the user: ``error.emit(text)``."""

    @property
    def error(self) -> SignalInstance: ...


class EventSignal(Protocol):
    """The events of the engine: ``happened`` with an `Event`."""

    @property
    def happened(self) -> SignalInstance: ...


class CurrentEngine(Protocol):
    """The engine that is open, seen from the hand shown."""

    @property
    def setup(self) -> EngineSetup | None: ...


class RunState(Protocol):
    """Whether the engine runs: ``running_changed`` with a bool."""

    @property
    def running(self) -> bool: ...

    @property
    def running_changed(self) -> SignalInstance: ...


class EngineChanges(Protocol):
    """An engine is open from ``opened``, with its `EngineSetup`, until ``closed``."""

    @property
    def opened(self) -> SignalInstance: ...

    @property
    def closed(self) -> SignalInstance: ...


class HandChanges(EngineChanges, Protocol):
    """Besides, ``hand_changed`` with the `EngineSetup` seen from the hand that is shown now."""

    @property
    def hand_changed(self) -> SignalInstance: ...


class HandSwitch(HandChanges, Protocol):
    """Besides, a request to show the other hand."""

    def show_hand(self, side: str) -> None: ...


class ColourUse(Protocol):
    """The colours that the engine searches; ``profile_followed`` when it has adapted them."""

    @property
    def profile_followed(self) -> SignalInstance: ...

    def set_profile(self, profile: ColourProfile) -> None: ...


class EngineCommands(CurrentEngine, Protocol):
    """Work on the engine's own thread, see `EngineHost.command`."""

    @property
    def running(self) -> bool: ...

    def command(
        self, work: Callable[[Engine], T], side: str = "", answer: Callable[[T], None] = ignore
    ) -> bool: ...


class EngineChoice(Protocol):
    """``engine_changed`` with the name of the engine that tracks from now on."""

    @property
    def engine_changed(self) -> SignalInstance: ...


class RecordingPart(Protocol):
    """The recording of what is tracked."""

    @property
    def recording(self) -> Recording: ...


class NotesPart(Protocol):
    """The notes of the recording."""

    @property
    def notes(self) -> Notes: ...


class Snapshots(Protocol):
    """The latest data of all streams."""

    def snapshot(self) -> Snapshot | None: ...
