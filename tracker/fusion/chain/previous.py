"""Correspondence from the last image's pose: what the IMUs say of the way since is not used."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.fusion.chain.pixels import Prediction


@dataclass(frozen=True, eq=False)
class Previous:
    """Markers after the image at ``t`` (s) as the filter then had them."""

    t: float
    markers: Prediction

    def at(self, t: float, speed: float) -> Prediction:
        """The same places, less certain by what a hand of ``speed`` m/s (SD) goes meanwhile."""
        gone = (speed * (t - self.t)) ** 2
        A = self.markers.A[:, self.markers.rows]
        return replace(self.markers, S=self.markers.S + gone * A @ np.swapaxes(A, -1, -2))
