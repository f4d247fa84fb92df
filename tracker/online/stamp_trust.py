"""Whether time stamps of packets and images can be relied on: not on an overloaded computer.

A computer that is too slow takes images from a camera late and unevenly and stamps them so. At
hand speed an image that is 50 ms off shows all markers dozens of pixels from where they belong.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from statistics import median


@dataclass(frozen=True)
class TrustParams:
    """Times in s."""

    packet_gap: float = 0.035  # without a packet
    late: float = 0.05  # arrival after the instant, more than the least of late
    uneven: tuple[float, float] = (0.5, 1.8)  # of the usual interval between images
    images: int = 15  # over which that is taken
    regain: float = 1.0  # without any of these, before stamps are trusted again


class StampTrust:
    """Fed with all packets and images; ``since`` is when (s) the stamps were last in doubt."""

    def __init__(self, params: TrustParams | None = None) -> None:
        self._params = params or TrustParams()
        self._packet = self._image = float("nan")
        self._intervals: deque[float] = deque(maxlen=self._params.images)
        self._packet_lags, self._image_lags = _Lags(), _Lags()
        self.since = float("-inf")

    def packet(self, t: float, t_arrival: float) -> None:
        """A packet of the instant ``t`` (s)."""
        p = self._params
        if t - self._packet > p.packet_gap or self._packet_lags.excess(t, t_arrival) > p.late:
            self._doubt(t)
        self._packet = t

    def image(self, t: float, t_arrival: float) -> None:
        """An image exposed at ``t`` (s)."""
        interval, self._image = t - self._image, t
        late = self._image_lags.excess(t, t_arrival) > self._params.late
        if late or self._is_uneven(interval):
            self._doubt(t)
        if interval > 0:
            self._intervals.append(interval)

    def is_given(self, t: float) -> bool:
        """Whether stamps have been right for a while at ``t`` (s)."""
        return t - self.since >= self._params.regain

    def _is_uneven(self, interval: float) -> bool:
        if len(self._intervals) < 3:
            return False
        low, high = self._params.uneven
        usual = median(self._intervals)
        return not low * usual <= interval <= high * usual

    def _doubt(self, t: float) -> None:
        self.since = max(self.since, t)


class _Lags:
    """How much later than the least lag of the last seconds something arrives."""

    KEPT = 3.0  # s

    def __init__(self) -> None:
        self._lags: deque[tuple[float, float]] = deque()  # rising lags

    def excess(self, t: float, t_arrival: float) -> float:
        lag = t_arrival - t
        while self._lags and self._lags[-1][1] >= lag:
            self._lags.pop()
        self._lags.append((t, lag))
        while self._lags[0][0] < t - self.KEPT:
            self._lags.popleft()
        return lag - self._lags[0][1]
