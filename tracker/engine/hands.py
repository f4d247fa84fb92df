"""The gloves in view of one camera, one or two: a pipeline each, and blobs shared between them.

One hand alone passes through its pipeline unchanged: nothing is shared, and its estimates are those
of the pipeline to the last bit.
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
from tracker.engine.pipeline import Pipeline, PipelineKept
from tracker.hand.names import SIDES
from tracker.messages import (
    BlobFrame,
    CameraImuSample,
    Estimate,
    Event,
    FrameResult,
    ImuSample,
    Search,
)
from tracker.vision.sharing import share, taken_twice

CLASH_BLOBS = 6
"""Blobs that two hands took for their own in one image: one of the hands is not there."""
AGAIN_EVERY, ANEW_EVERY = 0.045, 0.25
"""s at least between two searches for a hand that is not there while the other one is tracked, and
waits for it meanwhile: one from nothing takes some 20 ms."""


class Sided(NamedTuple):
    """A packet, and the side of its glove."""

    sample: ImuSample
    side: str

    @property
    def t_arrival(self) -> float:
        return self.sample.t_arrival


@record("two_hands")
@dataclass(eq=False)
class TwoHandsKept:
    """All of two hands that changes. ``left`` and ``right`` are their pipelines', ``last`` what the
    newest image gave each of them; the left one's first. Instants (s) of the last images in which a
    hand could be searched for, as it was bent and from nothing."""

    left: PipelineKept
    right: PipelineKept
    last: list[FrameResult | None]
    last_again: float = -np.inf
    last_anew: float = -np.inf


class Hands:
    """A pipeline for each side, fed with its own glove's packets and with one camera's images.

    ``make`` builds the pipeline of each side, left or right or both; that of the weaker hand starts
    again when two hands were found in the same position. ``alone``: there is one hand only. Raises
    ConfigError where a glove is of the other side.
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
        self._last_again = self._last_anew = -np.inf

    @property
    def engine(self) -> str:
        """The name of the engine that tracks all hands."""
        return self._main.settings.engine

    def feed_imu(self, side: str, sample: ImuSample) -> Estimate:
        """Take a packet of one glove; that hand at the packet's instant."""
        estimate = self.pipelines[side].feed_imu(sample)
        if not self.alone:
            self._collect()
        return estimate

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen in an image of all hands."""
        if self.alone:
            self._main.feed_frame(frame)
            return
        for pipeline, own in zip(self.pipelines.values(), self._shares(frame), strict=True):
            pipeline.feed_frame(own)
        self._collect()

    def _shares(self, frame: BlobFrame) -> list[BlobFrame]:
        """The frame as each of two hands may use it."""
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
        """How far a hand may be looked for in the image of ``t`` beside one that is tracked."""
        again, restarts = t - self._last_again >= AGAIN_EVERY, t - self._last_anew >= ANEW_EVERY
        if restarts:
            self._last_again = self._last_anew = t
            return Search.ANEW
        if again:
            self._last_again = t
        return Search.AGAIN if again else Search.NEAR

    def feed_camera_imu(self, sample: CameraImuSample) -> None:
        """Take a sample of the camera's own IMU."""
        for pipeline in self.pipelines.values():
            pipeline.feed_camera_imu(sample)

    def feed_event(self, event: Event) -> None:
        """Take a guided pose or a pose reset, of one hand if the event names one."""
        for side, pipeline in self.pipelines.items():
            if is_for(event, side):
                pipeline.feed_event(event)

    def take_results(self, side: str) -> list[FrameResult]:
        """What a hand's pipeline made of images since the last call, oldest first."""
        if self.alone:
            return self._main.take_results()
        results, self._results[side] = self._results[side], []
        return results

    def with_engine(self, name: str) -> Hands:
        """Another engine, at its start. Raises ConfigError for an unknown name."""
        return Hands({s: partial(p.with_engine, name) for s, p in self.pipelines.items()})

    def _collect(self) -> None:
        for side, pipeline in self.pipelines.items():
            found = pipeline.take_results()
            if found:
                self._results[side] += found
                self._last[side] = found[-1]
                self._part()

    def _part(self) -> None:
        """Of two hands that took the same blobs, the one with fewer markers starts over.

        Blobs that a tracked hand expects are kept from the other, so this is a start: both hands
        were looked for in the same image, and one was found where the other is.
        """
        left, right = (self._last[side] for side in SIDES)
        if left is None or right is None or left.t != right.t:
            return
        if in_common(left, right) < CLASH_BLOBS:
            return
        weaker = SIDES[int(agreement(left) > agreement(right))]
        self.pipelines[weaker].set_state(self._fresh[weaker])
        self._last[weaker] = None

    def get_state(self) -> PipelineKept | TwoHandsKept:
        """Everything that changes and that estimates depend on; of one hand its pipeline's."""
        if self.alone:
            return self._main.get_state()
        left, right = (self.pipelines[side].get_state() for side in SIDES)
        last = [self._last[side] for side in SIDES]
        return TwoHandsKept(left, right, last, self._last_again, self._last_anew)

    def set_state(self, state: Any) -> None:
        """Go on from `get_state`."""
        if self.alone:
            self._main.set_state(state)
            return
        self.pipelines["left"].set_state(state.left)
        self.pipelines["right"].set_state(state.right)
        self._last = dict(zip(SIDES, state.last, strict=True))
        self._last_again, self._last_anew = state.last_again, state.last_anew


def is_for(event: Event, side: str) -> bool:
    """Whether the hand of this side is the event's, or the event names none."""
    return bool(event.data.get("hand", side) == side)


def in_common(a: FrameResult, b: FrameResult) -> int:
    """Blobs that both took, in both images."""
    return taken_twice(a.match_left, b.match_left) + taken_twice(a.match_right, b.match_right)


def agreement(result: FrameResult) -> float:
    """Share of the markers that should be seen which are, times how many those are."""
    seen = float(((result.match_left >= 0) | (result.match_right >= 0)).sum())
    return seen**2 / max(float(result.visible.sum()), 1.0)
