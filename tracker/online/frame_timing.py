"""Converts the time stamps of images to the glove's clock.

Once the offset is known well enough and is significant, it is subtracted for the engine; the
results are returned with the original stamps.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field, replace

from tracker.base.records import record
from tracker.messages import BlobFrame, FrameResult, ImuSample
from tracker.online.stamp_jitter import StampJitter, StampJitterSavedState
from tracker.online.time_offset import Offset, TimeOffset, TimeOffsetSavedState

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
