"""Detects a glove that is tracked with another glove's files.

`SideWatch` detects a left glove with the files of a right one, and the reverse. A glove's patches
are mirrored on the other hand, so the hand is not found, or by mistake and lost again: there are
enough blobs, but no hand among them. Then the same packets and images are tried with the mirrored
glove and hand, and with other names of the hues (`hue_watch`). `ExchangeWatch` detects
two gloves of which each has the other one's files.
"""

from __future__ import annotations

import math

from tracker.base.notices import Notice, Outbox, failure
from tracker.engine.hands import Hands
from tracker.engine.hue_watch import ENOUGH, HueWatch, sees
from tracker.engine.pipeline import Pipeline
from tracker.glove.mirror import OTHER, mirrored_glove, mirrored_hand
from tracker.glove.model import GloveModel
from tracker.hand.names import SIDES
from tracker.messages import BlobFrame, ImuSample, Tracking

DELAY = 2.0  # s of search with as many, before the mirrored glove is tried
TRIAL = 8.0  # s that it is tried for; again only after a hand was found meanwhile
FOUND = 0.5  # s for which a hand has to be tracked to be the right one: wrong ones are lost sooner
SURE = 1.0  # s for which the mirrored hand has to be tracked, and ours not found


class SideWatch:
    """Fed with what a hand's ``pipeline`` is fed with; costs nothing while that finds the hand."""

    def __init__(self, pipeline: Pipeline, delay: float = DELAY) -> None:
        """``delay``: s of search before the mirrored glove is tried."""
        self._pipeline, self._delay = pipeline, delay
        self._trial: Pipeline | None = None
        self._waited = self._tried = self._sure = 0.0
        self._last: float | None = None
        self._over = False
        self._sees_many = False
        self.notices = Outbox()
        self._hues = HueWatch({pipeline.glove.side: pipeline})
        self.is_other = False  # reported, and our hand was not found since

    def packet(self, sample: ImuSample, tracking: Tracking) -> None:
        """Takes a packet and the state of tracking after it."""
        step = 0.0 if self._last is None else min(max(sample.t - self._last, 0.0), 0.1)
        self._last = sample.t
        self._hues.is_off = self.is_other
        self._hues.packet(self._pipeline.glove.side, sample, tracking)
        if tracking in (Tracking.TRACKING, Tracking.COASTING):
            self._restart()
        elif self._trial is not None:
            self._try(self._trial, sample, step)
        elif self._sees_many and not self._over:
            self._waited += step
            if self._waited >= self._delay:
                self._trial = _mirrored(self._pipeline)

    def take_names(self) -> tuple[str, ...]:
        """Returns the right names of exchanged hues, once after they were found; the pipeline is to
        use them (`hue_names_event`)."""
        return self._hues.take_names().get(self._pipeline.glove.side, ())

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        self._sees_many = sees(blobs, ENOUGH)
        self._hues.frame(blobs)
        if self._trial is not None:
            self._trial.feed_frame(blobs)
            self._trial.take_results()

    def _restart(self) -> None:
        self._trial, self._over, self.is_other = None, False, False
        self._waited = self._tried = self._sure = 0.0

    def _try(self, trial: Pipeline, sample: ImuSample, step: float) -> None:
        found = trial.feed_imu(sample).tracking == Tracking.TRACKING
        self._tried += step
        self._sure = self._sure + step if found else 0.0
        if self._sure >= SURE:
            self.is_other = True
            self.notices.post(other_side(self._pipeline.glove))
        if self._sure >= SURE or self._tried >= TRIAL:
            self._trial, self._over = None, True


def other_side(glove: GloveModel) -> Notice:
    """Returns the notice that the device tracked as ``glove`` is its mirror image."""
    return failure("glove.other_hand", other=OTHER[glove.side], glove=glove.name, side=glove.side)


def _mirrored(pipeline: Pipeline) -> Pipeline:
    hand, glove = mirrored_hand(pipeline.hand), mirrored_glove(pipeline.glove)
    return Pipeline(hand, glove, pipeline.calibrated_rig, pipeline.settings)


class ExchangeWatch:
    """Detects that each of two gloves has the other one's files: neither hand is tracked, though
    one that hardly moves may have been found, and both are tracked when the packets of each glove
    are used as the other's. Other names of the hues are tried too (`hue_watch`).

    It is fed with the input of ``hands`` and does nothing while they track a hand.
    """

    def __init__(self, hands: Hands, delay: float = DELAY) -> None:
        """``delay``: s of search before the gloves are tried exchanged."""
        self._hands, self._delay = hands, delay
        self._trial: Hands | None = None
        self._tracking = dict.fromkeys(SIDES, Tracking.SEARCHING)
        self._tried_as = dict.fromkeys(SIDES, Tracking.SEARCHING)
        self._since = self._sure_since = self._found_since = math.inf
        self._sees_many = self._over = False
        self.notices = Outbox()
        self._hues = HueWatch(hands.pipelines)

    def take_names(self) -> dict[str, tuple[str, ...]]:
        """Returns the right names of exchanged hues by side, once after they were found."""
        return self._hues.take_names()

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> None:
        """Takes a packet of the glove used for ``side``, and that hand's state of tracking."""
        self._tracking[side] = tracking
        self._hues.packet(side, sample, tracking)
        found = Tracking.TRACKING in self._tracking.values()
        self._found_since = min(self._found_since, sample.t) if found else math.inf
        if sample.t - self._found_since >= FOUND:
            self._trial, self._over, self._since = None, False, math.inf
            self._hues.is_off = False
        elif self._trial is not None:
            self._try(self._trial, OTHER[side], sample)
        elif self._sees_many and not self._over:
            self._since = min(self._since, sample.t)
            if sample.t - self._since >= self._delay:
                self._trial = self._hands.with_engine(self._hands.engine)
                self._since = sample.t
                self._sure_since = math.inf

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        self._sees_many = sees(blobs, 2 * ENOUGH)
        self._hues.frame(blobs)
        if self._trial is not None:
            self._trial.feed_frame(blobs)

    def _try(self, trial: Hands, side: str, sample: ImuSample) -> None:
        self._tried_as[side] = trial.feed_imu(side, sample).tracking
        trial.take_results(side)
        found = all(state == Tracking.TRACKING for state in self._tried_as.values())
        self._sure_since = min(self._sure_since, sample.t) if found else math.inf
        sure = sample.t - self._sure_since >= SURE
        if sure:
            self._hues.is_off = True
            self.notices.post(failure("gloves.exchanged"))
        if sure or sample.t - self._since >= TRIAL:
            self._trial, self._over = None, True
