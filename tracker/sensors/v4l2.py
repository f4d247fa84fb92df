"""Features of cameras on Linux that OpenCV lacks: limits, more controls, serial numbers.

A separate file descriptor is used, so the stream continues (Linux kernel, Video for Linux API,
ioctls VIDIOC_QUERYCTRL, VIDIOC_G_CTRL and VIDIOC_S_CTRL).
"""

from __future__ import annotations

import os
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

if sys.platform != "win32":
    from fcntl import ioctl

QUERY = 0xC0445624  # VIDIOC_QUERYCTRL of a struct of 68 bytes
GET, SET = 0xC008561B, 0xC008561C  # VIDIOC_G_CTRL, VIDIOC_S_CTRL
_VALUE = struct.Struct("=Ii")
_CONTROL = struct.Struct("=II32siiiiI8x")
DISABLED = 0x0001
IDS = {
    "exposure": 0x009A0902,  # V4L2_CID_EXPOSURE_ABSOLUTE
    "gain": 0x00980913,
    "white_balance": 0x0098091A,  # V4L2_CID_WHITE_BALANCE_TEMPERATURE
}
SYSTEM = Path("/sys/class/video4linux")
Ioctl = Callable[[int, int, bytearray], int]


def system_ioctl(device: int, request: int, data: bytearray) -> int:
    """The system's own; raises OSError where it has none."""
    if sys.platform == "win32":
        raise OSError("this system has no ioctl")
    return ioctl(device, request, data, True)


class Limits(NamedTuple):
    """For a control, in the driver's own units."""

    least: float
    greatest: float
    step: float
    default: float


def limits_of(path: str, name: str, ioctl: Ioctl = system_ioctl) -> Limits | None:
    """Returns the limits of a control of the camera at ``path``; None where the driver reports
    none, and on other systems."""
    with ControlIo(path, ioctl) as io:
        return io.limits(IDS[name])


class ControlIo:
    """Reads and writes the controls of one camera while it is entered.

    Everything is None or False where the camera cannot be opened or has no such control.
    """

    def __init__(self, path: str, ioctl: Ioctl = system_ioctl) -> None:
        self._path, self._ioctl = path, ioctl
        self._device = -1

    def __enter__(self) -> ControlIo:
        if sys.platform != "win32" and self._path.startswith("/dev/"):
            try:
                self._device = os.open(self._path, os.O_RDWR | os.O_NONBLOCK)
            except OSError:
                self._device = -1
        return self

    def __exit__(self, *_error: object) -> None:
        if self._device >= 0:
            os.close(self._device)
            self._device = -1

    def limits(self, control: int) -> Limits | None:
        """For a control that exists and is not disabled."""
        answer = self._ask(QUERY, _CONTROL.pack(control, 0, b"", 0, 0, 0, 0, 0))
        if answer is None:
            return None
        _, _, _, least, greatest, step, default, flags = _CONTROL.unpack(answer)
        return None if flags & DISABLED else Limits(least, greatest, step, default)

    def get(self, control: int) -> int | None:
        """The present value."""
        answer = self._ask(GET, _VALUE.pack(control, 0))
        return None if answer is None else _VALUE.unpack(answer)[1]

    def set(self, control: int, value: int) -> bool:
        """Whether the driver accepted the value; read it back to see whether it is in effect."""
        return self._ask(SET, _VALUE.pack(control, value)) is not None

    def _ask(self, request: int, data: bytes) -> bytes | None:
        if self._device < 0:
            return None
        buffer = bytearray(data)
        try:
            self._ioctl(self._device, request, buffer)
        except OSError:  # EINVAL: the device has no such control
            return None
        return bytes(buffer)


def serial_number(path: str, system: Path = SYSTEM) -> str:
    """Returns the USB serial number of the camera at ``path``; empty where there is none."""
    device = (system / Path(path).name / "device").resolve()
    for folder in (device, *device.parents[:2]):  # the interface, then the device itself
        try:
            return (folder / "serial").read_text("utf-8").strip()
        except OSError:
            continue
    return ""
