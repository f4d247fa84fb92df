"""Statistics of agreement against published examples and laws of mathematics."""

from __future__ import annotations

import numpy as np
import pytest

from extensions.reference.statistics import (
    bland_altman,
    effective_size,
    icc_2_1,
    random_intercept,
    rms,
)

# Bland & Altman 1986, table 1: peak expiratory flow rate of 17 people in l/min, first measurement
# with each meter.
WRIGHT = [494, 395, 516, 434, 476, 557, 413, 442, 650, 433, 417, 656, 267, 478, 178, 423, 427]
MINI_WRIGHT = [512, 430, 520, 428, 500, 600, 364, 380, 658, 445, 432, 626, 260, 477, 259, 350, 451]

# Shrout & Fleiss 1979, table 2: six targets, four judges.
JUDGES = [[9, 2, 5, 8], [6, 1, 3, 2], [8, 4, 6, 8], [7, 1, 2, 6], [10, 5, 6, 9], [6, 2, 4, 7]]


def test_the_data_of_bland_and_altman_1986_give_their_published_limits() -> None:
    """Mean -2.1, SD 38.8; the paper computed its limits, -79.7 and 75.5, from these rounded values
    (2 SD), so ours differ from them by at most 0.05 + 2 · 0.05. Its intervals are -22.0 to 17.8
    for the bias, -114.3 to -45.1 and 40.9 to 110.1 for the limits (there with √(3/n))."""
    found = bland_altman(np.subtract(WRIGHT, MINI_WRIGHT), factor=2.0)
    assert found.n == 17
    assert round(found.bias, 1) == -2.1
    assert round(found.sd, 1) == 38.8
    rounded = [round(found.bias, 1) + k * round(found.sd, 1) for k in (-2, 2)]
    assert np.round(rounded, 1).tolist() == [-79.7, 75.5]
    assert (found.low, found.high) == pytest.approx((-79.7, 75.5), abs=0.15)
    assert np.round(found.bias_ci, 1).tolist() == [-22.0, 17.8]
    # √(1/n + 4/(2(n-1))) of 1999 instead of √(3/n) of 1986: 16.68 instead of 16.29 l/min
    assert found.low_ci == pytest.approx((-114.3, -45.1), abs=3.5)
    assert found.high_ci == pytest.approx((40.9, 110.1), abs=3.5)


def test_the_example_of_shrout_and_fleiss_1979_gives_its_published_icc() -> None:
    """ICC(2,1) = 0.29 there; interval 0.019 to 0.761 by R's psych::ICC of the same data."""
    found = icc_2_1(np.array(JUDGES, float))
    assert round(found.value, 2) == 0.29
    assert found.ci == pytest.approx((0.019, 0.761), abs=5e-4)


def test_an_interval_covers_the_truth_as_often_as_it_claims() -> None:
    """1000 samples of 12 differences: the share of 95 % intervals with the truth has a standard
    deviation of 0.7 %, so that it is outside 95 ± 3 % once in 50 000 runs; the seed is fixed. The
    limit's interval is approximate."""
    rng = np.random.default_rng(5)
    hits = np.zeros(2)
    for _ in range(1000):
        found = bland_altman(rng.normal(3.0, 2.0, 12))
        hits += [
            found.bias_ci[0] <= 3.0 <= found.bias_ci[1],
            found.high_ci[0] <= 3.0 + 1.96 * 2.0 <= found.high_ci[1],
        ]
    assert hits[0] / 1000 == pytest.approx(0.95, abs=0.03)
    assert hits[1] / 1000 == pytest.approx(0.95, abs=0.04)


def test_missing_differences_are_left_out_and_few_give_no_interval() -> None:
    found = bland_altman(np.array([1.0, np.nan, 3.0]))
    assert (found.n, found.bias) == (2, 2.0)
    alone = bland_altman(np.array([4.0]))
    assert alone.bias == 4.0 and np.isnan(alone.sd) and np.isnan(alone.bias_ci).all()


def test_the_effective_size_of_a_first_order_series_is_its_law() -> None:
    """n (1 - φ) / (1 + φ) for an autoregressive series; 20 000 values give it to about 10 %."""
    rng = np.random.default_rng(2)
    for phi in (0.0, 0.5, 0.9):
        x = np.zeros(20_000)
        for i, e in enumerate(rng.normal(size=len(x) - 1)):
            x[i + 1] = phi * x[i] + e
        assert effective_size(x) / len(x) == pytest.approx((1 - phi) / (1 + phi), rel=0.15)
    assert effective_size(np.full(50, 3.0)) == 1.0


def test_icc_is_one_without_error_and_counts_a_bias_as_disagreement() -> None:
    truth = np.random.default_rng(1).normal(0, 10, 400)
    assert icc_2_1(np.column_stack([truth, truth])).value == pytest.approx(1.0)
    biased = icc_2_1(np.column_stack([truth, truth + 10.0])).value
    variance = truth.var(ddof=1)
    assert biased == pytest.approx(variance / (variance + 10.0**2 / 2))


def test_variance_components_of_people_are_recovered() -> None:
    """400 people with 1 to 4 recordings: σ_b = 2 and σ_e = 1 to 10 %, four standard deviations of
    the estimates (σ / √(2·400) ≈ 3.5 % of it, σ_e fewer)."""
    rng = np.random.default_rng(8)
    values, people = [], []
    for person in range(400):
        intercept = 7.0 + rng.normal(0, 2.0)
        for _ in range(1 + person % 4):
            values.append(intercept + rng.normal(0, 1.0))
            people.append(f"p{person}")
    found = random_intercept(values, people)
    assert found.between == pytest.approx(2.0, rel=0.15)
    assert found.within == pytest.approx(1.0, rel=0.1)
    assert found.ci[0] < 7.0 < found.ci[1]
    assert found.ci[1] - found.ci[0] == pytest.approx(2 * 1.966 * 2.1 / 20, rel=0.15)
    assert (found.people, found.recordings) == (400, 1000)


def test_a_balanced_design_gives_the_textbook_interval_of_person_means() -> None:
    values, people = [1.0, 3.0, 5.0, 7.0, 4.0, 10.0], ["a", "a", "b", "b", "c", "c"]
    found = random_intercept(values, people)
    means = np.array([2.0, 6.0, 7.0])
    half = 4.302653 * means.std(ddof=1) / np.sqrt(3)
    assert found.mean == pytest.approx(5.0)
    assert found.ci == pytest.approx((5.0 - half, 5.0 + half), rel=1e-5)
    assert found.within**2 == pytest.approx((2 + 2 + 18) / 3)


def test_one_recording_each_and_one_person_alone() -> None:
    found = random_intercept([1.0, 2.0, 6.0], ["a", "b", "c"])
    assert found.between == pytest.approx(np.std([1, 2, 6], ddof=1)) and np.isnan(found.within)
    alone = random_intercept([1.0, 2.0, 6.0], ["a", "a", "a"])
    assert np.isnan(alone.between) and alone.people == 1 and alone.recordings == 3
    assert random_intercept([float("nan")], ["a"]).recordings == 0
    assert rms(np.array([3.0, np.nan, 4.0])) == pytest.approx(np.sqrt(12.5))
