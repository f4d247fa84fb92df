"""The wearer's calibration as learned by a chain filter, for storage and reuse."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.distal import Synergies
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.messages import Array


@record(
    "chain.profile",
    shapes={
        "bg": "I 3",
        "R_IB": "I 3 3",
        "ba": "I 3",
        "scale": "A 2",
        "joint": "B 3",
        "marker": "M 3",
        "P": "c c",
        "axis": "K | 0",
    },
)
@dataclass(frozen=True, eq=False)
class WearerProfile:
    """The calibration part of a `ChainState` and its covariance P (C, C), in the same order; the
    wearer's own synergies where they are known."""

    bg: Array
    R_IB: Array
    ba: Array
    scale: Array
    joint: Array
    marker: Array
    P: Array
    synergies: Synergies | None = None
    axis: Array = field(default_factory=lambda: np.zeros(0))


def profile_of(state: ChainState, layout: ChainLayout) -> WearerProfile:
    """The calibration of ``state``, independent of its pose."""
    block = slice(layout.n_dynamic, layout.blocks.size)
    return WearerProfile(
        state.bg.copy(),
        state.R_IB.copy(),
        state.ba.copy(),
        state.scale.copy(),
        state.joint.copy(),
        state.marker.copy(),
        state.P[block, block].copy(),
        axis=state.axis.copy(),
    )


def wear(state: ChainState, layout: ChainLayout, profile: WearerProfile) -> None:
    """Applies a profile: the pose is unchanged, correlations of pose and calibration are
    discarded."""
    n = layout.n_dynamic
    for name in ("bg", "R_IB", "ba", "scale", "joint", "marker", "axis"):
        setattr(state, name, getattr(profile, name).copy())
    state.P[:n, n:] = 0.0
    state.P[n:, :n] = 0.0
    state.P[n:, n:] = profile.P
