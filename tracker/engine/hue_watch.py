"""Finds the right names of hues that are exchanged in the colours, for instance red called blue.

Then there are enough blobs, but no hand among them, or one that is found by mistake and lost again.
The same packets and images are tried in another pipeline, with another order of the names in each
search. Where a hand is tracked nevertheless, the pipeline itself corrects them (`HueNames`).
"""

from __future__ import annotations

import math
from dataclasses import replace

from tracker.engine.pipeline import Pipeline
from tracker.messages import BlobFrame, FrameResult, ImuSample, Tracking
from tracker.vision.hue_orders import orders

PATIENCE = 1.5  # s without a hand, before other names are tried
ROUND = 1.2  # s for which a new hand is searched for; more than all 23 orders
ROUNDS = 2
EVERY = 0.03  # s between two searches, of 10 to 30 ms each: packets wait for them
PAUSE = 10.0  # s until they are tried again
FOUND = 3.0  # s for which our hand has to be tracked to be the right one
TRIAL = 0.3  # s without enough markers, after which a hand that was found is given up
SURE = 1.0  # s for which a hand has to be tracked with other names
SHARE = 0.75  # of the expected markers matched, likewise
REMEMBERED = 32  # images whose results are not known yet


class HueWatch:
    """Fed with what a hand's ``pipeline`` is fed with; costs nothing while that finds the hand."""

    def __init__(self, pipeline: Pipeline, patience: float = PATIENCE) -> None:
        self._pipeline, self._patience = pipeline, patience
        self._trial: Pipeline | None = None
        self._next = 0
        self._order: tuple[str, ...] = ()  # of the hand that was found; empty while there is none
        self._asked: dict[float, tuple[str, ...]] = {}  # by the image's time
        self._shows = False  # enough markers
        self._rounds = 0
        self._last = -math.inf  # image that was searched
        self._waited = self._followed = self._searched = self._missing = self._sure = 0.0
        self._names: tuple[str, ...] = ()

    @property
    def is_trying(self) -> bool:
        """Whether other names are being tried."""
        return self._trial is not None

    def take_names(self) -> tuple[str, ...]:
        """What blobs with the name of each of the glove's hues are to be called, once after it was
        found; empty otherwise."""
        names, self._names = self._names, ()
        return names

    def packet(self, sample: ImuSample, tracking: Tracking, step: float, sees_many: bool) -> None:
        """Takes a packet, ``step`` s after the last one, and the state of tracking after it;
        ``sees_many``: there are enough blobs."""
        is_found = tracking == Tracking.TRACKING
        self._followed = self._followed + step if is_found else 0.0
        if self._followed >= FOUND:
            self._stop(0.0)
        elif self._trial is not None:
            self._try(self._trial, sample, step)
        elif sees_many and not is_found:
            self._waited += step
            if self._waited >= self._patience:
                self._begin()

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        if self._trial is None:
            return
        order = self._order
        if not order:
            if blobs.t - self._last < EVERY:
                return
            self._last = blobs.t
            others = tuple(orders(self._pipeline.hues.names))
            if not others:
                return
            order = others[self._next % len(others)]
            self._next += 1
        self._asked[blobs.t] = order
        while len(self._asked) > REMEMBERED:
            del self._asked[next(iter(self._asked))]
        own = dict(zip(self._pipeline.glove.hues, order, strict=True))
        names = tuple(own.get(name, name) for name in blobs.hue_names)
        self._trial.feed_frame(replace(blobs, hue_names=names))
        for result in self._trial.take_results():
            self._take(result)

    def _take(self, result: FrameResult) -> None:
        if result.tracking != Tracking.TRACKING:
            return
        matched = ((result.match_left >= 0) | (result.match_right >= 0)).sum()
        self._shows = bool(matched >= SHARE * result.visible.sum())
        self._order = self._order or self._asked.get(result.t, ())

    def _begin(self) -> None:
        own = self._pipeline
        chain = own.settings.chain
        match = replace(chain.match, search_period=EVERY / 2)
        settings = replace(own.settings, chain=replace(chain, match=match))
        self._trial = Pipeline(own.hand, own.glove, own.calibrated_rig, settings)
        self._order, self._shows = (), False
        self._asked.clear()
        self._missing = self._sure = 0.0

    def _stop(self, pause: float) -> None:
        self._trial, self._rounds, self._searched, self._waited = None, 0, 0.0, -pause

    def _try(self, trial: Pipeline, sample: ImuSample, step: float) -> None:
        is_found = trial.feed_imu(sample).tracking == Tracking.TRACKING
        if not self._order:
            self._searched += step
            if self._searched >= ROUND * (self._rounds + 1):
                self._rounds += 1
                self._begin() if self._rounds < ROUNDS else self._stop(PAUSE)
            return
        shows = is_found and self._shows
        self._sure += step if shows else 0.0
        self._missing = 0.0 if shows else self._missing + step
        if self._sure >= SURE:
            self._names = trial.hues.called(self._order)
            self._stop(0.0)
        elif self._missing >= TRIAL:
            self._begin()
