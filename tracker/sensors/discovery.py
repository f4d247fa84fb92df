"""Which serial ports have a glove behind them, and what slows a port down.

A port that may belong to something else hears nothing but HELLO?, which no common device heeds.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from serial.tools import list_ports

from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import Port, reason, serial_port
from tracker.sensors.protocol import BAUD, Hello, HelloRequest, Samples, encode

LATENCY_FILES = Path("/sys/bus/usb-serial/devices")
GOOD_LATENCY_MS = 2
READ_BYTES = 4096
ASK_EVERY = 0.5  # s between two requests, for a chip that is still starting


@dataclass(frozen=True)
class PortReport:
    """What was found at a port. ``hello`` is the glove's answer; None where none came."""

    path: str
    hello: Hello | None
    streaming: bool = False  # samples came without HELLO: a glove that another run had started
    trouble: str = ""

    @property
    def is_glove(self) -> bool:
        """Whether a glove speaks there."""
        return self.hello is not None or self.streaming


def serial_ports() -> list[str]:
    """Paths of the system's USB serial ports; built-in ones without a device are left out."""
    return sorted(p.device for p in list_ports.comports() if p.vid is not None)


def find_gloves(
    paths: Iterable[str] | None = None, patience: float = 4.0, baud: int = BAUD
) -> list[PortReport]:
    """Ask every port in turn, for at most ``patience`` s each (a reset chip needs two)."""
    found = serial_ports() if paths is None else paths
    return [probe(path, serial_port(path, baud), patience) for path in found]


def probe(
    path: str,
    open_port: Callable[[], Port],
    patience: float = 4.0,
    clock: Callable[[], float] = time.monotonic,
) -> PortReport:
    """Send HELLO? and listen until a glove answers. Never raises for a port that fails."""
    try:
        port = open_port()
    except OSError as error:
        return PortReport(path, None, trouble=f"{path} cannot be opened: {reason(error)}.")
    try:
        return _ask(path, port, patience, clock)
    except OSError as error:
        return PortReport(path, None, trouble=f"{path} went away: {reason(error)}.")
    finally:
        port.close()


def _ask(path: str, port: Port, patience: float, clock: Callable[[], float]) -> PortReport:
    decoder, start = FrameDecoder(), clock()
    next_request, streaming = start, False
    while (now := clock()) - start < patience:
        if now >= next_request:
            port.write(b"\0" + encode(HelloRequest()))
            next_request = now + ASK_EVERY
        for frame in decoder.feed(port.read(max(1, min(port.in_waiting, READ_BYTES)))):
            if isinstance(frame, Hello):
                return PortReport(path, frame, streaming)
            streaming |= isinstance(frame, Samples)
    return PortReport(path, None, streaming, "" if streaming else _silence(path, decoder))


def _silence(path: str, decoder: FrameDecoder) -> str:
    if decoder.counters.bytes:
        return (
            f"{path} sends {decoder.counters.bytes} bytes that are no glove's: "
            "another device, or another baud rate."
        )
    return f"Nothing answers at {path}."


def latency_advice(port: str, root: Path = LATENCY_FILES) -> str:
    """What to do about an FTDI adapter that holds bytes back; empty where there is no need."""
    name = Path(port).resolve().name
    try:
        value_ms = int((root / name / "latency_timer").read_text())
    except (OSError, ValueError):
        return ""  # not an FTDI adapter
    if value_ms <= GOOD_LATENCY_MS:
        return ""
    return (
        f"The USB adapter at {port} holds bytes back for up to {value_ms} ms. For quicker "
        f"tracking set it to 1 ms: echo 1 | sudo tee {root / name / 'latency_timer'}"
    )
