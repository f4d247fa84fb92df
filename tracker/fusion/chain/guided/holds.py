"""Requested poses and the samples of each hold that are used.

A wearer reaches a pose up to half a second late and may release it slightly early; in between, the
hand moves about one posture. The rows of the pose are taken from the sample closest to that
posture.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.records import record
from tracker.hand.poses import EARLY, LATE
from tracker.messages import Array


@record("chain.guided.hold")
@dataclass(eq=False)
class Hold:
    """A pose held from ``begin`` to ``end`` (s, NaN while it lasts); ``held``: not skipped."""

    pose: str
    begin: float
    end: float = np.nan
    held: bool = False

    def may_count(self, t: float) -> bool:
        """Whether the pose has certainly been reached and not yet released at ``t``."""
        return t >= self.begin + LATE and not t > self.end - EARLY

    def is_over(self, t: float) -> bool:
        """Whether no sample later than ``t`` can count."""
        return t > self.end - EARLY


@record("chain.guided.sample", shapes={"posture": "a 3"}, rows="told")
@dataclass(eq=False)
class HeldSample:
    """One sample of a hold: t s; posture (A - 1, 3) rotation vectors of joints; the pose's rows on
    the calibration, in groups."""

    t: float
    posture: Array
    rows: list[ReducedRows]


@record(
    "chain.guided.told", shapes={"H": "m c", "H_own": "m e", "r": "m", "R": "m m", "own": "d 3"}
)
@dataclass(eq=False)
class ReducedRows:
    """Rows of a pose on calibration and synergies, with the posture eliminated.

    Jacobians H (m, C) and H_own (m, 3 d), innovation r (m,) and its noise R (m, m), linearised at
    ``calibration``, a list of the calibration's arrays, and ``own`` (d, 3).
    """

    pose: str
    H: Array
    H_own: Array
    r: Array
    R: Array
    calibration: list[Array]
    own: Array


def chosen(hold: Hold, samples: list[HeldSample], moving: float) -> HeldSample | None:
    """The sample to use from a completed hold, closest to the posture held longest; None where the
    hand did not come to rest.

    ``moving`` rad, all joints together: samples farther from it belong to a moving hand.
    """
    inside = [s for s in samples if hold.may_count(s.t)]
    if not inside:
        return None
    postures = np.array([s.posture.ravel() for s in inside])
    apart = np.linalg.norm(postures[:, None] - postures[None], axis=2)
    company = (apart < moving).sum(axis=1)
    if company.max() * 2 < len(inside):
        return None
    return inside[int(np.lexsort((apart.sum(axis=1), -company))[0])]
