"""What the process opens: a picklable description that builds the engine there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

from app.engines.engine import Built, Send
from app.engines.protocols import GroundTruth, SimulatedWearer
from app.platform.tasks import JobProgress
from app.storage.settings import AppSettings
from tracker.live.listeners import remote_kinds

if TYPE_CHECKING:
    from app.engines.apart.messages import Opened


class Companions(NamedTuple):
    """What the window adds to an engine: who follows the guidance, and the true hands by side."""

    wearer: SimulatedWearer | None = None
    truths: Mapping[str, GroundTruth] = {}
    close: Callable[[], None] = lambda: None


class Source(Protocol):
    """Is sent to the process."""

    def prepare(self) -> None:
        """Load what `build` needs, in a process of the `Reserve`; opens no device."""

    def build(self, progress: JobProgress) -> Built:
        """Build the engine, in the process. Raises GlovetrackError."""

    def companions(self, opened: Opened, send: Send) -> Companions:
        """What the window adds to it; ``send`` passes postures on to the process."""


@dataclass(frozen=True)
class DeviceSource:
    """The gloves and the camera of the settings."""

    settings: AppSettings

    def prepare(self) -> None:
        # deferred: loads every engine; `hardware` for `build`
        from app.engines import hardware, warm_up  # noqa: F401

        warm_up.load_engine(self.settings.glove, self.settings.hand)

    def build(self, progress: JobProgress) -> Built:
        from app.engines.hardware import hardware_setup  # deferred: loads every engine

        return Built(hardware_setup(progress, self.settings, remote_kinds()))

    def companions(self, opened: Opened, send: Send) -> Companions:
        return Companions()
