"""Where the robot's fingertips are to go, from where the wearer's are.

Each finger's reach from its knuckle is scaled by the ratio of the fingers' lengths. Where the
wearer's thumb comes near a finger, what is between the two tips counts instead, so that a pinch is
one for every wearer (the idea of the vectors of DexPilot, Handa et al. 2020, section IV).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from extensions.robot.worn import FINGERS, WornHand
from tracker.messages import Array

NEAR, FAR = 0.020, 0.060  # m between the wearer's tips: the pinch counts alone, and not at all
TOUCH = 0.013  # m between a wearer's tips whose pads touch
PRESS = 0.003  # m by which the robot's are then to be nearer than touching: a grip holds


class TargetMap:
    """For one robot: knuckle (5, 3) m in P, length (5,) m, radius (5,) m of its fingers; NaN where
    it has no such finger."""

    def __init__(self, knuckle: Array, length: Array, radius: Array, scale: float = 1.0) -> None:
        self._knuckle, self._length, self._radius = knuckle, length, radius
        self.scale = scale

    def targets(self, worn: WornHand) -> tuple[Array, NDArray[np.bool_]]:
        """(5, 3) m in P, and which of them are known (5,)."""
        known = worn.known & np.isfinite(self._length)
        share = self.scale * self._length / worn.length
        tips = self._knuckle + share[:, None] * (worn.tip - worn.knuckle)
        if known[0]:
            self._close(tips, worn, known)
        return tips, known

    def _close(self, tips: Array, worn: WornHand, known: NDArray[np.bool_]) -> None:
        """Let thumb and fingers that are near each other meet as the wearer's do."""
        weights, errors = np.zeros(len(FINGERS)), np.zeros((len(FINGERS), 3))
        for f in range(1, len(FINGERS)):
            if not known[f]:
                continue
            gap = worn.tip[f] - worn.tip[0]
            distance = float(np.linalg.norm(gap))
            weights[f] = np.clip((FAR - distance) / (FAR - NEAR), 0.0, 1.0)
            touch = self._radius[f] + self._radius[0] - PRESS
            wanted = touch + max(distance - TOUCH, 0.0)
            errors[f] = tips[f] - tips[0] - gap * (wanted / max(distance, 1e-6))
        thumb = weights @ errors / (1.0 + weights.sum())
        tips[0] += thumb
        tips[1:] -= weights[1:, None] * (errors[1:] - thumb)
