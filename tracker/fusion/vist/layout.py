"""The segments that the paper's filter estimates and the positions of their error states.

A segment with an IMU has 23 states and 21 errors, in this order (3 each; the quaternions' errors
are local rotation vectors):  p_GI, v_GI, theta (q_GI), b_g, b_a, lambda_B, phi (q_IB).
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.layout import ChainLayout
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray

P, V, TH, BG, BA, LAM, PHI = 0, 3, 6, 9, 12, 15, 18
ERRORS = 21


class VistLayout:
    """Arrays of one hand with one glove. Rows are segments with an IMU, parents first. The states
    of each are those of eqs. 7 and 8 of Lee et al. 2021, doi:10.1126/scirobotics.abe1315.

    Markers of segments without an IMU have no state to correct and are omitted:
    ``used_markers`` (m,) are the rows of the others in the glove. ``chain`` is the layout of the
    reduced glove, which the shared stages (search, output) use.

    Raises ConfigError for a segment without IMU within a finger.
    """

    def __init__(self, hand: HandModel, glove: GloveModel) -> None:
        sensed = [imu.segment for imu in glove.imus]
        self.hand, self.glove = hand, glove
        self.used_markers: IntArray = np.array(
            [k for k, m in enumerate(glove.markers) if m.segment in sensed], np.int64
        )
        reduced = replace(glove, markers=tuple(glove.markers[k] for k in self.used_markers))
        self.chain = ChainLayout(hand, reduced)
        gaps = [name for name in self.chain.names if name not in sensed]
        if gaps:
            raise ConfigError(notice("engine.vist_gaps", glove=glove.name, segments=gaps))
        if len(set(sensed)) < len(sensed):
            raise ConfigError(notice("engine.vist_extra", glove=glove.name))

    @property
    def n(self) -> int:
        """Number of segments."""
        return len(self.chain.active)

    @property
    def size(self) -> int:
        """Number of error states."""
        return ERRORS * self.n

    @cached_property
    def imu_of(self) -> IntArray:
        """(n,) number of each segment's IMU in a packet."""
        return self.chain.imu_of

    @cached_property
    def imu_position(self) -> Array:
        """(n, 3) m, nominal, of each IMU in its B."""
        return self.chain.imu_position[self.imu_of]

    @cached_property
    def R_IB(self) -> Array:
        """(n, 3, 3) nominal mountings."""
        return self.chain.R_IB[self.imu_of]

    @cached_property
    def marker_lever(self) -> Array:
        """(m, 3) m, nominal, from the IMU to each used marker in its B."""
        marker = self.chain.glove.marker_position
        return marker - self.imu_position[self.chain.marker_segment]

    @cached_property
    def tip_lever(self) -> Array:
        """(n, 3) m, nominal, from the IMU to the segment's far end."""
        end = np.zeros((self.n, 3))
        end[:, 0] = [self.hand.segments[h].length for h in self.chain.active]
        return end - self.imu_position
