"""What waits for the engine thread: packets and commands all of them, images only a few."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass

from tracker.channels import Fifo
from tracker.fusion.engine import Engine
from tracker.messages import BlobFrame, StereoFrame
from tracker.two_hands import Sided

SIZE = 4096  # 40 s of packets
MAX_FRAMES_BEHIND = 3  # with more the hand would be shown late


@dataclass(frozen=True, eq=False)
class DetectedFrame:
    """An image, what the detector found in it, and how many before it nobody had time for."""

    frame: StereoFrame
    blobs: BlobFrame
    missed: int = 0


@dataclass(frozen=True, eq=False)
class EngineCommand:
    """Something to be done to a hand's engine between two messages."""

    work: Callable[[Engine], None]
    side: str


@dataclass(frozen=True)
class GuidedCommand:
    """A guided pose begins, or ends and was ``held`` or not; stamped when it is fed."""

    pose: str
    begins: bool
    side: str
    held: bool = False


Item = Sided | DetectedFrame | EngineCommand | GuidedCommand


class Inbox:
    """Filled by any thread, emptied by one. A lost packet is lost motion, a late image is not."""

    def __init__(self) -> None:
        self._items: Fifo[Item] = Fifo(SIZE)
        self._frames = self._skipped = 0
        self._counting = threading.Lock()

    def put(self, item: Sided | EngineCommand | GuidedCommand) -> None:
        """Append; what finds it full is lost and counted."""
        self._items.put(item)

    def put_frame(self, found: DetectedFrame) -> None:
        """Append, or skip the image where the engine has older ones to do."""
        with self._counting:
            if self._frames >= MAX_FRAMES_BEHIND:
                self._skipped += 1
                return
            self._frames += self._items.put(found)

    def get(self, timeout: float) -> Item | None:
        """The oldest; None if there is none within ``timeout`` s.

        Raises Closed once it is closed and empty.
        """
        item = self._items.get(timeout)
        if isinstance(item, DetectedFrame):
            with self._counting:
                self._frames -= 1
        return item

    def close(self) -> None:
        """Refuse what comes and wake who waits."""
        self._items.close()

    @property
    def skipped(self) -> int:
        """Images that the engine had no time for."""
        return self._skipped

    def figures(self) -> dict[str, float]:
        """What was lost because the engine is far behind, and what waits for it."""
        return {"imu_overflow": self._items.overflowed, "engine_waiting": len(self._items)}
