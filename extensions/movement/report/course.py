"""Smoothness and repetitions of a time series."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import butter, sosfiltfilt

from tracker.messages import Array, IntArray
from tracker.session.holes import runs

CUTOFF = 6.0  # Hz, of a zero-phase second-order Butterworth filter: hands do not move faster
HIGHEST = 10.0  # Hz: upper limit of the spectral arc length
LOWEST_SHARE = 0.05  # of the spectrum's maximum, at which the arc ends
PADDED = 4  # powers of two by which the spectrum is zero-padded
BAND = 0.15  # of the range on both sides of its middle, which a repetition has to cross
LEAST_RAD, LEAST_M = np.deg2rad(10.0), 0.01  # smaller ranges do not count as movement


class Course(NamedTuple):
    """Results for one time series.

    Of the longest part without a gap: ``arc``, the spectral arc length, and ``jerk``, the logarithm
    of the dimensionless jerk (both negative; nearer to zero is smoother; NaN without movement). Of
    the whole series: ``repetitions``, their median range ``each`` and its standard deviation
    ``each_sd`` (NaN for fewer than two), the largest rate of change ``fastest`` per s and its time
    ``at`` in s.
    """

    arc: float
    jerk: float
    repetitions: int
    fastest: float
    at: float
    each: float = float("nan")
    each_sd: float = float("nan")


def course(t: Array, values: Array, least: float) -> Course:
    """Analyse values (N,) at t (N,) s; a range below ``least`` does not count as movement."""
    stretches = [even(t[r], values[r]) for r in runs(t, np.asarray(np.isfinite(values)))]
    long = [s for s in stretches if len(s[0]) > 30]
    if not long:
        return Course(np.nan, np.nan, 0, np.nan, np.nan)
    smooth = [(at, low_passed(x, at[1] - at[0])) for at, x in long]
    low, high = (f([f(x) for _, x in smooth]) for f in (min, max))
    speeds = [(at, np.gradient(x, at)) for at, x in smooth]
    peak_at, peak = max(((at, v) for at, v in speeds), key=lambda s: float(np.abs(s[1]).max()))
    k = int(np.argmax(np.abs(peak)))
    if high - low < least:
        return Course(np.nan, np.nan, 0, float(abs(peak[k])), float(peak_at[k]))
    at, v = max(speeds, key=lambda s: len(s[0]))
    count = sum(repetitions(x, low, high) for _, x in smooth)
    swings = np.concatenate([turns(x, low, high) for _, x in smooth])
    step = float(at[1] - at[0])
    return Course(
        arc_length(v, step),
        jerk(v, step),
        count,
        float(abs(peak[k])),
        float(peak_at[k]),
        float(np.median(swings)) if len(swings) else np.nan,
        float(np.std(swings, ddof=1)) if len(swings) > 1 else np.nan,
    )


def even(t: Array, values: Array) -> tuple[Array, Array]:
    """The known values resampled at the median interval by a cubic spline."""
    known = np.isfinite(values)
    t, values = t[known], values[known]
    rising = np.r_[True, np.diff(t) > 0] if len(t) else np.zeros(0, bool)
    t, values = t[rising], values[rising]
    if len(t) < 4:
        return t, values
    step = float(np.median(np.diff(t)))
    at = t[0] + step * np.arange(int((t[-1] - t[0]) / step + 1e-6) + 1)
    return at, CubicSpline(t, values)(at)


def low_passed(values: Array, step: float) -> Array:
    """Values without noise above `CUTOFF`; unchanged if the rate is too low for the filter."""
    share = CUTOFF * 2 * step
    if share >= 1 or len(values) < 20:
        return values
    out: Array = sosfiltfilt(butter(2, share, output="sos"), values)
    return out


def arc_length(v: Array, step: float) -> float:
    """Spectral arc length of a speed (N,): Balasubramanian et al. 2015, J. NeuroEng. Rehabil.
    12:112, eq. 11 with its parameters: up to 10 Hz, down to 5 % of the maximum."""
    n = 2 ** (int(np.ceil(np.log2(len(v)))) + PADDED)
    frequency = np.fft.rfftfreq(n, step)
    magnitude = np.abs(np.fft.rfft(np.abs(v), n))
    if magnitude.max() == 0:
        return float("nan")
    magnitude = magnitude / magnitude.max()
    inside = frequency <= HIGHEST
    last = int(np.flatnonzero(inside & (magnitude >= LOWEST_SHARE))[-1]) + 1
    f, m = frequency[:last], magnitude[:last]
    if last < 2 or f[-1] == 0:
        return float("nan")
    return -float(np.hypot(np.diff(f) / (f[-1] - f[0]), np.diff(m)).sum())


def jerk(v: Array, step: float) -> float:
    """Negative logarithm of the dimensionless jerk of a speed; the same paper, eq. 3 and 4."""
    peak = float(np.abs(v).max())
    if peak == 0 or len(v) < 4:
        return float("nan")
    second = np.gradient(np.gradient(v, step), step)
    time = (len(v) - 1) * step
    return -float(np.log(time**3 / peak**2 * np.trapezoid(second**2, dx=step)))


def repetitions(values: Array, low: float, high: float) -> int:
    """Number of crossings of the band around the middle of the range, in the direction with more
    crossings."""
    side, _ = _sides(values, low, high)
    change = np.diff(side)
    return int(max((change > 0).sum(), (change < 0).sum()))


def turns(values: Array, low: float, high: float) -> Array:
    """Ranges (n,) between successive turning points of the movements that `repetitions` counts.

    A single movement takes seconds, in which an estimate drifts little, whereas the range of a
    whole take includes the drift between its minimum and maximum.
    """
    side, rows = _sides(values, low, high)
    if len(side) == 0:
        return np.zeros(0)
    begins = np.r_[0, np.flatnonzero(np.diff(side)) + 1]
    parts = np.split(values[rows], begins[1:])
    ends = [p.max() if side[b] > 0 else p.min() for p, b in zip(parts, begins, strict=True)]
    return np.abs(np.diff(ends))


def _sides(values: Array, low: float, high: float) -> tuple[IntArray, IntArray]:
    """Side of the band around the middle, 1 or -1, of the values outside it, and their rows."""
    middle, band = 0.5 * (low + high), BAND * (high - low)
    side = np.where(values > middle + band, 1, np.where(values < middle - band, -1, 0))
    rows = np.flatnonzero(side)
    return side[rows], rows
