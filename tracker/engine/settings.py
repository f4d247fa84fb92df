"""All settings of a tracking run, as one tree that a session carries along. Quick to import."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from tracker.base.config import OnProblem, from_dict
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.hybrid_params import HybridParams
from tracker.fusion.vist.params import VistParams
from tracker.online.frame_timing import TimingParams
from tracker.online.rig_alignment import AlignmentParams


@dataclass(frozen=True)
class Settings:
    """``engine`` is one of `tracker.engine.kinds.ENGINES`, ``lenses`` of `tracker.vision.lenses`.

    ``engines`` are tables of settings, by the name of an engine of another package; a table is read
    when its engine is made, so a recording opens without that package.
    """

    engine: str = "chain"
    lenses: str = "both"
    chain: ChainParams = field(default_factory=ChainParams)
    hybrid: HybridParams = field(default_factory=HybridParams)
    vist: VistParams = field(default_factory=VistParams)
    timing: TimingParams = field(default_factory=TimingParams)
    alignment: AlignmentParams = field(default_factory=AlignmentParams)
    engines: dict[str, dict[str, Any]] = field(default_factory=dict)


BEFORE: dict[str, dict[str, Any]] = {
    "timing": {"jitter": False},
    "alignment": {"apply": False},
    "chain": {"cloth": {"fingers": False}},
}
"""What the settings of recordings mean where they lack a key: what came later was not in use."""


def settings_from(data: Mapping[str, Any], on_problem: OnProblem) -> Settings:
    """Settings from a table, see `from_dict`.

    The table ``streams`` of older recordings and files has no effect on tracking and is ignored.
    """
    return from_dict(Settings, {k: v for k, v in data.items() if k != "streams"}, on_problem)


def recorded_settings_from(data: Mapping[str, Any], on_problem: OnProblem) -> Settings:
    """`settings_from` for those of a recording, which is tracked as it was when it was made."""
    older = {
        table: {**keys, **data.get(table, {})} if isinstance(data.get(table, {}), Mapping) else keys
        for table, keys in BEFORE.items()
    }
    return settings_from({**data, **older}, on_problem)
