"""A glove on a clock of the caller's own: as fast as it is asked, with every fault of a cable.

`glove_device` is its sibling in real time on a pseudo-terminal; here the port itself is simulated,
so that hours of faults pass in minutes and come out the same each time.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

import numpy as np

from tracker.messages import ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.protocol import (
    BAUD,
    BITS_PER_BYTE,
    GloveStatus,
    Hello,
    HelloRequest,
    Samples,
    Start,
    Stop,
    encode,
)
from tracker.simulation.glove_device import ACCEL_RANGE_G, GYRO_RANGE_DPS, quantised

FAULTS = ("lose", "corrupt", "garbage", "unplug", "stall", "silence", "reset", "clock jump")
BOOT = 0.3  # s that the chip takes after power returns
LONGEST_JUMP = 30.0  # s
BUFFER_BYTES = 20_000  # what the system keeps of a stalled line; more is lost


class VirtualGlove:
    """Also its own `Port`. ``source`` gives samples whose t = 0 is the clock's zero."""

    timeout: float | None = 0.0
    wire_baud = BAUD  # a packet is on its way for as long as its bytes take

    def __init__(self, source: Iterator[ImuSample], imu_count: int, seed: int = 0) -> None:
        self._source, self._imu_count = source, imu_count
        self._rng = np.random.default_rng(seed)
        self._next = next(source, None)
        self._wire = BITS_PER_BYTE * (12 * imu_count + 11) / BAUD
        self._fault = ""
        self._out = b""
        self._sent: deque[int] = deque(maxlen=1000)
        self.now = self._ready_at = 0.0
        self._restart()

    def _restart(self) -> None:
        self._born, self._jumped, self._seq, self._streaming = self.now, 0.0, 0, False
        self._next_hello, self._next_status = max(self._ready_at, self.now), self.now + 1.0
        self._decoder = FrameDecoder()

    # ---- the caller's side

    def next_event(self) -> float:
        """When the next packet will have left, s."""
        return self._next.t + self._wire if self._next is not None else float("inf")

    def advance(self, now: float) -> None:
        """Let time pass until ``now`` (s)."""
        self.now = now
        while self._next is not None and self._next.t + self._wire <= now:
            if self._streaming:
                self._put(encode(self._packet(self._next)))
            self._next = next(self._source, None)
        self._speak()

    def _speak(self) -> None:
        """HELLO until START, STATUS once a second after it."""
        if self._streaming and self.now >= self._next_status:
            self._next_status = self.now + 1.0
            self._put(encode(GloveStatus(3700, 2900, (1 << self._imu_count) - 1, 0)))
        elif not self._streaming and self.now >= self._next_hello:
            self._next_hello = self.now + 1.0
            self._put(encode(self._hello()))

    def fail(self, kind: str) -> None:
        """Begin one of `FAULTS`."""
        self._fault = kind
        if kind == "unplug":
            self._out, self._streaming = b"", False
        elif kind == "reset":
            self._ready_at = self.now + BOOT
            self._restart()
        elif kind == "garbage":
            self._out += self._rng.bytes(int(self._rng.integers(1, 600)))
        elif kind == "clock jump":
            self._jumped += float(self._rng.uniform(-1, 1)) * LONGEST_JUMP

    def heal(self) -> None:
        """End the fault: the cable is in again, the line runs."""
        if self._fault == "unplug":
            self._ready_at = self.now + BOOT
            self._restart()
        self._fault = ""

    # ---- the firmware

    def _packet(self, sample: ImuSample) -> Samples:
        t_us = round((sample.t - self._born + self._jumped + 100.0) * 1e6)
        seq, self._seq = self._seq, (self._seq + 1) % 65536
        return Samples(seq, t_us % 2**32, quantised(sample))

    def _hello(self) -> Hello:
        return Hello(1, self._imu_count, GYRO_RANGE_DPS, ACCEL_RANGE_G)

    def _put(self, data: bytes) -> None:
        if self._fault in ("unplug", "silence") or self.now < self._ready_at:
            return
        if self._fault == "lose" and self._rng.random() < 0.5:
            return
        if self._fault == "corrupt" and self._rng.random() < 0.5:
            damaged = bytearray(data)
            damaged[int(self._rng.integers(len(data)))] ^= 1 << int(self._rng.integers(8))
            data = bytes(damaged)
        if len(self._out) < BUFFER_BYTES:
            self._out += data

    # ---- the port's side

    def open(self) -> VirtualGlove:
        """Opens the port."""
        if self._fault == "unplug":
            raise FileNotFoundError(2, "No such file")
        return self

    @property
    def in_waiting(self) -> int:
        return 0 if self._fault == "stall" else len(self._out)

    def read(self, size: int) -> bytes:
        if self._fault == "unplug":
            raise OSError(5, "Input/output error")
        size = min(size, self.in_waiting)
        data, self._out = self._out[:size], self._out[size:]
        return data

    def write(self, data: bytes) -> int:
        if self.now < self._ready_at:
            return len(data)
        for frame in self._decoder.feed(data):
            if isinstance(frame, HelloRequest):
                self._put(encode(self._hello()))
            elif isinstance(frame, Start | Stop):
                self._streaming = isinstance(frame, Start)
        return len(data)

    def close(self) -> None:
        """The line goes on by itself."""
