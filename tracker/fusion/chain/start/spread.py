"""How far aside digits point at a start: gravity tells how each is raised, but not that.

Fingers that are spread otherwise than the hand file's lie a patch's distance away by their ends,
where a neighbour's patch of the same hue is as near. So each digit is turned about its base, and
stands where the points support it best, before any blob is called a marker's.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.digits import SupportPoints, posture_scores
from tracker.fusion.chain.kinematics import marker_positions, segment_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.start.search import StereoPoints
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array

TURNS = np.deg2rad([0, -5, 5, -10, 10, -15, 15, -20, 20, -25, 25])  # about the palm's normal
RADIUS = 0.010  # m, within which a point supports a marker: closer than two fingers are
BETTER = 0.5  # markers by which a turned digit must be supported more


def spread(state: ChainState, layout: ChainLayout, seen: StereoPoints) -> Array:
    """R_GB (A, 3, 3) of ``state`` with each digit turned aside to where the points support it."""
    digit, glove = digit_of(layout), layout.glove
    origin, marker = segment_positions(state, layout), marker_positions(state, layout)
    turns = so3.exp(TURNS[:, None] * state.R_GB[0][:, 2])
    points = SupportPoints(seen.p_G, seen.hue, RADIUS)
    out = state.R_GB.copy()
    for d in range(int(digit.max(initial=-1)) + 1):
        segments = np.flatnonzero(digit == d)
        rows = np.flatnonzero(np.isin(layout.marker_segment, segments))
        base = origin[segments[0]]
        way = (seen.p_GC - base) / np.linalg.norm(seen.p_GC - base)
        R = state.R_GB[layout.marker_segment[rows]]
        normal = np.einsum("mij,mj->mi", R, glove.marker_normal[rows])
        score = posture_scores(
            np.ascontiguousarray(np.einsum("kij,mj->kmi", turns, marker[rows] - base)),
            np.ascontiguousarray(np.einsum("kij,mj->kmi", turns, normal)),
            np.eye(3), base, way, glove.marker_hue[rows], points,
        )  # fmt: skip
        best = int(np.argmax(score))
        if score[best] >= score[0] + BETTER:
            out[segments] = turns[best] @ out[segments]
    return out
