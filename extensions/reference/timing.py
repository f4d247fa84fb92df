"""Time alignment of a reference recording with a session: by clock, by pulses, or by movement.

t_session = offset + (1 + drift) * t_reference, in s from the session's start and in s of the
reference's axis. By movement: `tracker.session.align` finds the offset coarsely; then the offset of
each part of the recording is where the speeds of its points correlate best, between samples by a
parabola, and a robust line through these local offsets gives offset and drift. Once the frames are
registered, `refined` repeats this with the points' positions: of each part the offset that explains
most of the difference by the velocity.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import butter, sosfiltfilt

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array
from tracker.session.align import MIN_OVERLAP, RATE, match_channels
from tracker.session.holes import LONGEST_FILLED

WAYS = ("movement", "clock", "pulse")
_RATE = 200.0  # Hz, of the speeds that are correlated
_CUTOFF = 8.0  # Hz: hands do not move faster; the correlation is smooth over several samples
_WINDOW, _HOP = 4.0, 1.0  # s
_PART = 2.0  # s, of the parts of `refined`, which do not overlap
_SLOW = 0.01  # m/s: slower coordinates do not show a delay
_REACH = 0.1  # s: largest local offset that is looked for
_COMMON = 0.3  # share of the shorter recording that is in the other one too
_LEAST = 0.6  # correlation in a part that is used
_PARTS = 10  # parts that a line needs
_DRIFT_SD = 100e-6  # a drift that is known less accurately is taken as 0
_MATCHED = 0.05  # s: between a pulse and its partner at the right offset, drift included


@dataclass(frozen=True)
class ReferenceTiming:
    """``offset`` and ``offset_sd`` s at the middle of the common time, expressed at the reference's
    t = 0; ``drift`` and ``drift_sd`` without unit (1e-6 is 1 ppm; sd NaN: it was taken as 0).

    ``residual``: root mean square of the local offsets or pulses from the line, s; ``parts`` of
    them; ``correlation``: median of the parts by movement, NaN otherwise."""

    by: str
    offset: float
    offset_sd: float = float("nan")
    drift: float = 0.0
    drift_sd: float = float("nan")
    residual: float = float("nan")
    parts: int = 0
    correlation: float = float("nan")

    def session_time(self, t: Array) -> Array:
        """(N,) s of the session for (N,) s of the reference."""
        return np.asarray(self.offset + (1.0 + self.drift) * t)


def by_clock(start_ns: int, session_start_ns: int) -> ReferenceTiming:
    """``start_ns``: wall clock at the reference's t = 0; both in ns since 1970."""
    return ReferenceTiming("clock", (start_ns - session_start_ns) * 1e-9)


def by_pulse(ours: Sequence[float], theirs: Sequence[float]) -> ReferenceTiming:
    """Instants of the same pulses in s of the session and of the reference; either may lack some.

    Raises FileError if no offset, or more than one, lets most of them match.
    """
    a, b = np.sort(np.asarray(ours, float)), np.sort(np.asarray(theirs, float))
    if len(a) == 0:
        raise FileError(notice("reference.no_pulses"))
    if len(b) == 0:
        raise FileError(notice("reference.no_pulses_in_file"))
    pairs = _matching(a, b)
    x, y = b[pairs[:, 1]], a[pairs[:, 0]]
    if len(x) < 3:
        return ReferenceTiming("pulse", float(np.mean(y - x)), parts=len(x))
    return _line("pulse", x, y - x, np.ones(len(x)), True)


def _matching(a: Array, b: Array) -> Array:
    """(n, 2) rows of a and b that match at the offset at which most do."""
    best: list[tuple[int, Array]] = []
    for offset in (a[:, None] - b[None]).ravel():
        nearest = np.abs(a[None] - b[:, None] - offset).argmin(axis=1)
        rows = np.flatnonzero(np.abs(a[nearest] - b - offset) < _MATCHED)
        if len(np.unique(nearest[rows])) == len(rows):
            best.append((len(rows), np.column_stack([nearest[rows], rows])))
    most = max(n for n, _ in best)
    at_most = {tuple(map(tuple, pairs)) for n, pairs in best if n == most}
    if len(at_most) > 1 or 2 * most <= min(len(a), len(b)):
        raise FileError(notice("reference.pulses_differ", ours=len(a), theirs=len(b)))
    return next(pairs for n, pairs in best if n == most)


def by_movement(
    t_session: Array,
    session: Array,
    t_reference: Array,
    reference: Array,
    relative: bool = False,
    with_drift: bool = True,
) -> ReferenceTiming:
    """For the same K points (N, K, 3) and (M, K, 3) m at (N,) and (M,) s.

    ``relative``: by the movement relative to the points' mean, for a session without positions.
    Raises FileError if no offset, or more than one, fits.
    """
    ours, theirs = (_Speeds.of(t, x, relative) for t, x in
                    ((t_session, session), (t_reference, reference)))  # fmt: skip
    coarse = _coarse(ours, theirs)
    found = ReferenceTiming("movement", coarse)
    for k in range(4):
        at, local, weight, correlation = _local_offsets(ours, theirs, found)
        if len(at) == 0:
            raise FileError(notice("reference.no_movement", windows=0))
        t = (at - local - found.offset) / (1 + found.drift)
        straight = with_drift and len(t) >= _PARTS
        fitted = _line("movement", t, at - t, weight, straight, _WINDOW / _HOP)
        found = replace(fitted, correlation=float(np.median(correlation)))
        if k and np.abs(local).max() < 1e-5:
            break
    return found


def refined(
    timing: ReferenceTiming, t: Array, ours: Array, theirs: Array, with_drift: bool = True
) -> ReferenceTiming:
    """``timing`` improved by registered points: ``ours`` and ``theirs`` (N, K, 3) m in G, both at
    session times t (N,) s, NaN where unknown. Unchanged if too little moves."""
    velocity = np.gradient(theirs, t, axis=0)
    use = np.isfinite(velocity) & np.isfinite(ours)
    v, e = np.where(use, velocity, 0.0), np.where(use, ours - theirs, 0.0)
    along, squared = (v * e).sum(axis=(1, 2)), (v**2).sum(axis=(1, 2))
    part = ((t - t[0]) / _PART).astype(int)
    n = np.bincount(part, use.sum(axis=(1, 2)))
    energy = np.asarray(np.bincount(part, squared), float)
    fine = energy > n * _SLOW**2
    if fine.sum() < 3:
        return timing
    local = -np.bincount(part, along)[fine] / energy[fine]
    at = np.bincount(part, squared * t)[fine] / energy[fine]
    t_reference = (at - local - timing.offset) / (1 + timing.drift)
    straight = with_drift and len(at) >= _PARTS
    found = _line("movement", t_reference, at - t_reference, energy[fine], straight)
    return replace(found, correlation=timing.correlation)


@dataclass(frozen=True, eq=False)
class _Speeds:
    """Speeds (N, K) m/s of K points at even steps of 1/`_RATE` from ``start`` s; NaN in holes."""

    start: float
    values: Array

    @classmethod
    def of(cls, t: Array, points: Array, relative: bool) -> _Speeds:
        if relative:
            points = points - np.nanmean(points, axis=1, keepdims=True)
        at = np.arange(t[0], t[-1], 1 / _RATE)
        out = np.full((len(at), points.shape[1]), np.nan)
        for k in range(points.shape[1]):
            known = np.isfinite(points[:, k]).all(axis=1)
            if known.sum() < 10:
                continue
            even = np.column_stack([np.interp(at, t[known], x) for x in points[known, k].T])
            smooth = sosfiltfilt(butter(2, 2 * _CUTOFF / _RATE, output="sos"), even, axis=0)
            speed = np.linalg.norm(np.gradient(smooth, 1 / _RATE, axis=0), axis=1)
            after = np.clip(np.searchsorted(t[known], at), 1, int(known.sum()) - 1)
            gap = t[known][after] - t[known][after - 1] > LONGEST_FILLED
            outside = (at < t[known][0]) | (at > t[known][-1])
            out[:, k] = np.where(gap | outside, np.nan, speed)
        return cls(float(t[0]), out)

    @property
    def t(self) -> Array:
        return np.asarray(self.start + np.arange(len(self.values)) / _RATE)

    def at(self, t: Array) -> Array:
        """(n, K) at the instants t (n,), linear between samples; NaN outside and in holes."""
        x = np.clip((t - self.start) * _RATE, 0, len(self.values) - 1.000001)
        i = x.astype(int)
        share = (x - i)[:, None]
        out = (1 - share) * self.values[i] + share * self.values[
            np.minimum(i + 1, len(self.values) - 1)
        ]
        outside = (t < self.start) | (t > self.start + (len(self.values) - 1) / _RATE)
        return np.where(outside[:, None], np.nan, out)


def _coarse(ours: _Speeds, theirs: _Speeds) -> float:
    """The offset to about a sample. Raises FileError if no offset, or more than one, fits."""
    a, b = (v.at(v.start + np.arange(0, len(v.values) / _RATE, 1 / RATE)) for v in (ours, theirs))
    common = max(MIN_OVERLAP, _COMMON * min(len(a), len(b)) / RATE)
    return match_channels(a, b, ours.start - theirs.start, common).offset


def _local_offsets(
    ours: _Speeds, theirs: _Speeds, timing: ReferenceTiming
) -> tuple[Array, Array, Array, Array]:
    """Middle (n,) s of each part of the session, its offset (n,) s from ``timing``, its weight
    1/variance and its correlation."""
    t = ours.t
    x, y = ours.values, theirs.at((t - timing.offset) / (1 + timing.drift))
    reach, width = round(_REACH * _RATE), round(_WINDOW * _RATE)
    found = []
    for begin in range(reach, len(t) - width - reach, round(_HOP * _RATE)):
        r = _correlations(x[begin : begin + width], y[begin - reach : begin + width + reach])
        top = int(np.argmax(np.where(np.isfinite(r), r, -1.0)))
        if not 0 < top < len(r) - 1 or not r[top] >= _LEAST:
            continue
        bend = r[top - 1] - 2 * r[top] + r[top + 1]
        if not bend < 0:
            continue
        shift = 0.5 * (r[top - 1] - r[top + 1]) / bend
        variance = (1 - r[top] ** 2 + 1e-6) / -bend
        found.append((t[begin + width // 2], (reach - top - shift) / _RATE, 1 / variance, r[top]))
    at, local, weight, correlation = np.array(found).reshape(-1, 4).T
    return at, local, weight, correlation


def _correlations(x: Array, y: Array) -> Array:
    """Pearson's of x (w, K) with each part of y (w + 2 reach, K), pooled over the points that both
    know completely; entry i is of the part that begins at row i."""
    both = np.isfinite(x).all(axis=0) & np.isfinite(y).all(axis=0)
    shifts = len(y) - len(x) + 1
    if not both.any():
        return np.full(shifts, np.nan)
    x, y = x[:, both] - x[:, both].mean(axis=0), y[:, both]
    parts = np.lib.stride_tricks.sliding_window_view(y, len(x), axis=0)  # (shifts, K, w)
    centred = parts - parts.mean(axis=2, keepdims=True)
    product = np.einsum("skw,wk->s", centred, x)
    scale = np.sqrt((x**2).sum() * np.einsum("skw,skw->s", centred, centred))
    return np.asarray(product / np.maximum(scale, 1e-12))


def _line(
    by: str, t: Array, offsets: Array, weight: Array, with_drift: bool, shared: float = 1.0
) -> ReferenceTiming:
    """A line through offsets (n,) s at t (n,) s of the reference, by Huber's weights; a constant
    where the drift would be known to less than `_DRIFT_SD`. ``shared``: parts that overlap."""
    middle = float(np.average(t, weights=weight))
    A = np.column_stack([np.ones(len(t)), t - middle])
    for columns in (2, 1) if with_drift else (1,):
        solution, covariance, residual = _robust(A[:, :columns], offsets, weight)
        sd = np.sqrt(np.diag(covariance) * shared)
        if columns == 1 or sd[1] < _DRIFT_SD:
            break
    drift = float(solution[1]) if columns == 2 else 0.0
    return ReferenceTiming(
        by,
        float(solution[0]) - drift * middle,
        float(sd[0]),
        drift,
        float(sd[1]) if columns == 2 else float("nan"),
        residual,
        len(t),
    )


def _robust(A: Array, y: Array, weight: Array) -> tuple[Array, Array, float]:
    """Iteratively reweighted least squares: solution, covariance, and root mean square residual."""
    w = weight / weight.mean()
    solution = np.zeros(A.shape[1])
    huber = np.ones(len(y))
    for _ in range(50):
        H = A.T @ (A * (w * huber)[:, None])
        solution = np.linalg.solve(H, A.T @ (w * huber * y))
        e = np.sqrt(w) * (y - A @ solution)
        scale = 1.4826 * float(np.median(np.abs(e))) + 1e-9
        huber = np.minimum(1.0, 1.345 * scale / np.maximum(np.abs(e), 1e-12))
    freedom = max(float(huber.sum()) - A.shape[1], 1.0)
    variance = float((huber * e**2).sum()) / freedom
    return solution, np.linalg.inv(H) * variance, float(np.sqrt(np.mean((y - A @ solution) ** 2)))
