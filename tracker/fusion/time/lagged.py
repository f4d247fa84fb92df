"""What both filters share: time.

A filter lives at the exposure of the last image, or a fixed lag behind the newest packet when no
image comes. What it shows is a copy of its nominal state (the head), carried on with the packets
since. Late images therefore need no rolling back: an image waits until packets cover its
exposure, and one that comes after the filter went on without it makes the lag longer.
"""

from __future__ import annotations

import copy
from abc import ABC, abstractmethod
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.messages import BlobFrame, Estimate, FrameResult, ImuSample, Tracking
from tracker.online.imu_health import ImuHealth

LATE_MARGIN = 0.03  # s beyond the latest image so far
LONGEST_LAG = 0.5  # s


class TimedState(Protocol):
    """A filter's state at time ``t``."""

    t: float

    def copy_nominal(self) -> Any:
        """A copy without its own covariance, to be carried on."""


S = TypeVar("S", bound=TimedState)


class LaggedEngine(ABC, Generic[S]):
    """Feeds packets and images to a filter in the order of their instants.

    ``silence`` s without packets let an image be processed without them; ``lag`` s is how far the
    filter stays behind at first.
    """

    _KEPT: tuple[str, ...] = ("_state", "_head", "_waiting", "_results", "_lag", "_last_frame")

    def __init__(self, imu_count: int, state: S, silence: float, lag: float) -> None:
        self._silence_limit, self._lag = silence, lag
        self._buffer = ImuBuffer(imu_count)
        self._health = ImuHealth(imu_count)
        self._state: S = state
        self._head: S = state.copy_nominal()
        self._waiting: list[BlobFrame] = []
        self._results: list[FrameResult] = []
        self._last_frame = -np.inf

    # ---- what a filter says and does

    @property
    @abstractmethod
    def tracking(self) -> Tracking:
        """The state of tracking."""

    @abstractmethod
    def _heard(self, sample: ImuSample) -> None:
        """A believable packet has come."""

    @abstractmethod
    def _step(self, way: Intervals, first: int) -> int:
        """Move the filter, with its covariance, through the interval ``first`` of ``way`` and, as
        far as `_stepped` has nothing to do between, the next ones; the number of the one after."""

    @abstractmethod
    def _carry(self, state: S, t: float) -> None:
        """Move a nominal state to ``t`` with the packets on the way."""

    def _stepped(self) -> None:
        """The filter has made a step with covariance."""
        return

    @abstractmethod
    def _process(self, frame: BlobFrame) -> None:
        """Use an image later than the filter's time."""

    @abstractmethod
    def _start(self, frame: BlobFrame) -> None:
        """Look for the hand from nothing."""

    @abstractmethod
    def _without_image(self, t: float) -> None:
        """The filter has gone on to ``t`` and no image has come."""

    @abstractmethod
    def _estimate(self, state: S, t: float) -> Estimate:
        """The hand that ``state`` stands for."""

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> Estimate:
        sample = self._health.check(sample)
        if not self._buffer.add(sample):
            return self.predict(sample.t)
        self._heard(sample)
        self._process_waiting()
        self._keep_up(sample.t)
        if self.tracking != Tracking.SEARCHING:
            self._carry(self._head, sample.t)
        return self._estimate(self._head, sample.t)

    def feed_frame(self, frame: BlobFrame) -> None:
        self._waiting.append(frame)
        self._process_waiting()

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    def predict(self, t: float) -> Estimate:
        return self._estimate(self._head_at(t), t)

    def _head_at(self, t: float) -> S:
        """A copy of the head carried to ``t``."""
        state: S = self._head.copy_nominal()
        if self.tracking != Tracking.SEARCHING:
            self._carry(state, t)
        return state

    # ---- time

    def _process_waiting(self) -> None:
        while self._waiting and self._ready(self._waiting[0]):
            frame = self._waiting.pop(0)
            if self.tracking == Tracking.SEARCHING:
                self._start(frame)
            elif frame.t > self._state.t:
                self._advance(frame.t)
                self._process(frame)
                self._last_frame = frame.t
            else:
                self._wait_longer(frame.t)
            self._rebuild_head()

    def _ready(self, frame: BlobFrame) -> bool:
        """Covered by packets, or the glove has been silent for too long to wait for them."""
        if self._buffer.covers(frame.t):
            return True
        newest, now = self._buffer.newest, self._waiting[-1].t_arrival
        return newest is not None and now - newest.t > self._silence_limit

    def _wait_longer(self, t: float) -> None:
        """An image came after the filter had gone on without it: the next ones are waited for."""
        newest = self._buffer.newest
        if newest is not None and t > self._last_frame:
            self._lag = min(max(self._lag, newest.t - t + LATE_MARGIN), LONGEST_LAG)

    def _keep_up(self, now: float) -> None:
        target = now - self._lag
        searching = self.tracking == Tracking.SEARCHING
        if searching or self._waiting or target <= self._state.t:
            return
        self._advance(target)
        self._without_image(target)
        if self._head.t < self._state.t:
            self._rebuild_head()

    def _advance(self, t: float) -> None:
        """Move the filter, with its covariance, to ``t`` through every packet on the way."""
        way = self._buffer.intervals(self._state.t, t)
        k = 0
        while k < len(way.stop):
            k = self._step(way, k)
            self._stepped()
        self._state.t = t

    def _rebuild_head(self) -> None:
        self._head = self._state.copy_nominal()
        newest = self._buffer.newest
        if newest is not None and self.tracking != Tracking.SEARCHING:
            self._carry(self._head, newest.t)

    # ---- saving

    def get_state(self) -> dict[str, Any]:
        out = {name: copy.deepcopy(getattr(self, name)) for name in self._KEPT}
        out["buffer"] = self._buffer.state()
        out["health"] = self._health.state()
        return out

    def set_state(self, state: dict[str, Any]) -> None:
        for name in self._KEPT:
            setattr(self, name, copy.deepcopy(state[name]))
        self._buffer.restore(state["buffer"])
        self._health.restore(state["health"])
