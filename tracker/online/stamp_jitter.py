"""Estimates the jitter of images' time stamps about the camera's regular exposures.

A camera exposes at a constant rate: a grid of instants whose phase and period follow the stamps by
the gains of a straight line through the last images. The difference of a stamp from its predicted
instant is its jitter. Missing images are steps over several periods.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from statistics import median

from tracker.base.records import record


@dataclass(frozen=True)
class JitterParams:
    """Times in s."""

    first: int = 15  # steps whose median is the first period
    line: int = 40  # images to which the straight line is fitted
    memory: float = 300.0  # images over which older ones are forgotten
    images: float = 20.0  # images on the line before the jitter is reported
    longest_gap: float = 1.0
    worth: float = 0.0008  # below it, the noise of the markers covers it
    most: float = 0.012  # of one image
    odd: float = 0.3  # of a period
    odd_images: int = 6  # consecutive ones, after which the camera has another rate


@record("stamp_jitter")
@dataclass(eq=False)
class StampJitterSavedState:
    """The saved state: the last stamp, the first steps, the grid's last instant and period
    (s; NaN before it is known), the images on it, sums over images of 1 and of the squared
    differences (s²), and the number of the last images that do not fit it."""

    last: float = math.nan
    steps: list[float] = field(default_factory=list)
    instant: float = math.nan
    period: float = math.nan
    images: int = 0
    count: float = 0.0
    squares: float = 0.0
    odd: int = 0


class StampJitter:
    """Receives the stamps of images in order."""

    def __init__(self, params: JitterParams | None = None) -> None:
        self._params, self._saved = params or JitterParams(), StampJitterSavedState()

    @property
    def measured(self) -> float:
        """Standard deviation of a stamp (s); 0 while unknown."""
        now, p = self._saved, self._params
        if now.count < p.images:
            return 0.0
        of_line = 1.0 + 4.0 / p.line  # ratio of the prediction's variance to that of a stamp
        return math.sqrt(now.squares / now.count / of_line)

    @property
    def sd(self) -> float:
        """Jitter (s) that counts as noise: 0 if negligible."""
        found = self.measured
        return found if found >= self._params.worth else 0.0

    def take(self, t: float) -> None:
        """Adds the next image's stamp."""
        now, p = self._saved, self._params
        step, now.last = t - now.last, t
        if not 0.0 < step <= p.longest_gap:
            now.steps, now.instant, now.images = [], t, 0
            return
        if len(now.steps) < p.first:
            now.steps = [*now.steps, step]
            now.instant, now.period, now.images = t, median(now.steps), 1
            return
        self._follow(t)

    def _follow(self, t: float) -> None:
        """Compares a stamp with the grid and updates the grid."""
        now, p = self._saved, self._params
        periods = max(1, round((t - now.instant) / now.period))
        expected = now.instant + periods * now.period
        off, k = t - expected, now.images + 1
        now.images = min(k, p.line)
        # a straight line through k values, by its gains for the last one and for the slope
        now.instant = expected + off * 2 * (2 * k - 1) / (k * (k + 1))
        now.period += off * 6 / (k * (k + 1)) / periods
        now.odd = now.odd + 1 if abs(off) > p.odd * now.period else 0
        if now.odd >= p.odd_images or now.period <= 0:
            now.steps, now.odd = [], 0
        elif now.images == p.line:
            keep = 1.0 - 1.0 / p.memory
            now.count = keep * now.count + 1.0
            now.squares = keep * now.squares + min(abs(off), p.most) ** 2

    def get_state(self) -> StampJitterSavedState:
        """The state to save."""
        return replace(self._saved, steps=list(self._saved.steps))

    def set_state(self, state: StampJitterSavedState) -> None:
        """Continues from `get_state`."""
        self._saved = replace(state, steps=list(state.steps))
