"""States and parameters of the glove's line."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from tracker.sensors.protocol import BAUD, RATES_HZ

SLOW_MOST_HZ = 100  # packets a second that 115200 baud carry


class LinkState(Enum):
    """State of the link."""

    UNPLUGGED = "unplugged"
    GREETING = "greeting"  # open, waiting for HELLO
    STREAMING = "streaming"
    SILENT = "silent"  # streaming, but nothing has arrived for a while


@dataclass(frozen=True)
class LinkParams:
    """Times in s."""

    rate_hz: int = 100
    boot: float = 2.0  # opening the port may reset the chip
    timeout: float = 2.0  # further s without HELLO, after which START is sent anyway
    silent_after: float = 0.5
    reopen_every: float = 0.5
    baud: int = BAUD  # 200 packets a second need `BAUD`

    def __post_init__(self) -> None:
        if self.rate_hz not in RATES_HZ:
            raise ValueError(f"the rate must be one of {RATES_HZ}")
        if self.rate_hz > SLOW_MOST_HZ and self.baud < BAUD:
            raise ValueError(f"{self.rate_hz} packets a second need {BAUD} baud")


def rates_at(baud: int) -> tuple[int, ...]:
    """Returns the packets per second that a line of ``baud`` carries."""
    return RATES_HZ if baud >= BAUD else tuple(r for r in RATES_HZ if r <= SLOW_MOST_HZ)
