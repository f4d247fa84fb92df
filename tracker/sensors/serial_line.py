"""Opening serial ports: transport of the bytes, and error messages.

Systems answer differently: Linux names ports after their driver (``ttyUSB``, ``ttyACM``), macOS
after their class (``cu.usbserial``, ``cu.usbmodem``), Windows not at all (``COM7``), where the USB
numbers identify the device.
"""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple, Protocol, runtime_checkable

import serial
from serial.tools import list_ports

from tracker.sensors.protocol import BAUD

BRIDGE_FTDI = 0x0403
BRIDGE_MAKERS = frozenset({BRIDGE_FTDI, 0x10C4, 0x1A86, 0x067B})  # and Silabs, WCH, Prolific
BRIDGE_BOARDS = frozenset(
    {(maker, board) for maker in (0x2341, 0x2A03) for board in (0x01, 0x10, 0x42, 0x43, 0x243)}
)
"""Arduino Uno and Mega: CDC ACM by name, but their USB chip is connected to the ATmega by a
UART."""
UART_NAMES = ("ttyUSB", "ttyS", "ttyAMA", "cu.usbserial", "cu.SLAB", "cu.wchusb", "COM")
CDC_NAMES = ("ttyACM", "cu.usbmodem", "tty.usbmodem", "COM")  # a COM port on USB without a bridge
GOOD_LATENCY_MS = 2
MOST_AT_ONCE = 65536  # bytes
TTY_FILES = Path("/sys/class/tty")
LATENCY_FILES = Path("/sys/bus/usb-serial/devices")


class Port(Protocol):
    """The part of `serial.Serial` that is used."""

    timeout: float | None

    @property
    def in_waiting(self) -> int: ...

    def read(self, size: int) -> bytes: ...

    def write(self, data: bytes) -> int | None: ...

    def close(self) -> None: ...


@runtime_checkable
class WiredPort(Protocol):
    """A port with a known transport: ``wire_baud`` is 0 if there is no UART."""

    @property
    def wire_baud(self) -> int: ...


@runtime_checkable
class TunablePort(Protocol):
    """A port whose speed can be changed while it is open."""

    baudrate: int


class UsbPort(NamedTuple):
    """A serial port on USB. ``serial_number``, if any, distinguishes adapters of one type."""

    path: str
    vid: int
    pid: int
    serial_number: str | None


def usb_ports() -> list[UsbPort]:
    """The system's USB serial ports by path; built-in ones without a device are left out."""
    ports = (p for p in list_ports.comports() if p.vid is not None)
    return sorted(UsbPort(p.device, p.vid, p.pid or 0, p.serial_number) for p in ports)


def serial_ports() -> list[str]:
    """Their paths."""
    return [p.path for p in usb_ports()]


def crosses_uart(path: str, ports: Iterable[UsbPort]) -> bool:
    """Whether the bytes of the port at ``path`` are transmitted serially on a UART.

    On USB alone (CDC ACM) and on a pseudo-terminal a packet arrives as a whole.
    """
    name = Path(path).name
    here = next((p for p in ports if p.path == path), None)
    if here is None:
        return name.startswith(UART_NAMES)
    if here.vid in BRIDGE_MAKERS or (here.vid, here.pid) in BRIDGE_BOARDS:
        return True
    return not name.startswith(CDC_NAMES)


def read_waiting(port: Port, timeout: float) -> bytes:
    """What there is, after waiting at most ``timeout`` s for the first byte. Raises OSError."""
    return (
        port.read_waiting(timeout) if isinstance(port, SerialPort) else _read_waiting(port, timeout)
    )


def write_now(port: Port, data: bytes) -> bool:
    """Writes as much as the line has room for: frequently repeated commands must not wait. Returns
    whether all was written. Raises OSError."""
    if isinstance(port, SerialPort):
        return port.write_now(data) == len(data)
    port.write(data)
    return True


def _read_waiting(port: Port, timeout: float) -> bytes:
    if port.timeout != timeout:  # setting it configures the line again, which is slow
        port.timeout = timeout
    first = port.read(1)
    waiting = port.in_waiting if first else 0
    return first + (port.read(min(waiting, MOST_AT_ONCE)) if waiting else b"")


@contextmanager
def _as_os_error() -> Iterator[None]:
    """Converts the loss of a port while it is configured to OSError: pyserial
    passes ``termios.error`` on, and raises ValueError at non-standard speeds."""
    try:
        yield
    except OSError:
        raise
    except Exception as error:
        raise serial.SerialException(*error.args) from error


class SerialPort(serial.Serial):
    """A real port or pseudo-terminal, open."""

    def __init__(self, path: str, baud: int) -> None:
        """Raises OSError (`serial.SerialException`) where it cannot be opened."""
        with _as_os_error():
            super().__init__(path, baud, timeout=0.05, write_timeout=1.0, exclusive=True)
        self._path = real_path(path)
        self._on_uart = crosses_uart(self._path, usb_ports())

    @property
    def wire_baud(self) -> int:
        """Bits per second on the UART behind the port; 0 if there is none."""
        return int(self.baudrate) if self._on_uart else 0

    def _reconfigure_port(self, *force: bool, **named: bool) -> None:
        """As pyserial at each change of timeout or speed. Raises only OSError."""
        with _as_os_error():
            super()._reconfigure_port(*force, **named)

    def read_waiting(self, timeout: float) -> bytes:
        """What there is, after waiting at most ``timeout`` s for the first byte. Raises OSError.

        If possible with two system calls instead of pyserial's five: after each of
        them a thread waits for Python's lock, and a packet with it.
        """
        if not self.is_open:
            raise serial.PortNotOpenError
        if sys.platform == "win32":
            return _read_waiting(self, timeout)
        if not select.select([self.fd], [], [], timeout)[0]:
            return b""
        try:
            data = os.read(self.fd, MOST_AT_ONCE)
        except BlockingIOError:  # another program opened it first
            return b""
        if not data:  # readable but empty: how systems report a pulled cable
            raise serial.SerialException("the device is no longer there")
        return data

    def write(self, data: bytes) -> int:
        """Writes everything, with one system call if it accepts that much. Raises OSError."""
        done = 0 if sys.platform == "win32" else self.write_now(data)
        return done if done == len(data) else done + (super().write(data[done:]) or 0)

    def write_now(self, data: bytes) -> int:
        """Writes as much as there is room for, without waiting if the system allows it. Returns the
        bytes.

        Raises OSError.
        """
        if not self.is_open:
            raise serial.PortNotOpenError
        if sys.platform == "win32":
            return super().write(data) or 0
        with suppress(BlockingIOError):
            return os.write(self.fd, data)
        return 0

    @property
    def is_suspended(self) -> bool:
        """Whether the system has suspended the USB device, to save power."""
        return is_suspended(self._path)

    @property
    def latency_ms(self) -> int | None:
        """Delay that an FTDI adapter adds; None if the system does not report it."""
        return latency_of(self._path)


def is_suspended(path: str, root: Path = TTY_FILES) -> bool:
    """Whether the system has suspended the USB device of a port, on Linux; False elsewhere."""
    device = (root / Path(path).name / "device").resolve()
    for folder in (device, *list(device.parents)[:4]):
        try:
            if (folder / "power" / "runtime_status").read_text().strip() == "suspended":
                return True
        except OSError:
            continue
    return False


def serial_port(path: str, baud: int = BAUD) -> Callable[[], Port]:
    """Opens a real port (or a pseudo-terminal) by its path or name."""
    return lambda: SerialPort(path, baud)


def real_path(path: str) -> str:
    """The target of a link such as ``/dev/serial/by-id/…``; a name that is not a file is
    unchanged."""
    return str(Path(path).resolve()) if Path(path).exists() else path


def latency_of(path: str, root: Path = LATENCY_FILES) -> int | None:
    """Delay (ms) that an FTDI adapter adds, on Linux; None for other adapters and systems."""
    try:
        return int((root / Path(path).resolve().name / "latency_timer").read_text())
    except (OSError, ValueError):
        return None


def reason(error: Exception, system: str = sys.platform) -> str:
    """The message for an operating-system error, with the remedy on ``system``."""
    number, text = getattr(error, "errno", None), str(error)
    if number == 13 or "ermission" in text or "Access is denied" in text:
        return _refused(system)
    if number == 2 or "No such file" in text or "FileNotFoundError" in text:
        return "it is not there"
    if number in (11, 16, 35) or "busy" in text.lower():  # 11, 35: the port is locked
        return "another program has it open"
    return getattr(error, "strerror", None) or text


def _refused(system: str) -> str:
    if system == "win32":  # Windows allows one program to open a port and refuses others
        return "access is denied: another program has it open"
    if system == "darwin":
        return "permission denied: another program has it open, or macOS has not allowed its driver"
    return (
        "permission denied. Add yourself to the group dialout "
        "(sudo usermod -aG dialout $USER) and log in again, or install the udev rule "
        "70-glovetrack.rules of the package"
    )
