"""Checks of the cameras: size and rate granted and measured, exposure, time stamps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from tracker.base.errors import DeviceError
from tracker.doctor.finding import Finding, error, ok, warning
from tracker.doctor.machine import Machine
from tracker.messages import Array
from tracker.sensors.camera_controls import Capture, HasCaptures, report_of, set_control
from tracker.sensors.camera_grant import granted_shortfall, measured_shortfall
from tracker.sensors.image_input import CameraName, CaptureFormat
from tracker.sensors.image_watch import ImageWatch

STEREO_NAMES = ("ZED",)
"""Cameras whose images are two side by side."""
STAMP_STEP = 0.5
"""Share of an interval by which steps of a driver's time stamps may differ from each other."""
JITTER_MS = 8.0
SETTLING = 5
"""Images after opening that are not measured."""


def cameras(machine: Machine) -> Iterator[Finding]:
    """Opens each camera of the system once."""
    found = [c for c in machine.cameras() if c.index >= 0]
    if not found:
        yield warning("There is no camera.", "Plug the camera in.")
    for camera in found:
        if camera.path in machine.in_use:
            yield ok(f"{camera.name} is in use by this window and was not tested.")
            continue
        yield from _camera(machine, camera)


def _wanted(machine: Machine, camera: CameraName) -> CaptureFormat:
    eyes = 2 if any(name in camera.name for name in STEREO_NAMES) else 1
    return CaptureFormat(eyes * 1280, 720, machine.fps, backend=camera.backend)


def _camera(machine: Machine, camera: CameraName) -> Iterator[Finding]:
    want = _wanted(machine, camera)
    source = machine.open_camera(camera, want)
    try:
        source.open()
        measured = _measure(machine, source)
        captures = source.captures()
        yield from _rates(camera, want, captures, measured)
        if captures and measured.images:
            yield _exposure(camera, captures[0])
            yield _time_stamps(camera, measured)
    except DeviceError as trouble:
        yield error(str(trouble), "Close other programs that use it, or plug it in again.")
    finally:
        source.close()


@dataclass(frozen=True, eq=False)
class _Measured:
    """Arrivals (n,) s and the driver's own stamps (n,) s of images that were not black.

    ``black`` is the number of those that were.
    """

    arrivals: Array
    stamps: Array
    black: int

    @property
    def images(self) -> int:
        return len(self.arrivals)

    @property
    def fps(self) -> float:
        """0 without two images."""
        steps = np.diff(self.arrivals)
        return float(1 / steps.mean()) if len(steps) else 0.0


def _measure(machine: Machine, source: HasCaptures) -> _Measured:
    arrivals, stamps, black, watch = [], [], 0, ImageWatch()
    end, number = machine.clock() + machine.patience + machine.duration, 0
    while machine.clock() < end:
        pair = source.read()
        if pair is None:
            break
        number += 1
        now = machine.clock()
        watch.look(pair[0], now)
        black += watch.black
        if number <= SETTLING:
            continue
        arrivals.append(now)
        captures = source.captures()
        stamps.append(captures[0].get(cv2.CAP_PROP_POS_MSEC) / 1000 if captures else 0.0)
        if arrivals[-1] - arrivals[0] >= machine.duration:
            break
    return _Measured(np.array(arrivals), np.array(stamps), black)


def _rates(
    camera: CameraName, want: CaptureFormat, captures: list[cv2.VideoCapture], measured: _Measured
) -> Iterator[Finding]:
    if measured.images < 2:
        yield error(
            f"{camera.name} opens but no images arrive.",
            "Plug it into another USB port; another camera on the same hub may use its bandwidth.",
        )
        return
    granted = report_of(captures[0], camera.path) if captures else None
    fps = measured.fps
    values = {"measured_fps": fps} | ({"granted_fps": granted.fps} if granted else {})
    name = f"{camera.name}: "
    troubles = [
        granted_shortfall(want, granted) if granted else None,
        measured_shortfall(granted.fps if granted and granted.fps else want.fps, fps),
    ]
    for trouble in filter(None, troubles):
        yield error(name + trouble.what, trouble.remedy, **values)
    if not any(troubles):
        about = f" of {granted.width} × {granted.height} pixels" if granted else ""
        kind = f" as {granted.pixel_format}" if granted and granted.pixel_format else ""
        yield ok(f"{name}{fps:.1f} images per second{about}{kind}.", **values)
    if measured.black > measured.images / 2:
        yield warning(f"{name}the image is black.", "Take the cover off the lens.")


def _exposure(camera: CameraName, capture: Capture) -> Finding:
    """Locks the exposure at its present value, reads the lock back and gives it up again."""
    now = capture.get(cv2.CAP_PROP_EXPOSURE)
    control = set_control(capture, "exposure", now)
    set_control(capture, "exposure", None)
    if not control.available:
        return warning(
            f"{camera.name} has no exposure control: its automatic exposure cannot be verified.",
            "Keep the light constant, or use a camera with a manual exposure.",
        )
    if not control.locked or not control.verified:
        return warning(
            f"{camera.name} does not confirm that its exposure is locked.",
            "Check the exposure in the camera's own program, and keep the light constant.",
        )
    return ok(f"{camera.name}: the exposure can be locked.")


def _time_stamps(camera: CameraName, measured: _Measured) -> Finding:
    """Whether the driver stamps images, and how irregularly they arrive."""
    arrival, stamp = np.diff(measured.arrivals), np.diff(measured.stamps)
    jitter_ms = 1000 * float(np.std(arrival))
    period = float(np.median(arrival))
    stamped = bool(
        len(stamp) and np.all(stamp > 0) and abs(np.median(stamp) - period) < STAMP_STEP * period
    )
    values = {"arrival_jitter_ms": jitter_ms}
    name = f"{camera.name}: images arrive with {jitter_ms:.1f} ms of jitter; the driver stamps "
    if stamped:
        stamp_ms = 1000 * float(np.std(stamp))
        return ok(f"{name}them itself ({stamp_ms:.1f} ms).", **values, stamp_jitter_ms=stamp_ms)
    if jitter_ms > JITTER_MS:
        remedy = "Use another USB port without a hub, and close other programs."
        return warning(f"{name}none.", remedy, **values)
    return ok(f"{name}none.", **values)
