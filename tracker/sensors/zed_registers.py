"""Exposure, gain and serial number of ZED cameras, which their USB video class does not offer.

The sensors (OV4689) and their processor (OV580) are reached by registers through an extension unit
of the camera (Linux, ioctl UVCIOC_CTRL_QUERY). Facts from Stereolabs' zed-open-capture (MIT); no
camera was available to test them, so every value is read back before it counts as set.
"""

from __future__ import annotations

import ctypes
import os
import struct
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tracker.sensors.v4l2 import SYSTEM, Ioctl, Limits, system_ioctl

QUERY = 0xC0107521  # UVCIOC_CTRL_QUERY of a struct of 16 bytes
SET_CURRENT, GET_CURRENT, GET_LENGTH = 0x01, 0x81, 0x85
UNIT, SELECTOR = 4, 2
LENGTH = 384  # bytes of a command over USB 3; 64 over USB 2
ANSWER = 17  # offset of the result
PAUSE = 0.002  # s from a command to its answer
READ, WRITE = 0x51, 0x50
SYSTEM_REGISTER, FLASH = 0xA2, 0xA1
SENSORS = (0xA3, 0xA5)  # left, right
AUTOMATIC = (0x80181033, 0x80181833)  # system registers of the left and the right image
AUTOMATIC_BIT = 0x02
EXPOSURE, GAIN = (0x3500, 0x3501, 0x3502), (0x3507, 0x3508, 0x3509)  # sensor registers, high first
SERIAL = 0x18000  # in the flash memory
VENDOR = "2B03"
_QUERY = struct.Struct("=BBBxHxxQ")
GAIN_ZONES = ((0, 255), (378, 511), (890, 1023), (1914, 2047))
"""Register values of the gain, which doubles its step from one zone to the next."""
LONGEST = {15: 1550, 30: 1100, 60: 880, 100: 720}
"""Rows of the longest exposure, by images per second."""
GAIN_LIMITS = Limits(0.0, float(sum(high - low for low, high in GAIN_ZONES)), 1.0, 0.0)


class ZedExposure(NamedTuple):
    """For both images: whether the camera changes it automatically, ``exposure`` in rows and
    ``gain`` in steps."""

    automatic: bool
    exposure: int
    gain: int


def is_zed(path: str, system: Path = SYSTEM) -> bool:
    """Whether the camera at ``path`` is one of Stereolabs'."""
    try:
        alias = (system / Path(path).name / "device" / "modalias").read_text("utf-8")
    except OSError:
        return False
    return alias.upper().startswith(f"USB:V{VENDOR}")


def exposure_limits(fps: float) -> Limits:
    """Rows."""
    nearest = min(LONGEST, key=lambda known: abs(known - fps))
    return Limits(2.0, float(LONGEST[nearest]), 1.0, LONGEST[nearest] / 2)


class ZedRegisters:
    """Reads and sets registers of the ZED at ``path`` in a ``with`` block, while it streams.

    Everything is None where the camera cannot be opened or does not answer.
    """

    def __init__(self, path: str, ioctl: Ioctl = system_ioctl) -> None:
        self._path, self._ioctl = path, ioctl
        self._device = -1

    def __enter__(self) -> ZedRegisters:
        if sys.platform != "win32":
            try:
                self._device = os.open(self._path, os.O_RDWR | os.O_NONBLOCK)
            except OSError:
                self._device = -1
        return self

    def __exit__(self, *_error: object) -> None:
        if self._device >= 0:
            os.close(self._device)
            self._device = -1

    def exposure(self) -> ZedExposure | None:
        """The values of the left sensor; automatic if either sensor is."""
        switches = [self._system(address) for address in AUTOMATIC]
        exposure, gain = self._sensor(0, EXPOSURE), self._sensor(0, GAIN)
        if None in switches or exposure is None or gain is None:
            return None
        automatic = any((switch or 0) & AUTOMATIC_BIT for switch in switches)
        return ZedExposure(automatic, exposure >> 4, _steps_of(gain))

    def set_automatic(self, on: bool) -> bool:
        """For both images; whether both confirm it."""
        for address in AUTOMATIC:
            value = self._system(address)
            if value is None:
                return False
            value = value | AUTOMATIC_BIT if on else value & ~AUTOMATIC_BIT
            self._command(WRITE, SYSTEM_REGISTER, 0, 4, address, value)
        read = [self._system(address) for address in AUTOMATIC]
        return all(v is not None and bool(v & AUTOMATIC_BIT) == on for v in read)

    def set_exposure(self, rows: int) -> bool:
        """For both images; whether both confirm it."""
        return self._set_both(EXPOSURE, rows << 4)

    def set_gain(self, steps: int) -> bool:
        """For both images; whether both confirm it."""
        return self._set_both(GAIN, _register_of(steps))

    def serial_number(self) -> int | None:
        """As on the camera's label and in the name of its calibration file."""
        found = self._command(READ, FLASH, 3, 0, SERIAL, length=64)
        if found is None or found[:2] != b"OV":
            return None
        digits = found[2:6].hex().lstrip("0")
        return int(digits) if digits.isdigit() else None

    def _set_both(self, registers: Sequence[int], value: int) -> bool:
        shares = [value >> 16 & 0xFF, value >> 8 & 0xFF, value & 0xFF]
        for sensor in SENSORS:
            for address, share in zip(registers, shares, strict=True):
                self._command(WRITE, sensor, 0x6C, 2, address, share)
        return all(self._sensor(k, registers) == value for k in range(len(SENSORS)))

    def _sensor(self, side: int, registers: Sequence[int]) -> int | None:
        value = 0
        for address in registers:
            found = self._command(READ, SENSORS[side], 0x6C, 2, address)
            if found is None:
                return None
            value = value << 8 | found[0]
        return value

    def _system(self, address: int) -> int | None:
        found = self._command(READ, SYSTEM_REGISTER, 0, 4, address)
        return None if found is None else found[0]

    def _command(
        self,
        task: int,
        what: int,
        where: int,
        address_bytes: int,
        address: int,
        value: int = 0,
        length: int = 1,
    ) -> bytes | None:
        """Returns the result of a read command; None if the camera refuses it."""
        size = self._query(GET_LENGTH, bytearray(2))
        if size is None:
            return None
        page = 0x9000 if what in (*SENSORS, FLASH) else 0
        head = struct.pack(">BBBBBIHH", task, what, where, address_bytes, int(address_bytes > 0),
                           address, page + length, length)  # fmt: skip
        sent = bytearray(head.ljust(16, b"\0") + bytes([value])).ljust(LENGTH, b"\0")
        sent = sent[: int.from_bytes(size, "little")]
        if self._query(SET_CURRENT, sent) is None:
            return None
        time.sleep(PAUSE)
        if task == WRITE:
            return b""
        found = self._query(GET_CURRENT, bytearray(len(sent)))
        return None if found is None else bytes(found[ANSWER : ANSWER + length])

    def _query(self, request: int, data: bytearray) -> bytearray | None:
        if self._device < 0:
            return None
        buffer = (ctypes.c_uint8 * len(data)).from_buffer(data)
        block = _QUERY.pack(UNIT, SELECTOR, request, len(data), ctypes.addressof(buffer))
        try:
            self._ioctl(self._device, QUERY, bytearray(block))
        except OSError:  # no such unit, or the camera is disconnected
            return None
        return data


def _register_of(steps: int) -> int:
    for low, high in GAIN_ZONES:
        if steps <= high - low:
            return low + max(steps, 0)
        steps -= high - low
    return GAIN_ZONES[-1][1]


def _steps_of(register: int) -> int:
    before = 0
    for low, high in GAIN_ZONES:
        if register <= high:
            return before + max(register - low, 0)
        before += high - low
    return before


def lock_exposure(
    path: str, exposure: float | None, gain: float | None, ioctl: Ioctl = system_ioctl
) -> tuple[ZedExposure, bool] | None:
    """Locks the given ones and leaves the other unchanged; without either, both become automatic.

    Returns the resulting values, and whether the camera confirms the request; None if it does
    not answer.
    """
    with ZedRegisters(path, ioctl) as zed:
        locks = exposure is not None or gain is not None
        confirmed = zed.set_automatic(not locks)
        if exposure is not None:
            confirmed = zed.set_exposure(round(exposure)) and confirmed
        if gain is not None:
            confirmed = zed.set_gain(round(gain)) and confirmed
        now = zed.exposure()
    return None if now is None else (now, confirmed)


def zed_serial(path: str, ioctl: Ioctl = system_ioctl) -> int | None:
    """The serial number of the ZED at ``path``; None where it does not answer."""
    with ZedRegisters(path, ioctl) as zed:
        return zed.serial_number()
