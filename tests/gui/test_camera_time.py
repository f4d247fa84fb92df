"""The camera's offset in time, as the calibration panel shows it."""

import pytest

from app.viewmodels.calibration import camera_time
from tracker.messages import Status, Tracking


@pytest.mark.parametrize(
    ("values", "shown"),
    [
        ({}, "not known yet; turn the hand"),
        ((21.34, 1.5, 21.3), "21.3 ± 3.0 ms late, corrected"),
        ((-1.26, 2.0, 0.0), "none (± 4.0 ms)"),
        ((-5.26, 2.0, 0.0), "5.3 ± 4.0 ms early, not corrected"),
    ],
)
def test_words(values, shown: str) -> None:
    names = ("camera_offset_ms", "camera_offset_sd_ms", "camera_offset_applied_ms")
    status = Status(1.0, Tracking.TRACKING, dict(zip(names, values, strict=False)))
    assert camera_time(status) == shown


def test_without_an_engine() -> None:
    assert camera_time(None) == "not known yet; turn the hand"
