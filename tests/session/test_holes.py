"""Holes in a series, which are never drawn or counted across."""

import numpy as np
import pytest

from tracker.session.holes import (
    LONGEST_FILLED,
    durations,
    gaps,
    is_hole,
    time_shares,
    with_breaks,
)

T = np.r_[np.arange(0.0, 1.0, 0.01), np.arange(3.0, 4.0, 0.05), 5.0]
"""1 s at 100 Hz, a hole of 2 s, 1 s at 20 Hz, a hole, and one value alone."""


def test_a_line_is_interrupted_in_each_hole_and_nowhere_else() -> None:
    t, values = with_breaks(T, T**2)
    broken = np.isnan(values)
    assert t[broken] == pytest.approx([(0.99 + 3.0) / 2, (3.95 + 5.0) / 2])
    np.testing.assert_array_equal(t[~broken], T)
    np.testing.assert_array_equal(values[~broken], T**2)
    assert (np.diff(t) > 0).all()
    assert len(t) - len(T) == len(gaps(T, np.ones(len(T), bool)))
    rows = with_breaks(T, np.zeros((len(T), 3)))[1]
    assert rows.shape == (len(T) + 2, 3) and np.isnan(rows[broken]).all()


def test_a_value_is_weighted_by_its_time_at_any_rate() -> None:
    each = durations(T)
    assert each[:100] == pytest.approx(0.01) and each[100:120] == pytest.approx(0.05)
    assert each[-1] == 0.0
    shares = time_shares(T)
    total = 5.0 + 0.005
    assert shares[:100].sum() == pytest.approx(1.0 / total)
    assert shares.sum() == pytest.approx(2.0 / total)
    assert time_shares(T[:100]).sum() == pytest.approx(1.0)


def test_the_longest_step_that_is_not_a_hole() -> None:
    assert not is_hole(1.0, 1.0 + LONGEST_FILLED)
    assert is_hole(1.0, 1.001 + LONGEST_FILLED)
    assert durations(np.array([0.0, LONGEST_FILLED])).sum() == pytest.approx(2 * LONGEST_FILLED)


@pytest.mark.parametrize("t", [np.zeros(0), np.array([2.0]), np.array([0.0, 9.0])])
def test_few_values_have_shares_too(t: np.ndarray) -> None:
    assert time_shares(t).sum() == pytest.approx(1.0 if len(t) else 0.0)
    assert len(durations(t)) == len(t)
    assert len(with_breaks(t, t)[0]) == len(t) + (len(t) == 2)
