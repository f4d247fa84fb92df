"""Rates and latencies of the last seconds."""

import numpy as np
import pytest

from tracker.live.telemetry import KEPT, WINDOW, Telemetry


@pytest.mark.parametrize("count", [1, 2, 3, 100, KEPT, 2 * KEPT])
def test_medians_and_percentiles_equal_numpys(count):
    telemetry, took = Telemetry(), np.random.default_rng(count).exponential(0.01, count)
    for duration in took:
        telemetry.took("filter", float(duration))
    values = telemetry.values(0.0)
    recent = 1e3 * took[-KEPT:]
    assert values["latency_filter_ms"] == pytest.approx(np.median(recent))
    assert values["latency_filter_p99_ms"] == pytest.approx(np.percentile(recent, 99))


def test_a_rate_covers_the_last_seconds_and_decays_to_zero():
    telemetry = Telemetry()
    for i in range(1000):
        telemetry.tick("imu", i / 100)
    assert telemetry.values(9.99)["imu_rate_hz"] == pytest.approx(100.0, rel=0.01)
    half = telemetry.values(9.99 + WINDOW / 2)["imu_rate_hz"]
    assert half == pytest.approx(50.0, rel=0.02)
    assert telemetry.values(9.99 + 2 * WINDOW)["imu_rate_hz"] == 0.0
