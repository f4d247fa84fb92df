"""All settings of a tracking run, as one tree that a session carries along."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracker.fusion.chain.params import ChainParams
from tracker.fusion.hybrid import HybridParams
from tracker.fusion.vist.params import VistParams
from tracker.online.frame_timing import TimingParams
from tracker.streaming.params import StreamParams


@dataclass(frozen=True)
class Settings:
    """``engine`` is one of `tracker.pipeline.ENGINES`, ``lenses`` of `tracker.vision.lenses`."""

    engine: str = "chain"
    lenses: str = "both"
    chain: ChainParams = field(default_factory=ChainParams)
    hybrid: HybridParams = field(default_factory=HybridParams)
    vist: VistParams = field(default_factory=VistParams)
    timing: TimingParams = field(default_factory=TimingParams)
    streams: StreamParams = field(default_factory=StreamParams)
