"""Exposure, gain and white balance of open cameras, set from another thread.

A camera that adjusts its exposure changes the markers' colours with every movement of the hand, so
locking it is part of the set-up. Values are in the driver's own units, which no driver documents.

The limits of controls and the serial numbers come from Linux (Video for Linux API, ioctl
VIDIOC_QUERYCTRL), since OpenCV does not read them. A file descriptor of its own is used for that;
the image stream continues meanwhile.
"""

from __future__ import annotations

import math
import threading
from dataclasses import dataclass, replace
from typing import Protocol

import cv2

from tracker.base.notices import Notice
from tracker.sensors.camera_fixed import FixedSetting, fix_settings, local_mains_hz, unverified
from tracker.sensors.camera_format import CameraReport as CameraReport
from tracker.sensors.camera_format import Capture, report_of
from tracker.sensors.camera_stamps import HasStamps
from tracker.sensors.camera_systems import exposure_switch
from tracker.sensors.image_input import HasShortfalls, ImageInput, Pair
from tracker.sensors.v4l2 import QUERY as QUERY
from tracker.sensors.v4l2 import Limits as Limits
from tracker.sensors.v4l2 import limits_of as limits_of
from tracker.sensors.v4l2 import serial_number as serial_number
from tracker.sensors.zed_registers import GAIN_LIMITS, exposure_limits, is_zed, lock_exposure


@dataclass(frozen=True)
class _Property:
    """OpenCV's names of a control: its value, and the switch of its automatic mode."""

    value: int
    switch: int | None = None
    manual: float = 0.0
    automatic: float = 0.0


PROPERTIES = {
    "exposure": _Property(cv2.CAP_PROP_EXPOSURE, cv2.CAP_PROP_AUTO_EXPOSURE, *exposure_switch()),
    "gain": _Property(cv2.CAP_PROP_GAIN),
    "white_balance": _Property(cv2.CAP_PROP_WB_TEMPERATURE, cv2.CAP_PROP_AUTO_WB, 0.0, 1.0),
}
ABSENT = -1.0
"""OpenCV's value for a control that the device lacks."""
COARSE, STEP = 1.0, 0.05
"""Steps in which drivers round values: in their own units, and as a share of the value."""


@dataclass(frozen=True)
class Control:
    """One control as the device reports it: ``available``, its value, whether it was ``locked``,
    and whether the device confirms that lock (``verified``); ``limits`` are None where the system
    does not report them."""

    name: str
    available: bool = False
    value: float = 0.0
    locked: bool = False
    verified: bool = True
    limits: Limits | None = None

    @property
    def is_open(self) -> bool:
        """Whether the camera adjusts it automatically."""
        return self.available and not self.locked

    @property
    def is_unverified(self) -> bool:
        """Whether it was locked but the camera does not confirm the lock."""
        return self.available and self.locked and not self.verified


@dataclass(frozen=True)
class Locks:
    """A value locks a control, None leaves it to the camera."""

    exposure: float | None = None
    gain: float | None = None
    white_balance: float | None = None


class HasCaptures(ImageInput, Protocol):
    """An image input on devices."""

    def captures(self) -> list[cv2.VideoCapture]:
        """The open devices."""


class ControlledInput:
    """An image input whose cameras' controls can be set while another thread reads images.

    Requests are applied between two images, in the reading thread; a reconnected camera
    receives them again.
    """

    live = True

    def __init__(
        self,
        inner: HasCaptures,
        locks: Locks | None = None,
        paths: tuple[str, ...] = (),
        mains_hz: int = 0,
    ) -> None:
        """``paths`` of the devices, where the system has any; ``mains_hz`` 50 or 60 for lamps that
        flicker, 0 for that of the time zone."""
        self._inner, self._paths = inner, paths
        self._reports: tuple[CameraReport, ...] = ()
        self.name, self.fps = inner.name, inner.fps
        self._lock = threading.Lock()
        self._locks, self._changed = locks or Locks(), True
        self._controls: tuple[Control, ...] = tuple(Control(n) for n in PROPERTIES)
        self._fixed: tuple[FixedSetting, ...] = ()
        self._mains_hz = mains_hz or local_mains_hz()

    def open(self) -> None:
        self._inner.open()
        self.fps = self._inner.fps
        found = [fix_settings(path, self._mains_hz) for path in self._paths]
        with self._lock:
            self._fixed = tuple(setting for settings in found for setting in settings)
            self._changed = True

    def read(self) -> Pair | None:
        self._apply()
        return self._inner.read()

    def stamp(self) -> float:
        """s, the driver's time stamp of the last image; NaN where there is none."""
        return self._inner.stamp() if isinstance(self._inner, HasStamps) else math.nan

    def close(self) -> None:
        self._inner.close()

    def shortfalls(self) -> list[Notice]:
        """What the devices grant less than was requested, or do not confirm."""
        refused = unverified(self.name, list(self.fixed()))
        inner = self._inner
        found = inner.shortfalls() if isinstance(inner, HasShortfalls) else []
        return found if refused is None else [*found, refused]

    def fixed(self) -> tuple[FixedSetting, ...]:
        """Settings that tracking needs, as read back when the devices were opened."""
        with self._lock:
            return self._fixed

    def controls(self) -> tuple[Control, ...]:
        """State after the last change."""
        with self._lock:
            return self._controls

    def reports(self) -> tuple[CameraReport, ...]:
        """Returns what each camera granted when it was opened; none before that."""
        with self._lock:
            return self._reports

    def request_locks(self, locks: Locks) -> None:
        """Applies this from the next image on."""
        with self._lock:
            self._locks, self._changed = locks, True

    def _apply(self) -> None:
        with self._lock:
            if not self._changed:
                return
            self._changed, locks = False, self._locks
        captures = self._inner.captures()
        found = tuple(self._set(captures, name, getattr(locks, name)) for name in PROPERTIES)
        if captures and not all(control.available for control in found):
            own = self._own_registers(locks)
            found = tuple(c if c.available else own.get(c.name, c) for c in found)
        paths = self._paths or ("",) * len(captures)
        reports = tuple(report_of(c, path) for c, path in zip(captures, paths, strict=False))
        with self._lock:
            self._controls, self._reports = found, reports

    def _own_registers(self, locks: Locks) -> dict[str, Control]:
        """Exposure and gain of a ZED, which has them in its own registers."""
        if len(self._paths) != 1 or not is_zed(self._paths[0]):
            return {}
        found = lock_exposure(self._paths[0], locks.exposure, locks.gain)
        if found is None:
            return {}
        now, confirmed = found
        rows, locked = exposure_limits(self.fps), not now.automatic
        return {
            "exposure": Control("exposure", True, now.exposure, locked, confirmed, rows),
            "gain": Control("gain", True, now.gain, locked, confirmed, GAIN_LIMITS),
        }

    def _set(self, captures: list[cv2.VideoCapture], name: str, value: float | None) -> Control:
        limits = limits_of(self._paths[0], name) if self._paths else None
        return replace(_set_all(captures, name, value), limits=limits)


def _set_all(captures: list[cv2.VideoCapture], name: str, value: float | None) -> Control:
    """One setting for two cameras; a control exists if both cameras have it."""
    found = [set_control(c, name, value) for c in captures]
    if not found:
        return Control(name)
    return Control(
        name,
        all(c.available for c in found),
        found[0].value,
        all(c.locked for c in found),
        all(c.verified for c in found),
    )


def set_control(capture: Capture, name: str, value: float | None) -> Control:
    """Lock a control at ``value``, or return it to the camera. Returns the device's answer."""
    prop = PROPERTIES[name]
    if value is None:
        if prop.switch is not None:
            capture.set(prop.switch, prop.automatic)
        now = capture.get(prop.value)
        # a control without an automatic mode keeps its value
        return Control(name, now != ABSENT, now, False)
    if prop.switch is not None:
        capture.set(prop.switch, prop.manual)
    locked = capture.set(prop.value, value)
    now = capture.get(prop.value)
    there = now != ABSENT
    return Control(name, there, now, locked and there, _is_confirmed(capture, prop, now, value))


def _is_confirmed(capture: Capture, prop: _Property, now: float, wanted: float) -> bool:
    """Whether a locked device reads back what was set: the value, to its steps, and
    neither an absent switch nor the automatic one."""
    if abs(now - wanted) > max(COARSE, STEP * abs(wanted)):
        return False
    return prop.switch is None or capture.get(prop.switch) not in (prop.automatic, ABSENT)


def locks_text(locks: Locks) -> str:
    """``exposure=157 gain=4``, as stored in the settings."""
    pairs = ((n, getattr(locks, n)) for n in PROPERTIES)
    return " ".join(f"{n}={v:g}" for n, v in pairs if v is not None)


def locks_from(text: str) -> Locks:
    """Parses the text of `locks_text`; unknown words are ignored."""
    values: dict[str, float] = {}
    for word in text.split():
        name, _, number = word.partition("=")
        try:
            if name in PROPERTIES:
                values[name] = float(number)
        except ValueError:
            continue
    return Locks(**values)
