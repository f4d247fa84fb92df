"""Checks of the cameras: size and rate granted and measured, exposure, time stamps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from tracker.base.errors import DeviceError
from tracker.base.notices import Severity, failure, notice, warning
from tracker.doctor.finding import Finding, graded
from tracker.doctor.machine import Machine
from tracker.messages import Array
from tracker.sensors.camera_controls import HasCaptures, set_control
from tracker.sensors.camera_format import (
    CameraReport,
    Capture,
    CaptureFormat,
    is_slow,
    report_of,
    shortfall,
)
from tracker.sensors.image_input import CameraName
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
        yield Finding(warning("doctor.no_camera"), notice("doctor.plug_camera"))
    for camera in found:
        if camera.path in machine.in_use:
            yield Finding(notice("doctor.in_use", device=camera.name))
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
    except DeviceError as problem:
        what = problem.notice.with_severity(Severity.ERROR)
        yield Finding(what, notice("doctor.camera_busy"))
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
    end, number = machine.clock() + machine.timeout + machine.duration, 0
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
    name = camera.name
    if measured.images < 2:
        yield Finding(failure("doctor.no_images", camera=name), notice("doctor.other_port"))
        return
    granted = report_of(captures[0], camera.path) if captures else CameraReport()
    lacking = shortfall(want, granted)
    promised, fps = granted.fps or want.fps, measured.fps
    is_poor = lacking is not None and lacking.severity is Severity.ERROR
    if is_poor:
        yield Finding(failure("doctor.camera_grant", camera=name, what=lacking))
    if is_slow(promised, fps):
        rates = {"measured_fps": fps, "granted_fps": promised}
        slow = failure("doctor.camera_slow", camera=name, **rates)
        yield Finding(slow, notice("doctor.more_light"))
    elif not is_poor:
        size = {"width": granted.width, "height": granted.height}
        yield Finding(notice("doctor.camera", camera=name, measured_fps=fps, **size))
    if measured.black > measured.images / 2:
        yield Finding(warning("doctor.black", camera=name), notice("doctor.uncover"))


def _exposure(camera: CameraName, capture: Capture) -> Finding:
    """Locks the exposure at its present value, reads the lock back and gives it up again."""
    now = capture.get(cv2.CAP_PROP_EXPOSURE)
    control = set_control(capture, "exposure", now)
    set_control(capture, "exposure", None)
    name = camera.name
    if not control.available:
        absent = warning("doctor.no_exposure", camera=name)
        return Finding(absent, notice("doctor.constant_light"))
    if not control.locked or not control.verified:
        unsure = warning("doctor.exposure_unverified", camera=name)
        return Finding(unsure, notice("doctor.own_program"))
    return Finding(notice("doctor.exposure", camera=name))


def _time_stamps(camera: CameraName, measured: _Measured) -> Finding:
    """Whether the driver stamps images, and how irregularly they arrive."""
    arrival, stamp = np.diff(measured.arrivals), np.diff(measured.stamps)
    jitter_ms = 1000 * float(np.std(arrival))
    period = float(np.median(arrival))
    stamped = bool(
        len(stamp) and np.all(stamp > 0) and abs(np.median(stamp) - period) < STAMP_STEP * period
    )
    jitter = {"camera": camera.name, "arrival_jitter_ms": jitter_ms}
    if stamped:
        stamp_ms = 1000 * float(np.std(stamp))
        return Finding(notice("doctor.stamps", stamp_jitter_ms=stamp_ms, **jitter))
    severity = Severity.WARNING if jitter_ms > JITTER_MS else Severity.INFO
    return graded(notice("doctor.no_stamps", **jitter), severity, notice("doctor.no_hub"))
