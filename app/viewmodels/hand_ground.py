"""The ground under the hand: a grid with a scale, and the axes of G."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.messages import Array

CELL = 0.05  # m
HALF = 6  # cells from the middle to the border
UNDER = 0.06  # m from the lowest point of the hand to the ground, at least, when it is laid
FAR = 0.3  # m above the ground from which it is laid anew
AXIS = CELL  # m, length of the axes that are drawn: the scale stands beside one of them
STRONG, FAINT = 0.34, 0.16  # lines a decimetre apart, and those between


@dataclass(frozen=True, eq=False)
class GroundGrid:
    """Lines (M, 6) m in G from end to end with strength (M,); corner (3,), where the axes stand."""

    ends: Array
    strength: Array
    corner: Array


class HandGround:
    """Stays where it is until the hand leaves it."""

    def __init__(self) -> None:
        self._middle: Array | None = None
        self.grid = GroundGrid(np.empty((0, 6)), np.empty(0), np.zeros(3))

    def follow(self, points: Array) -> bool:
        """Be under a hand's points (N, 3) m; whether the ground has changed."""
        low, at = float(points[:, 2].min()), points.mean(axis=0)
        if self._middle is not None:
            above, aside = low - self._middle[2], np.abs(at - self._middle)[:2].max()
            if 0.0 < above < FAR and aside < 2 * CELL:
                return False
        height = CELL * np.floor((low - UNDER) / CELL)
        self._middle = np.array([*(2 * CELL * np.round(at[:2] / (2 * CELL))), height])
        self.grid = _grid(self._middle)
        return True


def _grid(middle: Array) -> GroundGrid:
    reach, ends, strength = HALF * CELL, [], []
    for k in range(-HALF, HALF + 1):
        share = (STRONG if k % 2 == 0 else FAINT) * (1.0 - (k / (HALF + 1)) ** 2)
        for axis in (0, 1):
            across, along = np.zeros(3), np.zeros(3)
            across[axis], along[1 - axis] = k * CELL, reach
            ends.append([*(middle + across - along), *(middle + across + along)])
            strength.append(share)
    corner = middle + [-2 * CELL, -2 * CELL, 0.0]
    return GroundGrid(np.array(ends), np.array(strength), corner)
