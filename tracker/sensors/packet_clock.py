"""Sequence numbers and times of the glove's packets, and the glove's clock mapped to the host's.

Numbers and times wrap, and a clock may jump. The map is a line below the points (device time,
arrival - device time): a packet can arrive late but not early, so the lowest offsets are the most
accurate. The line is the edge of the lower convex hull at the middle of the window, the line below
all points with the least sum of distances. It is deterministic and robust to bunching and stalls.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from statistics import median

from tracker.sensors.decoder import Unwrapper
from tracker.sensors.protocol import Samples

Point = tuple[float, float]


@dataclass(frozen=True)
class ClockMapParams:
    """Times in s."""

    bucket: float = 0.25  # one lowest offset is kept per bucket
    window: float = 40.0
    settle: float = 5.0  # span below which no skew is estimated
    max_skew: float = 300e-6  # crystals are within ±200 ppm


class ClockMap:
    """Causal: `host` uses what has arrived until now."""

    def __init__(self, params: ClockMapParams | None = None) -> None:
        self._params = params or ClockMapParams()
        self._lowest: deque[Point] = deque()
        self._bucket: int | None = None  # of the last packet; a wrapped count may be below zero
        self._line: tuple[float, float, float] | None = None  # (t_device, offset, skew)
        self._last_host = float("-inf")

    @property
    def skew(self) -> float:
        """Host seconds gained per device second."""
        return self._line[2] if self._line else 0.0

    @property
    def settled(self) -> bool:
        """Whether the packets span enough time for a valid skew estimate."""
        return self._span() >= self._params.settle

    def _span(self) -> float:
        return self._lowest[-1][0] - self._lowest[0][0] if self._lowest else 0.0

    def add(self, t_device: float, t_arrival: float) -> None:
        """Adds a packet stamped ``t_device`` that arrived at ``t_arrival`` (s)."""
        offset = t_arrival - t_device
        bucket = int(t_device // self._params.bucket)
        if bucket != self._bucket:
            self._bucket = bucket
            self._lowest.append((t_device, offset))
            while self._lowest[-1][0] - self._lowest[0][0] > self._params.window:
                self._lowest.popleft()
            self._line = self._fit()
        elif offset < self._lowest[-1][1]:
            self._lowest[-1] = (t_device, offset)
            self._line = self._fit()

    def host(self, t_device: float) -> float:
        """The host's time of a device time; never decreases between calls."""
        assert self._line is not None, "add comes before host"
        t_0, offset, skew = self._line
        t = t_device + offset + skew * (t_device - t_0)
        self._last_host = max(t, self._last_host + 1e-6)
        return self._last_host

    def _fit(self) -> tuple[float, float, float]:
        points = list(self._lowest)
        if points[-1][0] - points[0][0] < self._params.settle:
            t, lowest = min(points, key=lambda p: p[1])
            return t, lowest, 0.0
        hull = _lower_hull(points)
        middle = sum(t for t, _ in points) / len(points)
        k = next(i for i in range(1, len(hull)) if hull[i][0] >= middle)
        (t_a, a), (t_b, b) = hull[k - 1], hull[k]
        skew = (b - a) / (t_b - t_a)
        limit = self._params.max_skew
        if abs(skew) > limit:
            skew = max(-limit, min(limit, skew))
            a = min(offset - skew * (t - t_a) for t, offset in points)
        return t_a, a, skew


def _lower_hull(points: list[Point]) -> list[Point]:
    """For points in order of their first coordinate."""
    hull: list[Point] = []
    for p in points:
        while len(hull) >= 2 and _turn(hull[-2], hull[-1], p) <= 0:
            hull.pop()
        hull.append(p)
    return hull


def _turn(a: Point, b: Point, c: Point) -> float:
    """Positive where a, b, c turn left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


SEQ_BITS, TIME_BITS = 16, 32
CLOCK_JUMP, CLOCK_RATE = 0.005, 0.02  # s and share by which t_us may differ from seq
SHORTEST, LONGEST = 1 / 400, 1 / 20  # s between packets, limits over all rates
LEARN, SURE = 5, 30  # equal steps until the period is adopted, and until it is reported


@dataclass(frozen=True)
class PacketTime:
    """``seq`` and ``t_device`` (s) are unwrapped; ``t`` (s) is the sample's instant on the host's
    clock.

    ``lost`` packets are missing before this one; ``jumped`` s is how far the glove's clock has
    come to differ from its packet numbers, 0 where it agrees.
    """

    seq: int
    t_device: float
    t: float
    lost: int = 0
    jumped: float = 0.0


class PacketClock:
    """``period`` s between samples as asked for; ``wire_time`` s that a packet's bytes take.

    ``reported_period`` is the glove's period before the request, which it may ignore.
    """

    def __init__(
        self, period: float, wire_time: float, reported_period: float | None = None
    ) -> None:
        self._asked, self._reported_period, self._wire_time = period, reported_period, wire_time
        self.restart()

    def restart(self) -> None:
        """Resets: the next packet begins a new count, on an unknown clock."""
        self._seq, self._device = Unwrapper(SEQ_BITS), Unwrapper(TIME_BITS)
        self._last: tuple[int, float] | None = None
        self._map = ClockMap()
        self._period = self._asked
        self._steps: deque[float] = deque(maxlen=SURE)
        self._doubt: tuple[float, float] | None = None  # an irregular step and the possible jump

    @property
    def rate_hz(self) -> float | None:
        """Packets per second by the glove's own clock; None until known reliably."""
        return 1 / self._period if len(self._steps) == SURE else None

    @property
    def skew_ppm(self) -> float | None:
        """Host microseconds gained per device second; None until it is known."""
        return 1e6 * self._map.skew if self._map.settled else None

    def read(self, packet: Samples, now: float) -> PacketTime | None:
        """The time of a packet that arrived at ``now`` (s); None for a repeated or late one."""
        seq, t_device = self._seq(packet.seq), self._device(packet.t_us) * 1e-6
        lost, jumped = 0, 0.0
        if self._last is not None:
            passed = seq - self._last[0]
            if passed <= 0:
                return None
            lost, jumped = passed - 1, self._jump(passed, t_device - self._last[1])
        self._last = seq, t_device
        if jumped:
            self._map = ClockMap()
        self._map.add(t_device, now - self._wire_time)
        return PacketTime(seq, t_device, min(self._map.host(t_device), now), lost, jumped)

    def instant(self, t_us: int) -> tuple[float, float] | None:
        """s on the glove's clock, counting on as `PacketTime.t_device`, and on the host's, of a
        ``t_us`` within 35 minutes of the last packet; None before the first."""
        if self._last is None:
            return None
        last_us = round(self._last[1] * 1e6)
        half = 2 ** (TIME_BITS - 1)
        t_device = (last_us + (t_us - last_us + half) % (2 * half) - half) * 1e-6
        return t_device, self._map.host(t_device)

    def _jump(self, packets: int, passed: float) -> float:
        """Time (s) by which the glove's clock deviates from its packet numbers, 0 if it does not.

        A single irregular step is a jump; two equal ones mean another rate, and the map stays. An
        ambiguous step is decided by the next packet.
        """
        step, doubt, self._doubt = passed / packets, self._doubt, None
        if _agree(packets, passed, self._period):
            self._learn(step)
            return doubt[1] if doubt is not None else 0.0
        if self._is_rate(packets, passed, doubt):
            self._period = step
            self._steps.clear()
            self._steps.append(step)
            return 0.0
        by = passed - packets * self._period
        if doubt is None and SHORTEST <= step <= LONGEST:
            self._doubt = step, by
            return 0.0
        return by

    def _is_rate(self, packets: int, passed: float, doubt: tuple[float, float] | None) -> bool:
        if doubt is not None:
            return _agree(packets, passed, doubt[0])
        return (
            not self._steps
            and self._reported_period is not None
            and _agree(packets, passed, self._reported_period)
        )

    def _learn(self, step: float) -> None:
        self._steps.append(step)
        if len(self._steps) >= LEARN:
            self._period = median(self._steps)


def _agree(packets: int, passed: float, period: float) -> bool:
    expected = packets * period
    return abs(passed - expected) <= CLOCK_JUMP + CLOCK_RATE * expected
