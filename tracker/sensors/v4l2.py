"""What Linux knows of a camera that OpenCV does not ask for: limits of controls, serial numbers.

Asking uses a file descriptor of its own and changes nothing, so images go on (Linux kernel, Video
for Linux API, ioctl VIDIOC_QUERYCTRL).
"""

from __future__ import annotations

import os
import struct
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

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
