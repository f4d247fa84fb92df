"""Where the robot's palm is carried: after the wearer's, by a clutch, scaled and never too fast.

It turns as the wearer's palm is turned in G (z up). Its place follows by the way that the wearer's
went since the clutch engaged, so that an arm can be laid down and lifted anew.
"""

from __future__ import annotations

import numpy as np

from extensions.robot.settings import RobotSettings
from extensions.robot.worn import WornHand
from tracker.geometry import so3
from tracker.messages import Array

HOME = np.array([-0.08, 0.0, 0.20])
"""m in the robot's world W, whose z is up and whose table is at 0; x goes away from the wearer."""
LOWEST, HIGHEST = np.array([-0.45, -0.45, 0.03]), np.array([0.45, 0.45, 0.60])
"""m: where the middle knuckle may be."""


class PalmCarrier:
    """R (3, 3) and p (3,) m of the robot's palm frame P in W."""

    def __init__(self, settings: RobotSettings) -> None:
        self._settings = settings
        self.reset()

    def reset(self) -> None:
        """Home, and not coupled to where the wearer was."""
        self.R, self.p = np.eye(3), HOME.copy()
        self._from: tuple[Array, Array] | None = None  # the wearer's place and the robot's then

    def let_go(self) -> None:
        """The next step couples anew, at the place that the wearer is at then."""
        self._from = None

    def step(self, worn: WornHand, scale: float, dt: float) -> None:
        """``dt`` s later; ``worn`` is located."""
        if self._from is None:
            self._from = worn.p_G.copy(), self.p.copy()
        there, here = self._from
        goal = np.clip(here + scale * (worn.p_G - there), LOWEST, HIGHEST)
        self.p = self.p + _at_most(goal - self.p, self._settings.palm_speed * dt)
        turn = _at_most(so3.log(worn.R_GB @ self.R.T), self._settings.turn_speed * dt)
        self.R = so3.exp(turn) @ self.R

    @property
    def memory(self) -> Array:
        """(18,) all that the next step depends on."""
        anchors = np.full(6, np.nan) if self._from is None else np.concatenate(self._from)
        return np.concatenate([self.R.ravel(), self.p, anchors])

    def remember(self, memory: Array) -> None:
        """As it was when ``memory`` was asked for."""
        self.R, self.p = memory[:9].reshape(3, 3).copy(), memory[9:12].copy()
        there = memory[12:18]
        self._from = None if np.isnan(there).any() else (there[:3].copy(), there[3:].copy())


def _at_most(way: Array, length: float) -> Array:
    """(3,) a way, cut to ``length``."""
    full = float(np.linalg.norm(way))
    return way if full <= length else way * (length / full)
