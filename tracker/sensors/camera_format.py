"""Size, rate and pixel format of a camera: requested, granted, and whether that is enough."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import cv2

from tracker.base.notices import Notice, failure, notice
from tracker.sensors.v4l2 import serial_number

MJPG, YUYV = "MJPG", "YUYV"
LEAST_COMPRESSED_PIXELS = 640 * 480
"""From this size on, MJPG is tried first: uncompressed images need more than a USB 2 port has."""
SLOW_SHARE = 0.8
"""Share of a requested or granted rate below which a camera is slow."""
ENOUGH_FPS = 24.0
"""A camera that grants this rate is fast enough, whatever was requested."""


@dataclass(frozen=True)
class CaptureFormat:
    """The request to a device; 0 and "" leave the choice to the driver.

    ``exposure``, ``gain`` and ``white_balance`` are in the driver's own units; a value locks it.
    """

    width: int = 0
    height: int = 0
    fps: float = 0.0
    fourcc: str = ""
    backend: int = cv2.CAP_ANY
    exposure: float | None = None
    gain: float | None = None
    white_balance: float | None = None
    timeout_ms: int = 1000


@dataclass(frozen=True)
class CameraReport:
    """What an open camera grants: image size (px), images per second, pixel format and OpenCV's
    backend. ``path`` and ``serial_number`` are empty where the system does not report them."""

    width: int = 0
    height: int = 0
    fps: float = 0.0
    pixel_format: str = ""
    backend: str = ""
    path: str = ""
    serial_number: str = ""


class Capture(Protocol):
    """The part of `cv2.VideoCapture` that is used."""

    def get(self, prop: int) -> float: ...

    def set(self, prop: int, value: float) -> bool: ...


def report_of(capture: Capture, path: str = "") -> CameraReport:
    """Reads what a device granted, without changing it."""
    backend = capture.getBackendName() if isinstance(capture, cv2.VideoCapture) else ""
    return CameraReport(
        width=max(0, int(capture.get(cv2.CAP_PROP_FRAME_WIDTH))),
        height=max(0, int(capture.get(cv2.CAP_PROP_FRAME_HEIGHT))),
        fps=max(0.0, float(capture.get(cv2.CAP_PROP_FPS))),
        pixel_format=_four_letters(int(capture.get(cv2.CAP_PROP_FOURCC))),
        backend=backend,
        path=path,
        serial_number=serial_number(path) if path.startswith("/dev/") else "",
    )


def _four_letters(code: int) -> str:
    """A FOURCC as text; empty where the device reports none."""
    if code <= 0:
        return ""
    letters = "".join(chr(code >> shift & 0xFF) for shift in (0, 8, 16, 24))
    return letters.strip() if letters.isprintable() else ""


def set_format(capture: Capture, want: CaptureFormat) -> None:
    """Sets the pixel format first: it determines which sizes and rates are available."""
    if want.fourcc:
        capture.set(cv2.CAP_PROP_FOURCC, cv2.VideoWriter.fourcc(*want.fourcc))
    for prop, value in (
        (cv2.CAP_PROP_FRAME_WIDTH, want.width),
        (cv2.CAP_PROP_FRAME_HEIGHT, want.height),
        (cv2.CAP_PROP_FPS, want.fps),
    ):
        if value:
            capture.set(prop, value)


def negotiate(capture: Capture, want: CaptureFormat) -> CameraReport:
    """Sets the format of a device that is open and delivers no images yet; returns the grant.

    Without ``want.fourcc``, MJPG and uncompressed images are tried. The first that grants size and
    rate is used, otherwise the one whose grant is closest: the size counts before the rate.
    """
    tried: list[tuple[CaptureFormat, CameraReport]] = []
    for each in _candidates(want):
        set_format(capture, each)
        granted = report_of(capture)
        if is_granted(want, granted):
            return granted
        tried.append((each, granted))
    best, granted = max(tried, key=lambda pair: _closeness(want, pair[1]))
    if best is not tried[-1][0]:
        set_format(capture, best)
        granted = report_of(capture)
    return granted


def _candidates(want: CaptureFormat) -> Sequence[CaptureFormat]:
    if want.fourcc or not (want.width and want.height):
        return (want,)
    is_large = want.width * want.height >= LEAST_COMPRESSED_PIXELS
    order = (MJPG, YUYV) if is_large else (YUYV, MJPG)
    return [_with_fourcc(want, fourcc) for fourcc in order]


def _with_fourcc(want: CaptureFormat, fourcc: str) -> CaptureFormat:
    return CaptureFormat(want.width, want.height, want.fps, fourcc, want.backend)


def is_granted(want: CaptureFormat, granted: CameraReport) -> bool:
    """Whether size and rate match ``want``."""
    return _has_size(want, granted) and granted.fps >= SLOW_SHARE * want.fps


def _has_size(want: CaptureFormat, granted: CameraReport) -> bool:
    return (granted.width, granted.height) == (want.width, want.height)


def _closeness(want: CaptureFormat, granted: CameraReport) -> tuple[bool, float]:
    return _has_size(want, granted), granted.fps


def shortfall(want: CaptureFormat, granted: CameraReport) -> Notice | None:
    """What an open camera grants less than ``want``; None if nothing.

    Another size, and a rate that is too low for tracking, are errors with a remedy; a rate that is
    lower and high enough is only reported. What is 0, requested or granted, is not compared.
    """
    sizes: dict[str, object] = {"width": granted.width, "height": granted.height}
    is_known = 0 not in (want.width, want.height, granted.width, granted.height)
    if is_known and not _has_size(want, granted):
        asked = {"asked_width": want.width, "asked_height": want.height}
        return failure("camera.size_not_granted", **sizes, **asked)
    if not (want.fps and granted.fps) or granted.fps >= SLOW_SHARE * want.fps:
        return None
    rates = {"rate_hz": granted.fps, "asked_hz": want.fps, "format": granted.pixel_format or "?"}
    if granted.fps >= ENOUGH_FPS:
        return notice("camera.lower_rate", **sizes, **rates)
    return failure("camera.slow_grant", **sizes, **rates)


def is_slow(granted_fps: float, measured_fps: float) -> bool:
    """Whether fewer images arrive than were granted; False if a rate is unknown (0)."""
    return 0 < measured_fps < SLOW_SHARE * granted_fps
