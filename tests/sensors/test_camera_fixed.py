"""Power-line frequency, autofocus, zoom and mirror with a fake driver."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from tracker.sensors.camera_fixed import (
    AUTOFOCUS,
    FLIP,
    MIRROR,
    POWER_LINE,
    ZOOM,
    fix_settings,
    local_mains_hz,
    unverified,
)
from tracker.sensors.v4l2 import GET, QUERY, SET, ControlIo

RANGES = {POWER_LINE: (0, 2), AUTOFOCUS: (0, 1), ZOOM: (100, 400), MIRROR: (0, 1)}
"""No FLIP: this driver does not have it."""


class Driver:
    """The ioctls of a camera; ``stubborn`` controls accept a value and do not change."""

    def __init__(self, *stubborn: int) -> None:
        self.values = {POWER_LINE: 2, AUTOFOCUS: 1, ZOOM: 150, MIRROR: 1}
        self.stubborn = stubborn

    def __call__(self, device: int, request: int, data: bytearray) -> int:
        control = struct.unpack_from("=I", data)[0]
        if control not in RANGES:
            raise OSError(22, "Invalid argument")
        if request == QUERY:
            least, most = RANGES[control]
            struct.pack_into("=II32siiiiI", data, 0, control, 1, b"x", least, most, 1, least, 0)
        elif request == GET:
            struct.pack_into("=Ii", data, 0, control, self.values[control])
        elif request == SET and control not in self.stubborn:
            self.values[control] = struct.unpack_from("=Ii", data)[1]
        return 0


def test_all_supported_settings_are_set_and_verified() -> None:
    driver = Driver()
    found = fix_settings("/dev/null", 50, ControlIo("/dev/null", driver))
    assert {s.name: s.found for s in found} == {
        "power_line": 1,
        "autofocus": 0,
        "zoom": 100,
        "mirror": 0,
    }
    assert all(s.is_verified for s in found)
    assert driver.values[ZOOM] == 100 and FLIP not in driver.values
    assert unverified("webcam", found) is None


def test_a_setting_that_is_not_applied_is_not_verified() -> None:
    found = fix_settings("/dev/null", 60, ControlIo("/dev/null", Driver(AUTOFOCUS, ZOOM)))
    assert [s.name for s in found if not s.is_verified] == ["autofocus", "zoom"]
    report = unverified("webcam", found)
    assert report is not None and report.code == "camera.not_fixed"
    assert report.values == {"camera": "webcam", "settings": ("autofocus", "digital zoom")}


def test_other_devices_have_no_settings() -> None:
    assert fix_settings("/dev/null", 50) == []
    assert fix_settings("", 50) == []
    assert fix_settings("/dev/no-such-camera", 50) == []


@pytest.mark.parametrize(
    ("zone", "mains_hz"),
    [
        ("Europe/Berlin", 50),
        ("America/New_York", 60),
        ("America/Argentina/Cordoba", 50),
        ("Asia/Seoul", 60),
        ("Asia/Tokyo", 50),
        ("US/Pacific", 60),
    ],
)
def test_the_power_line_frequency_follows_the_time_zone(
    tmp_path: Path, zone: str, mains_hz: int
) -> None:
    link = tmp_path / "localtime"
    target = tmp_path / "zoneinfo" / zone
    target.parent.mkdir(parents=True)
    target.touch()
    link.symlink_to(target)
    assert local_mains_hz(link) == mains_hz
