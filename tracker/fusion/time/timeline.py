"""Time handling shared by all filters.

A filter's state is at the exposure of the last image, or a fixed lag behind the newest packet when
no image arrives. The displayed state is a copy of its nominal state (the head), propagated with the
packets since. Late images therefore need no rollback: an image waits until packets cover its
exposure, and one that arrives after the filter has continued without it increases the lag
(docs/chain.md, "Delay").

While no packets arrive, images are used without them. On a loaded computer packets may arrive late
and in bursts after all: then the filter returns to its earlier state, and those images wait for
their packets like others.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, Self, TypeVar

import numpy as np

from tracker.base.records import record
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.messages import BlobFrame, FrameResult, ImuSample, Tracking, WristPose
from tracker.online.imu_health import ImuHealth, ImuHealthSavedState

LATE_MARGIN = 0.03  # s in addition to the largest image delay so far
LONGEST_LAG = 0.5  # s
LONGEST_AHEAD = 20.0  # s of images used without packets, beyond which the filter does not return
HAND_SPEED = 0.5  # m/s per axis, sd of a hand whose displayed position is that of a later time


def behind_variance(shown: float, t: float) -> float:
    """m² per axis, added for a state of time ``shown`` (s) that is returned for ``t``, before it.

    Packets that arrive too late for a return to the earlier state are older than the filter's
    state.
    """
    return (HAND_SPEED * max(shown - t, 0.0)) ** 2


class TimedState(Protocol):
    """A filter's state at time ``t``."""

    t: float

    def copy_nominal(self) -> Self:
        """A copy without its own covariance, to be propagated."""


S = TypeVar("S", bound=TimedState)
Observation = BlobFrame | WristPose
"""What corrects a filter at its instant: an image, or a pose that another system measured."""


class Filter(Protocol[S]):
    """The object that a `Timeline` drives: a filter with a delayed state, and the search for the
    hand."""

    @property
    def state(self) -> S:
        """The delayed state, with its covariance."""

    @property
    def tracking(self) -> Tracking:
        """The tracking state."""

    def packet(self, sample: ImuSample) -> None:
        """A plausible packet has arrived."""

    def step(self, way: Intervals, first: int) -> int:
        """Propagate the state, with its covariance, through the interval ``first`` of ``way`` and
        the next ones until an action is due in between; returns the number of the next interval."""

    def carry(self, state: S, t: float) -> None:
        """Propagate a nominal state to ``t`` through the packets in between."""

    def image(self, frame: Any) -> FrameResult | None:
        """Process an `Observation` of the state's own time."""

    def start(self, frame: Any) -> FrameResult | None:
        """Search for the hand without a prior; None where it is not found, or no search is due."""

    def no_image(self) -> bool:
        """The state has moved on without an image. Returns True where the output must be
        updated."""

    @property
    def saved(self) -> Any:
        """The complete state, not copied."""

    def restore(self, saved: Any) -> None:
        """Restore a `saved` state, which is not copied."""


@record("timeline.ahead")
@dataclass(eq=False)
class ImagesWithoutPackets:
    """The filter's state before it used images without packets, and these images."""

    filter: Any  # its `Filter.saved`
    last_frame: float
    frames: list[Observation] = field(default_factory=list)


@record("timeline")
@dataclass(eq=False)
class TimelineSavedState(Generic[S]):
    """The complete state of a timeline: images that wait, results of others, packets."""

    head: S
    lag: float
    last_frame: float
    waiting: list[Observation]
    results: list[FrameResult]
    packets: list[ImuSample]
    health: ImuHealthSavedState
    ahead: ImagesWithoutPackets | None = None
    reported: float = -np.inf  # s of the newest image with a result


class Timeline(Generic[S]):
    """Feeds packets and images to a filter in the order of their times.

    ``buffer`` is empty, and the filter reads packets from it; after ``silence`` s without packets
    an image is used without them; ``lag`` s is the filter's initial delay.
    """

    def __init__(self, target: Filter[S], buffer: ImuBuffer, silence: float, lag: float) -> None:
        self._filter, self._buffer = target, buffer
        self._silence, self._lag = silence, lag
        self._health = ImuHealth(buffer.imus)
        self._head: S = target.state.copy_nominal()
        self._waiting: list[Observation] = []
        self._results: list[FrameResult] = []
        self._last_frame = self._reported = -np.inf
        self._ahead: ImagesWithoutPackets | None = None

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> S:
        """Process a packet; returns the nominal state at its time."""
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

    def feed_frame(self, frame: Observation) -> None:
        """Queue an image; it is used once packets cover its exposure."""
        self._waiting.append(frame)
        self._use_waiting()

    def take_results(self) -> list[FrameResult]:
        """The results of the images since the last call, oldest first."""
        out, self._results = self._results, []
        return out

    def head_at(self, t: float) -> S:
        """A copy of the newest nominal state, propagated to ``t``."""
        state: S = self._head.copy_nominal()
        if not self._searching:
            self._filter.carry(state, t)
        return state

    def past_at(self, t: float) -> S:
        """A copy of the filter's own delayed nominal state, propagated to ``t``."""
        state: S = self._filter.state.copy_nominal()
        if not self._searching and t > state.t:
            self._filter.carry(state, t)
        return state

    @property
    def newest(self) -> float | None:
        """Time (s) of the newest accepted packet."""
        newest = self._buffer.newest
        return None if newest is None else newest.t

    def packet_at(self, t: float) -> ImuSample | None:
        """Returns the newest accepted packet, if its time is ``t`` (s)."""
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

    def _use(self, frame: Observation) -> None:
        result: FrameResult | None = None
        if self._searching:
            result = self._filter.start(frame)
        elif frame.t > self._filter.state.t:
            self.advance(frame.t)
            result = self._filter.image(frame)
            self._last_frame = frame.t
        else:
            self._wait_longer(frame.t)
        if result is not None and result.t > self._reported:  # one result per image
            self._results.append(result)
            self._reported = result.t

    def _ready(self, frame: Observation) -> bool:
        """Whether packets cover the image, or none have arrived for too long to wait for them."""
        if self._buffer.covers(frame.t):
            return True
        newest, now = self._buffer.newest, self._waiting[-1].t_arrival
        return newest is not None and now - newest.t_arrival > self._silence

    def _note_ahead(self, frame: Observation) -> None:
        """Before an image is used without packets: save the state to return to."""
        if self._buffer.covers(frame.t) or self._searching:
            return
        if self._ahead is None:
            self._ahead = ImagesWithoutPackets(copy.deepcopy(self._filter.saved), self._last_frame)
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
        """An image arrived after the filter had continued without it: increase the lag."""
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
        """Propagate the filter, with its covariance, to ``t`` through every packet in between."""
        way = self._buffer.intervals(self._filter.state.t, t)
        k = 0
        while k < len(way.stop):
            k = self._filter.step(way, k)
        self._filter.state.t = t

    def rebuild_head(self) -> None:
        """Recompute the head: the filter's nominal state at the newest packet (eq. 39)."""
        self._head = self._filter.state.copy_nominal()
        newest = self._buffer.newest
        if newest is not None and not self._searching:
            self._filter.carry(self._head, newest.t)

    # ---- saving

    @property
    def saved(self) -> TimelineSavedState[S]:
        """The complete state, not copied."""
        return TimelineSavedState(
            self._head,
            self._lag,
            self._last_frame,
            self._waiting,
            self._results,
            list(self._buffer),
            self._health.saved,
            self._ahead,
            self._reported,
        )

    def restore(self, saved: TimelineSavedState[S]) -> None:
        """Restore a `saved` state, which is not copied."""
        self._head, self._lag, self._last_frame = saved.head, saved.lag, saved.last_frame
        self._waiting, self._results = saved.waiting, saved.results
        self._buffer.restore(saved.packets)
        self._health.restore(saved.health)
        self._ahead, self._reported = saved.ahead, saved.reported
