"""Another rate: cubic splines and slerp, with a low-pass before where the new rate is lower."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from tracker.clock import NS
from tracker.messages import Array
from tracker.session.export.series import EstimateSeries


def resample(m: EstimateSeries, rate: float) -> EstimateSeries:
    """Estimates at ``rate`` Hz.

    A number next to one that was lost stays lost; states are those of the nearest estimate.
    """
    if len(m) < 4:
        return m
    smooth = low_passed(m, rate) if rate < 0.9 * m.rate else m
    n = int(np.floor(m.elapsed[-1] * rate + 1e-9)) + 1
    t = np.arange(n) / rate
    nearest = np.searchsorted((m.elapsed[1:] + m.elapsed[:-1]) / 2, t)
    return replace(
        m.rows(nearest),
        stamp_ns=m.stamp_ns[0] + np.round(t * NS).astype(np.int64),
        keypoints=_spline(m.elapsed, smooth.keypoints, t),
        angles=_spline(m.elapsed, smooth.angles, t),
        q=_slerp(m.elapsed, smooth.q, t),
    )


def low_passed(m: EstimateSeries, rate: float) -> EstimateSeries:
    """A Gaussian that halves what lies at 0.4 of the new rate, so that little folds over."""
    sigma = np.sqrt(2 * np.log(2)) / (2 * np.pi * 0.4 * rate) * m.rate  # samples
    reach = max(int(np.ceil(3 * sigma)), 1)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    return replace(
        m,
        keypoints=_smoothed(m.keypoints, kernel),
        angles=_smoothed(m.angles, kernel),
        q=_smoothed_turns(m.q, kernel),
    )


def _smoothed(values: Array, kernel: Array) -> Array:
    """Weighted means along time of what is known; what is lost stays lost."""
    flat = values.reshape(len(values), -1)
    out = np.empty_like(flat)
    for k, column in enumerate(flat.T):
        known = np.isfinite(column)
        total = np.convolve(np.where(known, column, 0.0), kernel, "full")
        weight = np.convolve(known.astype(float), kernel, "full")
        inside = slice(len(kernel) // 2, len(kernel) // 2 + len(column))
        mean = total[inside] / np.where(known, weight[inside], 1.0)
        out[:, k] = np.where(known, mean, np.nan)
    return out.reshape(values.shape)


def _smoothed_turns(q: Array, kernel: Array) -> Array:
    """(N, K, 4): normalised means of quaternions of one sign, right for turns within a kernel."""
    out = np.empty_like(q)
    for k in range(q.shape[1]):
        mean = _smoothed(continuous(q[:, k]), kernel)
        out[:, k] = mean / np.linalg.norm(mean, axis=1, keepdims=True)
    return out


def continuous(q: Array) -> Array:
    """The same rotations (N, 4) without jumps of sign; lost rows (NaN) are stepped over."""
    known = np.flatnonzero(np.isfinite(q).all(axis=1))
    flips = np.sum(q[known[1:]] * q[known[:-1]], axis=1) < 0
    sign = np.ones(len(q))
    sign[known[1:]] = np.where(np.cumsum(flips) % 2 == 1, -1.0, 1.0)
    return q * sign[:, None]


def _spline(t_old: Array, values: Array, t: Array) -> Array:
    flat = values.reshape(len(values), -1)
    out = np.full((len(t), flat.shape[1]), np.nan)
    for k, column in enumerate(flat.T):
        known = np.isfinite(column)
        if known.sum() < 2:
            continue
        covered = _covered(t_old, known, t)
        out[covered, k] = CubicSpline(t_old[known], column[known])(t[covered])
    return out.reshape(len(t), *values.shape[1:])


def _slerp(t_old: Array, q: Array, t: Array) -> Array:
    out = np.full((len(t), *q.shape[1:]), np.nan)
    for k in range(q.shape[1]):
        known = np.asarray(np.isfinite(q[:, k]).all(axis=1))
        if known.sum() < 2:
            continue
        covered = _covered(t_old, known, t)
        turn = Slerp(t_old[known], Rotation.from_quat(q[known, k]))
        out[covered, k] = turn(t[covered]).as_quat()
    return out


def _covered(t_old: Array, known: NDArray[np.bool_], t: Array) -> NDArray[np.bool_]:
    """Instants whose neighbours on both sides are known."""
    after = np.clip(np.searchsorted(t_old, t - 1e-9), 0, len(t_old) - 1)
    before = np.clip(np.searchsorted(t_old, t + 1e-9, side="right") - 1, 0, len(t_old) - 1)
    return known[after] & known[before]
