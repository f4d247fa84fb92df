"""A scene for simulated cameras: a grey ball that rolls behind the hand.

``glovetrack simulate -o ball.mcap --scene ball``
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glovetrack.scenes import (
    UNOWNED,
    BackgroundParams,
    RenderParams,
    Room,
    SceneKind,
    Solids,
    StereoRig,
    capsules,
)

Array = NDArray[np.float64]
RADIUS = 0.04  # m
GREY = np.array([140.0, 140.0, 140.0])  # BGR


class Ball:
    """Rolls to and fro along y of the global frame, 0.3 m to each side."""

    def __init__(self, seed: int) -> None:
        self._start = float(np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi))

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """A capsule without length, in G."""
        centre = np.array([[0.45, 0.3 * np.sin(self._start + t), 0.05]])
        return capsules(centre, centre, np.array([RADIUS]), np.array([UNOWNED]), GREY)

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        """Nothing has the colour of a marker."""
        return np.zeros((0, 3)), np.zeros(0), ()


def make_room(rig: StereoRig, seed: int) -> Room:
    return Room(RenderParams(BackgroundParams("plain")), (Ball(seed),))


BALL = SceneKind("ball", "a ball that rolls behind the hand", make_room)
