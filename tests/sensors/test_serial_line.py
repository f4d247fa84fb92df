"""Serial ports on Linux, macOS and Windows, and the errors of these systems."""

from __future__ import annotations

import fcntl
import os
import pty
import sys
import termios
import threading
import time
import tty
from collections.abc import Iterator
from types import ModuleType

import pytest

from tracker.sensors.protocol import BAUD
from tracker.sensors.serial_line import (
    SerialPort,
    UsbPort,
    crosses_uart,
    read_waiting,
    reason,
    usb_ports,
    write_now,
)

FTDI, WCH, SILABS, ARDUINO, TEENSY = 0x0403, 0x1A86, 0x10C4, 0x2341, 0x16C0


@pytest.mark.parametrize(
    ("path", "vid", "pid", "uart"),
    [
        ("/dev/ttyUSB0", FTDI, 0x6001, True),
        ("/dev/ttyUSB0", 0x1234, 0x0001, True),  # Linux names bridges so, whoever made them
        ("/dev/ttyACM0", TEENSY, 0x0483, False),
        ("/dev/ttyACM0", ARDUINO, 0x0043, True),  # Uno: its USB chip speaks to the ATmega
        ("/dev/ttyACM0", ARDUINO, 0x8036, False),  # Leonardo: the ATmega has USB itself
        ("/dev/ttyACM0", WCH, 0x55D4, True),  # CH9102, a bridge of class CDC
        ("/dev/cu.usbserial-110", FTDI, 0x6001, True),
        ("/dev/cu.usbmodem1101", TEENSY, 0x0483, False),
        ("/dev/cu.usbmodem1101", ARDUINO, 0x0043, True),
        ("COM7", SILABS, 0xEA60, True),
        ("COM7", TEENSY, 0x0483, False),
    ],
)
def test_a_bridge_is_distinguished_from_native_usb(
    path: str, vid: int, pid: int, uart: bool
) -> None:
    assert crosses_uart(path, [UsbPort(path, vid, pid, None)]) == uart


@pytest.mark.parametrize(
    ("path", "uart"),
    [("/dev/ttyS0", True), ("/dev/ttyAMA0", True), ("COM1", True), ("/dev/pts/4", False)],
)
def test_a_port_that_is_not_on_usb(path: str, uart: bool) -> None:
    assert crosses_uart(path, []) == uart


def test_a_pseudo_terminal_has_no_transmission_time() -> None:
    master, slave = pty.openpty()
    port = SerialPort(os.ttyname(slave), 115_200)
    assert port.wire_baud == 0 and port.latency_ms is None
    port.close()
    os.close(slave)
    os.close(master)


class Cable:
    """A pseudo-terminal whose other end is closed right after a system call."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.master, self.slave = pty.openpty()
        self.path = os.ttyname(self.slave)
        self._monkeypatch = monkeypatch

    def pull_after(self, module: ModuleType, name: str) -> None:
        call = getattr(module, name)

        def pulled(*args: object) -> object:
            out = call(*args)
            self.pull()
            return out

        self._monkeypatch.setattr(module, name, pulled)

    def pull(self) -> None:
        if self.master >= 0:
            os.close(self.slave)
            os.close(self.master)
            self.master = -1


@pytest.fixture
def cable(monkeypatch: pytest.MonkeyPatch) -> Iterator[Cable]:
    cable = Cable(monkeypatch)
    yield cable
    cable.pull()


CALLS = {"flock": fcntl, "tcgetattr": termios, "tcsetattr": termios, "ioctl": fcntl}
"""The system calls while a port is configured; pyserial does not convert later failures."""


@pytest.mark.parametrize("call", ["flock", "tcgetattr", "ioctl"])
def test_a_port_removed_during_configuration_is_an_ordinary_error(cable: Cable, call: str) -> None:
    port = SerialPort(cable.path, BAUD)
    cable.pull_after(CALLS[call], call)
    with pytest.raises(OSError) as caught:
        port.timeout = 0.01
    assert reason(caught.value)
    port.close()


@pytest.mark.parametrize("call", CALLS)
def test_so_is_one_removed_while_it_is_opened(cable: Cable, call: str) -> None:
    cable.pull_after(CALLS[call], call)
    with pytest.raises(OSError):
        SerialPort(cable.path, BAUD)
    assert cable.master < 0


def test_ports_are_listed_with_their_serial_numbers() -> None:
    assert all(p.vid > 0 and p.path for p in usb_ports())


@pytest.mark.parametrize(
    ("error", "system", "words"),
    [
        (PermissionError(13, "Permission denied"), "linux", "usermod -aG dialout"),
        (PermissionError(13, "Access is denied."), "win32", "another program has it open"),
        (OSError("could not open port 'COM7': Access is denied."), "win32", "another program"),
        (PermissionError(13, "Permission denied"), "darwin", "macOS has not allowed"),
        (OSError("could not open port 'COM9': FileNotFoundError(2, ...)"), "win32", "not there"),
        (OSError(16, "Resource busy"), "darwin", "another program has it open"),
    ],
)
def test_errors_name_the_remedy_on_the_current_system(
    error: Exception, system: str, words: str
) -> None:
    text = reason(error, system)
    assert words in text
    assert ("sudo" in text) == (system == "linux")


def wait_for(slave: int, count: int) -> None:
    """Waits for a number of bytes, which the system transfers asynchronously."""
    deadline = time.monotonic() + 10
    while int.from_bytes(fcntl.ioctl(slave, termios.FIONREAD, bytes(4)), sys.byteorder) < count:
        assert time.monotonic() < deadline, "they did not come within 10 s"
        time.sleep(0.001)


def test_a_motor_command_does_not_wait_for_a_full_line() -> None:
    master, slave = pty.openpty()
    port = SerialPort(os.ttyname(slave), BAUD)
    port.write_timeout = 60.0  # pyserial's wait: the test would hang if it were called
    try:
        assert port.write_now(b"x") == 1
        termios.tcflow(port.fd, termios.TCOOFF)  # like a full line, which here empties on its own
        assert port.write_now(b"x") == 0
        assert not write_now(port, b"buzz")
    finally:
        port.close()
        os.close(slave)
        os.close(master)
    with pytest.raises(OSError):
        port.write_now(b"x")


def test_waiting_bytes_are_read_at_once_and_an_empty_line_is_not_read() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    port = SerialPort(os.ttyname(slave), BAUD)
    try:
        assert read_waiting(port, 0.0) == b""
        os.write(master, b"first")
        os.write(master, b" second")
        wait_for(slave, len(b"first second"))
        assert read_waiting(port, 5.0) == b"first second"
        assert read_waiting(port, 0.0) == b""
    finally:
        port.close()
        os.close(slave)
        os.close(master)
    with pytest.raises(OSError):
        read_waiting(port, 0.0)
    with pytest.raises(OSError):
        port.write(b"x")


def test_an_unplugged_cable_is_an_os_error_for_readers() -> None:
    master, slave = pty.openpty()
    port = SerialPort(os.ttyname(slave), BAUD)
    os.close(slave)
    os.close(master)
    with pytest.raises(OSError):
        read_waiting(port, 5.0)
    port.close()


def test_partial_writes_are_completed() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    port = SerialPort(os.ttyname(slave), BAUD)
    data, received = bytes(range(256)) * 128, bytearray()

    def listen() -> None:
        while len(received) < taken + len(data):
            received.extend(os.read(master, 4096))

    try:
        taken = os.write(port.fd, data)
        assert taken < len(data)  # so much it does not take, and now nothing
        listener = threading.Thread(target=listen)
        listener.start()
        assert port.write(data) == len(data)
        listener.join(10)
        assert bytes(received) == data[:taken] + data
    finally:
        port.close()
        os.close(slave)
        os.close(master)
