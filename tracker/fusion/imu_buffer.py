"""A short memory of glove packets, so that a late picture meets the motion of its own instant."""

from __future__ import annotations

from collections import deque

import numpy as np

from tracker.messages import ImuSample


class ImuBuffer:
    """The packets of the last ``span`` seconds, in order of sampling instant."""

    def __init__(self, span: float = 1.0) -> None:
        self._span = span
        self._samples: deque[ImuSample] = deque()

    def __len__(self) -> int:
        return len(self._samples)

    def __iter__(self):  # type: ignore[no-untyped-def]
        return iter(self._samples)

    @property
    def newest(self) -> ImuSample | None:
        return self._samples[-1] if self._samples else None

    def add(self, sample: ImuSample) -> bool:
        """Keep a packet; False (and nothing kept) where it is not later than the newest."""
        if self._samples and sample.t <= self._samples[-1].t:
            return False
        self._samples.append(sample)
        while self._samples[-1].t - self._samples[0].t > self._span:
            self._samples.popleft()
        return True

    def covers(self, t: float) -> bool:
        """Whether a packet at or after ``t`` has come."""
        return bool(self._samples) and self._samples[-1].t >= t

    def after(self, t: float) -> list[ImuSample]:
        """Packets later than ``t``."""
        out: list[ImuSample] = []
        for sample in reversed(self._samples):
            if sample.t <= t:
                break
            out.append(sample)
        return out[::-1]

    def at(self, t: float) -> ImuSample | None:
        """The packet interpolated to ``t``; the nearest one outside the memory; None if empty.

        An IMU is valid where both neighbours are.
        """
        later = next((s for s in self._samples if s.t >= t), None)
        if later is None:
            return self.newest
        earlier = next((s for s in reversed(self._samples) if s.t < t), None)
        if earlier is None:
            return later
        return interpolate(earlier, later, t)

    def state(self) -> list[ImuSample]:
        return list(self._samples)

    def restore(self, samples: list[ImuSample]) -> None:
        self._samples = deque(samples)


def interpolate(a: ImuSample, b: ImuSample, t: float) -> ImuSample:
    """Linear between two packets."""
    w = (t - a.t) / (b.t - a.t)
    return ImuSample(
        t=t,
        t_arrival=b.t_arrival,
        t_device=a.t_device + w * (b.t_device - a.t_device),
        seq=a.seq,
        accel=(1 - w) * a.accel + w * b.accel,
        gyro=(1 - w) * a.gyro + w * b.gyro,
        valid=np.logical_and(a.valid, b.valid),
    )
