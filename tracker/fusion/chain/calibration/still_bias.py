"""Gyro biases measured on a resting hand, made part of what is known of a wearer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.messages import Array

FLOOR = np.deg2rad(0.1)
"""rad/s: what a hand laid on a table still turns, and the bias drifts until it is used."""


def with_gyro_bias(
    profile: WearerProfile, layout: ChainLayout, bias: Array, sd: Array
) -> WearerProfile:
    """``profile`` with the biases (n, 3) rad/s and their deviations (n,) of each IMU; rows of NaN
    leave an IMU as it was."""
    known = np.flatnonzero(np.all(np.isfinite(bias), axis=1) & np.isfinite(sd))
    bg, P = profile.bg.copy(), profile.P.copy()
    for j in known:
        rows = layout.blocks.bg - layout.n_dynamic + 3 * j + np.arange(3)
        P[rows, :] = 0.0
        P[:, rows] = 0.0
        P[rows, rows] = float(np.hypot(sd[j], FLOOR)) ** 2
        bg[j] = bias[j]
    return replace(profile, bg=bg, P=P)
