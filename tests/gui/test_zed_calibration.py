"""The factory calibration of a connected ZED is found by its serial number."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.engines import hardware
from app.engines.hardware import zed_calibration
from tracker.sensors.image_input import CameraName

SERIALS = {"/dev/video0": None, "/dev/video2": 11, "/dev/video4": 12}


@pytest.fixture(autouse=True)
def cameras(monkeypatch: pytest.MonkeyPatch) -> None:
    """A webcam and two ZEDs."""
    known = [CameraName(0, "webcam", "/dev/video0"), CameraName(2, "ZED-M", "/dev/video2")]
    known.append(CameraName(4, "ZED 2", "/dev/video4"))
    monkeypatch.setattr(hardware, "all_cameras", lambda: known)
    monkeypatch.setattr(hardware, "is_zed", lambda path: path != "/dev/video0")
    monkeypatch.setattr(hardware, "zed_serial", SERIALS.__getitem__)


@pytest.mark.parametrize(
    ("chosen", "serial"), [("", 11), ("name:ZED 2", 12), ("two:name:ZED-M", 11), ("4", 12)]
)
def test_the_chosen_camera_decides(chosen: str, serial: int, tmp_path: Path) -> None:
    for number in (11, 12):
        (tmp_path / f"SN{number}.conf").touch()
    folders = [tmp_path / "missing", tmp_path]
    assert zed_calibration(chosen, folders) == str(tmp_path / f"SN{serial}.conf")


def test_other_cameras_and_missing_files_have_none(tmp_path: Path) -> None:
    (tmp_path / "SN12.conf").touch()
    assert zed_calibration("name:webcam", [tmp_path]) == ""
    assert zed_calibration("name:ZED-M", [tmp_path]) == ""
