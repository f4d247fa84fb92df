"""Statistics of agreement between two methods of measurement, and over several people.

Limits of agreement: Bland & Altman 1986, Lancet 327:307, and 1999, Stat. Methods Med. Res. 8:135.
ICC: Shrout & Fleiss 1979, Psychol. Bull. 86:420, and McGraw & Wong 1996, Psychol. Methods 1:30.
Variance components of people: Searle, Casella & McCulloch 1992, Variance Components, chapter 3.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import fdtri, stdtrit  # scipy.stats takes seconds to import

from tracker.messages import Array

LIMITS = 1.96  # standard deviations from the bias to the 95 % limits of agreement
Interval = tuple[float, float]
UNKNOWN: Interval = (float("nan"), float("nan"))


@dataclass(frozen=True)
class Agreement:
    """Differences between two methods: ``bias`` (mean), ``sd``, and the limits of agreement, in the
    unit of the differences; 95 % confidence intervals of each. ``n`` differences, of which
    ``n_effective`` count as independent. NaN where they do not suffice."""

    n: int
    n_effective: float
    bias: float
    sd: float
    low: float
    high: float
    bias_ci: Interval
    low_ci: Interval
    high_ci: Interval


def bland_altman(
    differences: Array, factor: float = LIMITS, n_effective: float | None = None
) -> Agreement:
    """Bias and limits of agreement ``bias ± factor * sd`` of differences (n,); NaN are left out.

    ``n_effective``: the number of independent differences, for the intervals; n by default. The
    variance of a limit is sd² (1/n + factor² / (2 (n - 1))) (Bland & Altman 1999, section 2.2).
    """
    d = np.asarray(differences, float)
    d = d[np.isfinite(d)]
    n = float(len(d)) if n_effective is None else min(float(n_effective), float(len(d)))
    bias = float(d.mean()) if len(d) else float("nan")
    sd = float(d.std(ddof=1)) if len(d) > 1 else float("nan")
    low, high = bias - factor * sd, bias + factor * sd
    if len(d) < 2 or n < 2:
        return Agreement(len(d), n, bias, sd, low, high, UNKNOWN, UNKNOWN, UNKNOWN)
    t = float(stdtrit(n - 1, 0.975))
    of_bias = t * sd / np.sqrt(n)
    of_limit = t * sd * np.sqrt(1 / n + factor**2 / (2 * (n - 1)))
    return Agreement(
        len(d),
        n,
        bias,
        sd,
        low,
        high,
        (bias - of_bias, bias + of_bias),
        (low - of_limit, low + of_limit),
        (high - of_limit, high + of_limit),
    )


def effective_size(series: Array) -> float:
    """The number of independent values in an evenly sampled series (n,) with autocorrelation.

    n / (1 + 2 Σ ρ_k), summed in pairs of lags as long as the pairs are positive and do not grow
    (Geyer 1992, Stat. Sci. 7:473). At most n. NaN are replaced by the mean, which adds nothing.
    """
    x = np.asarray(series, float)
    known = np.isfinite(x)
    n = int(known.sum())
    if n < 4:
        return float(n)
    x = np.where(known, x - x[known].mean(), 0.0)
    size = 2 ** int(np.ceil(np.log2(2 * len(x))))
    covariance = np.fft.irfft(np.abs(np.fft.rfft(x, size)) ** 2)[: len(x)]
    if covariance[0] <= 0:
        return 1.0
    rho = covariance / covariance[0]
    pairs = rho[: len(rho) // 2 * 2].reshape(-1, 2).sum(axis=1)
    ends = np.flatnonzero(pairs <= 0)
    positive = pairs[: ends[0]] if len(ends) else pairs
    time = 2 * float(np.minimum.accumulate(positive).sum()) - 1.0
    return float(np.clip(n / max(time, 1e-9), 1.0, n))


@dataclass(frozen=True)
class Icc:
    """ICC(2,1): absolute agreement, two-way random effects, single measurement; 95 % interval."""

    value: float
    ci: Interval
    n: int
    n_effective: float


def icc_2_1(ratings: Array, n_effective: float | None = None) -> Icc:
    """Intraclass correlation of ratings (n targets, k methods); rows with NaN are left out.

    ``n_effective``: the number of independent targets, for the interval (McGraw & Wong 1996,
    table 7, case 2A); n by default. NaN for fewer than two targets or constant ratings.
    """
    x = np.asarray(ratings, float)
    x = x[np.isfinite(x).all(axis=1)]
    n, k = x.shape
    if n < 2 or k < 2:
        return Icc(float("nan"), UNKNOWN, n, float(n))
    between, methods, error = _mean_squares(x)
    scale = between + (k - 1) * error + k * (methods - error) / n
    value = float((between - error) / scale) if scale > 0 else float("nan")
    independent = float(n) if n_effective is None else float(np.clip(n_effective, 2.0, n))
    return Icc(value, _icc_interval(value, between, methods, error, independent, k), n, independent)


def _mean_squares(x: Array) -> tuple[float, float, float]:
    """Mean squares between targets, between methods, and of the residual of ratings (n, k)."""
    n, k = x.shape
    mean, rows, columns = x.mean(), x.mean(axis=1), x.mean(axis=0)
    between = k * float(((rows - mean) ** 2).sum()) / (n - 1)
    methods = n * float(((columns - mean) ** 2).sum()) / (k - 1)
    rest = x - rows[:, None] - columns[None] + mean
    return between, methods, float((rest**2).sum()) / ((n - 1) * (k - 1))


def _icc_interval(
    value: float, between: float, methods: float, error: float, n: float, k: int
) -> Interval:
    if not np.isfinite(value) or value >= 1.0 or error <= 0.0:
        return UNKNOWN
    a = k * value / (n * (1 - value))
    b = 1 + k * value * (n - 1) / (n * (1 - value))
    freedom = (a * methods + b * error) ** 2 / (
        (a * methods) ** 2 / (k - 1) + (b * error) ** 2 / ((n - 1) * (k - 1))
    )
    upper = float(fdtri(n - 1, freedom, 0.975))
    lower = float(fdtri(freedom, n - 1, 0.975))
    common = k * methods + (k * n - k - n) * error
    return (
        float(n * (between - upper * error) / (upper * common + n * between)),
        float(n * (lower * between - error) / (common + n * lower * between)),
    )


@dataclass(frozen=True)
class Pooled:
    """Mean of a quantity over people with a random intercept each: ``mean`` with its 95 % interval,
    standard deviations ``between`` people and ``within`` (between recordings of a person; NaN
    without a person who has two). ``people`` and ``recordings`` on which it is based."""

    mean: float
    ci: Interval
    between: float
    within: float
    people: int
    recordings: int


def random_intercept(values: Sequence[float], people: Sequence[Hashable]) -> Pooled:
    """y_ij = μ + b_i + e_ij for recording j of person i, by the method of moments.

    With the mean squares of a one-way analysis of variance, σ_e² = MS_within and
    σ_b² = max(0, (MS_between - MS_within) / n_0), n_0 = (N - Σ n_i² / N) / (a - 1) (Searle et al.
    1992, eq. 3.6); then μ by weights 1 / (σ_b² + σ_e² / n_i), as DerSimonian & Laird 1986 weigh
    studies, with a t interval of a - 1 degrees of freedom. With one recording per person, σ_b
    contains both.
    """
    pairs = [(v, p) for v, p in zip(values, people, strict=True) if np.isfinite(v)]
    groups: dict[Hashable, list[float]] = {}
    for value, person in pairs:
        groups.setdefault(person, []).append(value)
    each = [np.array(g) for g in groups.values()]
    a, total = len(each), len(pairs)
    if a == 0:
        return Pooled(float("nan"), UNKNOWN, float("nan"), float("nan"), 0, 0)
    counts, means = np.array([len(g) for g in each], float), np.array([g.mean() for g in each])
    within = float("nan")
    if total > a:
        within = sum(float(((g - g.mean()) ** 2).sum()) for g in each) / (total - a)
    if a == 1:
        return _one_person(each[0], within)
    error = 0.0 if np.isnan(within) else within
    overall = float((counts * means).sum() / total)
    between_squares = float((counts * (means - overall) ** 2).sum()) / (a - 1)
    n_0 = (total - float((counts**2).sum()) / total) / (a - 1)
    between = max(0.0, (between_squares - error) / n_0)
    spread = between + error / counts
    weights = 1 / spread if (spread > 0).all() else counts
    mean = float((weights * means).sum() / weights.sum())
    half = float(stdtrit(a - 1, 0.975)) * (
        float(np.sqrt(1 / weights.sum())) if (spread > 0).all() else 0.0
    )
    return Pooled(
        mean, (mean - half, mean + half), float(np.sqrt(between)), float(np.sqrt(within)), a, total
    )


def _one_person(values: Array, within: float) -> Pooled:
    """The interval of one person's mean: the spread of people is unknown."""
    agreement = bland_altman(values)
    return Pooled(
        agreement.bias, agreement.bias_ci, float("nan"), float(np.sqrt(within)), 1, len(values)
    )


def rms(values: Array) -> float:
    """Root of the mean square of what is known; NaN if nothing is."""
    x = np.asarray(values, float)
    x = x[np.isfinite(x)]
    return float(np.sqrt(np.mean(x**2))) if len(x) else float("nan")
