"""Numbers and times of the glove's packets, which wrap, and a clock that may jump."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from statistics import median

from tracker.sensors.clock_map import ClockMap
from tracker.sensors.decoder import Unwrapper
from tracker.sensors.protocol import Samples

SEQ_BITS, TIME_BITS = 16, 32
CLOCK_JUMP, CLOCK_RATE = 0.005, 0.02  # s and share by which t_us may differ from what seq says
SHORTEST, LONGEST = 1 / 400, 1 / 20  # s between packets that some rate may have
LEARN, SURE = 5, 30  # steps alike until the period is theirs, and until it is said


@dataclass(frozen=True)
class PacketTime:
    """``seq`` and ``t_device`` (s) count on; ``t`` (s) is the sample's instant on the host's clock.

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

    ``said_period`` is what the glove said before it was asked: it may not heed the wish.
    """

    def __init__(self, period: float, wire_time: float, said_period: float | None = None) -> None:
        self._asked, self._said, self._wire_time = period, said_period, wire_time
        self.restart()

    def restart(self) -> None:
        """Forget: the next packet begins a new count, on a clock of which nothing is known."""
        self._seq, self._device = Unwrapper(SEQ_BITS), Unwrapper(TIME_BITS)
        self._last: tuple[int, float] | None = None
        self._map = ClockMap()
        self._period = self._asked
        self._steps: deque[float] = deque(maxlen=SURE)
        self._doubt: tuple[float, float] | None = None  # an odd step, and what jump it would be

    @property
    def rate_hz(self) -> float | None:
        """Packets a second by the glove's own clock; None until that is sure."""
        return 1 / self._period if len(self._steps) == SURE else None

    @property
    def skew_ppm(self) -> float | None:
        """Host microseconds gained per device second; None until it can be told."""
        return 1e6 * self._map.skew if self._map.settled else None

    def read(self, packet: Samples, now: float) -> PacketTime | None:
        """The time of a packet that came at ``now`` (s); None for one that came before."""
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
        """By how much (s) the glove's clock has left its packet numbers, 0 where it has not.

        One odd step is a jump, two alike are another rate: then the map stays. What may be either
        is judged by the next packet.
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
        return not self._steps and self._said is not None and _agree(packets, passed, self._said)

    def _learn(self, step: float) -> None:
        self._steps.append(step)
        if len(self._steps) >= LEARN:
            self._period = median(self._steps)


def _agree(packets: int, passed: float, period: float) -> bool:
    expected = packets * period
    return abs(passed - expected) <= CLOCK_JUMP + CLOCK_RATE * expected
