"""Smooth functions of time that can be evaluated at any time: drifts, sway and moves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.messages import Array

_FEW = 32
"""Times up to which each has the same bits as when it is asked for alone: those of an image."""


def rng_for(seed: int, *stream: int | str) -> np.random.Generator:
    """An independent generator for each named use of one seed."""
    words = [seed]
    for s in stream:
        words += list(s.encode()) if isinstance(s, str) else [s]
    return np.random.default_rng(words)


class SmoothNoise:
    """Gaussian noise of time with unit variance and correlation exp(-(dt / correlation)² / 2).

    A sum of cosines of random frequency and phase (random Fourier features, Rahimi & Recht 2007):
    infinitely smooth, and independent of the order of evaluation.
    """

    def __init__(
        self, rng: np.random.Generator, shape: Sequence[int], correlation: float, waves: int = 24
    ) -> None:
        self.shape = tuple(shape)
        n = int(np.prod(self.shape))
        self._omega = np.abs(rng.normal(0, 1 / correlation, waves))
        phase = rng.uniform(0, 2 * np.pi, (n, waves))
        self._amplitude = rng.normal(0, np.sqrt(2.0 / waves), (n, waves)) * np.exp(1j * phase)

    def __call__(self, t: Array) -> Array:
        """(n, *shape) at the times t (n,) s."""
        return _sum_of_waves(t, self._omega, self._amplitude).reshape(len(t), *self.shape)


class Oscillation:
    """A few sines in a band of frequencies, of unit variance: tremor."""

    def __init__(
        self, rng: np.random.Generator, n: int, low_hz: float, high_hz: float, waves: int = 6
    ) -> None:
        self._omega = 2 * np.pi * rng.uniform(low_hz, high_hz, waves)
        phase = rng.uniform(0, 2 * np.pi, (n, waves))
        self._amplitude = np.sqrt(2.0 / waves) * np.exp(1j * phase)

    def __call__(self, t: Array) -> Array:
        """(n_times, n) at the times t (s)."""
        return _sum_of_waves(t, self._omega, self._amplitude)


def _sum_of_waves(t: Array, omega: Array, amplitude: Array) -> Array:
    """(n_times, n) at the times t (s): waves of omega (w,) rad/s and complex amplitudes (n, w)."""
    wave = np.exp(1j * np.multiply.outer(t, omega))
    if 1 < len(wave) <= _FEW:  # BLAS adds the waves of several rows in another order
        few: Array = (wave[:, None] @ amplitude.T)[:, 0].real
        return few
    values: Array = (wave @ amplitude.T).real
    return values


def minimum_jerk(x: Array) -> Array:
    """Flash & Hogan (1985): 0 for x ≤ 0, 1 for x ≥ 1, between them 10x³ - 15x⁴ + 6x⁵."""
    x = np.clip(x, 0.0, 1.0)
    return x * x * x * (10 - 15 * x + 6 * x * x)
