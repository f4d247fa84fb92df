"""One or two gloves in view of one camera: a pipeline each, and blobs shared between them.

A single hand passes through its pipeline unchanged: nothing is shared, and its estimates are those
of the pipeline, bit for bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.records import record
from tracker.engine.pipeline import Pipeline, PipelineSavedState
from tracker.hand.names import SIDES
from tracker.messages import (
    BlobFrame,
    CameraImuSample,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Search,
    Tracking,
    WristPose,
)
from tracker.vision.sharing import share, taken_twice

CLASH_BLOBS = 6
"""Blobs of one image that both hands matched: one of the hands is not there."""
NEAR_INTERVAL, FULL_INTERVAL = 0.045, 0.25
"""s at least between two searches for a hand that is not in view while the other one is tracked: in
its last posture, and without prior knowledge. The tracked hand waits meanwhile; a search without
prior knowledge takes about 20 ms."""


class Sided(NamedTuple):
    """A packet, and the side of its glove."""

    sample: ImuSample
    side: str

    @property
    def t_arrival(self) -> float:
        return self.sample.t_arrival


@record("two_hands", last_near="last_again", last_full="last_anew")
@dataclass(eq=False)
class TwoHandsSavedState:
    """The state of two hands. ``left`` and ``right`` are their pipelines', ``last`` is the result
    of the newest image for each of them, the left one first. Then the instants (s) of the last
    images in which a hand could be searched for, in its last posture and without prior knowledge;
    and the side of the hand that restarts with the next image, if any."""

    left: PipelineSavedState
    right: PipelineSavedState
    last: list[FrameResult | None]
    last_near: float = -np.inf
    last_full: float = -np.inf
    weaker: str = ""


class Hands:
    """A pipeline for each side, fed with its own glove's packets and with one camera's images.

    ``make`` builds the pipeline of each side, left or right or both. When two hands were found in
    the same position, that of the weaker one restarts with the next image. ``alone``: there is only
    one hand. Raises ConfigError if a glove is for the other side.
    """

    def __init__(self, make: Mapping[str, Callable[[], Pipeline]]) -> None:
        self.pipelines = {side: make[side]() for side in SIDES if side in make}
        for side, pipeline in self.pipelines.items():
            if pipeline.glove.side != side:
                raise ConfigError(
                    notice(
                        "glove.wrong_hand",
                        glove=pipeline.glove.name,
                        made_for=pipeline.glove.side,
                        side=side,
                    )
                )
        self._main = next(iter(self.pipelines.values()))
        self.alone = len(self.pipelines) == 1
        self._fresh = {side: p.get_state() for side, p in self.pipelines.items()}
        self._last: dict[str, FrameResult | None] = dict.fromkeys(self.pipelines)
        self._results: dict[str, list[FrameResult]] = {side: [] for side in self.pipelines}
        self._last_near = self._last_full = -np.inf
        self._weaker = ""

    @property
    def engine(self) -> str:
        """The name of the engine that tracks all hands."""
        return self._main.settings.engine

    def feed_imu(self, side: str, sample: ImuSample) -> Estimate:
        """Feeds a packet of one glove; returns that hand at the packet's instant."""
        estimate = self.pipelines[side].feed_imu(sample)
        if not self.alone:
            self._collect()
        return estimate

    def feed_frame(self, frame: BlobFrame) -> None:
        """Feeds the blobs of an image of all hands."""
        for feed in self.feeds(frame).values():
            feed()

    def feeds(self, frame: BlobFrame) -> Mapping[str, Callable[[], None]]:
        """The parts of `feed_frame`, by the side of their hands: both are to be called, in any
        order, and a hand's packets may be fed after its own part and before the other's. Estimates
        do not depend on either order."""
        if self.alone:
            return {side: partial(p.feed_frame, frame) for side, p in self.pipelines.items()}
        self._restart_weaker()
        self._share_names()
        shares = zip(self.pipelines, self._shares(frame), strict=True)
        return {side: partial(self._feed_share, side, own) for side, own in shares}

    def _feed_share(self, side: str, own: BlobFrame) -> None:
        self.pipelines[side].feed_frame(own)
        self._collect()

    def _shares(self, frame: BlobFrame) -> list[BlobFrame]:
        """Returns the frame for each of two hands, with the blobs that it may use."""
        expected = [p.ahead.in_view(frame) for p in self.pipelines.values()]
        pose = frame.pose or self._main.camera_pose(frame.t)
        search = self._search(frame.t)
        return [
            own if other is None else replace(own, search=search)
            for own, other in zip(
                share(frame, expected, self._main.rig, pose), reversed(expected), strict=True
            )
        ]

    def _search(self, t: float) -> Search:
        """Returns the extent of the search for a hand in the image of ``t`` while the other is
        tracked."""
        near, full = t - self._last_near >= NEAR_INTERVAL, t - self._last_full >= FULL_INTERVAL
        if full:
            self._last_near = self._last_full = t
            return Search.FULL
        if near:
            self._last_near = t
        return Search.AGAIN if near else Search.NEAR

    def feed_camera_imu(self, sample: CameraImuSample) -> None:
        """Feeds a sample of the camera's own IMU."""
        for pipeline in self.pipelines.values():
            pipeline.feed_camera_imu(sample)

    def feed_wrist(self, pose: WristPose) -> None:
        """Feeds the pose of a tracker to the hand that it is on."""
        if pose.side in self.pipelines:
            self.pipelines[pose.side].feed_wrist(pose)

    def feed_event(self, event: Event) -> None:
        """Feeds a guided pose or a pose reset to one hand if the event names it, else to all."""
        for side, pipeline in self.pipelines.items():
            if is_for(event, side):
                pipeline.feed_event(event)

    def take_results(self, side: str) -> list[FrameResult]:
        """Returns the results of a hand's images since the last call, oldest first."""
        if self.alone:
            return self._main.take_results()
        results, self._results[side] = self._results[side], []
        return results

    def with_engine(self, name: str) -> Hands:
        """Returns the same hands with another engine, at its start.

        Raises ConfigError for an unknown name.
        """
        return Hands({s: partial(p.with_engine, name) for s, p in self.pipelines.items()})

    def _collect(self) -> None:
        for side, pipeline in self.pipelines.items():
            found = pipeline.take_results()
            if found:
                self._results[side] += found
                self._last[side] = found[-1]
                self._separate()

    def _separate(self) -> None:
        """Notes the hand with fewer markers if both hands matched the same blobs.

        Blobs that a tracked hand expects are not given to the other hand, so this happens only at
        a start: both hands were searched for in the same image, and one was found at the other.
        """
        left, right = (self._last[side] for side in SIDES)
        if left is None or right is None or left.t != right.t:
            return
        if in_common(left, right) >= CLASH_BLOBS:
            self._weaker = SIDES[int(agreement(left) > agreement(right))]

    def _restart_weaker(self) -> None:
        """Not before the next image: the other hand's part may be processed after packets."""
        if self._weaker:
            self.pipelines[self._weaker].set_state(self._fresh[self._weaker])
            self._last[self._weaker], self._weaker = None, ""

    def _share_names(self) -> None:
        """Corrected names of hues of a tracked hand are those of the other one while it is not
        found: the same camera sees both."""
        for own, other in (SIDES, tuple(reversed(SIDES))):
            last, before = self._last[own], self._last[other]
            one, another = self.pipelines[own], self.pipelines[other]
            is_known = last is not None and last.tracking == Tracking.TRACKING
            is_other = before is not None and before.tracking == Tracking.TRACKING
            is_same = set(one.glove.hues) == set(another.glove.hues)
            is_news = one.hues.is_corrected and not another.hues.is_corrected
            if is_known and not is_other and is_same and is_news:
                another.hues.use(one.hues.called(another.glove.hues))

    def get_state(self) -> PipelineSavedState | TwoHandsSavedState:
        """Returns the state that estimates depend on; that of the pipeline if there is one hand."""
        if self.alone:
            return self._main.get_state()
        left, right = (self.pipelines[side].get_state() for side in SIDES)
        last = [self._last[side] for side in SIDES]
        near, full = self._last_near, self._last_full
        return TwoHandsSavedState(left, right, last, near, full, self._weaker)

    def set_state(self, state: Any) -> None:
        """Restores a state that `get_state` returned."""
        if self.alone:
            self._main.set_state(state)
            return
        self.pipelines["left"].set_state(state.left)
        self.pipelines["right"].set_state(state.right)
        self._last = dict(zip(SIDES, state.last, strict=True))
        self._last_near, self._last_full = state.last_near, state.last_full
        self._weaker = state.weaker


def is_for(event: Event, side: str) -> bool:
    """Returns whether the event is for the hand of this side, or for all hands."""
    return bool(event.data.get("hand", side) == side)


def in_common(a: FrameResult, b: FrameResult) -> int:
    """Returns the number of blobs that both matched, in both images."""
    return taken_twice(a.match_left, b.match_left) + taken_twice(a.match_right, b.match_right)


def agreement(result: FrameResult) -> float:
    """Returns the share of the visible markers that were matched, times their number."""
    seen = float(((result.match_left >= 0) | (result.match_right >= 0)).sum())
    return seen**2 / max(float(result.visible.sum()), 1.0)
