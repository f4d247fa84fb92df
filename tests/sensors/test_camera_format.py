"""The size, rate and pixel format requested from a webcam, and the report of a poor grant."""

from __future__ import annotations

import cv2
import pytest

from tracker.base.notices import Severity
from tracker.messages import Event
from tracker.sensors.camera import StereoCamera
from tracker.sensors.camera_format import (
    CameraReport,
    CaptureFormat,
    is_slow,
    negotiate,
    shortfall,
)

WANT = CaptureFormat(1280, 720, 30.0)
CODES = {name: float(cv2.VideoWriter.fourcc(*name)) for name in ("MJPG", "YUYV")}


class Webcam:
    """Grants the modes it has, as V4L2 does: the nearest size, then that mode's highest rate.

    ``modes`` are sizes with their rate, by pixel format.
    """

    def __init__(self, modes: dict[str, dict[tuple[int, int], float]]) -> None:
        self.modes, self.asked = modes, []
        self.format, self.size = next(iter(modes)), (640, 480)

    def set(self, prop: int, value: float) -> bool:
        if prop == cv2.CAP_PROP_FOURCC:
            name = next(n for n, code in CODES.items() if code == value)
            self.asked.append(name)
            if name not in self.modes:
                return False
            self.format = name
        elif prop == cv2.CAP_PROP_FRAME_WIDTH:
            self._width = int(value)
        elif prop == cv2.CAP_PROP_FRAME_HEIGHT:
            self.size = min(
                self.modes[self.format],
                key=lambda size: abs(size[0] - self._width) + abs(size[1] - int(value)),
            )
        return True

    def get(self, prop: int) -> float:
        return {
            cv2.CAP_PROP_FRAME_WIDTH: float(self.size[0]),
            cv2.CAP_PROP_FRAME_HEIGHT: float(self.size[1]),
            cv2.CAP_PROP_FPS: self.modes[self.format][self.size],
            cv2.CAP_PROP_FOURCC: CODES[self.format],
        }.get(prop, -1.0)


USB_2 = {
    "YUYV": {(640, 480): 30.0, (1280, 720): 10.0},
    "MJPG": {(640, 480): 30.0, (1280, 720): 30.0},
}


def test_compressed_images_are_requested_first() -> None:
    camera = Webcam(USB_2)
    granted = negotiate(camera, WANT)
    assert (granted.pixel_format, granted.fps, camera.asked) == ("MJPG", 30.0, ["MJPG"])
    assert shortfall(WANT, granted) is None


def test_small_images_are_asked_for_uncompressed_first() -> None:
    camera = Webcam({"MJPG": {(320, 240): 30.0}, "YUYV": {(320, 240): 30.0}})
    assert negotiate(camera, CaptureFormat(320, 240, 30.0)).pixel_format == "YUYV"


def test_a_camera_without_compression_is_used_unchanged() -> None:
    camera = Webcam({"YUYV": {(2560, 720): 60.0}})
    granted = negotiate(camera, CaptureFormat(2560, 720, 60.0))
    assert (granted.pixel_format, granted.width, granted.fps) == ("YUYV", 2560, 60.0)


def test_the_better_of_two_poor_formats_is_used() -> None:
    fast_small = Webcam({"MJPG": {(640, 480): 60.0}, "YUYV": {(1280, 720): 10.0}})
    assert negotiate(fast_small, WANT).width == 1280  # calibrated for this size
    slow_both = Webcam({"MJPG": {(1280, 720): 15.0}, "YUYV": {(1280, 720): 10.0}})
    granted = negotiate(slow_both, WANT)
    assert (granted.pixel_format, granted.fps, slow_both.format) == ("MJPG", 15.0, "MJPG")


def test_a_chosen_format_is_the_only_one_requested() -> None:
    camera = Webcam(USB_2)
    negotiate(camera, CaptureFormat(1280, 720, 30.0, "YUYV"))
    assert camera.asked == ["YUYV"]


@pytest.mark.parametrize(
    ("granted", "code", "severity"),
    [
        (CameraReport(1280, 720, 10.0, "YUYV"), "camera.slow_grant", Severity.ERROR),
        (CameraReport(640, 480, 60.0, "MJPG"), "camera.size_not_granted", Severity.ERROR),
        (CameraReport(1280, 720, 30.0, "MJPG"), "camera.lower_rate", Severity.INFO),
    ],
)
def test_a_poor_grant_is_an_error_with_a_remedy(
    granted: CameraReport, code: str, severity: Severity
) -> None:
    found = shortfall(CaptureFormat(1280, 720, 60.0), granted)
    assert found is not None and (found.code, found.severity) == (code, severity)


def test_the_remedy_names_the_port_and_the_size() -> None:
    report = shortfall(WANT, CameraReport(1280, 720, 10.0, "YUYV"))
    assert report is not None and report.code == "camera.slow_grant"
    assert (report.values["rate_hz"], report.values["format"]) == (10, "YUYV")


def test_unknown_figures_are_not_compared() -> None:
    assert shortfall(WANT, CameraReport()) is None
    assert shortfall(CaptureFormat(), CameraReport(1280, 720, 5.0)) is None
    assert not is_slow(0.0, 5.0) and not is_slow(30.0, 0.0) and is_slow(30.0, 20.0)


class PoorInput:
    """A device that opens and grants 10 images per second."""

    name, live, fps = "webcam", True, 10.0

    def open(self) -> None: ...

    def read(self):
        return None

    def close(self) -> None: ...

    def shortfalls(self):
        return [shortfall(WANT, CameraReport(1280, 720, 10.0, "YUYV"))]


def test_the_tracker_reports_a_poor_grant_when_the_camera_is_opened() -> None:
    camera = StereoCamera(PoorInput(), None, clock=lambda: 5.0, sleep=lambda s: None)
    camera.read(0.0)
    events: list[Event] = list(camera.drain_events())
    slow = [e for e in events if e.code == "camera.slow_grant"]
    assert len(slow) == 1 and slow[0].notice.severity is Severity.ERROR
