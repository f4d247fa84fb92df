"""Hands of either side with random angles, as if measured without error."""

from __future__ import annotations

import numpy as np

from tracker.geometry import so3
from tracker.glove import library
from tracker.messages import Estimate, Tracking, Validity
from tracker.streaming.publisher import Names

__all__ = ["posed_estimate", "side_names"]
GLOVES = {"right": "vist-small", "left": "vist-small-left"}


def side_names(side: str) -> Names:
    """For a bundled hand and glove of this side."""
    return Names.of(*library.load(GLOVES[side]))


def posed_estimate(names: Names, seed: int, t: float = 1.25) -> Estimate:
    """A hand for ``names``, of a bundled glove, in an arbitrary pose."""
    hand, rng = names.model, np.random.default_rng(seed)
    _, glove = library.load(GLOVES[names.side])
    angles = rng.uniform(*hand.angle_limits.T)
    R, p = hand.forward(angles, so3.exp(rng.normal(0, 0.6, 3)), rng.uniform(-0.5, 0.5, 3))
    k, j = len(names.keypoints), len(names.angles)
    return Estimate(
        t=t,
        tracking=Tracking.TRACKING,
        keypoints=glove.keypoint_positions(hand, R, p),
        keypoint_q=so3.quat_from_matrix(R)[glove.keypoint_segments(hand)],
        keypoint_state=np.full(k, int(Validity.MEASURED)),
        keypoint_sd=np.full(k, 0.002),
        angles=angles,
        angle_state=np.full(j, int(Validity.MEASURED)),
        segment_R=R,
        segment_p=p,
    )
