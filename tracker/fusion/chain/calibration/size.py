"""Uncertainty of the hand's size in a wearer profile, which one camera cannot measure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.reports import length_gain
from tracker.fusion.chain.start.mono_start import SIZE_KEPT
from tracker.messages import Array


def size_sd(profile: WearerProfile, layout: ChainLayout) -> float:
    """The relative standard deviation of the hand's length."""
    gain, first = length_gain(layout), layout.n_dynamic
    rows = slice(layout.blocks.scale - first, layout.blocks.joint - first, 2)
    variance = max(float(gain @ profile.P[rows, rows] @ gain), 0.0)
    return float(np.sqrt(variance) / (gain @ profile.scale[:, 0]))


def size_index(scale: Array, layout: ChainLayout) -> float:
    """The size that the distance of a hand in an image is proportional to, from scale (A, 2):
    relative, the mean of length and girth."""
    gain = length_gain(layout)
    return float((gain @ scale[:, 0] / gain.sum() + scale[:, 1].mean()) / 2)


def size_index_gain(layout: ChainLayout) -> Array:
    """(C,) the derivative of `size_index` by the errors of a calibration."""
    first, gain, n = layout.n_dynamic, length_gain(layout), len(layout.active)
    out = np.zeros(layout.blocks.size - first)
    shares = np.column_stack([gain / (2 * gain.sum()), np.full(n, 0.5 / n)])
    out[layout.blocks.scale - first : layout.blocks.joint - first] = shares.ravel()
    return out


def distance_sd(profile: WearerProfile, layout: ChainLayout) -> float:
    """The relative standard deviation of `size_index`: of the distance from one camera."""
    gain = size_index_gain(layout)
    variance = max(float(gain @ profile.P @ gain), 0.0)
    return float(np.sqrt(variance) / size_index(profile.scale, layout))


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


def with_min_distance_sd(profile: WearerProfile, layout: ChainLayout, sd: float) -> WearerProfile:
    """A copy whose relative `distance_sd` is at least ``sd``; the added variance is common to all
    girths."""
    missing = sd**2 - distance_sd(profile, layout) ** 2
    if missing <= 0.0:
        return profile
    first = layout.n_dynamic
    rows = np.arange(layout.blocks.scale - first + 1, layout.blocks.joint - first, 2)
    P, girth = profile.P.copy(), profile.scale[:, 1]
    common = size_index(profile.scale, layout) / (girth.mean() / 2)
    P[np.ix_(rows, rows)] += missing * common**2 * np.outer(girth, girth)
    return replace(profile, P=P)
