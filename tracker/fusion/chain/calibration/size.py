"""Uncertainty of the hand's size in a wearer profile, which one camera cannot measure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.reports import length_gain
from tracker.fusion.chain.start.mono_start import SIZE_KEPT


def size_sd(profile: WearerProfile, layout: ChainLayout) -> float:
    """The relative standard deviation of the hand's length."""
    gain, first = length_gain(layout), layout.n_dynamic
    rows = slice(layout.blocks.scale - first, layout.blocks.joint - first, 2)
    variance = max(float(gain @ profile.P[rows, rows] @ gain), 0.0)
    return float(np.sqrt(variance) / (gain @ profile.scale[:, 0]))


def with_kept_size(profile: WearerProfile, layout: ChainLayout) -> WearerProfile:
    """A copy whose sizes are as certain as in a filter after a start with one camera (eq. 43)."""
    first = layout.n_dynamic
    rows = slice(layout.blocks.scale - first, layout.blocks.joint - first)
    P = profile.P.copy()
    P[rows, :] *= SIZE_KEPT
    P[:, rows] *= SIZE_KEPT
    return replace(profile, P=P)


def with_min_size_sd(profile: WearerProfile, layout: ChainLayout, sd: float) -> WearerProfile:
    """A copy whose relative size uncertainty is at least ``sd``.

    The added variance is common to all lengths and girths: in the images of one camera, a hand of
    another size looks the same at another distance (docs/chain.md, eq. 43).
    """
    missing = sd**2 - size_sd(profile, layout) ** 2
    if missing <= 0.0:
        return profile
    first = layout.n_dynamic
    rows = slice(layout.blocks.scale - first, layout.blocks.joint - first)
    P, scale = profile.P.copy(), profile.scale.ravel()
    P[rows, rows] += missing * np.outer(scale, scale)
    return replace(profile, P=P)
