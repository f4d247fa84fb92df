"""Numbers and times of the glove's packets, which wrap, and a clock that may jump."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.sensors.clock_map import ClockMap
from tracker.sensors.decoder import Unwrapper
from tracker.sensors.protocol import Samples

SEQ_BITS, TIME_BITS = 16, 32
CLOCK_JUMP, CLOCK_RATE = 0.005, 0.02  # s and share by which t_us may differ from what seq says


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
    """``period`` s between samples; ``wire_time`` s that a packet's bytes take to arrive."""

    def __init__(self, period: float, wire_time: float) -> None:
        self._period, self._wire_time = period, wire_time
        self.restart()

    def restart(self) -> None:
        """Forget: the next packet begins a new count, on a clock of which nothing is known."""
        self._seq, self._device = Unwrapper(SEQ_BITS), Unwrapper(TIME_BITS)
        self._last: tuple[int, float] | None = None
        self._map = ClockMap()

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
        self._map.add(t_device, now - self._wire_time)
        return PacketTime(seq, t_device, min(self._map.host(t_device), now), lost, jumped)

    def _jump(self, packets: int, passed: float) -> float:
        """The glove's clock has to agree with its packet numbers; else it is mapped anew."""
        expected = packets * self._period
        if abs(passed - expected) <= CLOCK_JUMP + CLOCK_RATE * expected:
            return 0.0
        self._map = ClockMap()
        return passed - expected
