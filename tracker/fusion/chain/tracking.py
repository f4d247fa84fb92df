"""The tracking state: tracking, coasting, lost, and when to search for the hand."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.params import MatchParams
from tracker.fusion.chain.pixels import Tally
from tracker.messages import Array, Tracking

EAGER = 1.0  # s of searches without a prior at the maximum rate, then every `SPARING` s
SPARING = 0.25
IN_VAIN = 0.3  # s of images with markers that do not match the last articulation of a lost hand
KEEP_CALIBRATION = 5.0  # s after which a lost hand is searched for without its calibration
MANY_MARKERS = 6  # in an image that shows the hand
DOUBTFUL_SHARE = 0.35  # of the expected markers
ENOUGH_SHARE = 0.6  # of the few markers visible on a hand edge-on
DOUBT_AFTER = 0.08  # s without support, after which no point is measured
SURE_AFTER = 0.08  # s with support, after which points are measured again
STRANGE_FOR = 0.4  # s of consecutive images
DIGIT_PERIOD = 0.09  # s between two searches of all digits
PLACES_APART = 0.12  # s, maximum between two searches from which the velocity is computed
BELIEVABLE_SHARE = 0.5  # of the expected markers, for a hand that was out of view


@record("chain.tracking", shapes={"last_place": "3"})
@dataclass(eq=False)
class TrackingSavedState:
    """The part that changes. Times in s."""

    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf  # last image with enough matches
    last_search: float = -np.inf
    last_start: float = -np.inf  # last search without a prior
    starting_since: float = np.inf  # images show markers and such searches fail
    in_vain_since: float = np.inf  # lost, although images show markers
    doubtful_since: float = np.inf
    supported_since: float = np.inf  # images support the hand more than chance would
    last_supported: float = -np.inf
    strange_since: float = np.inf  # images show another hand than the tracked one
    last_digits: float = -np.inf  # the last search of all digits began
    next_digit: int = 0  # with which that search continues; 0 after its end
    last_found: float = -np.inf  # last search that found the hand, at last_place (3,) m in G
    last_place: Array = field(default_factory=lambda: np.zeros(3))


def is_believable(tally: Tally, least: int) -> bool:
    """Whether enough markers match, ``least`` or more, for a hand that was out of view."""
    return tally.matched >= max(least, BELIEVABLE_SHARE * tally.expected)


class TrackingJudge:
    """Decides after each image, and where none arrives, how far the filter can be trusted."""

    def __init__(self, params: MatchParams) -> None:
        self._params = params
        self.saved = TrackingSavedState()

    @property
    def tracking(self) -> Tracking:
        """The tracking state."""
        return self.saved.tracking

    def is_coasting(self, t: float) -> bool:
        """Whether no recent image had enough markers."""
        return t - self.saved.last_good > self._params.lost_after

    def is_enough(self, tally: Tally) -> bool:
        """Whether enough markers match: some, or most of the few visible on a hand edge-on."""
        p = self._params
        least = max(p.least_markers, ENOUGH_SHARE * tally.expected)
        return tally.matched >= min(p.min_markers, least)

    def judge(self, t: float, enough: bool) -> None:
        """After an image with ``enough`` markers, or without."""
        now, gap = self.saved, t - self.saved.last_good
        if enough:
            now.last_good, now.tracking = t, Tracking.TRACKING
        elif gap > self._params.coast_limit:
            now.tracking = Tracking.LOST
        elif gap > self._params.lost_after:
            now.tracking = Tracking.COASTING

    def measured(self, t: float, credible: bool) -> float:
        """After a pose that another system measured, which agrees with the state or not: since when
        (s) poses have been disagreeing without a break; infinite where this one agrees."""
        now = self.saved
        now.strange_since = np.inf if credible else min(now.strange_since, t)
        if credible:
            self.judge(t, enough=True)
        return now.strange_since

    def support(self, t: float, there: bool) -> bool:
        """Call after an image that supports the pose or not: whether the output may be called
        measured.

        A pose just found or doubted becomes certain only after a period of support, not merely of
        time.
        """
        now = self.saved
        if there:
            now.last_supported = t
            now.supported_since = min(now.supported_since, t)
        elif t - now.last_supported > DOUBT_AFTER:
            now.supported_since = np.inf
        return self.is_sure

    @property
    def is_sure(self) -> bool:
        """Whether images have supported the pose for long enough, and recently."""
        return self.saved.last_supported - self.saved.supported_since >= SURE_AFTER

    def is_another(self, t: float, followed: bool) -> bool:
        """Call after an image in which the hand was ``followed`` or not: whether the tracked hand
        differs from the one in the images; it is then discarded."""
        now = self.saved
        now.strange_since = np.inf if followed else min(now.strange_since, t)
        another = t - now.strange_since >= STRANGE_FOR
        if another:
            self.forget()
            self.saved.last_start = t
        return another

    def found(self, t: float, p: Array) -> Array | None:
        """A search has found the hand at p (3,) m: its velocity (3,) m/s, if another search
        succeeded shortly before."""
        now = self.saved
        since, way = t - now.last_found, p - now.last_place
        now.last_found, now.last_place = t, p.copy()
        now.supported_since = np.inf  # what supported the pose before supported another one
        return way / since if 0.0 < since <= PLACES_APART else None

    # ---- when to search

    def next_digit(self, t: float) -> int | None:
        """The digit with which a search of misplaced digits begins or continues, None if it is not
        due. Who searches sets ``saved.next_digit``."""
        now = self.saved
        if now.next_digit == 0 and t - now.last_digits < DIGIT_PERIOD:
            return None
        if now.next_digit == 0:
            now.last_digits = t
        return now.next_digit

    def should_search(self, t: float, tally: Tally) -> bool:
        """Whether lost, or with too few of the expected markers for too long; if so, the time is
        recorded."""
        p, now = self._params, self.saved
        doubtful = tally.matched < max(p.min_markers, DOUBTFUL_SHARE * tally.expected)
        now.doubtful_since = min(now.doubtful_since, t) if doubtful else np.inf
        long = t - now.doubtful_since >= p.lost_after or self.is_coasting(t)
        if not long or t - now.last_search < p.search_period / 10:
            return False
        now.last_search = t
        return True

    def should_start(self, t: float) -> bool:
        """Whether a search without a prior is due; if so, its time is recorded.

        It takes as long as several images, and a glove with the files of the other hand is searched
        for continuously.
        """
        now = self.saved
        eager = not t - now.starting_since > EAGER
        period = self._params.search_period if eager else max(self._params.search_period, SPARING)
        if t - now.last_start < period:
            return False
        now.last_start, now.starting_since = t, min(now.starting_since, t)
        return True

    def saw_nothing(self) -> None:
        """The image to be searched shows no hand: this took no time, and the next image with one is
        searched at once."""
        self.saved.starting_since = np.inf

    def started(self, t: float) -> None:
        """The hand was found without a prior."""
        self.saved.tracking, self.saved.last_good = Tracking.TRACKING, t
        self.saved.supported_since = self.saved.in_vain_since = np.inf
        self.saved.starting_since = np.inf

    def started_anywhere(self) -> None:
        """The posture of the hand is known from its IMUs, its position is not."""
        self.saved.tracking = Tracking.LOST

    def forget(self) -> None:
        """The hand is unknown again."""
        self.saved = TrackingSavedState()

    # ---- a lost hand

    def looked(self, t: float, most_blobs: int) -> None:
        """An image with ``most_blobs`` in one of its sides was processed."""
        in_vain = self.tracking == Tracking.LOST and most_blobs >= MANY_MARKERS
        self.saved.in_vain_since = min(self.saved.in_vain_since, t) if in_vain else np.inf

    def is_in_vain(self, t: float) -> bool:
        """Whether a lost hand is in the images, in another articulation than its last one."""
        return t - self.saved.in_vain_since > IN_VAIN

    def was_recent(self, t: float) -> bool:
        """Whether the last good image is so recent that the calibration is not the cause."""
        return t - self.saved.last_good < KEEP_CALIBRATION
