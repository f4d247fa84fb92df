"""Another rate: cubic splines and slerp, after a low-pass filter if the new rate is lower."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.series import EstimateSeries
from tracker.session.holes import runs

MOST_ROWS = 1_000_000
"""In addition to twenty for each estimate: more are the result of wrong stamps."""


def resample(m: EstimateSeries, rate: float) -> EstimateSeries:
    """Estimates at ``rate`` Hz.

    A value next to a lost one stays lost, and holes longer than `holes.LONGEST_FILLED` are not
    interpolated; states and sd are the nearest estimate's, or lost. Raises FileError if the stamps
    would result in far more rows than there are estimates.
    """
    m = m.rows(np.flatnonzero(np.diff(m.stamp_ns, prepend=m.stamp_ns[0] - 1) > 0))
    if len(m) < 4:
        return m
    n = int(np.floor(m.elapsed[-1] * rate + 1e-9)) + 1
    if n > 20 * len(m) + MOST_ROWS:
        raise FileError(
            notice(
                "export.too_many_rows",
                estimates=len(m),
                seconds=m.elapsed[-1],
                rows=n,
                rate_hz=rate,
            )
        )
    return sampled_at(m, np.arange(n) / rate, rate)


def sampled_at(m: EstimateSeries, t: Array, rate: float) -> EstimateSeries:
    """Estimates at increasing times ``t`` (n,), s from the first estimate; lost outside of the
    series.

    The stamps of ``m`` increase; ``rate`` Hz is that of ``t``. See `resample`.
    """
    smooth = low_passed(m, rate) if rate < 0.9 * m.rate else m
    nearest = np.searchsorted((m.elapsed[1:] + m.elapsed[:-1]) / 2, t)
    keypoints = _spline(m.elapsed, smooth.keypoints, t)
    angles = _spline(m.elapsed, smooth.angles, t)
    near = m.rows(nearest)
    return replace(
        near,
        stamp_ns=m.stamp_ns[0] + np.round(t * NS).astype(np.int64),
        keypoints=keypoints,
        angles=angles,
        q=_slerp(m.elapsed, smooth.q, t),
        sd=np.where(np.isfinite(keypoints).all(axis=2), near.sd, np.nan),
        segment_p=_spline(m.elapsed, smooth.segment_p, t),
        segment_q=_slerp(m.elapsed, smooth.segment_q, t),
        state=np.where(np.isfinite(keypoints).all(axis=2), near.state, Validity.LOST),
        angle_state=np.where(np.isfinite(angles), near.angle_state, Validity.LOST),
    )


def low_passed(m: EstimateSeries, rate: float) -> EstimateSeries:
    """Returns a Gaussian whose gain is one half at 0.4 of the new rate, against aliasing."""
    sigma = np.sqrt(2 * np.log(2)) / (2 * np.pi * 0.4 * rate) * m.rate  # samples
    reach = max(int(np.ceil(3 * sigma)), 1)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    return replace(
        m,
        keypoints=_smoothed(m.elapsed, m.keypoints, kernel),
        angles=_smoothed(m.elapsed, m.angles, kernel),
        q=_smoothed_turns(m.elapsed, m.q, kernel),
        segment_p=_smoothed(m.elapsed, m.segment_p, kernel),
        segment_q=_smoothed_turns(m.elapsed, m.segment_q, kernel),
    )


def _smoothed(t: Array, values: Array, kernel: Array) -> Array:
    """Returns weighted means over time of known values, not across holes; lost stays lost."""
    flat = values.reshape(len(values), -1)
    out = np.full_like(flat, np.nan)
    for k, column in enumerate(flat.T):
        for run in runs(t, np.isfinite(column)):
            out[run, k] = _smoothed_run(column[run], kernel)
    return out.reshape(values.shape)


def _smoothed_run(column: Array, kernel: Array) -> Array:
    known = np.isfinite(column)
    total = np.convolve(np.where(known, column, 0.0), kernel, "full")
    weight = np.convolve(known.astype(float), kernel, "full")
    inside = slice(len(kernel) // 2, len(kernel) // 2 + len(column))
    mean = total[inside] / np.where(known, weight[inside], 1.0)
    return np.where(known, mean, np.nan)


def _smoothed_turns(t: Array, q: Array, kernel: Array) -> Array:
    """(N, K, 4): normalised means of sign-consistent quaternions, which approximate the mean
    rotation within a kernel."""
    out = np.empty_like(q)
    for k in range(q.shape[1]):
        mean = _smoothed(t, continuous(q[:, k]), kernel)
        out[:, k] = mean / np.linalg.norm(mean, axis=1, keepdims=True)
    return out


def continuous(q: Array) -> Array:
    """The same rotations (N, 4) without sign changes; lost rows (NaN) are skipped."""
    known = np.flatnonzero(np.isfinite(q).all(axis=1))
    flips = np.sum(q[known[1:]] * q[known[:-1]], axis=1) < 0
    sign = np.ones(len(q))
    sign[known[1:]] = np.where(np.cumsum(flips) % 2 == 1, -1.0, 1.0)
    return q * sign[:, None]


def _spline(t_old: Array, values: Array, t: Array) -> Array:
    flat = values.reshape(len(values), -1)
    out = np.full((len(t), flat.shape[1]), np.nan)
    for k, column in enumerate(flat.T):
        for knots, wanted in _pieces(t_old, np.isfinite(column), t):
            out[wanted, k] = CubicSpline(t_old[knots], column[knots])(t[wanted])
    return out.reshape(len(t), *values.shape[1:])


def _slerp(t_old: Array, q: Array, t: Array) -> Array:
    out = np.full((len(t), *q.shape[1:]), np.nan)
    for k in range(q.shape[1]):
        for knots, wanted in _pieces(t_old, np.asarray(np.isfinite(q[:, k]).all(axis=1)), t):
            turn = Slerp(t_old[knots], Rotation.from_quat(q[knots, k]))
            at = np.clip(t[wanted], t_old[knots[0]], t_old[knots[-1]])
            out[wanted, k] = turn(at).as_quat()
    return out


def _pieces(
    t_old: Array, known: NDArray[np.bool_], t: Array
) -> Iterator[tuple[IntArray, NDArray[np.int64]]]:
    """For each stretch without a hole: its rows, and the instants that it covers."""
    covered = _covered(t_old, known, t)
    for run in runs(t_old, known):
        knots = run.start + np.flatnonzero(known[run])
        if len(knots) < 2:
            continue
        low, high = t_old[knots[0]] - 1e-9, t_old[knots[-1]] + 1e-9
        first, last = np.searchsorted(t, low), np.searchsorted(t, high, side="right")
        yield knots, first + np.flatnonzero(covered[first:last])


def _covered(t_old: Array, known: NDArray[np.bool_], t: Array) -> NDArray[np.bool_]:
    """Instants whose neighbours on both sides are known."""
    after = np.clip(np.searchsorted(t_old, t - 1e-9), 0, len(t_old) - 1)
    before = np.clip(np.searchsorted(t_old, t + 1e-9, side="right") - 1, 0, len(t_old) - 1)
    return known[after] & known[before]
