"""Time stamps of simulated images, with jitter like a real camera's."""

from __future__ import annotations

import numpy as np

from tracker.base.clock import nanoseconds, seconds
from tracker.simulation.smooth import rng_for

MOST_JITTER = 3.0
"""Standard deviations by which a time stamp is early or late at most."""
LEAST_STEP = 1e-3
"""s between the time stamps of two images."""


class JitteredStamps:
    """Adds jitter to the time stamps of successive images without changing their order."""

    def __init__(self, sd: float, seed: int) -> None:
        self._sd, self._rng, self._last = sd, rng_for(seed, "stamps"), -np.inf

    def stamp(self, t: float) -> float:
        """The stamp (s) of the next image, which was exposed at ``t``."""
        if self._sd > 0.0:
            limit = MOST_JITTER * self._sd
            late = float(np.clip(self._rng.normal(0, self._sd), -limit, limit))
            t = seconds(nanoseconds(max(t + late, self._last + LEAST_STEP)))
        self._last = t
        return t
