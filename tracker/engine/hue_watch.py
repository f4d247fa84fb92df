"""Finds the right names of hues that are exchanged in the colours, for instance red called blue.

Then there are enough blobs, but no hand among them, or one that is found by mistake and lost again.
The same packets and images are tried in other pipelines, with another order of the names in each
search. Where a hand is tracked nevertheless, its pipeline itself corrects them (`HueNames`). Of two
hands, one is searched for in each image, in turn; the names of the first that is found are those of
both, which the same camera sees.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from tracker.engine.pipeline import Pipeline
from tracker.messages import BlobFrame, FrameResult, ImuSample, Tracking
from tracker.vision.hue_orders import orders

DELAY = 1.5  # s without a hand, before other names are tried
ROUND = 1.2  # s for which a new hand is searched for, of two twice; more than all 23 orders
ROUNDS = 2
EVERY = 0.03  # s between two searches, of 10 to 30 ms each: packets wait for them
PAUSE = 10.0  # s until they are tried again
FOUND = 3.0  # s for which our hand has to be tracked to be the right one
TRIAL = 0.3  # s without enough markers, after which a hand that was found is given up
SURE = 1.0  # s for which a hand has to be tracked with other names
SHARE = 0.75  # of the expected markers matched, likewise
REMEMBERED = 32  # images whose results are not known yet
ENOUGH = 8  # blobs in each image, of a glove that is there to be found


class HueWatch:
    """Fed with what the ``pipelines`` of all hands, by side, are fed with; costs nothing while one
    of them finds its hand. ``is_off``: nothing is tried."""

    def __init__(self, pipelines: Mapping[str, Pipeline], delay: float = DELAY) -> None:
        self._pipelines, self._delay = pipelines, delay
        self._sides = tuple(pipelines)
        self._tracked = dict.fromkeys(self._sides, False)
        self._trials: dict[str, Pipeline] = {}  # empty while nothing is tried
        self._next = 0
        self._found_side = ""  # of the hand that was found; empty while there is none
        self._order: tuple[str, ...] = ()  # likewise
        self._asked: dict[tuple[str, float], tuple[str, ...]] = {}  # by side and the image's time
        self._is_tracked = self._shows = False  # it is tracked; with enough markers
        self._sees_many = self.is_off = False
        self._rounds = 0
        self._image = -math.inf  # that was searched
        self._packet: float | None = None
        self._waited = self._followed = self._searched = self._missing = self._sure = 0.0
        self._names: dict[str, tuple[str, ...]] = {}

    @property
    def is_trying(self) -> bool:
        """Whether other names are being tried."""
        return bool(self._trials)

    def take_names(self) -> dict[str, tuple[str, ...]]:
        """Returns by side what blobs with the name of each of the glove's hues are to be called,
        once after it was found; empty otherwise."""
        names, self._names = self._names, {}
        return names

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> None:
        """Takes a packet of one hand, and its state of tracking after it."""
        step = 0.0 if self._packet is None else min(max(sample.t - self._packet, 0.0), 0.1)
        self._packet = sample.t
        self._tracked[side] = tracking == Tracking.TRACKING
        is_found = any(self._tracked.values())
        self._followed = self._followed + step if is_found else 0.0
        if self._followed >= FOUND:
            self._stop(0.0)
        elif self._trials:
            self._try(side, sample, step)
        elif self._sees_many and not is_found and not self.is_off:
            self._waited += step
            if self._waited >= self._delay:
                self._begin()

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        self._sees_many = sees(blobs, ENOUGH)
        if not self._trials:
            return
        side, order = self._found_side, self._order
        if not order:
            others = tuple(orders(self._pipelines[self._sides[0]].hues.names))
            if blobs.t - self._image < EVERY or not others:
                return
            self._image = blobs.t
            round_, k = divmod(self._next, len(self._sides))
            side, order = self._sides[k], others[round_ % len(others)]
            self._next += 1
        self._asked[side, blobs.t] = order
        while len(self._asked) > REMEMBERED:
            del self._asked[next(iter(self._asked))]
        own = dict(zip(self._pipelines[self._sides[0]].glove.hues, order, strict=True))
        names = tuple(own.get(name, name) for name in blobs.hue_names)
        self._trials[side].feed_frame(replace(blobs, hue_names=names))
        for result in self._trials[side].take_results():
            self._take(side, result)

    def _take(self, side: str, result: FrameResult) -> None:
        if result.tracking != Tracking.TRACKING:
            return
        matched = ((result.match_left >= 0) | (result.match_right >= 0)).sum()
        is_complete = result.hues is None  # no hue's markers are missing, as with a wrong name
        self._shows = is_complete and bool(matched >= SHARE * result.visible.sum())
        if not self._order and (side, result.t) in self._asked:
            self._found_side, self._order = side, self._asked[side, result.t]

    def _begin(self) -> None:
        self._trials = {side: _trial(own) for side, own in self._pipelines.items()}
        self._found_side, self._order = "", ()
        self._is_tracked = self._shows = False
        self._asked.clear()
        self._missing = self._sure = 0.0

    def _stop(self, pause: float) -> None:
        self._trials, self._rounds, self._searched, self._waited = {}, 0, 0.0, -pause

    def _try(self, side: str, sample: ImuSample, step: float) -> None:
        if not self._order or side == self._found_side:
            estimate = self._trials[side].feed_imu(sample)
            self._is_tracked = estimate.tracking == Tracking.TRACKING
        if not self._order:
            self._searched += step
            if self._searched >= ROUND * len(self._sides) * (self._rounds + 1):
                self._rounds += 1
                self._begin() if self._rounds < ROUNDS else self._stop(PAUSE)
            return
        shows = self._is_tracked and self._shows
        self._sure += step if shows else 0.0
        self._missing = 0.0 if shows else self._missing + step
        if self._sure >= SURE:
            self._use(self._trials[self._found_side].hues.called(self._order))
            self._stop(0.0)
        elif self._missing >= TRIAL:
            self._begin()

    def _use(self, names: tuple[str, ...]) -> None:
        """Reports what blobs with the name of each hue of the first glove are to be called."""
        own = dict(zip(self._pipelines[self._sides[0]].glove.hues, names, strict=True))
        for side, pipeline in self._pipelines.items():
            if set(own) == set(pipeline.glove.hues):
                self._names[side] = tuple(own[hue] for hue in pipeline.glove.hues)


def sees(blobs: BlobFrame, least: int) -> bool:
    """Returns whether each image has at least ``least`` blobs."""
    counts = [len(b) for b in (blobs.left, blobs.right) if b is not None]
    return bool(counts) and min(counts) >= least


def _trial(own: Pipeline) -> Pipeline:
    """Another pipeline of the same hand, which searches in each image that it is fed with."""
    chain = own.settings.chain
    match = replace(chain.match, search_period=EVERY / 2)
    settings = replace(own.settings, chain=replace(chain, match=match))
    return Pipeline(own.hand, own.glove, own.calibrated_rig, settings)
