"""Haptic feedback: forces on the robot's fingertips become commands to the glove's motors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracker.messages import Array

AGAIN = 0.05  # s between commands to a motor while a tip presses
LASTS_MS = 80  # longer than `AGAIN`, so that a motor does not pause while a tip presses
LEAST_FORCE, MOST_FORCE = 0.1, 8.0  # N: threshold and full amplitude
LEAST, MOST = 60, 255  # amplitudes at which a motor starts to turn and turns fastest
SUDDEN = 1.5  # times the last force: sent at once

Vibrate = Callable[[int, int, int], object]
"""Takes the motor's channel (thumb 0), amplitude 0..255 and duration in ms."""


class TouchMotors:
    """Sends fingertip forces to motors, at most 20 times a second each unless a force grows."""

    def __init__(self, vibrate: Vibrate) -> None:
        self._vibrate = vibrate
        self._sent_at = np.full(5, -np.inf)
        self._sent = np.zeros(5)

    def feel(self, t: float, force: Array) -> None:
        """Take the forces (5,) N at ``t`` s, thumb first."""
        for channel, newton in enumerate(force):
            if newton < LEAST_FORCE:
                self._sent[channel] = 0.0
                continue
            grew = newton > SUDDEN * self._sent[channel]
            if grew or t - self._sent_at[channel] >= AGAIN or t < self._sent_at[channel]:
                self._sent_at[channel], self._sent[channel] = t, newton
                self._vibrate(channel, amplitude(float(newton)), LASTS_MS)


def amplitude(newton: float) -> int:
    """Amplitude of a force. It grows with the square root, as the sensation does (Stevens)."""
    share = min(max(newton - LEAST_FORCE, 0.0) / (MOST_FORCE - LEAST_FORCE), 1.0)
    return round(LEAST + (MOST - LEAST) * share**0.5)
