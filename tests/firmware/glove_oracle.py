"""The glove link decoded from its description alone, and a simulated glove to communicate with.

Nothing of ``tracker`` is used here: the firmware is checked against the description of its
protocol, and the engine's decoder against the firmware.
"""

from __future__ import annotations

import binascii
import json
import struct
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import serial
from numpy.typing import NDArray

HELLO, SAMPLES, STATUS, ERROR, PULSE, TEMPERATURES = 0x01, 0x02, 0x03, 0x04, 0x05, 0x06
ASK_HELLO, START, STOP, RATE, HAPTIC = 0x81, 0x82, 0x83, 0x84, 0x85
IMUS = 7
NO_READING = -32768
SAMPLE_BYTES = 1 + 6 + 12 * IMUS + 2 + 2  # type, payload, CRC; COBS' code and the closing zero
PATIENCE_S = 30.0


@dataclass(frozen=True)
class Frame:
    kind: int
    payload: bytes

    @property
    def numbers(self) -> tuple[int, ...]:
        """The fields of a frame in the order of the wire; of a HELLO without `chips`."""
        layout = {
            HELLO: "<BBBBIBHBHB",
            SAMPLES: "<HI42h",
            STATUS: "<HhHH",
            PULSE: "<HI",
            TEMPERATURES: "<7h",
        }[self.kind]
        size = struct.calcsize(layout)
        assert len(self.payload) == size + (2 * IMUS if self.kind == HELLO else 0)
        return struct.unpack(layout, self.payload[:size])

    @property
    def chips(self) -> list[tuple[int, int]]:
        """For a HELLO, per IMU: WHO_AM_I and flags of the self-test (1, 2 failed, 0x80 absent)."""
        return list(struct.iter_unpack("<BB", self.payload[-2 * IMUS :]))

    @property
    def text(self) -> str:
        return self.payload.decode("utf-8")


def crc(body: bytes) -> bytes:
    """CRC-16/CCITT-FALSE, little-endian."""
    return binascii.crc_hqx(body, 0xFFFF).to_bytes(2, "little")


def encode(kind: int, payload: bytes = b"") -> bytes:
    body = bytes([kind]) + payload
    runs = (body + crc(body)).split(b"\0")
    return b"".join(bytes([len(run) + 1]) + run for run in runs) + b"\0"


def decode(stuffed: bytes) -> Frame:
    """One frame without its closing zero; AssertionError where it is not right."""
    runs, i = [], 0
    while i < len(stuffed):
        runs.append(stuffed[i + 1 : i + stuffed[i]])
        assert len(runs[-1]) == stuffed[i] - 1, "COBS"
        i += stuffed[i]
    body = b"\0".join(runs)
    assert len(body) >= 3 and body[-2:] == crc(body[:-2]), "CRC"
    return Frame(body[0], body[1:-2])


@dataclass
class SimulatedGlove:
    """The firmware under simavr, with its port open."""

    process: subprocess.Popen[str]
    port: serial.Serial
    frames: list[Frame] = field(default_factory=list)
    raw: bytearray = field(default_factory=bytearray)
    printed: str = ""
    cut_off: int = 0  # frames that a reset has truncated, if allowed
    may_cut_off: bool = False
    _rest: bytes = b""

    def send(self, kind: int, layout: str = "", *values: int) -> None:
        self.port.write(encode(kind, struct.pack("<" + layout, *values)))

    def tell(self, command: str) -> None:
        """Sends a command to the simulator, such as a change of the glove, now."""
        assert self.process.stdin is not None
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()

    def of(self, kind: int) -> list[Frame]:
        return [f for f in self.frames if f.kind == kind]

    def read(self) -> None:
        """Reads what has arrived; all frames must be valid except one truncated by a reset."""
        data = self.port.read(max(1, self.port.in_waiting))
        self.raw += data
        *whole, self._rest = (self._rest + data).split(b"\0")
        for stuffed in filter(None, whole):
            try:
                self.frames.append(decode(stuffed))
            except AssertionError:
                assert self.may_cut_off
                self.cut_off += 1

    def read_until(self, condition: Callable[[], bool]) -> None:
        end = time.monotonic() + PATIENCE_S
        while not condition():
            assert time.monotonic() < end, f"waited in vain; last {self.frames[-5:]}"
            self.read()

    def wait_for(self, kind: int, count: int = 1) -> list[Frame]:
        """Reads until ``count`` more frames of a kind have arrived; returns them."""
        before = len(self.of(kind))
        self.read_until(lambda: len(self.of(kind)) >= before + count)
        return self.of(kind)[before : before + count]

    def start(self) -> None:
        self.wait_for(HELLO)
        self.send(START)

    def stop(self) -> dict[str, float]:
        """Ends the simulation; returns its measurements."""
        self.process.terminate()
        self.printed += self.process.communicate(timeout=PATIENCE_S)[0]
        report: dict[str, float] = json.loads(self.printed.splitlines()[-1])
        assert report["alive"] and report["violations"] == 0
        return report


@contextmanager
def simulated_glove(
    build: Path, *events: str, motion: Path | None = None, fast: bool = True
) -> Iterator[SimulatedGlove]:
    """The firmware of a build folder, running; ``events`` are "T:COMMAND" of the simulator."""
    command = [str(build / "simulate_glove"), str(build / "glove.elf")]
    command += ["--fast"] if fast else []
    command += ["--motion", str(motion)] if motion else []
    for event in events:
        command += ["--at", event]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True) as process:
        assert process.stdout is not None
        name = process.stdout.readline().split()[1]
        try:
            with serial.Serial(name, 250_000, timeout=0.1) as port:
                yield SimulatedGlove(process, port)
        finally:
            process.kill()


def samples(frames: list[Frame]) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """seq (n,), t_us (n,) and raw (n, 7, 6) of SAMPLES frames."""
    rows = np.array([f.numbers for f in frames], np.int64)
    return rows[:, 0], rows[:, 1], rows[:, 2:].reshape(-1, IMUS, 6)
