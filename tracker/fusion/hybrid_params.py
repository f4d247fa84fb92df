"""Settings of the hybrid engines."""

from dataclasses import dataclass


@dataclass(frozen=True)
class HybridParams:
    """``rate_hz`` is the packet rate of the glove; the dorsum's filter has its own settings."""

    rate_hz: float = 100.0
