"""The movement of an alignment: the hand turns in all directions, the wrist rests on a point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array
from tracker.simulation.motion import Poses

WRIST = np.array([0.4, -0.2, 0.9])


@dataclass(frozen=True)
class Turning:
    """Rotation about the three axes of the hand by sines, ``wander`` m of the wrist."""

    joints: int
    duration: float = 15.0
    about: tuple[float, float, float] = (0.9, 0.7, 0.5)  # rad
    wander: float = 0.001
    follows_synergies: bool = True

    def poses(self, t: Array) -> Poses:
        """The hand at the times t (n,) s."""
        t = np.clip(np.asarray(t, float), 0.0, self.duration)
        ease = np.clip(t / 1.5, 0.0, 1.0)
        ease = ease**3 * (10 - 15 * ease + 6 * ease**2)  # at rest first
        a, b, c = (
            ease * most * np.sin(2 * np.pi * f * t)
            for most, f in zip(self.about, (0.31, 0.47, 0.23), strict=True)
        )
        zero = np.zeros_like(t)
        R = so3.exp(np.stack([zero, zero, c], 1)) @ so3.exp(np.stack([zero, b, zero], 1))
        R = R @ so3.exp(np.stack([a, zero, zero], 1))
        moved = np.stack([np.sin(1.3 * t), np.sin(1.7 * t), np.sin(0.9 * t)], axis=1)
        p = WRIST + self.wander * ease[:, None] * moved
        return Poses(np.zeros((len(t), self.joints)), R, p)
