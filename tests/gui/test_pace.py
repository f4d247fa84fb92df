"""The frame rate of the window: lower under load, never so low that it appears frozen."""

import numpy as np
import pytest

from app.viewmodels.signal_curves import FIRST_CAPACITY, TimedRows
from app.window.ticker import LOW_LATENCY_SHARE, OVERLOADED, STARVED, Pace

COST = 0.02  # s of processor time a drawing, at 60 calls a second


def drawings(pace, seconds, hurried=False, cost=COST):
    """Number of drawings per second, and their share of a processor."""
    now = spent = 100.0
    pace.is_due(now, spent, hurried)
    count = 0
    while now < 100.0 + seconds:
        now += 1 / 60
        if pace.is_due(now, spent, hurried):
            count += 1
            spent += cost
            now += cost
    return count / seconds, count * cost / seconds


def test_without_load_it_is_drawn_at_each_call():
    rate, _ = drawings(Pace(), 10.0)
    assert rate > 25.0  # 20 ms of work and 17 ms of waiting each


def test_load_reduces_the_rate_and_it_is_restored():
    pace = Pace()
    for _ in range(20):
        pace.look(True)
    assert pace.share == OVERLOADED.share
    _, share = drawings(pace, 10.0, cost=0.01)
    assert share <= OVERLOADED.share  # 0.01 s of work in 0.04 s, less than `OVERLOADED.slowest`
    for _ in range(151):  # four a second: half a minute and more
        pace.look(False)
    assert pace.share == 1.0


@pytest.mark.parametrize(("starved", "floor"), [(False, OVERLOADED), (True, STARVED)])
def test_a_slow_window_is_drawn_at_the_minimum_rate(starved, floor):
    """The more tracking lacks, the less remains to the window."""
    pace = Pace()
    for _ in range(20):
        pace.look(True, starved)
    rate, _ = drawings(pace, 10.0, cost=0.035)
    assert 0.9 / (floor.slowest + 2 / 60 + 0.035) < rate <= 1 / floor.slowest


def test_with_a_robot_the_share_is_limited_at_any_rate():
    _, share = drawings(Pace(), 10.0, hurried=True, cost=0.1)
    assert share <= LOW_LATENCY_SHARE


def test_rows_of_the_last_seconds_are_kept_at_any_size():
    rows, t, span = TimedRows(5.0), 0.0, 5.0
    rng = np.random.default_rng(3)
    wanted = []
    for i in range(5 * FIRST_CAPACITY):
        t += rng.uniform(0.001, 0.02)
        rows.add(t, np.array([i, -i]))
        wanted = [w for w in (*wanted, (t, i)) if t - w[0] <= span]
        assert len(rows) == len(wanted)
    np.testing.assert_array_equal(rows.t, [w[0] for w in wanted])
    np.testing.assert_array_equal(rows.rows[:, 1], [-w[1] for w in wanted])
    rows.clear()
    assert len(rows) == 0
    rows.add(1.0, np.zeros(3))
    assert rows.rows.shape == (1, 3)
