"""The state of tracking: found, coasting, lost, and when to look for the hand again."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.params import MatchParams
from tracker.fusion.chain.pixels import Tally
from tracker.messages import Array, Tracking

EAGER = 1.0  # s of searches from nothing as often as there may be, then `SPARING` s apart
SPARING = 0.25
IN_VAIN = 0.3  # s of images with markers in which a lost hand is not found as it was last
KEEP_CALIBRATION = 5.0  # s after which a hand that is still lost is looked for without it
MANY_MARKERS = 6  # in an image that shows the hand
DOUBTFUL_SHARE = 0.35  # of the expected markers
ENOUGH_SHARE = 0.6  # of the few markers that can be seen of a hand edge-on
DOUBT_AFTER = 0.08  # s without support, after which nothing is called measured
SURE_AFTER = 0.08  # s with support, after which it is again
STRANGE_FOR = 0.4  # s of images without a break
DIGIT_PERIOD = 0.09  # s between two searches for digits
PLACES_APART = 0.12  # s at most between two searches whose places tell how fast the hand moves
BELIEVABLE_SHARE = 0.5  # of the expected markers, for a hand that was out of sight


@record("chain.tracking", shapes={"last_place": "3"})
@dataclass(eq=False)
class TrackingKept:
    """All of the judgement that changes. Instants in s."""

    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf  # last image with enough matches
    last_search: float = -np.inf
    last_start: float = -np.inf  # last search from nothing
    starting_since: float = np.inf  # images show markers and such searches find nothing
    in_vain_since: float = np.inf  # lost, although images show markers
    doubtful_since: float = np.inf
    supported_since: float = np.inf  # images show more of the hand than chance does
    last_supported: float = -np.inf
    strange_since: float = np.inf  # images show another hand than the one that is followed
    last_digits: float = -np.inf  # last search for digits
    last_found: float = -np.inf  # last search that found the hand, at last_place (3,) m in G
    last_place: Array = field(default_factory=lambda: np.zeros(3))


class TrackingJudge:
    """Says after each image, and where none comes, how far the filter can be trusted."""

    def __init__(self, params: MatchParams) -> None:
        self._params = params
        self.kept = TrackingKept()

    @property
    def tracking(self) -> Tracking:
        """The state of tracking."""
        return self.kept.tracking

    def is_coasting(self, t: float) -> bool:
        """No image with enough markers lately."""
        return t - self.kept.last_good > self._params.lost_after

    def is_enough(self, tally: Tally) -> bool:
        """Markers to go by: some, or most of the few that can be seen of a hand edge-on."""
        p = self._params
        least = max(p.least_markers, ENOUGH_SHARE * tally.expected)
        return tally.matched >= min(p.min_markers, least)

    def is_believable(self, tally: Tally) -> bool:
        """Markers enough for a hand that was out of sight."""
        return tally.matched >= max(self._params.min_markers, BELIEVABLE_SHARE * tally.expected)

    def judge(self, t: float, enough: bool) -> None:
        """After an image with ``enough`` markers, or without."""
        now, gap = self.kept, t - self.kept.last_good
        if enough:
            now.last_good, now.tracking = t, Tracking.TRACKING
        elif gap > self._params.coast_limit:
            now.tracking = Tracking.LOST
        elif gap > self._params.lost_after:
            now.tracking = Tracking.COASTING

    def support(self, t: float, there: bool) -> bool:
        """After an image that supports the pose or not: whether what is shown may be called
        measured.

        A pose that has just been found, or doubted, is sure only after a while of support, not by
        time that passes.
        """
        now = self.kept
        if there:
            now.last_supported = t
            now.supported_since = min(now.supported_since, t)
        elif t - now.last_supported > DOUBT_AFTER:
            now.supported_since = np.inf
        return self.is_sure

    @property
    def is_sure(self) -> bool:
        """Whether images have supported the pose for long enough, and lately."""
        return self.kept.last_supported - self.kept.supported_since >= SURE_AFTER

    def is_another(self, t: float, followed: bool) -> bool:
        """After an image in which the hand was ``followed`` or not: whether what is tracked is
        another hand than the images show, which is then forgotten."""
        now = self.kept
        now.strange_since = np.inf if followed else min(now.strange_since, t)
        another = t - now.strange_since >= STRANGE_FOR
        if another:
            self.forget()
            self.kept.last_start = t
        return another

    def found(self, t: float, p: Array) -> Array | None:
        """A search has found the hand at p (3,) m: its velocity (3,) m/s, if another one found it
        shortly before."""
        now = self.kept
        since, way = t - now.last_found, p - now.last_place
        now.last_found, now.last_place = t, p.copy()
        return way / since if 0.0 < since <= PLACES_APART else None

    # ---- when to search

    def should_search_digits(self, t: float) -> bool:
        """A search for digits is due; then it is noted."""
        if t - self.kept.last_digits < DIGIT_PERIOD:
            return False
        self.kept.last_digits = t
        return True

    def should_search(self, t: float, tally: Tally) -> bool:
        """Lost, or too few of the expected markers are there for too long; then it is noted."""
        p, now = self._params, self.kept
        doubtful = tally.matched < max(p.min_markers, DOUBTFUL_SHARE * tally.expected)
        now.doubtful_since = min(now.doubtful_since, t) if doubtful else np.inf
        long = t - now.doubtful_since >= p.lost_after or self.is_coasting(t)
        if not long or t - now.last_search < p.search_period / 10:
            return False
        now.last_search = t
        return True

    def should_start(self, t: float) -> bool:
        """A search from nothing is due; then it is noted.

        It takes what several images take, and a glove on the files of the other hand is searched
        for all the time.
        """
        now = self.kept
        eager = not t - now.starting_since > EAGER
        period = self._params.search_period if eager else max(self._params.search_period, SPARING)
        if t - now.last_start < period:
            return False
        now.last_start, now.starting_since = t, min(now.starting_since, t)
        return True

    def saw_nothing(self) -> None:
        """The image that was to be searched shows no hand: that took no time, and the next one that
        does is searched at once."""
        self.kept.starting_since = np.inf

    def started(self, t: float) -> None:
        """The hand was found from nothing."""
        self.kept.tracking, self.kept.last_good = Tracking.TRACKING, t
        self.kept.supported_since = self.kept.in_vain_since = np.inf
        self.kept.starting_since = np.inf

    def started_anywhere(self) -> None:
        """The hand's posture is known by its IMUs, its position is not."""
        self.kept.tracking = Tracking.LOST

    def forget(self) -> None:
        """Nothing is known of the hand any more."""
        self.kept = TrackingKept()

    # ---- a lost hand

    def looked(self, t: float, most_blobs: int) -> None:
        """An image with ``most_blobs`` in one of its sides was used."""
        in_vain = self.tracking == Tracking.LOST and most_blobs >= MANY_MARKERS
        self.kept.in_vain_since = min(self.kept.in_vain_since, t) if in_vain else np.inf

    def is_in_vain(self, t: float) -> bool:
        """A lost hand is in the images, and not as it was last."""
        return t - self.kept.in_vain_since > IN_VAIN

    def was_lately(self, t: float) -> bool:
        """So short a time after the last good image, what was learned is not what is wrong."""
        return t - self.kept.last_good < KEEP_CALIBRATION
