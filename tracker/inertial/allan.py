"""Noise of inertial sensors at rest: overlapping Allan deviation, and the model fitted to it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import nnls

from tracker.messages import Array

POINTS_PER_DECADE = 12
LONGEST_SHARE = 1 / 9
"""For the recording: longer averages have fewer than nine clusters, and say little."""
BIAS_INSTABILITY = np.sqrt(2 * np.log(2) / np.pi)
"""For the flat part of a curve, as a share of the flicker coefficient (IEEE Std 952-1997, C.7)."""


@dataclass(frozen=True, eq=False)
class AllanCurve:
    """``deviation`` (M, k) of k signals at averaging times ``tau`` (M,) s, in their own unit."""

    tau: Array
    deviation: Array


@dataclass(frozen=True)
class NoiseModel:
    """For one signal in unit u: ``white`` u/√Hz, ``flicker`` u (bias instability), ``walk`` u/√s
    (random walk of the bias). 0 where the recording does not show one."""

    white: float
    flicker: float
    walk: float

    def deviation(self, tau: Array) -> Array:
        """The Allan deviation (M,) of this model at ``tau`` (M,) s."""
        coefficients = np.array([self.white, self.flicker, self.walk]) ** 2
        return np.asarray(np.sqrt(_terms(tau) @ coefficients))


def allan(signal: Array, rate_hz: float) -> AllanCurve:
    """Overlapping Allan deviation of ``signal`` (N, k), sampled at ``rate_hz`` without gaps.

    IEEE Std 952-1997, C.2, with overlapping clusters. Raises ValueError for fewer than 100 samples.
    """
    n = len(signal)
    if n < 100:
        raise ValueError("an Allan deviation needs 100 samples")
    longest = int(n * LONGEST_SHARE)
    decades = np.log10(longest)
    sizes = np.unique(np.logspace(0, decades, int(POINTS_PER_DECADE * decades)).astype(int))
    theta = np.concatenate([np.zeros((1, signal.shape[1])), np.cumsum(signal, axis=0)]) / rate_hz
    rows = []
    for m in sizes:
        second = theta[2 * m :] - 2 * theta[m:-m] + theta[: -2 * m]
        tau = m / rate_hz
        rows.append(np.sqrt((second**2).mean(axis=0) / (2 * tau**2)))
    return AllanCurve(sizes / rate_hz, np.array(rows))


def fit(tau: Array, deviation: Array, clusters: Array) -> NoiseModel:
    """White noise, flicker and random walk of one curve (M,), none negative.

    ``clusters`` (M,) is how many independent averages each point has: the relative error of a
    variance is the inverse of the root of that.
    """
    weight = np.sqrt(np.maximum(clusters, 1.0)) / deviation**2
    solution, _ = nnls(_terms(tau) * weight[:, None], deviation**2 * weight)
    return NoiseModel(*(float(np.sqrt(c)) for c in solution))


def _terms(tau: Array) -> Array:
    """(M, 3) variances of unit coefficients: white N²/τ, flicker, walk K² τ/3."""
    return np.stack([1 / tau, np.full_like(tau, BIAS_INSTABILITY**2), tau / 3], axis=1)


def noise_of(signal: Array, rate_hz: float) -> tuple[AllanCurve, list[NoiseModel]]:
    """The curve of ``signal`` (N, k) and the k models fitted to it."""
    curve = allan(signal, rate_hz)
    clusters = len(signal) / (curve.tau * rate_hz)
    return curve, [fit(curve.tau, column, clusters) for column in curve.deviation.T]
