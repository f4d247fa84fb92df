"""Load shedding on an overloaded computer: lags in, one decision out."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.live.load import BEGINS, ENDS, IMAGE_INTERVALS, LoadParams, LoadWatch
from tracker.messages import Shed

P = LoadParams()


def fed(watch: LoadWatch, start: float, seconds: float, lag: float) -> list[tuple[float, Shed]]:
    """(s, level) after each packet of a glove at 100 Hz whose estimates are ``lag`` late."""
    out = []
    for t in np.arange(start, start + seconds, 0.01):
        watch.packet(float(t), lag)
        out.append((float(t), watch.level))
    return out


def test_a_computer_that_keeps_up_sheds_nothing() -> None:
    watch = LoadWatch()
    for k in range(600):
        watch.packet(0.01 * k, 0.02)
        if k % 3 == 0:
            watch.image(0.01 * k, 0.05, missed=0)
    assert watch.level == Shed.NOTHING and watch.notices.drain() == []


def test_one_delay_is_not_load() -> None:
    watch = LoadWatch()
    fed(watch, 0.0, 2.0, 0.01)
    fed(watch, 2.3, 0.02, 0.3)
    assert {level for _, level in fed(watch, 2.32, 3.0, 0.01)} == {Shed.NOTHING}


def test_levels_are_shed_in_order_and_reported() -> None:
    feeds = {
        "packets": lambda watch, t: watch.packet(t, 2 * P.packet_lag),
        "images": lambda watch, t: watch.image(t, 2 * P.image_lag, 0),
        "missed images": lambda watch, t: watch.image(t, 0.0, 3),
    }
    for name, feed in feeds.items():
        watch, levels = LoadWatch(), []
        for k in range(100):
            feed(watch, 0.05 * k)
            levels.append(watch.level)
        assert levels == sorted(levels) and set(levels) == set(Shed), name
        assert watch.notices.drain() == [BEGINS[s] for s in sorted(BEGINS)], name
        firsts = [0.05 * levels.index(s) for s in Shed]
        assert np.all(np.diff(firsts) >= P.begin - 1e-9), name


def test_levels_are_restored_late_and_in_reverse_order() -> None:
    watch = LoadWatch()
    fed(watch, 0.0, 3.0, 0.2)
    watch.notices.drain()
    levels = [level for _, level in fed(watch, 3.0, 20.0, 0.005)]
    assert levels == sorted(levels, reverse=True) and levels[-1] == Shed.NOTHING
    assert watch.notices.drain() == [ENDS[s] for s in sorted(ENDS, reverse=True)]
    held = [levels.count(s) for s in (Shed.OVERLAYS, Shed.VIEW_RATE)]
    assert min(held) >= 100 * P.end - 1


def test_a_lag_near_the_limit_does_not_oscillate() -> None:
    """Between the lower and the upper limit the level is unchanged."""
    watch, rng = LoadWatch(), np.random.default_rng(1)
    fed(watch, 0.0, 1.2, 0.2)
    levels = []
    for k in range(2000):
        watch.packet(1.2 + 0.01 * k, P.packet_lag * float(rng.uniform(0.6, 1.0)))
        levels.append(watch.level)
    settled = levels[300:]  # once the earlier load has expired
    assert set(settled) == {settled[0]} and settled[0] > Shed.NOTHING


def test_missing_data_and_another_clock_are_not_load() -> None:
    watch = LoadWatch()
    fed(watch, 0.0, 1.2, 0.2)
    assert watch.strain(1.2) > 1
    assert watch.strain(60.0) == 0.0
    other = LoadWatch()
    fed(other, 0.0, 5.0, 1e5)
    assert other.level == Shed.NOTHING


def test_the_image_rate_is_reduced_and_restored_in_steps() -> None:
    watch = LoadWatch()
    assert watch.image_interval == 0.0 and watch.figures()["images_missed"] == 0.0
    fed(watch, 0.0, 2.3, 1.0)  # four steps of half a second
    assert watch.level == Shed.IMAGES and watch.image_interval == IMAGE_INTERVALS[0]
    fed(watch, 2.3, 5.0, 1.0)
    assert watch.image_interval == IMAGE_INTERVALS[-1]
    assert len(watch.notices.drain()) == len(BEGINS)  # a further reduction is not reported
    seen = []
    for k in range(600):
        watch.packet(7.3 + 0.05 * k, 0.001)
        if not seen or seen[-1] != watch.image_interval:
            seen.append(watch.image_interval)
    assert tuple(seen) == (*reversed(IMAGE_INTERVALS), 0.0)
    assert watch.level == Shed.NOTHING


def test_the_share_of_missed_images_is_a_recent_one() -> None:
    watch = LoadWatch()
    for k in range(60):
        watch.image(k / 30, 0.01, 1)  # every second one
    assert watch.figures()["images_missed"] == pytest.approx(0.5)
    for k in range(60):
        watch.image(2.0 + k / 60, 0.01, 0)
    assert watch.figures()["images_missed"] < 0.1
