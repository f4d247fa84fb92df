"""The state of tracking: found, coasting, lost, and when to look for the hand again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.params import MatchParams
from tracker.messages import Array, Tracking

DOUBTFUL_SHARE = 0.35  # of the expected markers
MIN_RECOGNISED = 5  # stereo points that place a hand
RECOGNISED_SHARE = 0.6  # of the expected markers
LOST_SD = 0.05  # m: an unseen hand whose position is less certain than this is lost


@record("vist.tracking", shapes={"seen": "M", "felt": "I", "tip_sd": "t"})
@dataclass(eq=False)
class Track:
    """What changes beside the filter. seen (M,), felt (I,): when each marker and IMU was last."""

    seen: Array
    felt: Array
    tip_sd: Array
    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf
    last_search: float = -np.inf
    last_constraint: float = -np.inf
    doubtful_since: float = np.inf

    def is_coasting(self, t: float, params: MatchParams) -> bool:
        """No image with enough markers lately."""
        return t - self.last_good > params.lost_after

    def judge(self, t: float, enough: bool, params: MatchParams) -> None:
        """After an image, or without one."""
        if enough:
            self.last_good, self.tracking = t, Tracking.TRACKING
        elif t - self.last_good > params.coast_limit and self.tip_sd[0] > LOST_SD:
            self.tracking = Tracking.LOST
        elif self.is_coasting(t, params):
            self.tracking = Tracking.COASTING

    def should_search(self, t: float, matched: int, expected: float, params: MatchParams) -> bool:
        """Lost, or too few of the expected markers are there for too long."""
        doubtful = matched < max(params.min_markers, DOUBTFUL_SHARE * expected)
        self.doubtful_since = min(self.doubtful_since, t) if doubtful else np.inf
        long = t - self.doubtful_since >= params.lost_after or self.is_coasting(t, params)
        return long and t - self.last_search >= params.search_period / 10


def is_better(recognised: int, matched: int, expected: float) -> bool:
    """Whether a pose found by searching is to be believed rather than the present one.

    It must explain clearly more points, enough to be no accident, and most of what should be seen.
    """
    return recognised >= max(MIN_RECOGNISED, 1.2 * matched, RECOGNISED_SHARE * expected)
