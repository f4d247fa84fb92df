"""Motion of the robot's palm: follows the wearer's by a clutch, scaled, with limited speed.

Its orientation is that of the wearer's palm in G (z up). Its position moves by the displacement of
the wearer's palm since the clutch engaged, so that the wearer can put the arm down and raise it
again.
"""

from __future__ import annotations

import numpy as np

from extensions.robot.settings import RobotSettings
from extensions.robot.wearer_hand import WearerHand
from tracker.geometry import so3
from tracker.messages import Array

HOME = np.array([-0.08, 0.0, 0.20])
"""m in the robot's world W, whose z is up and whose table is at 0; x goes away from the wearer."""
LOWEST, HIGHEST = np.array([-0.45, -0.45, 0.03]), np.array([0.45, 0.45, 0.60])
"""m: range of the middle knuckle."""


class PalmCarrier:
    """Computes R (3, 3) and p (3,) m of the robot's palm frame P in W."""

    def __init__(self, settings: RobotSettings) -> None:
        self._settings = settings
        self.reset()

    def reset(self) -> None:
        """Return home and uncouple."""
        self.R, self.p = np.eye(3), HOME.copy()
        self._from: tuple[Array, Array] | None = None  # wearer's and robot's positions at coupling

    def let_go(self) -> None:
        """Uncouple: the next step couples at the wearer's position of that instant."""
        self._from = None

    def step(self, wearer: WearerHand, scale: float, dt: float) -> None:
        """Advance by ``dt`` s; ``wearer`` must be located."""
        if self._from is None:
            self._from = wearer.p_G.copy(), self.p.copy()
        there, here = self._from
        goal = np.clip(here + scale * (wearer.p_G - there), LOWEST, HIGHEST)
        self.p = self.p + _at_most(goal - self.p, self._settings.palm_speed * dt)
        turn = _at_most(so3.log(wearer.R_GB @ self.R.T), self._settings.turn_speed * dt)
        self.R = so3.exp(turn) @ self.R

    @property
    def memory(self) -> Array:
        """(18,) everything that the next step depends on."""
        anchors = np.full(6, np.nan) if self._from is None else np.concatenate(self._from)
        return np.concatenate([self.R.ravel(), self.p, anchors])

    def remember(self, memory: Array) -> None:
        """Restore a state returned by ``memory``."""
        self.R, self.p = memory[:9].reshape(3, 3).copy(), memory[9:12].copy()
        there = memory[12:18]
        self._from = None if np.isnan(there).any() else (there[:3].copy(), there[3:].copy())


def _at_most(vector: Array, length: float) -> Array:
    """(3,) the vector, shortened to ``length`` if it is longer."""
    full = float(np.linalg.norm(vector))
    return vector if full <= length else vector * (length / full)
