"""Exposure, gain and serial number of a ZED, by a fake of the kernel's ioctl.

The fake has the registers of both sensors and the automatic exposure of the processor, which
changes exposure and gain automatically while it is on.
"""

from __future__ import annotations

import ctypes
import errno
import struct
from pathlib import Path

import cv2
import pytest

from tests.sensors.test_camera_controls import Driver, Input, by_name
from tracker.sensors import camera_controls, v4l2
from tracker.sensors.camera_controls import ControlledInput, Locks
from tracker.sensors.zed_registers import (
    GAIN_LIMITS,
    ZedRegisters,
    exposure_limits,
    is_zed,
    lock_exposure,
    zed_serial,
)

SIDES = {0xA3: "left", 0xA5: "right"}
AUTOMATIC = {0x80181033: "left", 0x80181833: "right"}


class FakeZed:
    """Decodes commands as the camera does."""

    def __init__(self, length: int = 384, deaf: str = "") -> None:
        self.length, self.deaf = length, deaf
        self.automatic = {"left": 0x43, "right": 0x43}
        first = {0x3500: 0, 0x3501: 0x20, 0x3502: 0x30, 0x3508: 1}
        self.sensor = {side: dict(first) for side in AUTOMATIC.values()}
        self.flash = b"OV" + bytes.fromhex("00012345")
        self.answer = b""
        self.requests: list[int] = []

    def __call__(self, device: int, request: int, block: bytearray) -> int:
        assert device >= 0 and request == 0xC0107521 and len(block) == 16
        unit, selector, query, size, pointer = struct.unpack("=BBBxHxxQ", block)
        if (unit, selector) != (4, 2):
            raise OSError(errno.ENOENT, "no such unit")
        data = (ctypes.c_uint8 * size).from_address(pointer)
        self.requests.append(query)
        if query == 0x85:
            assert size == 2
            data[:] = self.length.to_bytes(2, "little")
        elif size != self.length:
            raise OSError(errno.ENOBUFS, "wrong size")
        elif query == 0x01:
            self._take(bytes(data))
        else:
            assert query == 0x81
            data[:] = self.answer.ljust(self.length, b"\0")
        return 0

    def _take(self, sent: bytes) -> None:
        task, what, where, wide = sent[:4]
        (address,) = struct.unpack(">I", sent[5:9])
        if what == 0xA1:
            assert task == 0x51 and where == 3 and address == 0x18000 and sent[11:13] == b"\0\x40"
            self._reply(self.flash)
        elif what == 0xA2:
            assert wide == 4 and sent[9:13] == b"\0\1\0\1"
            self._register(task, self.automatic, AUTOMATIC[address], sent[16])
        else:
            assert where == 0x6C and wide == 2 and sent[9:13] == b"\x90\1\0\1"
            side = SIDES[what]
            if self.automatic[side] & 2 and task == 0x51:
                self.sensor[side][0x3501] = (self.sensor[side][0x3501] + 7) % 64
            self._register(task, self.sensor[side], address, sent[16], side == self.deaf)

    def _register(
        self, task: int, registers: dict, address, value: int, deaf: bool = False
    ) -> None:
        if task == 0x50 and not deaf:
            registers[address] = value
        self._reply(bytes([registers.get(address, 0)]))

    def _reply(self, value: bytes) -> None:
        self.answer = bytes(17) + value


@pytest.fixture
def path(tmp_path: Path) -> str:
    device = tmp_path / "video0"
    device.touch()
    return str(device)


@pytest.mark.parametrize("length", [384, 64])
def test_exposure_and_gain_are_locked_on_both_sides(path: str, length: int) -> None:
    zed = FakeZed(length)
    found = lock_exposure(path, 700.0, 300.0, zed)
    assert found is not None
    now, confirmed = found
    assert confirmed and not now.automatic and (now.exposure, now.gain) == (700, 300)
    for side in AUTOMATIC.values():
        registers = zed.sensor[side]
        assert registers[0x3500] << 12 | registers[0x3501] << 4 | registers[0x3502] >> 4 == 700
        assert registers[0x3508] << 8 | registers[0x3509] == 378 + 300 - 255
        assert zed.automatic[side] == 0x41, "its other bits are as they were"


def test_without_locks_the_camera_adjusts_itself_again(path: str) -> None:
    zed = FakeZed()
    lock_exposure(path, 700.0, None, zed)
    found = lock_exposure(path, None, None, zed)
    assert found is not None and found[1] and found[0].automatic
    again = lock_exposure(path, None, None, zed)
    assert again is not None and again[0].exposure != found[0].exposure


def test_a_side_that_ignores_the_lock_is_noticed(path: str) -> None:
    found = lock_exposure(path, 700.0, None, FakeZed(deaf="right"))
    assert found is not None and not found[1]


def test_a_camera_without_the_unit_has_no_registers(path: str) -> None:
    def refuse(device: int, request: int, block: bytearray) -> int:
        raise OSError(errno.ENOENT, "no such unit")

    assert lock_exposure(path, 700.0, None, refuse) is None and zed_serial(path, refuse) is None
    assert lock_exposure(path + "9", 700.0, None, FakeZed()) is None


def test_the_serial_number_is_read_as_on_the_label(path: str) -> None:
    zed = FakeZed()
    assert zed_serial(path, zed) == 12345
    zed.flash = b"\xff" * 6
    assert zed_serial(path, zed) is None


def test_every_gain_comes_back(path: str) -> None:
    with ZedRegisters(path, FakeZed()) as zed:
        zed.set_automatic(False)
        for steps in (0, 254, 255, 256, 388, 389, 521, 522, int(GAIN_LIMITS.greatest)):
            assert zed.set_gain(steps)
            found = zed.exposure()
            assert found is not None and found.gain == steps
    assert exposure_limits(60.0).greatest == 880 < exposure_limits(30.0).greatest


def test_a_zed_is_known_by_its_usb_vendor(tmp_path: Path) -> None:
    for name, alias in (("video0", "usb:v2B03pF682d0100dc"), ("video1", "usb:v046Dp082D")):
        folder = tmp_path / name / "device"
        folder.mkdir(parents=True)
        (folder / "modalias").write_text(alias + "\n")
    assert is_zed("/dev/video0", tmp_path) and not is_zed("/dev/video1", tmp_path)
    assert not is_zed("/dev/video2", tmp_path)


def test_the_window_sees_a_confirmed_lock(path: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A driver without an exposure control, as that of a ZED: the registers take its place."""

    class NoExposure(Driver):
        def __init__(self) -> None:
            super().__init__()
            for prop in (cv2.CAP_PROP_AUTO_EXPOSURE, cv2.CAP_PROP_EXPOSURE):
                self.values.pop(prop, None)

    zed = FakeZed()
    monkeypatch.setattr(v4l2, "ioctl", lambda *asked: zed(*asked[:3]))
    monkeypatch.setattr(camera_controls, "is_zed", lambda _path: True)
    source = ControlledInput(Input(NoExposure()), Locks(), (path,))
    source.open()
    source.read()
    free = by_name(source)
    assert free["exposure"].is_open and free["gain"].available
    source.request_locks(Locks(exposure=400.0))
    source.read()
    locked = by_name(source)["exposure"]
    assert locked.locked and locked.verified and locked.value == 400 and locked.limits is not None
    zed.deaf = "left"
    source.request_locks(Locks(exposure=500.0))
    source.read()
    assert by_name(source)["exposure"].is_unverified
