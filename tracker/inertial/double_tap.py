"""Detects two quick taps on an IMU from its accelerometer and gyroscope.

A tap is a short spike of the specific force while the hand is otherwise at rest. Exactly two taps
count; movements, which are longer and rotate the hand, do not.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.messages import Array


@dataclass(frozen=True)
class TapParams:
    """Times in s. A glove samples at 100 Hz: a tap of 10–20 ms is one to three samples."""

    spike: float = 6.0  # m/s² beyond the slow average from which on it is a tap
    rest: float = 3.0  # m/s² below which the hand is at rest
    rest_gyro: float = np.deg2rad(120.0)  # rad/s; a tap jolts the hand, too
    average: float = 0.2  # time constant of the slow average, which a spike hardly moves
    longest: float = 0.06  # of a spike
    apart: tuple[float, float] = (0.10, 0.50)  # from one spike's beginning to the next one's
    quiet: float = 0.25  # of rest before the first tap and after the second
    gap: float = 0.1  # without samples, after which everything begins again


class DoubleTap:
    """Fed with one IMU's samples in order; `feed` is true once for each double tap."""

    def __init__(self, params: TapParams | None = None) -> None:
        self.params = params or TapParams()
        self._forget(-np.inf)

    def _forget(self, t: float) -> None:
        self._mean: Array | None = None
        self._last = self._still_since = t
        self._spike_since: float | None = None
        self._taps: list[float] = []

    def feed(self, t: float, accel: Array, gyro: Array) -> bool:
        """Sample at ``t`` s: accel (3,) m/s², gyro (3,) rad/s; NaN where the IMU did not answer."""
        p = self.params
        if not (np.isfinite(accel).all() and np.isfinite(gyro).all()) or t <= self._last:
            return False
        if self._mean is None or t - self._last > p.gap:
            self._forget(t)
            self._mean = np.array(accel)
            return False
        share = 1.0 - np.exp(-(t - self._last) / p.average)
        self._last = t
        apart = accel - self._mean
        force = float(np.linalg.norm(apart))
        self._mean = self._mean + share * min(1.0, p.rest / max(force, 1e-9)) * apart
        if force >= p.spike:
            self._spike(t)
        elif force > p.rest or np.linalg.norm(gyro) > p.rest_gyro:
            self._disturb(t)
        else:
            return self._rest(t)
        return False

    def _spike(self, t: float) -> None:
        if self._spike_since is None:
            first = not self._taps
            if first and t - self._still_since < self.params.quiet:
                self._still_since = t  # in the middle of a movement
                return
            self._spike_since = t
            self._taps.append(t)
        elif t - self._spike_since > self.params.longest:
            self._moved(t)

    def _disturb(self, t: float) -> None:
        """Neither a spike nor rest: the end of a tap, or a movement."""
        if self._taps and t - self._taps[-1] > 2 * self.params.longest:
            self._moved(t)
        if not self._taps:
            self._still_since = t

    def _moved(self, t: float) -> None:
        self._taps, self._spike_since, self._still_since = [], None, t

    def _rest(self, t: float) -> bool:
        p = self.params
        self._spike_since = None
        if not self._taps:
            return False
        if len(self._taps) == 1:
            if t - self._taps[0] > p.apart[1]:
                self._moved(t)
            return False
        if t - self._taps[-1] < p.quiet:
            return False
        low, high = p.apart
        double = len(self._taps) == 2 and low <= self._taps[1] - self._taps[0] <= high
        self._moved(t)
        return double
