"""The packets of the last seconds, for the screen, and how many never came."""

from __future__ import annotations

from collections import deque

from tracker.live.telemetry import Telemetry
from tracker.messages import ImuSample

HISTORY_S = 10.0
"""Seconds of packets that are kept for curves and for the steps of the set-up."""


class ImuHistory:
    """Written by one thread, read by any."""

    def __init__(self, telemetry: Telemetry) -> None:
        self._telemetry = telemetry
        self._samples: deque[ImuSample] = deque()
        self._lost = 0

    def add(self, sample: ImuSample) -> None:
        """The next packet."""
        self._telemetry.tick("imu", sample.t_arrival)
        samples = self._samples
        if samples and sample.seq > samples[-1].seq + 1 > 0:
            self._lost += sample.seq - samples[-1].seq - 1
        samples.append(sample)
        while samples[-1].t - samples[0].t > HISTORY_S:
            samples.popleft()

    def recent(self) -> list[ImuSample]:
        """Oldest first."""
        while True:
            try:
                return list(self._samples)
            except RuntimeError:  # a packet was added meanwhile
                continue

    def silent(self, t: float, after: float) -> bool:
        """Whether none had come for ``after`` s at ``t`` (s), by times of arrival."""
        return not self._samples or t - self._samples[-1].t_arrival > after

    def figures(self) -> dict[str, float]:
        """Packets missed by their numbers."""
        return {"imu_lost": self._lost}
