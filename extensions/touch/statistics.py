"""Estimates with confidence intervals: 95 %, two-sided."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2, norm
from scipy.stats import t as student

from tracker.messages import Array

LEVEL = 0.95
RESAMPLES, SEED = 2000, 20260101


@dataclass(frozen=True)
class ConfidenceInterval:
    """A value and the ends of its confidence interval."""

    value: float
    low: float
    high: float

    def scaled(self, factor: float) -> ConfidenceInterval:
        """In another unit; ``factor`` is positive."""
        return ConfidenceInterval(self.value * factor, self.low * factor, self.high * factor)


def mean_interval(values: Array) -> ConfidenceInterval:
    """For a mean, by Student's t; (n,)."""
    n, mean = len(values), float(np.mean(values))
    if n < 2:
        return ConfidenceInterval(mean, float("nan"), float("nan"))
    half = float(student.ppf(0.5 + LEVEL / 2, n - 1) * np.std(values, ddof=1) / np.sqrt(n))
    return ConfidenceInterval(mean, mean - half, mean + half)


def sd_interval(sd: float, dof: float) -> ConfidenceInterval:
    """For a standard deviation with ``dof`` degrees of freedom, by chi-square."""
    if dof < 1:
        return ConfidenceInterval(sd, float("nan"), float("nan"))
    low, high = (sd * np.sqrt(dof / chi2.ppf(q, dof)) for q in (0.5 + LEVEL / 2, 0.5 - LEVEL / 2))
    return ConfidenceInterval(sd, float(low), float(high))


def share_interval(count: int, n: int) -> ConfidenceInterval:
    """For a share, by Wilson's score interval (doi:10.1080/01621459.1927.10502953)."""
    if n == 0:
        return ConfidenceInterval(float("nan"), float("nan"), float("nan"))
    z, share = float(norm.ppf(0.5 + LEVEL / 2)), count / n
    middle = (share + z**2 / (2 * n)) / (1 + z**2 / n)
    half = z * np.sqrt(share * (1 - share) / n + z**2 / (4 * n**2)) / (1 + z**2 / n)
    return ConfidenceInterval(share, float(middle - half), float(middle + half))


def bootstrap(values: Array, figure: Callable[[Array], Array]) -> ConfidenceInterval:
    """For any figure of independent rows (n, …), by percentiles of resamples from a fixed seed.

    ``figure`` computes (k,) from k samples (k, n, …)."""
    rng = np.random.default_rng(SEED)
    picks = rng.integers(0, len(values), (RESAMPLES, len(values)))
    low, high = np.percentile(figure(values[picks]), [50 - 50 * LEVEL, 50 + 50 * LEVEL])
    return ConfidenceInterval(float(figure(values[None])[0]), float(low), float(high))


def slope(x: Array, y: Array) -> ConfidenceInterval:
    """For the least-squares line y = a + slope x, by Student's t; (n,) each."""
    n, centred = len(x), x - np.mean(x)
    spread = float(centred @ centred)
    if n < 3 or spread <= 0:
        return ConfidenceInterval(float("nan"), float("nan"), float("nan"))
    value = float(centred @ y) / spread
    rest = y - np.mean(y) - value * centred
    half = float(student.ppf(0.5 + LEVEL / 2, n - 2) * np.sqrt(rest @ rest / (n - 2) / spread))
    return ConfidenceInterval(value, value - half, value + half)


def agreement_limits(
    bias: float, sd: float, n: int
) -> tuple[ConfidenceInterval, ConfidenceInterval]:
    """The 95 % limits of agreement and their intervals (Bland & Altman 1986,
    doi:10.1016/S0140-6736(86)90837-8: standard error √3 sd / √n)."""
    z = float(norm.ppf(0.5 + LEVEL / 2))
    half = float(student.ppf(0.5 + LEVEL / 2, n - 1) * np.sqrt(3 / n) * sd) if n > 1 else np.nan
    ends = (bias - z * sd, bias + z * sd)
    return ConfidenceInterval(ends[0], ends[0] - half, ends[0] + half), ConfidenceInterval(
        ends[1], ends[1] - half, ends[1] + half
    )
