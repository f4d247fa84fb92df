"""Intervals without data from a device."""

import numpy as np
import pytest

from tracker.session.ros import topics
from tracker.session.verify import silences

S = 1_000_000_000
GLOVE = topics.imu("right", "dorsum")


def every(period: float, *spans: tuple[float, float]) -> list[int]:
    """Log times (ns) of a stream present in these intervals (s)."""
    return [round(t * S) for a, b in spans for t in np.arange(a, b, period)]


def test_a_glove_disconnected_for_five_seconds_is_reported_for_five():
    times = {
        GLOVE: every(0.01, (0, 4), (9, 20)),
        topics.image("left"): every(1 / 30, (0, 20)),
        topics.STATUS: every(1.0, (0, 20)),
    }
    assert silences(times, (0, 20 * S)) == {"/glove/right": pytest.approx(5.0, abs=0.02)}


def test_missing_data_at_the_ends_counts():
    times = {topics.blobs("left"): every(1 / 30, (2, 8)), topics.STATUS: every(1.0, (0, 12))}
    assert silences(times, (0, 12 * S)) == {"/camera": pytest.approx(2 + 4, abs=0.05)}


def test_a_delayed_recording_has_no_missing_data():
    held_back = ((0, 4), (12, 20))
    times = {name: every(0.01, *held_back) for name in (GLOVE, topics.image("left"))}
    times[topics.STATUS] = every(1.0, *held_back)
    assert silences(times, (0, 20 * S)) == {}


def test_one_imu_or_one_of_two_images_alone_does_not_count():
    times = {
        GLOVE: every(0.01, (0, 3)),
        topics.imu("right", "thumb_proximal"): every(0.01, (0, 10)),
        topics.image("left"): every(1 / 30, (0, 10)),
        topics.blobs("left"): every(1 / 30, (0, 2)),
    }
    assert silences(times, (0, 10 * S)) == {}


def test_devices_outside_the_session_do_not_count():
    assert silences({topics.EVENTS: [0, 9 * S]}, (0, 10 * S)) == {}
