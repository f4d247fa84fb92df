"""A thousand random faults on the glove's line, on a simulated clock."""

from __future__ import annotations

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.messages import ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.protocol import Hello, HelloRequest, Samples, Start, Stop, encode

FAULTS = ("lose", "corrupt", "garbage", "unplug", "stall", "silence", "reset")
N = 2
SKEW = 1 - 150e-6


class Line:
    """A glove and its cable. IMU 0 measures its packet's number, so a wrong one would be
    visible."""

    timeout: float | None = 0.0

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.t, self.plugged, self.stalled, self.silent = 50.0, True, False, False
        self.lose = self.corrupt = False
        self.out = b""
        self.restart()

    def restart(self) -> None:
        self.born, self.seq, self.streaming = self.t, 0, False
        self.next_hello, self.decoder = self.t, FrameDecoder()

    def step(self) -> None:
        """10 ms pass."""
        self.t = round(self.t + 0.01, 6)
        if self.streaming:
            self.put(encode(self.packet()))
        elif self.t >= self.next_hello:
            self.next_hello = self.t + 1.0
            self.put(encode(Hello(1, N)))

    def packet(self) -> Samples:
        raw = np.zeros((N, 6), np.int16)
        raw[0, 0] = self.seq % 30_000
        t_us = round((self.t - self.born) * SKEW * 1e6)
        self.seq += 1
        return Samples((self.seq - 1) % 65536, t_us, raw)

    def put(self, data: bytes) -> None:
        if self.silent or not self.plugged or (self.lose and self.rng.random() < 0.5):
            return
        if self.corrupt and self.rng.random() < 0.5:
            bad = bytearray(data)
            bad[self.rng.integers(len(bad))] ^= 1 << int(self.rng.integers(8))
            data = bytes(bad)
        self.out += data

    # ---- the port's side

    def open(self) -> Line:
        if not self.plugged:
            raise FileNotFoundError(2, "No such file")
        return self

    @property
    def in_waiting(self) -> int:
        return 0 if self.stalled else len(self.out)

    def read(self, size: int) -> bytes:
        if not self.plugged:
            raise OSError(5, "Input/output error")
        size = min(size, self.in_waiting)
        data, self.out = self.out[:size], self.out[size:]
        return data

    def write(self, data: bytes) -> int:
        for frame in self.decoder.feed(data):
            if isinstance(frame, HelloRequest):
                self.put(encode(Hello(1, N)))
            elif isinstance(frame, Start | Stop):
                self.streaming = isinstance(frame, Start)
                self.next_hello = self.t + 1.0
        return len(data)

    def close(self) -> None: ...

    # ---- faults

    def fail(self, kind: str) -> None:
        if kind == "unplug":
            self.plugged, self.out = False, b""
        elif kind == "reset":
            self.restart()
        elif kind == "garbage":
            self.out += self.rng.bytes(int(self.rng.integers(1, 600)))
        elif kind == "silence":
            self.silent = True
        else:
            setattr(self, {"stall": "stalled"}.get(kind, kind), True)

    def heal(self) -> None:
        if not self.plugged:
            self.restart()
        self.plugged = True
        self.stalled = self.silent = self.lose = self.corrupt = False


@pytest.mark.long
def test_a_thousand_faults() -> None:
    line, rng = Line(1), np.random.default_rng(2)
    link = GloveLink(line.open, N, clock=lambda: line.t)
    samples: list[ImuSample] = []
    codes: list[str] = []

    def run(dt: float) -> int:
        before = len(samples)
        for _ in range(round(dt * 100)):
            line.step()
            for item in link.poll(0.0):
                if isinstance(item, ImuSample):
                    samples.append(item)
                else:
                    codes.append(item.code)
        return len(samples) - before

    run(2.0)
    for _ in range(1000):
        line.fail(FAULTS[int(rng.integers(len(FAULTS)))])
        run(float(rng.uniform(0.05, 0.3)))
        line.heal()
        recovery = 0.0
        while run(0.05) < 4:
            recovery += 0.05
            assert recovery <= 1.2, codes[-5:]  # HELLO is sent once a second

    felt = [round(float(s.accel[0, 0]) * 32768 / (16 * GRAVITY)) for s in samples]
    assert felt == [s.seq % 30_000 for s in samples]
    arrival = np.array([s.t_arrival for s in samples])
    assert np.all(np.diff(arrival) >= 0)
    assert np.all(np.array([s.t for s in samples]) <= arrival)
    assert len(samples) > 15_000
    assert np.all(np.diff([s.t for s in samples]) > 0)
    assert {"glove.unplugged", "glove.restarted"} <= set(codes)
    assert link.figures.lost > 100
    link.close()
