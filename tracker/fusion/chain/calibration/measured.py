"""A profile from a ruler: only the length of the wearer's hand is known.

One camera cannot distinguish a small, near hand from a larger one farther away; a ruler can.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, profile_of
from tracker.fusion.chain.reports import length_gain
from tracker.fusion.chain.state import initial_state

RULER_SD = 0.002  # m: uncertainty of the wrist crease and of reading a ruler
SHORTEST, LONGEST = 0.13, 0.24  # m, range of human hand lengths from wrist to middle fingertip


def measured_profile(layout: ChainLayout, length: float, sd: float = RULER_SD) -> WearerProfile:
    """The profile of a hand of ``length`` m with standard deviation ``sd`` m, average otherwise.

    The Kalman update of the prior (docs/chain.md, eq. 19) with one scalar. Raises ConfigError for
    an impossible length.
    """
    if not SHORTEST <= length <= LONGEST:
        raise ConfigError(
            notice(
                "calibration.hand_length",
                least_mm=1000 * SHORTEST,
                most_mm=1000 * LONGEST,
                length_mm=1000 * length,
            )
        )
    state = initial_state(layout)
    P = initial_covariance(layout, PriorParams())
    h = np.zeros(len(P))
    h[layout.blocks.scale : layout.blocks.joint : 2] = length_gain(layout)
    gain = P @ h / (h @ P @ h + sd**2)
    change = gain * (length - length_gain(layout) @ state.scale[:, 0])
    state.P = P - np.outer(gain, h @ P)
    scale = state.scale + change[layout.blocks.scale : layout.blocks.joint].reshape(-1, 2)
    return profile_of(replace(state, scale=scale), layout)
