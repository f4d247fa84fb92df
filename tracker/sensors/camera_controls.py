"""Exposure, gain and white balance of open cameras, set from another thread.

A camera that adjusts its exposure changes the markers' colours with every movement of the hand, so
locking it is part of the set-up. Values are in the driver's own units, which no driver documents.

The limits of controls and the serial numbers come from Linux (Video for Linux API, ioctl
VIDIOC_QUERYCTRL), since OpenCV does not read them. A file descriptor of its own is used for that;
images go on meanwhile.
"""

from __future__ import annotations

import os
import struct
import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple, Protocol

import cv2

from tracker.sensors.camera_systems import exposure_switch
from tracker.sensors.image_input import ImageInput, Pair

QUERY = 0xC0445624  # VIDIOC_QUERYCTRL of a struct of 68 bytes
_CONTROL = struct.Struct("=II32siiiiI8x")
DISABLED = 0x0001
IDS = {
    "exposure": 0x009A0902,  # V4L2_CID_EXPOSURE_ABSOLUTE
    "gain": 0x00980913,
    "white_balance": 0x0098091A,  # V4L2_CID_WHITE_BALANCE_TEMPERATURE
}
SYSTEM = Path("/sys/class/video4linux")
Ioctl = Callable[[int, int, bytearray], int]


class Limits(NamedTuple):
    """Of a control, in the driver's own units."""

    least: float
    greatest: float
    step: float
    default: float


def limits_of(path: str, name: str, ioctl: Ioctl | None = None) -> Limits | None:
    """Returns the limits of a control of the camera at ``path``; None where the driver reports
    none, and on other systems."""
    ask = ioctl or _ioctl()
    if ask is None or not path.startswith("/dev/"):
        return None
    try:
        device = os.open(path, os.O_RDWR | os.O_NONBLOCK)
    except OSError:
        return None
    asked = bytearray(_CONTROL.pack(IDS[name], 0, b"", 0, 0, 0, 0, 0))
    try:
        ask(device, QUERY, asked)
    except OSError:  # EINVAL: the device has no such control
        return None
    finally:
        os.close(device)
    _, _, _, least, greatest, step, default, flags = _CONTROL.unpack(asked)
    return None if flags & DISABLED else Limits(least, greatest, step, default)


def serial_number(path: str, system: Path = SYSTEM) -> str:
    """Returns the USB serial number of the camera at ``path``; empty where there is none."""
    device = (system / Path(path).name / "device").resolve()
    for folder in (device, *device.parents[:2]):  # the interface, then the device itself
        try:
            return (folder / "serial").read_text("utf-8").strip()
        except OSError:
            continue
    return ""


def _ioctl() -> Ioctl | None:
    """The system's own, where there is one."""
    try:
        from fcntl import ioctl
    except ImportError:
        return None
    return lambda device, request, data: ioctl(device, request, data, True)


@dataclass(frozen=True)
class _Property:
    """How OpenCV calls a control: its value, and the switch of its automatic."""

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
"""What OpenCV answers for a control that the device does not have."""
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
        """Whether the camera changes it without being asked."""
        return self.available and not self.locked

    @property
    def is_unverified(self) -> bool:
        """Whether it was locked and the camera does not confirm that."""
        return self.available and self.locked and not self.verified


@dataclass(frozen=True)
class CameraReport:
    """What an open camera grants: its image (px), images a second, pixel format and OpenCV's way
    to it. ``path`` and ``serial_number`` are empty where the system does not report them."""

    width: int = 0
    height: int = 0
    fps: float = 0.0
    pixel_format: str = ""
    backend: str = ""
    path: str = ""
    serial_number: str = ""


@dataclass(frozen=True)
class Locks:
    """A value locks a control, None leaves it to the camera."""

    exposure: float | None = None
    gain: float | None = None
    white_balance: float | None = None


class Capture(Protocol):
    """What is used of `cv2.VideoCapture`."""

    def get(self, prop: int) -> float: ...

    def set(self, prop: int, value: float) -> bool: ...


class HasCaptures(ImageInput, Protocol):
    """An image input on devices."""

    def captures(self) -> list[cv2.VideoCapture]:
        """The open devices."""


class ControlledInput:
    """An image input whose cameras' controls can be set while another thread reads images.

    What is wanted is applied between two images, in the thread that reads; a camera that was away
    gets it again.
    """

    live = True

    def __init__(
        self, inner: HasCaptures, locks: Locks | None = None, paths: tuple[str, ...] = ()
    ) -> None:
        """``paths`` of the devices, where the system has any."""
        self._inner, self._paths = inner, paths
        self._reports: tuple[CameraReport, ...] = ()
        self.name, self.fps = inner.name, inner.fps
        self._lock = threading.Lock()
        self._locks, self._changed = locks or Locks(), True
        self._controls: tuple[Control, ...] = tuple(Control(n) for n in PROPERTIES)

    def open(self) -> None:
        self._inner.open()
        self.fps = self._inner.fps
        with self._lock:
            self._changed = True

    def read(self) -> Pair | None:
        self._apply()
        return self._inner.read()

    def close(self) -> None:
        self._inner.close()

    def controls(self) -> tuple[Control, ...]:
        """As they were after the last change."""
        with self._lock:
            return self._controls

    def reports(self) -> tuple[CameraReport, ...]:
        """Returns what each camera granted when it was opened; none before that."""
        with self._lock:
            return self._reports

    def want(self, locks: Locks) -> None:
        """Have this from the next image on."""
        with self._lock:
            self._locks, self._changed = locks, True

    def _apply(self) -> None:
        with self._lock:
            if not self._changed:
                return
            self._changed, locks = False, self._locks
        captures = self._inner.captures()
        found = tuple(self._set(captures, name, getattr(locks, name)) for name in PROPERTIES)
        paths = self._paths or ("",) * len(captures)
        reports = tuple(report_of(c, path) for c, path in zip(captures, paths, strict=False))
        with self._lock:
            self._controls, self._reports = found, reports

    def _set(self, captures: list[cv2.VideoCapture], name: str, value: float | None) -> Control:
        limits = limits_of(self._paths[0], name) if self._paths else None
        return replace(_set_all(captures, name, value), limits=limits)


def _set_all(captures: list[cv2.VideoCapture], name: str, value: float | None) -> Control:
    """The same for both of two cameras; it has a control where both do."""
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


def report_of(capture: Capture, path: str) -> CameraReport:
    """What the device granted; only read, as often as controls change."""
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


def set_control(capture: Capture, name: str, value: float | None) -> Control:
    """Lock a control at ``value``, or give it back to the camera; what the device then says."""
    prop = PROPERTIES[name]
    if value is None:
        if prop.switch is not None:
            capture.set(prop.switch, prop.automatic)
        now = capture.get(prop.value)
        # a control without an automatic stays where it is by itself
        return Control(name, now != ABSENT, now, False)
    if prop.switch is not None:
        capture.set(prop.switch, prop.manual)
    locked = capture.set(prop.value, value)
    now = capture.get(prop.value)
    there = now != ABSENT
    return Control(name, there, now, locked and there, _is_confirmed(capture, prop, now, value))


def _is_confirmed(capture: Capture, prop: _Property, now: float, wanted: float) -> bool:
    """Whether a device that was locked reads back what was set: the value, to its steps, and
    neither an absent switch nor the automatic one."""
    if abs(now - wanted) > max(COARSE, STEP * abs(wanted)):
        return False
    return prop.switch is None or capture.get(prop.switch) not in (prop.automatic, ABSENT)


def locks_text(locks: Locks) -> str:
    """``exposure=157 gain=4``; as the settings hold it."""
    pairs = ((n, getattr(locks, n)) for n in PROPERTIES)
    return " ".join(f"{n}={v:g}" for n, v in pairs if v is not None)


def locks_from(text: str) -> Locks:
    """What `locks_text` wrote; words that mean nothing are left out."""
    values: dict[str, float] = {}
    for word in text.split():
        name, _, number = word.partition("=")
        try:
            if name in PROPERTIES:
                values[name] = float(number)
        except ValueError:
            continue
    return Locks(**values)
