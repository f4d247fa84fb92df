"""The glove on a serial port: handshake, samples, faults, and coming back by itself.

`GloveLink.poll` does all the work and owns no thread; `GloveLink.vibrate` may be called from any.
Every fault becomes a counter and, once, an event in plain words.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

import numpy as np
import serial

from tracker import GRAVITY
from tracker.clock import nanoseconds, seconds
from tracker.messages import Event, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.packet_clock import PacketClock, PacketTime
from tracker.sensors.protocol import (
    BAUD,
    BITS_PER_BYTE,
    RATES_HZ,
    ErrorText,
    Frame,
    GloveStatus,
    Haptic,
    Hello,
    HelloRequest,
    Rate,
    Samples,
    Start,
    Stop,
    encode,
)

DEGREE = np.pi / 180
LONG_SILENCE = 60.0  # s, after which seq may have wrapped unseen


class Port(Protocol):
    """What is used of `serial.Serial`."""

    timeout: float | None

    @property
    def in_waiting(self) -> int: ...

    def read(self, size: int) -> bytes: ...

    def write(self, data: bytes) -> int | None: ...

    def close(self) -> None: ...


class LinkState(Enum):
    """Where the link stands."""

    UNPLUGGED = "unplugged"
    GREETING = "greeting"  # open, waiting for HELLO
    STREAMING = "streaming"
    SILENT = "silent"  # streaming, but nothing has come for a while


@dataclass(frozen=True)
class LinkParams:
    """Times in s."""

    rate_hz: int = 100
    boot: float = 2.0  # opening the port may reset the chip
    patience: float = 2.0  # more without HELLO, then START is sent anyway
    silent_after: float = 0.5
    reopen_every: float = 0.5
    baud: int = BAUD  # a packet's own time on the wire is known and taken off


@dataclass(eq=False)
class LinkFigures:
    """For the screen."""

    packets: int = 0
    lost: int = 0
    resets: int = 0
    clock_jumps: int = 0
    reopened: int = 0
    battery_mV: int | None = None
    temperature_cC: int | None = None


class GloveLink:
    """One glove with ``imu_count`` IMUs. ``open_port`` opens its port or raises OSError."""

    def __init__(
        self,
        open_port: Callable[[], Port],
        imu_count: int,
        params: LinkParams | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.params = params or LinkParams()
        if self.params.rate_hz not in RATES_HZ:
            raise ValueError(f"the rate must be one of {RATES_HZ}")
        self._open_port, self._imu_count, self._clock = open_port, imu_count, clock
        self._port: Port | None = None
        self._writing = threading.RLock()  # two frames must not mix, nor the port go between
        self._events: list[Event] = []
        self._next_open = float("-inf")
        self._told: set[str] = set()
        self.state = LinkState.UNPLUGGED
        self.hello: Hello | None = None
        self.figures = LinkFigures()
        self.decoder = FrameDecoder()
        self._imu_ok = (1 << imu_count) - 1
        packet = encode(Samples(0, 0, np.zeros((imu_count, 6), np.int16)))
        wire_time = BITS_PER_BYTE * len(packet) / self.params.baud
        self._packet_clock = PacketClock(1 / self.params.rate_hz, wire_time)

    # ---- outside

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        """Samples and events, after waiting at most ``timeout`` s for bytes."""
        out: list[ImuSample | Event] = []
        if self._port is None and not self._open(timeout):
            return self._taken(out)
        try:
            data = self._read(timeout)
            now = self._clock()
            for frame in self.decoder.feed(data):
                out += self._take(frame, now)
            self._watch(now)
        except (serial.SerialException, OSError) as error:
            self._unplugged(error)
        return self._taken(out)

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> None:
        """Let a motor run; nothing happens while the glove is away. From any thread."""
        self._send(Haptic(channel, amplitude, duration_ms))

    def close(self) -> None:
        """Stop the stream and free the port. May be called again."""
        self._send(Stop())
        if self._port is not None:
            self._port.close()
            self._port = None
        self.state = LinkState.UNPLUGGED

    # ---- the port

    def _open(self, timeout: float) -> bool:
        now = self._clock()
        if now < self._next_open:
            time.sleep(min(timeout, self._next_open - now))
            return False
        self._next_open = now + self.params.reopen_every
        try:
            self._port = self._open_port()
        except (serial.SerialException, OSError) as error:
            self._once("open", f"The glove's port cannot be opened: {reason(error)}")
            return False
        self._told.discard("open")
        self.figures.reopened += 1
        counters, self.decoder = self.decoder.counters, FrameDecoder()
        self.decoder.counters = counters
        self._greet(now)
        return True

    def _greet(self, now: float) -> None:
        self.state, self._since, self._asked = LinkState.GREETING, now, False
        self._packet_clock.restart()
        self._send(HelloRequest())

    def _read(self, timeout: float) -> bytes:
        port = self._port
        if port is None:  # a writer in another thread has just found it gone
            return b""
        port.timeout = timeout
        first = port.read(1)
        waiting = port.in_waiting if first else 0
        return first + (port.read(min(waiting, 65536)) if waiting else b"")

    def _send(self, frame: Frame) -> None:
        with self._writing:
            if self._port is None:
                return
            try:
                self._port.write(encode(frame))
            except (serial.SerialException, OSError) as error:
                self._unplugged(error)

    def _unplugged(self, error: Exception) -> None:
        with self._writing:
            if self._port is None:
                return
            self._port.close()
            self._port = None
        self.state = LinkState.UNPLUGGED
        self._say(f"The glove was unplugged ({reason(error)}); it is taken up when it returns.")

    # ---- frames

    def _take(self, frame: Frame, now: float) -> list[ImuSample]:
        match frame:
            case Samples():
                return self._samples(frame, now)
            case Hello():
                self._greeted(frame, now)
            case GloveStatus():
                self._status(frame)
            case ErrorText():
                self._say(f"The glove says: {frame.text}")
        return []

    def _greeted(self, hello: Hello, now: float) -> None:
        if self.state in (LinkState.STREAMING, LinkState.SILENT):
            self.figures.resets += 1
            self._say("The glove has restarted; it is told to go on.")
        self.hello = hello
        if hello.imu_count != self._imu_count:
            self._once(
                "count",
                f"This glove has {hello.imu_count} IMUs but the glove file says "
                f"{self._imu_count}: choose the right glove file.",
            )
        self._begin(now)

    def _begin(self, now: float) -> None:
        self._packet_clock.restart()
        if self.hello is None or self.hello.rate_hz != self.params.rate_hz:
            self._send(Rate(self.params.rate_hz))
        self._send(Start())
        self.state, self._since = LinkState.STREAMING, now

    def _samples(self, frame: Samples, now: float) -> list[ImuSample]:
        if len(frame.raw) != self._imu_count:
            self._once(
                "count",
                f"Packets hold {len(frame.raw)} IMUs but the glove file says {self._imu_count}.",
            )
            return []
        if self.state == LinkState.SILENT:
            self._say("The glove sends again.")
            if now - self._since > LONG_SILENCE:
                self._packet_clock.restart()
        self.state, self._since = LinkState.STREAMING, now
        time_of = self._packet_clock.read(frame, now)
        if time_of is None:
            return []
        self.figures.packets += 1
        self.figures.lost += time_of.lost
        if time_of.jumped:
            self.figures.clock_jumps += 1
            by = time_of.jumped
            self._say(f"The glove's clock jumped by {by:+.3f} s; its packets are timed anew.")
        return [self._sample(frame, time_of, now)]

    def _sample(self, frame: Samples, time_of: PacketTime, now: float) -> ImuSample:
        hello = self.hello or Hello(0, self._imu_count)
        raw = frame.raw.astype(float) / 32768.0
        valid = np.array([bool(self._imu_ok >> j & 1) for j in range(self._imu_count)])
        accel = raw[:, :3] * (hello.accel_range_g * GRAVITY)
        gyro = raw[:, 3:] * (hello.gyro_range_dps * DEGREE)
        accel[~valid], gyro[~valid] = np.nan, np.nan
        return ImuSample(
            t=seconds(nanoseconds(time_of.t)),
            t_arrival=seconds(nanoseconds(now)),
            t_device=time_of.t_device,
            seq=time_of.seq,
            accel=accel,
            gyro=gyro,
            valid=valid,
        )

    def _status(self, status: GloveStatus) -> None:
        self.figures.battery_mV = status.battery_mV
        self.figures.temperature_cC = status.temperature_cC
        changed = status.imu_ok ^ self._imu_ok
        self._imu_ok = status.imu_ok
        for j in range(self._imu_count):
            if changed >> j & 1:
                word = "answers again" if status.imu_ok >> j & 1 else "does not answer"
                self._say(f"IMU {j} of the glove {word}.")

    def _watch(self, now: float) -> None:
        """What does not come: HELLO, or samples."""
        p, waited = self.params, now - self._since
        if self.state == LinkState.GREETING:
            if waited > p.boot and not self._asked:
                self._asked = True
                self._send(HelloRequest())
            if waited > p.boot + p.patience:
                self._say("The glove has not said what it is; it is told to start anyway.")
                self._begin(now)
        elif self.state == LinkState.STREAMING and waited > p.silent_after:
            self.state = LinkState.SILENT
            self._say(f"The glove has been silent for {p.silent_after:g} s.")

    # ---- words

    def _say(self, text: str) -> None:
        self._events.append(Event(self._clock(), "device", text))

    def _once(self, topic: str, text: str) -> None:
        if topic not in self._told:
            self._told.add(topic)
            self._say(text)

    def _taken(self, out: list[ImuSample | Event]) -> list[ImuSample | Event]:
        events, self._events = self._events, []
        return out + events


def reason(error: Exception) -> str:
    """An operating system's complaint in words, with what to do about a missing permission."""
    number = getattr(error, "errno", None)
    text = str(error)
    if number == 13 or "ermission" in text:
        return (
            "permission denied. Add yourself to the group dialout "
            "(sudo usermod -aG dialout $USER) and log in again, or install the udev rule "
            "70-glovetrack.rules of the package"
        )
    if number == 2 or "No such file" in text:
        return "it is not there"
    if number == 16 or "busy" in text.lower():
        return "another program has it open"
    return getattr(error, "strerror", None) or text


def serial_port(path: str, baud: int = BAUD) -> Callable[[], Port]:
    """Opens a real port (or a pseudo-terminal) by its path or name."""
    return lambda: serial.Serial(path, baud, timeout=0.05, write_timeout=1.0)
