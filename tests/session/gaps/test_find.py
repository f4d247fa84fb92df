"""Gaps in synthetic states with known limits."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.messages import Validity
from tracker.session.gaps.find import HOLE, INFERRED, LOST, Interval, intervals

LIMIT = 0.5  # s
M, I, L = Validity.MEASURED, Validity.INFERRED, Validity.LOST  # noqa: E741


def found(
    t: np.ndarray, states: list[int], end: float | None = None, limit: float = LIMIT
) -> list[Interval]:
    ends = (0.0, float(t[-1]) if end is None else end)
    return sorted(intervals(t, np.array(states, np.int8), limit, ends), key=lambda i: i.before)


def evenly(n: int) -> np.ndarray:
    return np.arange(n) / 10.0


def test_a_hand_measured_throughout_has_no_gap() -> None:
    assert found(evenly(20), [M] * 20) == []


def test_lost_rows_are_a_gap_between_the_known_rows() -> None:
    assert found(evenly(10), [M] * 4 + [L] * 3 + [M] * 3) == [Interval(LOST, 3, 7)]


def test_a_lost_row_at_an_end_has_no_row_on_that_side() -> None:
    states = [L, M, M, L]
    assert found(evenly(4), states) == [Interval(LOST, -1, 1), Interval(LOST, 2, 4)]


def test_missing_estimates_are_a_hole() -> None:
    t = np.r_[evenly(5), 2.0 + evenly(5)]
    assert found(t, [M] * 10) == [Interval(HOLE, 4, 5)]


def test_missing_estimates_at_the_ends_of_a_session_are_holes() -> None:
    t = 1.0 + evenly(5)
    assert found(t, [M] * 5, end=3.0) == [Interval(HOLE, -1, 0), Interval(HOLE, 4, 5)]


def test_a_step_of_the_longest_filled_length_is_not_a_hole() -> None:
    assert found(evenly(5), [M] * 5) == []  # 0.1 s apart


@pytest.mark.parametrize(("rows", "listed"), [(4, False), (5, True)])
def test_inferred_rows_are_a_gap_beyond_the_limit(rows: int, listed: bool) -> None:
    states = [M] * 3 + [I] * rows + [M] * 3
    expected = [Interval(INFERRED, 2, 3 + rows)] if listed else []
    assert found(evenly(len(states)), states) == expected


def test_an_inferred_span_next_to_a_lost_one_ends_at_its_own_row() -> None:
    states = [M, *[I] * 8, L, L, M]
    assert found(evenly(12), states) == [Interval(INFERRED, 0, 8), Interval(LOST, 8, 11)]


def test_a_point_never_measured_is_one_gap_including_lost_spans() -> None:
    states = [I] * 4 + [L] + [I] * 4
    assert sorted(found(evenly(9), states)) == [Interval(INFERRED, -1, 9), Interval(LOST, 3, 5)]


def test_a_point_never_known_is_one_lost_gap() -> None:
    assert found(evenly(9), [L] * 9) == [Interval(LOST, -1, 9)]
