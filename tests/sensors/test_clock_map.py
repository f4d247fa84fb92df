"""Device time to host time, against known clocks."""

import numpy as np
import pytest

from tracker.sensors.packet_clock import ClockMap

LATENCY = 0.0004  # s, minimum: not observable with one-way timestamps


def errors(skew: float, bunch: float, stall: bool, seed: int = 0) -> np.ndarray:
    """Error (s) of each sample's host time after the first ten seconds."""
    rng = np.random.default_rng(seed)
    clock, out, flush = ClockMap(), [], 100.0
    for k in range(9000):
        t = 100.0 + 0.01 * k
        arrival = t + LATENCY + rng.exponential(0.0005)
        if bunch:
            while flush < arrival:  # the adapter's timer restarts after each flush
                flush += bunch + rng.uniform(0, 4e-4)
            arrival = flush
        if stall and 40.0 < t - 100 < 40.1:
            arrival = max(arrival, 140.1)
        device = 5.0 + (t - 100.0) * (1 + skew)
        clock.add(device, arrival)
        if k > 1000:
            out.append(clock.host(device) - t)
    return np.array(out)


@pytest.mark.parametrize("skew", [-200e-6, 0.0, 200e-6])
@pytest.mark.parametrize(("bunch", "stall"), [(0.0, False), (0.016, False), (0.016, True)])
def test_accurate_to_two_milliseconds(skew: float, bunch: float, stall: bool) -> None:
    error = errors(skew, bunch, stall)
    assert np.abs(error).max() < 0.002
    assert np.abs(np.diff(error)).max() < 0.002


def test_estimates_the_skew_and_is_monotonic() -> None:
    clock, rng = ClockMap(), np.random.default_rng(1)
    last = -np.inf
    for k in range(4000):
        device = 0.01 * k
        clock.add(device, 7 + device * (1 + 150e-6) + rng.exponential(0.004))
        t = clock.host(device)
        assert t > last
        last = t
    assert clock.skew == pytest.approx(150e-6, abs=40e-6)
