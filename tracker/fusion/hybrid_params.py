"""Settings of the hybrid engines."""

from dataclasses import dataclass


@dataclass(frozen=True)
class HybridParams:
    """``rate_hz`` of the glove; the dorsum's filter has its own settings."""

    rate_hz: float = 100.0
