"""What waits for the engine thread: packets and commands all of them, images only a few.

Packets go before images: one is done in a tenth of the time, and a robot or a motor waits for it.
What is fed is stamped then (`tracker.live.loop.ArrivalOrder`), so a session has the order that was.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

from tracker.base.channels import Closed
from tracker.engine.hands import Sided
from tracker.fusion.engine import Engine
from tracker.messages import BlobFrame, StereoFrame

T = TypeVar("T")
SIZE = 4096  # 40 s of packets
MAX_FRAMES_BEHIND = 3  # with more the hand would be shown late


@dataclass(frozen=True, eq=False)
class DetectedFrame:
    """An image, its detections, and the number of skipped images before it."""

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


@dataclass(frozen=True)
class ResetCommand:
    """The wearer holds the pose of a pose reset; stamped when it is fed."""

    side: str


Command = EngineCommand | GuidedCommand | ResetCommand
Item = Sided | DetectedFrame | Command


class Inbox:
    """Filled by any thread, emptied by one. A lost packet is lost motion, a late image is not."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._items: deque[Sided | Command] = deque()
        self._frames: deque[DetectedFrame] = deque()
        self._overflowed = self._skipped = 0
        self._closed = False

    def put(self, item: Sided | Command) -> None:
        """Append; what finds it full is lost and counted."""
        with self._changed:
            self._overflowed += self._is_refused(self._items, item, SIZE)

    def put_frame(self, found: DetectedFrame) -> None:
        """Append, or skip the image where the engine has older ones to do."""
        with self._changed:
            self._skipped += self._is_refused(self._frames, found, MAX_FRAMES_BEHIND)

    def _is_refused(self, queue: deque[T], item: T, most: int) -> bool:
        """Append to a queue of at most ``most``, if there is room; not counted once closed.

        To be called with the lock held.
        """
        if not self._closed and len(queue) < most:
            queue.append(item)
            self._changed.notify()
            return False
        return not self._closed

    def get(self, timeout: float) -> Item | None:
        """The oldest packet or command, else the oldest image; None if there is none within
        ``timeout`` s. Raises Closed once it is closed and empty."""
        with self._changed:
            self._changed.wait_for(lambda: self._items or self._frames or self._closed, timeout)
            if self._items:
                return self._items.popleft()
            if self._frames:
                return self._frames.popleft()
            if self._closed:
                raise Closed
            return None

    def close(self) -> None:
        """Refuse what comes and wake who waits."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    @property
    def skipped(self) -> int:
        """Images that the engine had no time for."""
        return self._skipped

    def figures(self) -> dict[str, float]:
        """What was lost because the engine is far behind, and what waits for it."""
        with self._changed:
            waiting = len(self._items) + len(self._frames)
            return {"imu_overflow": self._overflowed, "engine_waiting": waiting}
