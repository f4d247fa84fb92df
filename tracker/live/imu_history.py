"""The packets of the last seconds, for the screen, and how many never came."""

from __future__ import annotations

from tracker.live.history import History
from tracker.live.telemetry import Telemetry
from tracker.messages import ImuSample


class ImuHistory(History[ImuSample]):
    """Written by one thread, read by any."""

    def __init__(self, telemetry: Telemetry) -> None:
        super().__init__()
        self._telemetry = telemetry
        self._lost = 0

    def add(self, sample: ImuSample) -> None:
        """The next packet."""
        self._telemetry.tick("imu", sample.t_arrival)
        last = self._messages[-1] if self._messages else None
        if last is not None and sample.seq > last.seq + 1 > 0:
            self._lost += sample.seq - last.seq - 1
        super().add(sample)

    def silent(self, t: float, after: float) -> bool:
        """Whether none had come for ``after`` s at ``t`` (s), by times of arrival."""
        return not self._messages or t - self._messages[-1].t_arrival > after

    def figures(self) -> dict[str, float]:
        """Packets missed by their numbers."""
        return {"imu_lost": self._lost}
