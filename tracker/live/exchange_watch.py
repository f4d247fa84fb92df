"""Noticing that two gloves are exchanged: each has the files that are the other one's."""

from __future__ import annotations

import math

from tracker.base.notices import Outbox, failure
from tracker.engine.hands import Hands
from tracker.engine.side_watch import ENOUGH, PATIENCE, SURE, TRIAL, sees
from tracker.glove.mirror import OTHER
from tracker.hand.names import SIDES
from tracker.messages import BlobFrame, ImuSample, Tracking


class ExchangeWatch:
    """Notices that each of two gloves has the other one's files: neither hand is tracked, though
    one that hardly moves may have been found, and both are as soon as the packets of each glove are
    taken for the other's.

    Fed with what ``hands`` are fed with; costs nothing while they find a hand.
    """

    def __init__(self, hands: Hands, patience: float = PATIENCE) -> None:
        """``patience``: s of search before the gloves are taken for one another."""
        self._hands, self._patience = hands, patience
        self._trial: Hands | None = None
        self._tracking = dict.fromkeys(SIDES, Tracking.SEARCHING)
        self._tried_as = dict.fromkeys(SIDES, Tracking.SEARCHING)
        self._since = self._sure_since = math.inf
        self._sees_many = self._over = False
        self.notices = Outbox()

    def packet(self, side: str, sample: ImuSample, tracking: Tracking) -> None:
        """A packet of the glove that is taken for that of ``side``, and what its hand is then."""
        self._tracking[side] = tracking
        if Tracking.TRACKING in self._tracking.values():
            self._trial, self._over, self._since = None, False, math.inf
        elif self._trial is not None:
            self._try(self._trial, OTHER[side], sample)
        elif self._sees_many and not self._over:
            self._since = min(self._since, sample.t)
            if sample.t - self._since >= self._patience:
                self._trial = self._hands.with_engine(self._hands.engine)
                self._since = sample.t
                self._sure_since = math.inf

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        self._sees_many = sees(blobs, 2 * ENOUGH)
        if self._trial is not None:
            self._trial.feed_frame(blobs)

    def _try(self, trial: Hands, side: str, sample: ImuSample) -> None:
        self._tried_as[side] = trial.feed_imu(side, sample).tracking
        trial.take_results(side)
        found = all(state == Tracking.TRACKING for state in self._tried_as.values())
        self._sure_since = min(self._sure_since, sample.t) if found else math.inf
        sure = sample.t - self._sure_since >= SURE
        if sure:
            self.notices.post(failure("gloves.exchanged"))
        if sure or sample.t - self._since >= TRIAL:
            self._trial, self._over = None, True
