"""What all filters share: time.

A filter lives at the exposure of the last image, or a fixed lag behind the newest packet when no
image comes. What it shows is a copy of its nominal state (the head), carried on with the packets
since. Late images therefore need no rolling back: an image waits until packets cover its
exposure, and one that comes after the filter went on without it makes the lag longer
(docs/chain.md, "Delay").

While the glove is silent, images are used without packets. On a busy machine packets may come after
all, late and in bunches: then the filter goes back to where it stood before, and those images wait
for their packets as others do.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, Self, TypeVar

import numpy as np

from tracker.base.records import record
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.messages import BlobFrame, FrameResult, ImuSample, Tracking
from tracker.online.imu_health import ImuHealth, ImuHealthKept

LATE_MARGIN = 0.03  # s beyond the latest image so far
LONGEST_LAG = 0.5  # s
LONGEST_AHEAD = 20.0  # s of images used without packets, beyond which there is no way back
HAND_SPEED = 0.5  # m/s an axis, sd: what a hand does while it is shown where it will be only later


def behind_variance(shown: float, t: float) -> float:
    """m² an axis of a state of instant ``shown`` (s) that is given out as that of ``t``, before it.

    Packets that came too late for the way back tell of instants that the filter has left.
    """
    return (HAND_SPEED * max(shown - t, 0.0)) ** 2


class TimedState(Protocol):
    """A filter's state at time ``t``."""

    t: float

    def copy_nominal(self) -> Self:
        """A copy without its own covariance, to be carried on."""


S = TypeVar("S", bound=TimedState)


class Filter(Protocol[S]):
    """What a `Timeline` drives: a filter that lives in the past, and looks for the hand."""

    @property
    def state(self) -> S:
        """Of the past, with its covariance."""

    @property
    def tracking(self) -> Tracking:
        """The state of tracking."""

    def packet(self, sample: ImuSample) -> None:
        """A believable packet has come."""

    def step(self, way: Intervals, first: int) -> int:
        """Move the state, with its covariance, through the interval ``first`` of ``way`` and, as
        far as there is nothing to do between, the next ones; the number of the one after."""

    def carry(self, state: S, t: float) -> None:
        """Move a nominal state to ``t`` with the packets on the way."""

    def image(self, frame: BlobFrame) -> FrameResult:
        """Use an image of the state's own instant."""

    def start(self, frame: BlobFrame) -> FrameResult | None:
        """Look for the hand from nothing; None where it is not found, or was not looked for."""

    def no_image(self) -> bool:
        """The state has moved on and no image has come. True where what is shown has to follow."""

    @property
    def kept(self) -> Any:
        """All that changes, as it is: for a copy."""

    def restore(self, kept: Any) -> None:
        """Go on from what was `kept`, which is taken over."""


@record("timeline.ahead")
@dataclass(eq=False)
class ImagesWithoutPackets:
    """What a filter knew before it used images without packets, and these images."""

    filter: Any  # its `Filter.kept`
    last_frame: float
    frames: list[BlobFrame] = field(default_factory=list)


@record("timeline")
@dataclass(eq=False)
class TimelineKept(Generic[S]):
    """All of a timeline that changes: images that wait, what was made of others, packets."""

    head: S
    lag: float
    last_frame: float
    waiting: list[BlobFrame]
    results: list[FrameResult]
    packets: list[ImuSample]
    health: ImuHealthKept
    ahead: ImagesWithoutPackets | None = None
    reported: float = -np.inf  # s of the newest image that has a result


class Timeline(Generic[S]):
    """Feeds packets and images to a filter in the order of their instants.

    ``buffer`` is empty, and what the filter reads packets from; ``silence`` s without packets let
    an image be used without them; ``lag`` s is how far the filter stays behind at first.
    """

    def __init__(self, target: Filter[S], buffer: ImuBuffer, silence: float, lag: float) -> None:
        self._filter, self._buffer = target, buffer
        self._silence, self._lag = silence, lag
        self._health = ImuHealth(buffer.imus)
        self._head: S = target.state.copy_nominal()
        self._waiting: list[BlobFrame] = []
        self._results: list[FrameResult] = []
        self._last_frame = self._reported = -np.inf
        self._ahead: ImagesWithoutPackets | None = None

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> S:
        """Take a packet; the nominal state at its instant."""
        sample = self._health.check(sample)
        if not self._buffer.add(sample):
            return self.head_at(sample.t)
        self._go_back(sample.t)
        self._filter.packet(sample)
        self._use_waiting()
        self._keep_up(sample.t)
        if not self._searching:
            self._filter.carry(self._head, sample.t)
        return self._head

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen; it is used once packets cover its exposure."""
        self._waiting.append(frame)
        self._use_waiting()

    def take_results(self) -> list[FrameResult]:
        """What was made of images since the last call, oldest first."""
        out, self._results = self._results, []
        return out

    def head_at(self, t: float) -> S:
        """A copy of the newest nominal state, carried to ``t``."""
        state: S = self._head.copy_nominal()
        if not self._searching:
            self._filter.carry(state, t)
        return state

    def past_at(self, t: float) -> S:
        """A copy of the filter's own nominal state, which lives in the past, carried to ``t``."""
        state: S = self._filter.state.copy_nominal()
        if not self._searching and t > state.t:
            self._filter.carry(state, t)
        return state

    @property
    def newest(self) -> float | None:
        """Instant (s) of the newest packet that was taken."""
        newest = self._buffer.newest
        return None if newest is None else newest.t

    def packet_at(self, t: float) -> ImuSample | None:
        """Returns the newest packet that was taken, if it is of the instant ``t`` (s)."""
        newest = self._buffer.newest
        return newest if newest is not None and newest.t == t else None

    # ---- time

    @property
    def _searching(self) -> bool:
        return self._filter.tracking == Tracking.SEARCHING

    def _use_waiting(self) -> None:
        while self._waiting and self._ready(self._waiting[0]):
            frame = self._waiting.pop(0)
            self._note_ahead(frame)
            self._use(frame)
            self.rebuild_head()

    def _use(self, frame: BlobFrame) -> None:
        result: FrameResult | None = None
        if self._searching:
            result = self._filter.start(frame)
        elif frame.t > self._filter.state.t:
            self.advance(frame.t)
            result = self._filter.image(frame)
            self._last_frame = frame.t
        else:
            self._wait_longer(frame.t)
        if result is not None and result.t > self._reported:  # of one image, one result
            self._results.append(result)
            self._reported = result.t

    def _ready(self, frame: BlobFrame) -> bool:
        """Covered by packets, or the glove has been silent for too long to wait for them."""
        if self._buffer.covers(frame.t):
            return True
        newest, now = self._buffer.newest, self._waiting[-1].t_arrival
        return newest is not None and now - newest.t_arrival > self._silence

    def _note_ahead(self, frame: BlobFrame) -> None:
        """Before an image is used: without packets, remember how to come back."""
        if self._buffer.covers(frame.t) or self._searching:
            return
        if self._ahead is None:
            self._ahead = ImagesWithoutPackets(copy.deepcopy(self._filter.kept), self._last_frame)
        self._ahead.frames.append(frame)
        if frame.t - self._ahead.frames[0].t > LONGEST_AHEAD:
            self._ahead = None

    def _go_back(self, t: float) -> None:
        """A packet of ``t`` has arrived: if images were used without it, process them again with
        it."""
        ahead, self._ahead = self._ahead, None
        if ahead is None or t > self._filter.state.t:
            return
        self._filter.restore(ahead.filter)
        self._last_frame = ahead.last_frame
        self._waiting[:0] = ahead.frames
        self.rebuild_head()

    def _wait_longer(self, t: float) -> None:
        """An image came after the filter had gone on without it: the next ones are waited for."""
        newest = self._buffer.newest
        if newest is not None and t > self._last_frame:
            self._lag = min(max(self._lag, newest.t - t + LATE_MARGIN), LONGEST_LAG)

    def _keep_up(self, now: float) -> None:
        target = now - self._lag
        if self._searching or self._waiting or target <= self._filter.state.t:
            return
        self.advance(target)
        if self._filter.no_image() or self._head.t < self._filter.state.t:
            self.rebuild_head()

    def advance(self, t: float) -> None:
        """Move the filter, with its covariance, to ``t`` through every packet on the way."""
        way = self._buffer.intervals(self._filter.state.t, t)
        k = 0
        while k < len(way.stop):
            k = self._filter.step(way, k)
        self._filter.state.t = t

    def rebuild_head(self) -> None:
        """Show what the filter has become: its nominal state at the newest packet (eq. 39)."""
        self._head = self._filter.state.copy_nominal()
        newest = self._buffer.newest
        if newest is not None and not self._searching:
            self._filter.carry(self._head, newest.t)

    # ---- saving

    @property
    def kept(self) -> TimelineKept[S]:
        """All that changes, as it is: for a copy."""
        return TimelineKept(
            self._head,
            self._lag,
            self._last_frame,
            self._waiting,
            self._results,
            list(self._buffer),
            self._health.kept,
            self._ahead,
            self._reported,
        )

    def restore(self, kept: TimelineKept[S]) -> None:
        """Go on from what was `kept`, which is taken over."""
        self._head, self._lag, self._last_frame = kept.head, kept.lag, kept.last_frame
        self._waiting, self._results = kept.waiting, kept.results
        self._buffer.restore(kept.packets)
        self._health.restore(kept.health)
        self._ahead, self._reported = kept.ahead, kept.reported
