"""The segments of a hand that a filter estimates, and the segments that carry its sensors.

Estimated ("active") segments are those with an IMU or a marker and all their ancestors.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray


@dataclass(frozen=True, eq=False)
class EstimatedSegments:
    """Index arrays of one hand with one glove. Rows of segments here are *active* rows."""

    hand: HandModel
    glove: GloveModel

    @cached_property
    def active(self) -> IntArray:
        """(A,) rows of the hand's estimated segments, parents first."""
        wanted = {0}
        sensed = [*(i.segment for i in self.glove.imus), *(m.segment for m in self.glove.markers)]
        for name in sensed:
            row = self.hand.index[name]
            while row >= 0:
                wanted.add(row)
                row = self.hand.parent[row]
        return np.array(sorted(wanted), np.int64)

    @cached_property
    def row_of(self) -> dict[int, int]:
        """Maps a hand row to its active row."""
        return {int(h): a for a, h in enumerate(self.active)}

    @cached_property
    def names(self) -> tuple[str, ...]:
        return tuple(self.hand.segment_names[h] for h in self.active)

    @cached_property
    def parent(self) -> IntArray:
        """(A,) active row of each parent, -1 for the root."""
        return np.array([self.row_of.get(self.hand.parent[h], -1) for h in self.active], np.int64)

    @cached_property
    def origin(self) -> Array:
        """(A, 3) joint in the parent's B, m."""
        return np.array([self.hand.segments[h].origin for h in self.active])

    @cached_property
    def R_rest(self) -> Array:
        return np.array([self.hand.segments[h].R_rest for h in self.active])

    @cached_property
    def imu_segment(self) -> IntArray:
        """(n,) active row of each IMU."""
        return np.array([self.row_of[h] for h in self.glove.imu_segment(self.hand)], np.int64)

    @cached_property
    def imu_position(self) -> Array:
        """(n, 3) of I in B, m."""
        return np.array([i.position for i in self.glove.imus], float).reshape(-1, 3)

    @cached_property
    def R_IB(self) -> Array:
        """(n, 3, 3) nominal mountings."""
        return np.array([i.R_BI.T for i in self.glove.imus], float).reshape(-1, 3, 3)

    @cached_property
    def imu_of(self) -> IntArray:
        """(A,) IMU on each active segment, -1 if none."""
        out = np.full(len(self.active), -1, np.int64)
        for j, s in enumerate(self.imu_segment):
            out[s] = j
        return out

    @cached_property
    def marker_segment(self) -> IntArray:
        """(M,) active row of each marker."""
        rows = [self.row_of[h] for h in self.glove.marker_segment(self.hand)]
        return np.array(rows, np.int64)
