"""Poses that were announced, and which instants of one count.

A wearer reaches a pose up to half a second late and may let it go a little early; between, he
moves about one posture. The rows of the pose are those of the instant nearest to it.
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
    """A pose held from ``begin`` to ``end`` (s, NaN while it goes on); ``held``: as announced."""

    pose: str
    begin: float
    end: float = np.nan
    held: bool = False

    def may_count(self, t: float) -> bool:
        """Whether an instant is one at which the pose was certainly reached and not let go."""
        return t >= self.begin + LATE and not t > self.end - EARLY

    def is_over(self, t: float) -> bool:
        """Whether no later instant than ``t`` counts."""
        return t > self.end - EARLY


@record("chain.guided.sample", shapes={"posture": "a 3"}, rows="told")
@dataclass(eq=False)
class HeldSample:
    """One instant of a hold: t s; posture (A - 1, 3) rotation vectors of joints; the pose's rows on
    the calibration, in groups."""

    t: float
    posture: Array
    rows: list[ReducedRows]


@record(
    "chain.guided.told", shapes={"H": "m C", "H_own": "m e", "r": "m", "R": "m m", "own": "d 3"}
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
    """The sample that counts of a hold that is over, nearest to the posture held longest; None
    where the hand came to no rest.

    ``moving`` rad, all joints together: samples farther from it are of a moving hand.
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
