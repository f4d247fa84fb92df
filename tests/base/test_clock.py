"""Every time survives the conversion to a float and back, for any uptime."""

from __future__ import annotations

import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracker.base.clock import (
    COARSE_NS,
    EXACT_BELOW_NS,
    nanoseconds,
    next_instant,
    on_grid,
    seconds,
)
from tracker.live.loop import ArrivalOrder
from tracker.messages import ImuSample

YEARS_34 = 2**30 * 10**9
INSTANTS = st.integers(-YEARS_34, YEARS_34)


@given(INSTANTS)
def test_seconds_and_nanoseconds_are_inverse(ns: int) -> None:
    rounded = nanoseconds(seconds(ns))
    assert rounded == on_grid(ns) and nanoseconds(seconds(rounded)) == rounded
    assert abs(rounded - ns) <= (0 if abs(ns) < EXACT_BELOW_NS else COARSE_NS / 2)


@given(INSTANTS)
def test_the_next_time_is_later_also_as_a_float(ns: int) -> None:
    after = next_instant(ns)
    assert after > ns and seconds(after) > seconds(ns) and after - ns <= 2 * COARSE_NS
    assert nanoseconds(seconds(after)) == after


@given(
    st.lists(st.integers(0, 10**6), min_size=2, max_size=20), st.sampled_from([0, YEARS_34 // 2])
)
def test_packets_are_fed_in_the_order_of_their_timestamps(steps: list[int], begun: int) -> None:
    """Including several that arrive at one time."""
    order, fed = ArrivalOrder(), []
    for step in np.cumsum(steps):
        t = seconds(begun + int(step) // 100)
        zero = np.zeros((1, 3))
        fed.append(order.imu(ImuSample(t, t, t, 0, zero, zero, np.ones(1, bool))).t_arrival)
        fed.append(order.mark())
    stamps = [nanoseconds(t) for t in fed]
    assert all(b > a for a, b in itertools.pairwise(stamps))
    assert [seconds(s) for s in stamps] == fed
