"""A hand that another process tracks, as the window sees it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from app.engines.apart.messages import LISTENER, Estimated, HandUpdate
from app.engines.apart.process import EngineProcess
from tracker.base.callbacks import ignore
from tracker.base.clock import monotonic
from tracker.fusion.engine import Engine
from tracker.live.frame_results import MOST_SHOWN, ShownFrame
from tracker.live.history import History, SearchedImage
from tracker.live.listeners import ListenerLine, Listeners
from tracker.live.telemetry import Telemetry
from tracker.live.work_priority import WorkPriority
from tracker.messages import (
    Calibration,
    Estimate,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    Tracking,
    WristPose,
)

if TYPE_CHECKING:  # the window does not load the engine
    from tracker.live.hand import Follower, Subscriber

LISTENER_WAIT = 40.0  # s: a listener may import large packages
T = TypeVar("T")


class HandCommands:
    """Sends the commands of `CommandedHand` to a hand in another process."""

    def __init__(self, process: EngineProcess, side: str) -> None:
        self._process, self._target = process, f"hand {side}"

    def command(self, work: Callable[[Engine], T], answer: Callable[[T], None] = ignore) -> None:
        self._process.ask_later(self._target, "command", work, answer=answer)

    def reset_pose(self) -> None:
        self._process.tell(self._target, "reset_pose")

    def place(self, pose: WristPose) -> None:
        self._process.tell(self._target, "place", pose)

    def hold(self, pose: str) -> None:
        self._process.tell(self._target, "hold", pose)

    def let_go(self, pose: str, held: bool) -> None:
        self._process.tell(self._target, "let_go", pose, held)

    def record(self, message: Message) -> None:
        self._process.tell(self._target, "record", message)

    def set_figures(self, figures: Mapping[str, float]) -> None:
        self._process.tell(self._target, "set_figures", figures)

    def set_reference(self, name: str | None) -> None:
        """Raises ConfigError for an unknown name."""
        self._process.ask_or(None, self._target, "set_reference", name)


class LineToListener:
    """`ListenerLine` to one in the process that tracks."""

    def __init__(self, process: EngineProcess, side: str, name: str) -> None:
        self._process, self._target = process, LISTENER.format(side, name)

    def ask(self, method: str, *args: object) -> Any:
        return self._process.ask(self._target, method, *args, wait=LISTENER_WAIT, parallel=True)

    def tell(self, method: str, *args: object) -> None:
        self._process.tell(self._target, method, *args)


class ApartHand(HandCommands):
    """`TrackedHand` and `CommandedHand`. Written by the thread that reads the news, read by any.

    What follows the hand, and ``listeners`` or their representatives, are in the window's process.
    """

    def __init__(self, process: EngineProcess, side: str, listeners: Listeners) -> None:
        super().__init__(process, side)
        self._side = side
        self.listeners, self.telemetry = listeners, Telemetry()
        self.work_priority = WorkPriority()  # no engine works in this process
        self._estimate: Estimate | None = None
        self._estimates: History[Estimate] = History()
        self._imu: History[ImuSample] = History()
        self._images: History[SearchedImage] = History()
        self._frames: tuple[ShownFrame, ...] = ()
        self._calibration: Calibration | None = None
        self._status: Status | None = None
        self._reference: Estimate | None = None
        self._follower: Follower = ignore
        self._subscribers: tuple[Subscriber, ...] = ()  # replaced, never changed
        self._subscribing = threading.Lock()

    def line_to(self, name: str) -> ListenerLine:
        """The way to a listener in the process that tracks."""
        return LineToListener(self._process, self._side, name)

    # --- what arrives

    def take(self, item: Estimated) -> None:
        """A new estimate."""
        estimate, arrival = item.estimate, item.t_arrival
        follower = self._follower
        if arrival is not None:
            self.listeners.feed(estimate, arrival)
            follower(estimate, arrival)
        self._estimate = estimate
        self._estimates.add(estimate)
        for subscriber in self._subscribers:
            subscriber(estimate)

    def take_update(self, news: HandUpdate, images: dict[float, StereoFrame]) -> None:
        """What is new besides; ``images`` by the s of their exposure."""
        for sample in news.imu:
            self._imu.add(sample)
        for searched in news.images:
            self._images.add(searched)
        shown = [ShownFrame(images[f.t], f.blobs, f.result) for f in news.frames if f.t in images]
        self._frames = (*self._frames, *shown)[-MOST_SHOWN:]
        self._calibration = news.calibration or self._calibration
        self._status = news.status or self._status
        self._reference = news.reference
        self.listeners.take(news.listeners)

    # --- TrackedHand

    def latest_estimate(self) -> Estimate | None:
        return self._estimate

    def latest_frame(self, t: float | None = None) -> ShownFrame | None:
        if t is None:
            return self._frames[-1] if self._frames else None
        return next((shown for shown in self._frames if shown.image.t == t), None)

    def recent_imu(self) -> list[ImuSample]:
        return self._imu.recent()

    def recent_estimates(self) -> list[Estimate]:
        return self._estimates.recent()

    def recent_images(self) -> list[SearchedImage]:
        return self._images.recent()

    def calibration(self) -> Calibration | None:
        return self._calibration

    def status(self) -> Status:
        """The last one of the process, with the figures of the listeners."""
        now = monotonic()
        status = self._status or Status(now, Tracking.SEARCHING, {})
        own = self.telemetry.values(now)
        return replace(status, values={**status.values, **own}) if own else status

    def subscribe(self, subscriber: Subscriber) -> Callable[[], None]:
        with self._subscribing:
            self._subscribers += (subscriber,)

        def unsubscribe() -> None:
            with self._subscribing:
                self._subscribers = tuple(s for s in self._subscribers if s is not subscriber)

        return unsubscribe

    # --- CommandedHand

    def follow(self, follower: Follower) -> None:
        self._follower = follower

    def unfollow(self) -> None:
        self._follower = ignore

    def reference_estimate(self) -> Estimate | None:
        return self._reference
