"""The queue of the engine thread: all packets and commands, and a few images.

Packets go before images: one takes a tenth of the time, and a robot or a motor waits for it. On a
computer without time to spare the queue of packets is never empty, and without any image the hand
would be lost: after `PACKETS_BEFORE` packets an image is fed in its order of arrival.
`GloveReader` and `CameraReader` are what the devices' threads repeat: they put messages here.
Messages are stamped when they are fed (`tracker.live.loop.ArrivalOrder`), so a session contains the
actual order.
"""

from __future__ import annotations

import math
import threading
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TypeVar

from tracker.base.channels import Closed, Latest
from tracker.base.clock import monotonic
from tracker.base.notices import notice, plain
from tracker.engine.hands import Sided
from tracker.fusion.engine import Engine
from tracker.live.journal import Journal
from tracker.live.telemetry import Telemetry
from tracker.messages import BlobFrame, Event, StereoFrame, WristPose
from tracker.sensors.motor_events import KIND as MOTOR
from tracker.sensors.sources import CameraSource, GloveSource, ReportingGlove

T = TypeVar("T")
SIZE = 4096  # 40 s of packets
MAX_FRAMES_BEHIND = 3  # with more the hand would be shown late
PACKETS_BEFORE = 8  # that an image waits for at least, before its order of arrival counts
BACKLOG = 30  # packets; with more the hand is late already
FRAME_EVERY = 0.25  # s between further images that wait with a backlog
WAIT = 0.05  # s that a step of a reader waits for its device
LONGEST_FRAMES = 18  # images that wait at most, 5 MB each


@dataclass(frozen=True, eq=False)
class DetectedFrame:
    """An image, the blobs found in it, and the number of images skipped before it."""

    frame: StereoFrame
    blobs: BlobFrame
    missed: int = 0


@dataclass(frozen=True, eq=False)
class EngineCommand:
    """A function to be called with a hand's engine between two messages."""

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
    """Resets to the pose of the wearer; stamped when it is fed."""

    side: str


@dataclass(frozen=True, eq=False)
class MotorCommand:
    """A command to a motor of the glove; stamped when it is fed."""

    event: Event
    side: str


Command = EngineCommand | GuidedCommand | ResetCommand | MotorCommand
Queued = Sided | WristPose | Command
Item = Queued | DetectedFrame


class Inbox:
    """Filled by any thread, emptied by one. A lost packet is lost motion; a late image is not."""

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        """``clock`` gives s."""
        self._changed = threading.Condition()
        self._clock, self._rhythm = clock, PacketRhythm()
        self._items: deque[Queued] = deque()
        self._frames: deque[DetectedFrame] = deque()
        self._overflowed = self._skipped = 0
        self._passed = 0  # items that went before the oldest image
        self._closed = False

    def put(self, item: Queued) -> None:
        """Appends an item. If the queue is full, it is lost and counted."""
        with self._changed:
            self._overflowed += self._is_refused(self._items, item, SIZE)
            if isinstance(item, Sided):
                self._rhythm.packet(item.side, self._clock())

    def put_frame(self, found: DetectedFrame) -> None:
        """Appends an image, or skips it while the engine still has older ones."""
        with self._changed:
            self._skipped += self._is_refused(self._frames, found, self._most_frames(found))

    def _is_refused(self, queue: deque[T], item: T, most: int) -> bool:
        """Appends to a queue of at most ``most`` items. Returns whether that was refused; nothing
        is counted once the inbox is closed. The caller must hold the lock.
        """
        if not self._closed and len(queue) < most:
            queue.append(item)
            self._changed.notify()
            return False
        return not self._closed

    def _most_frames(self, found: DetectedFrame) -> int:
        """The number of images that may wait; with a backlog of packets, some from all of it."""
        backlog = len(self._items) // BACKLOG
        if not backlog or not self._frames:
            return MAX_FRAMES_BEHIND
        spaced = found.frame.t - self._frames[-1].frame.t >= FRAME_EVERY
        return min(MAX_FRAMES_BEHIND + spaced * backlog, LONGEST_FRAMES)

    def _frame_is_due(self) -> bool:
        """Whether the oldest image has waited and arrived before all packets that wait."""
        if not self._frames or self._passed < PACKETS_BEFORE:
            return False
        oldest = self._items[0]
        if not isinstance(oldest, Sided | WristPose):
            return False
        return self._frames[0].frame.t_arrival <= oldest.t_arrival

    def get(self, timeout: float) -> Item | None:
        """Returns the oldest packet or command, else the oldest image; None if there is none within
        ``timeout`` s. Raises Closed once it is closed and empty."""
        with self._changed:
            self._changed.wait_for(lambda: self._items or self._frames or self._closed, timeout)
            if len(self._frames) == 1 and not self._items and not self._closed:
                hold = self._rhythm.hold(self._clock())
                self._changed.wait_for(lambda: self._items or self._closed, hold)
            if self._items and not self._frame_is_due():
                self._passed += bool(self._frames)
                return self._items.popleft()
            if self._frames:
                self._passed = 0
                self._rhythm.begun()
                return self._frames.popleft()
            if self._closed:
                raise Closed
            return None

    def packet_of(self, side: str) -> Sided | None:
        """Removes the oldest packet of this hand and returns it; None if there is none, or if
        something other than a packet waits before it."""
        with self._changed:
            for k, item in enumerate(self._items):
                if not isinstance(item, Sided):
                    return None
                if item.side == side:
                    del self._items[k]
                    return item
            return None

    def in_order(self, sides: Iterable[str]) -> list[str]:
        """The sides in the order in which their next packets are expected."""
        with self._changed:
            return sorted(sides, key=self._rhythm.expected)

    def took(self, item: Item, seconds: float) -> None:
        """The item was processed within ``seconds``."""
        if isinstance(item, DetectedFrame):
            with self._changed:
                self._rhythm.image(seconds)

    def close(self) -> None:
        """Refuses new items and wakes waiting threads."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    @property
    def skipped(self) -> int:
        """The number of images that were skipped because the engine was overloaded."""
        return self._skipped

    def figures(self) -> dict[str, float]:
        """Returns the numbers of lost packets and of waiting items."""
        with self._changed:
            waiting = len(self._items) + len(self._frames)
            return {"imu_overflow": self._overflowed, "engine_waiting": waiting}


# ---- when the next packet of a glove is expected, so that no image is begun just before it
#
# An image takes the engine's thread a few milliseconds, and a packet that arrives meanwhile
# waits. Packets are regular: an image that is begun right after one is finished before the next.

LATE = 0.0015  # s after which an expected packet is no longer waited for
LONGEST = 0.012  # s that an image is held in all
SPARE = 0.0025  # s of a gap that its first packet, and an early next one, may use
NEW = 0.1  # weight of a new value in a mean
ENOUGH = 1.3  # times the mean duration of an image; the longest are three times as long
MISSED = 3.0  # periods; a longer interval says nothing about the period
MOST_PERIOD = 0.05  # s; rarer packets are not waited for


class PacketRhythm:
    """All times in s of one clock; for one thread at a time."""

    def __init__(self) -> None:
        self._last: dict[str, float] = {}  # arrival, by the side of the hand
        self._period: dict[str, float] = {}
        self._takes = 0.0  # mean of recent images
        self._until = math.inf  # when the held image is begun at the latest

    def packet(self, side: str, now: float) -> None:
        """A packet has arrived."""
        last, self._last[side] = self._last.get(side), now
        if last is None:
            return
        period = self._period.setdefault(side, now - last)
        self._period[side] += NEW * (min(now - last, MISSED * period) - period)

    def expected(self, side: str) -> float:
        """When the next packet of this hand is expected; infinite without packets."""
        return self._last[side] + self._period[side] if side in self._period else math.inf

    def image(self, took: float) -> None:
        """An image was processed within ``took``."""
        self._takes += NEW * (took - self._takes)

    def begun(self) -> None:
        """The image is no longer held."""
        self._until = math.inf

    def hold(self, now: float) -> float:
        """How long to wait for a packet at most before the next image is begun; 0: begin it."""
        expected = sorted(
            self._last[side] + period
            for side, period in self._period.items()
            if period <= MOST_PERIOD and now < self._last[side] + period + LATE
        )
        if not expected or now >= self._until:
            return 0.0
        ends = [*expected, expected[0] + min(self._period.values())]
        longest = max(b - a for a, b in pairwise(ends))
        ahead = expected[0] - now
        if ahead >= min(ENOUGH * self._takes, longest - SPARE):
            return 0.0
        self._until = min(self._until, now + LONGEST)
        return min(max(ahead, 0.0) + LATE, self._until - now)


# ---- what the devices' threads repeat


class GloveReader:
    """Passes packets to the engine's inbox and events to the journal.

    ``named``: events name their glove, since there is another one.
    """

    def __init__(
        self, glove: GloveSource, side: str, inbox: Inbox, journal: Journal, named: bool = False
    ) -> None:
        self._glove, self._side, self._named = glove, side, named
        self._inbox, self._journal = inbox, journal

    def step(self) -> None:
        """Passes on what has arrived."""
        for item in self._glove.poll(WAIT):
            if isinstance(item, Event) and item.kind == MOTOR:
                self._inbox.put(MotorCommand(item, self._side))
            elif isinstance(item, Event):
                self._journal.add(self._of_side(item) if self._named else item)
            else:
                self._inbox.put(Sided(item, self._side))

    def _of_side(self, event: Event) -> Event:
        what = event.notice or plain(event.text)
        left, right = notice("glove.of_left", what=what), notice("glove.of_right", what=what)
        named = (left if self._side == "left" else right).with_severity(what.severity)
        return replace(event, text=str(named), notice=named)

    def figures(self) -> dict[str, float]:
        """Battery, counters and clock, of a glove that reports them."""
        return self._glove.figures.values() if isinstance(self._glove, ReportingGlove) else {}


class CameraReader:
    """Images go to the vision thread, which may miss some, and onto the disk, which does not."""

    def __init__(
        self,
        camera: CameraSource,
        images: Latest[StereoFrame],
        journal: Journal,
        telemetry: Telemetry,
    ) -> None:
        self._camera, self._images = camera, images
        self._journal, self._telemetry = journal, telemetry

    def step(self) -> None:
        """Take the next image pair."""
        frame = self._camera.read(WAIT)
        for event in self._camera.drain_events():
            self._journal.add(event)
        if frame is not None:
            self._telemetry.tick("frame", frame.t_arrival)
            self._journal.record(frame)
            self._images.put(frame)
