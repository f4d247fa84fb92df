"""Finds the serial ports with a glove, and settings that slow a port down.

Ports that may belong to another device receive only HELLO?, which common devices ignore.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracker.base.notices import Notice, warning
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.protocol import BAUD, BAUDS, Hello, HelloRequest, Samples, encode
from tracker.sensors.serial_line import (
    BRIDGE_FTDI,
    GOOD_LATENCY_MS,
    LATENCY_FILES,
    Port,
    TunablePort,
    UsbPort,
    latency_of,
    reason,
    serial_port,
    usb_ports,
)
from tracker.sensors.serial_line import serial_ports as serial_ports

READ_BYTES = 4096
ASK_EVERY = 0.5  # s between requests, because the chip may still be starting


@dataclass(frozen=True)
class PortReport:
    """The result for one port. ``hello`` is the glove's answer; None if it did not answer."""

    path: str
    hello: Hello | None
    streaming: bool = False  # samples without a HELLO: another run started the glove
    problem: Notice | None = None
    baud: int = BAUD  # baud rate at which it answered

    @property
    def is_glove(self) -> bool:
        """Whether a glove responds at this port."""
        return self.hello is not None or self.streaming


def find_gloves(
    paths: Iterable[str] | None = None, timeout: float = 4.0, bauds: Sequence[int] = BAUDS
) -> list[PortReport]:
    """Queries each port in turn, for at most ``timeout`` s (a chip needs two after a reset)."""
    found = serial_ports() if paths is None else paths
    return [probe(path, serial_port(path, bauds[0]), timeout, bauds=bauds) for path in found]


def probe(
    path: str,
    open_port: Callable[[], Port],
    timeout: float = 4.0,
    clock: Callable[[], float] = time.monotonic,
    bauds: Sequence[int] = BAUDS,
) -> PortReport:
    """Send HELLO? at each of ``bauds`` in turn until a glove answers, on a port opened once:
    opening resets the chip. Never raises for a port that fails."""
    try:
        port = open_port()
    except OSError as error:
        return PortReport(
            path, None, problem=warning("port.not_opened", port=path, why=reason(error))
        )
    try:
        return _ask(path, port, timeout, clock, bauds)
    except OSError as error:
        return PortReport(path, None, problem=warning("port.lost", port=path, why=reason(error)))
    finally:
        port.close()


def _ask(
    path: str, port: Port, timeout: float, clock: Callable[[], float], bauds: Sequence[int]
) -> PortReport:
    start, received, turn, streaming_at = clock(), 0, 0, 0
    while (began := clock()) - start < timeout:
        baud = streaming_at or bauds[turn % len(bauds)]
        if isinstance(port, TunablePort):
            port.baudrate = baud
        end = min(began + ASK_EVERY, start + timeout)
        decoder, turn = FrameDecoder(), turn + 1
        port.write(b"\0" + encode(HelloRequest()))
        hello, streaming = _listen(port, decoder, clock, end)
        received += decoder.counters.bytes
        streaming_at = streaming_at or (baud if streaming else 0)
        if hello is not None:
            return PortReport(path, hello, bool(streaming_at), baud=baud)
    if streaming_at:
        return PortReport(path, None, True, baud=streaming_at)
    return PortReport(path, None, problem=_undecodable(path, received, bauds))


def _listen(
    port: Port, decoder: FrameDecoder, clock: Callable[[], float], end: float
) -> tuple[Hello | None, bool]:
    """The HELLO received until ``end`` (s), if any, and whether samples were received."""
    streaming = False
    while clock() < end:
        for frame in decoder.feed(port.read(max(1, min(port.in_waiting, READ_BYTES)))):
            if isinstance(frame, Hello):
                return frame, streaming
            streaming |= isinstance(frame, Samples)
    return None, streaming


def _undecodable(path: str, received: int, bauds: Sequence[int]) -> Notice:
    if received:
        return warning("port.not_glove", port=path, received_bytes=received, bauds=bauds)
    return warning("port.no_answer", port=path)


def latency_advice(
    port: str,
    root: Path = LATENCY_FILES,
    system: str = sys.platform,
    ports: Callable[[], Sequence[UsbPort]] = usb_ports,
) -> Notice | None:
    """The remedy for an FTDI adapter that delays bytes; None if none is needed.

    Linux reports the delay that is set. Windows does not, and its driver waits 16 ms by default;
    macOS's own driver has no such setting.
    """
    if system == "win32":
        made_by = next((p.vid for p in ports() if p.path == port), None)
        return warning("port.latency_windows", port=port) if made_by == BRIDGE_FTDI else None
    value_ms = latency_of(port, root)
    if value_ms is None or value_ms <= GOOD_LATENCY_MS:
        return None
    setting = root / Path(port).resolve().name / "latency_timer"
    held = {"latency_ms": value_ms, "setting": setting}
    return warning("port.latency_linux", port=port, **held)
