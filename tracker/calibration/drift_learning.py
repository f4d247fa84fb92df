"""Learns the change of biases with the temperature while a glove is used.

Packets are reduced to windows of a second. At the end, the rests among them improve the slopes that
were known before, unless they contradict them or do not determine them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.calibration.imu_drift import GYRO, WINDOW_S, Rests, at_rest, fit_drift
from tracker.glove.model import ImuDrift
from tracker.messages import Array, ImuSample

LEAST_SPAN_C = 1.0
"""°C between the coldest and the warmest second at rest, below which nothing is learned."""
GAIN = 0.9
"""The uncertainty after learning must be below this share of the one before."""
CONTRADICTION = 4.0
"""Standard deviations between the earlier slope and the new one, above which the new one is not
used: another glove, a defect, or a rest that was none."""
MOST_WINDOWS = 3600
LONGEST_GAP = 0.1
"""s without a packet, after which a window begins again."""


class RestWindow(NamedTuple):
    """Of a second: spread (n,) rad/s, celsius (n,), gyro (n, 3) rad/s, accel (n, 3) m/s²."""

    spread: Array
    celsius: Array
    gyro: Array
    accel: Array


@dataclass(eq=False)
class WarmthCollector:
    """Takes packets in order of time; stores the last hour."""

    windows: list[RestWindow] = field(default_factory=list)
    _block: list[ImuSample] = field(default_factory=list)
    _celsius: Array | None = None

    def add(self, sample: ImuSample) -> None:
        """Takes a packet; one that is not newer than the last is ignored."""
        block = self._block
        if block and sample.t <= block[-1].t:
            return
        if sample.temperature is not None:
            self._celsius = sample.temperature
        if block and sample.t - block[-1].t > LONGEST_GAP:
            block.clear()
        if block and sample.t - block[0].t >= WINDOW_S:
            self._close()
            del block[:-1]
        block.append(sample)

    def _close(self) -> None:
        block = self._block
        if self._celsius is None:
            return
        gyro, accel = (np.array([getattr(s, name) for s in block]) for name in ("gyro", "accel"))
        spread = gyro.std(axis=0).max(axis=1)
        window = RestWindow(spread, self._celsius, gyro.mean(axis=0), accel.mean(axis=0))
        self.windows = [*self.windows[1 - MOST_WINDOWS :], window]

    def rests(self) -> list[Rests]:
        """The rests of each IMU."""
        if not self.windows:
            return []
        spread, celsius, gyro, accel = (np.array(x) for x in zip(*self.windows, strict=True))
        n = spread.shape[1]
        return [at_rest(spread[:, j], celsius[:, j], gyro[:, j], accel[:, j]) for j in range(n)]


class LearnedDrift(NamedTuple):
    """Slopes by the name of the IMU: ``drift`` improves what was known, ``contradicted`` are IMUs
    whose rests do not match it, in which case the others are not to be trusted either.
    ``sd_before`` and ``sd_after`` are means, rad/s/°C."""

    drift: dict[str, ImuDrift]
    contradicted: tuple[str, ...]
    sd_before: float
    sd_after: float


def learn_drift(rests: Mapping[str, Rests], before: Mapping[str, ImuDrift | None]) -> LearnedDrift:
    """What the rests of each IMU teach, given earlier results by the same names."""
    drift, contradicted, sds = {}, [], []
    for name, own in rests.items():
        if len(own.celsius) == 0 or np.ptp(own.celsius) < LEAST_SPAN_C:
            continue
        known = before.get(name)
        new = fit_drift([own], known)
        if new is None:
            continue
        prior = np.zeros(3) if known is None else known.gyro
        prior_sd = np.full(3, GYRO.slope) if known is None else known.gyro_sd
        if new.gyro_sd.mean() > GAIN * prior_sd.mean():
            continue
        shift_sd = np.sqrt(np.maximum(prior_sd**2 - new.gyro_sd**2, 1e-18))
        if np.any(np.abs(new.gyro - prior) > CONTRADICTION * shift_sd):
            contradicted.append(name)
            continue
        drift[name] = new
        sds.append((float(prior_sd.mean()), float(new.gyro_sd.mean())))
    sd_before, sd_after = np.mean(sds, axis=0) if sds else (np.nan, np.nan)
    return LearnedDrift(drift, tuple(contradicted), float(sd_before), float(sd_after))
