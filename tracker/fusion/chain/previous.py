"""Correspondence from the last image's pose: what the IMUs say of the way since is not used."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.prediction import Prediction


@record("chain.previous")
@dataclass(frozen=True, eq=False)
class PreviousPrediction:
    """Markers after the image at ``t`` (s) as the filter then had them."""

    t: float
    markers: Prediction

    def at(self, t: float, speed: float) -> Prediction:
        """The same positions, less certain by what a hand of ``speed`` m/s (sd) goes meanwhile."""
        gone = (speed * (t - self.t)) ** 2
        A = self.markers.A[:, self.markers.rows]
        S = self.markers.S + gone * A @ np.swapaxes(A, -1, -2)
        return self.markers._replace(S=np.ascontiguousarray(S))
