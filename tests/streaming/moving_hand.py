"""A hand with known velocities."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.messages import Estimate, Motion
from tracker.streaming.publisher import Names

__all__ = ["turning"]


def turning(e: Estimate, names: Names) -> Estimate:
    """The estimate of a rigid hand that rotates about G's z at 2 rad/s and rises at 0.5 m/s."""
    w = np.array([0.0, 0.0, 2.0])
    linear = np.cross(w, e.keypoints) + [0.0, 0.0, 0.5]
    k, j = len(names.keypoints), len(names.angles)
    sds = np.full(k, 0.02), np.full(k, 0.03)
    rates = np.linspace(-1, 1, j), np.full(j, 0.05), np.full(j, 0.01)
    return replace(e, seq=7, motion=Motion(linear, np.tile(w, (k, 1)), *sds, *rates))
