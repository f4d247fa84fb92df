"""Three fingertips in a session: positions, orientations and reported standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from extensions.touch.protocol import FINGERS
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Calibration, Estimate, Validity


@dataclass(frozen=True, eq=False)
class TipTrack:
    """One fingertip at n instants.

    t (n,) s; p_G (n, 3) m of the tip keypoint, R_GB (n, 3, 3) of the last segment, sd (n,) m
    claimed; ``known`` (n,) False where it was lost. ``radius`` m of the last segment.
    """

    t: Array
    p_G: Array
    R_GB: Array
    sd: Array
    known: NDArray[np.bool_]
    radius: float

    def between(self, begin: float, end: float) -> TipTrack:
        """The part from ``begin`` to ``end`` s."""
        part = slice(*np.searchsorted(self.t, [begin, end]))
        return TipTrack(
            self.t[part], self.p_G[part], self.R_GB[part], self.sd[part], self.known[part],
            self.radius,
        )  # fmt: skip


def tip_tracks(
    estimates: Sequence[Estimate],
    hand: HandModel,
    glove: GloveModel,
    calibration: Calibration | None = None,
) -> Mapping[str, TipTrack]:
    """By finger, of those that the hand has; radii by the calibration where it knows them."""
    names = glove.keypoint_names(hand)
    t = np.array([e.t for e in estimates])
    order = np.argsort(t, kind="stable")
    out = {}
    for finger in FINGERS:
        if f"{finger}_tip" not in names or not len(t):
            continue
        row = names.index(f"{finger}_tip")
        p_G = np.array([e.keypoints[row] for e in estimates])[order]
        q = np.array([e.keypoint_q[row] for e in estimates])[order]
        state = np.array([e.keypoint_state[row] for e in estimates])[order]
        known = (state != Validity.LOST) & np.isfinite(p_G).all(axis=1) & np.isfinite(q).all(axis=1)
        q = np.where(known[:, None], q, [0.0, 0.0, 0.0, 1.0])
        sd = np.array([e.keypoint_sd[row] for e in estimates])[order]
        radius = _radius(hand, f"{finger}_distal", calibration)
        out[finger] = TipTrack(t[order], p_G, so3.matrix_from_quat(q), sd, known, radius)
    return out


def _radius(hand: HandModel, segment: str, calibration: Calibration | None) -> float:
    radius = hand.segments[hand.index[segment]].radius
    if calibration is None or segment not in calibration.segments:
        return radius
    girth = float(calibration.scale[calibration.segments.index(segment), 2])
    return radius * girth if np.isfinite(girth) else radius
