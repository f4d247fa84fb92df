"""Converts the time stamps of images to the glove's clock.

Once the offset is known well enough and is significant, it is subtracted for the engine; the
results are returned with the original stamps.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, field, replace
from statistics import median

from tracker.base.records import record
from tracker.messages import BlobFrame, FrameResult, ImuSample
from tracker.online.time_offset import Offset, TimeOffset, TimeOffsetSavedState


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
    """The jitter of images' time stamps about the camera's regular exposures.

    A camera exposes at a constant rate: a grid of instants whose phase and period follow the stamps
    by the gains of a straight line through the last images. The difference of a stamp from its
    predicted instant is its jitter. Missing images are steps over several periods.
    """

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
        """Adds the next image's stamp; images arrive in order."""
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


WAITING = 64  # maximum number of pending images


@dataclass(frozen=True)
class TimingParams:
    """When the measured offset is subtracted. Times in s."""

    apply: bool = True
    sure: float = 0.003  # standard deviation, at most
    clear: float = 3.0  # standard deviations from zero, at least
    worth: float = 0.005  # least offset that is subtracted: a smaller one may be noise
    step: float = 0.001  # change from one image to the next
    jitter: bool = True  # whether the jitter of stamps counts as noise


@record("frame_timing")
@dataclass(eq=False)
class FrameTimingSavedState:
    """The saved state: the measurement, pending images with the instants (s) that the
    engine received, the target and applied offset (s), and the jitter of stamps."""

    offset: TimeOffsetSavedState
    under_way: list[tuple[float, BlobFrame]]
    target: float
    applied: float
    jitter: StampJitterSavedState = field(default_factory=StampJitterSavedState)


class FrameTiming:
    """Between a pipeline and its engine."""

    def __init__(self, offset: TimeOffset, params: TimingParams) -> None:
        self._offset, self._params = offset, params
        self._under_way: deque[tuple[float, BlobFrame]] = deque(maxlen=WAITING)
        self._jitter = StampJitter()
        self._target = 0.0
        self.applied = 0.0
        """Offset (s) that is currently subtracted from stamps."""

    @property
    def offset(self) -> Offset:
        """The measured delay of images."""
        return self._offset.estimate

    @property
    def jitter(self) -> float:
        """Measured standard deviation of the stamps (s); 0 while unknown."""
        return self._jitter.measured

    def packet(self, sample: ImuSample) -> None:
        """To be called before the engine receives a packet."""
        self._offset.feed_imu(sample)

    def corrected(self, frame: BlobFrame) -> BlobFrame:
        """The image for the engine."""
        self._aim()
        self._jitter.take(frame.t)
        sd = self._jitter.sd if self._params.jitter else 0.0
        step = self._params.step
        self.applied += min(max(self._target - self.applied, -step), step)
        t = frame.t - self.applied
        self._under_way.append((t, frame))
        if t == frame.t and sd == 0.0:
            return frame
        return replace(frame, t=t, stamp_sd=sd)

    def restored(self, result: FrameResult) -> FrameResult:
        """Returns the engine's result with the image's own stamp; updates the offset."""
        while self._under_way and self._under_way[0][0] < result.t:
            self._under_way.popleft()
        if not self._under_way or self._under_way[0][0] != result.t:
            return result
        frame = self._under_way.popleft()[1]
        self._offset.feed_image(frame, result)
        return result if frame.t == result.t else replace(result, t=frame.t)

    def _aim(self) -> None:
        """Once an offset is significant, it follows the measurement."""
        measured, p = self._offset.estimate, self._params
        if not p.apply or measured.sd > p.sure:
            return
        if self._target != 0.0 or abs(measured.value) > max(p.worth, p.clear * measured.sd):
            self._target = measured.value

    def get_state(self) -> FrameTimingSavedState:
        """The state to save."""
        offset, under_way = self._offset.get_state(), list(self._under_way)
        jitter = self._jitter.get_state()
        return FrameTimingSavedState(offset, under_way, self._target, self.applied, jitter)

    def set_state(self, state: FrameTimingSavedState) -> None:
        """Continues from `get_state`."""
        self._offset.set_state(state.offset)
        self._under_way = deque(state.under_way, maxlen=WAITING)
        self._target, self.applied = state.target, state.applied
        self._jitter.set_state(state.jitter)
