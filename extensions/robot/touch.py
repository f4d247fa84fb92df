"""What a wearer feels of a robot's fingertips: forces as commands to the glove's motors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracker.messages import Array

AGAIN = 0.05  # s after which a motor is told anew while a tip presses
LASTS_MS = 80  # longer than that: a motor does not pause while a tip presses
LEAST_FORCE, MOST_FORCE = 0.1, 8.0  # N: felt at all, and felt most
LEAST, MOST = 60, 255  # amplitudes: a motor turns, and turns fastest
SUDDEN = 1.5  # times the force told last: told at once

Vibrate = Callable[[int, int, int], object]
"""Channel of the motor (thumb 0), amplitude 0..255, ms."""


class TouchMotors:
    """Tells motors what fingertips press, at most 20 times a second each unless it grows."""

    def __init__(self, vibrate: Vibrate) -> None:
        self._vibrate = vibrate
        self._told_at = np.full(5, -np.inf)
        self._told = np.zeros(5)

    def feel(self, t: float, force: Array) -> None:
        """``force`` (5,) N at ``t`` s, thumb first."""
        for channel, newton in enumerate(force):
            if newton < LEAST_FORCE:
                self._told[channel] = 0.0
                continue
            grew = newton > SUDDEN * self._told[channel]
            if grew or t - self._told_at[channel] >= AGAIN or t < self._told_at[channel]:
                self._told_at[channel], self._told[channel] = t, newton
                self._vibrate(channel, amplitude(float(newton)), LASTS_MS)


def amplitude(newton: float) -> int:
    """Of a force; it grows with its root, as what is felt does (Stevens)."""
    share = min(max(newton - LEAST_FORCE, 0.0) / (MOST_FORCE - LEAST_FORCE), 1.0)
    return round(LEAST + (MOST - LEAST) * share**0.5)
