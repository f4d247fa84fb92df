"""A simulated glove, its cable and a clock, controlled by a test."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from tracker.base.notices import Notice
from tracker.messages import Event, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink, Port
from tracker.sensors.protocol import Hello, HelloRequest, Rate, Samples, Start, Stop, encode

N = 3
SKEW = 80e-6  # of the glove's clock
PACKET_BITS = 10 * len(encode(Samples(0, 0, np.zeros((N, 6), np.int16))))
LATENCY = 0.0005  # s from a packet's last bit to the host


@dataclass(eq=False)
class Scripted:
    """A glove, its cable and the clock, in steps of 1 ms; ``obeys`` RATE or ignores it."""

    hello: Hello | None
    rate_hz: float = 100.0
    obeys: bool = False
    rest_counts: int = 2048  # raw |a| at rest, along z
    wire_baud: int = 0
    timeout: float | None = 0.0
    t: float = 20.0
    seq: int = 0
    streaming: bool = False
    gone: bool = False  # its cable is out
    out: bytes = b""
    truth: list[float] = field(default_factory=list)
    received: list[object] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.decoder, self.next, self.rng = FrameDecoder(), self.t, np.random.default_rng(3)
        self.motion = 0.0  # raw counts of shaking

    def step(self) -> None:
        self.t = round(self.t + 0.001, 6)
        wire = PACKET_BITS / self.wire_baud if self.wire_baud else 0.0
        while self.next + wire + LATENCY <= self.t:
            if self.streaming:
                self.put(self.packet(self.next))
            self.next += 1 / self.rate_hz

    def packet(self, t: float) -> Samples:
        raw = np.zeros((N, 6), np.int16)
        raw[:, 2] = self.rest_counts
        raw[:, :3] += (self.motion * self.rng.standard_normal((N, 3))).astype(np.int16)
        if self.motion:
            raw[:, 3:] = self.rng.integers(-2, 3, (N, 3))
        self.seq += 1
        self.truth.append(t)
        return Samples((self.seq - 1) % 65536, round(1e6 * t * (1 + SKEW)) % 2**32, raw)

    def put(self, *frames: object) -> None:
        self.out += b"".join(encode(f) for f in frames)  # type: ignore[arg-type]

    @property
    def in_waiting(self) -> int:
        return len(self.out)

    def read(self, size: int) -> bytes:
        if self.gone:
            raise OSError(5, "Input/output error")
        data, self.out = self.out[:size], self.out[size:]
        return data

    def write(self, data: bytes) -> int:
        for frame in self.decoder.feed(data):
            self.received.append(frame)
            if isinstance(frame, HelloRequest) and self.hello is not None:
                self.put(self.hello)
            elif isinstance(frame, Rate) and self.obeys:
                self.rate_hz = frame.rate_hz
            elif isinstance(frame, Start | Stop):
                self.streaming, self.next = isinstance(frame, Start), self.t
        return len(data)

    def close(self) -> None: ...


class Run:
    """A link to a scripted glove."""

    def __init__(self, glove: Scripted, open_port: Callable[[], Port] | None = None) -> None:
        self.glove = glove
        self.link = GloveLink(open_port or (lambda: glove), N, clock=lambda: glove.t)
        self.samples: list[ImuSample] = []
        self.notices: list[Notice] = []

    def go(self, duration: float) -> None:
        for _ in range(round(1000 * duration)):
            self.glove.step()
            for item in self.link.poll(0.0):
                if isinstance(item, Event):
                    assert item.notice is not None
                    self.notices.append(item.notice)
                else:
                    self.samples.append(item)

    @property
    def codes(self) -> list[str]:
        """Events reported by the link."""
        return [n.code for n in self.notices]

    def errors(self) -> np.ndarray:
        """Times of the samples, s; the last packet may still be in transmission."""
        return np.array(
            [s.t - true for s, true in zip(self.samples, self.glove.truth, strict=False)]
        )
