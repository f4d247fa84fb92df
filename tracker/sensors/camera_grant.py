"""Compares what a camera was asked for with what it grants and with what arrives."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.sensors.camera_controls import CameraReport
from tracker.sensors.image_input import CaptureFormat

SLOW_SHARE = 0.8
"""Of the requested or granted rate; below it, a camera is slow."""
REMEDY = (
    "Plug the camera into another USB port (USB 3, without a hub), or choose a smaller image size."
)
LIGHT_REMEDY = "Add light or shorten the exposure; otherwise use another USB port."


@dataclass(frozen=True)
class Shortfall:
    """``what`` is a sentence, ``remedy`` another one."""

    what: str
    remedy: str

    @property
    def text(self) -> str:
        return f"{self.what} {self.remedy}"


def granted_shortfall(want: CaptureFormat, granted: CameraReport) -> Shortfall | None:
    """What an open camera grants less than ``want``: another size, or a lower rate.

    None if nothing; a figure that is 0, requested or granted, is not compared.
    """
    size = f"{granted.width} × {granted.height}"
    is_known = 0 not in (want.width, want.height, granted.width, granted.height)
    if is_known and (granted.width, granted.height) != (want.width, want.height):
        what = f"The camera grants images of {size} instead of {want.width} × {want.height} pixels."
        return Shortfall(what, "Choose a size that the camera has, or another camera.")
    if want.fps and granted.fps and granted.fps < SLOW_SHARE * want.fps:
        kind = f" as {granted.pixel_format}" if granted.pixel_format else ""
        what = (
            f"The camera grants {granted.fps:.0f} images per second of {size} pixels{kind} instead "
            f"of {want.fps:.0f}."
        )
        return Shortfall(what, REMEDY)
    return None


def measured_shortfall(granted_fps: float, measured_fps: float) -> Shortfall | None:
    """What arrives less than was granted; None if nothing or if a rate is unknown."""
    if not 0 < measured_fps < SLOW_SHARE * granted_fps:
        return None
    what = (
        f"{measured_fps:.0f} images per second arrive instead of the {granted_fps:.0f} that the "
        "camera grants."
    )
    return Shortfall(what, LIGHT_REMEDY)
