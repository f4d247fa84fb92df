"""Which segments a filter estimates and where each error state stands in the covariance.

Equation numbers here and beside are those of docs/chain.md (this is eq. 2).

Estimated ("active") segments are those with an IMU or a marker and all their ancestors. Error
state, in this order (blocks of 3 unless said):

    p, v | theta per active segment | bg, phi, ba per IMU | scale (length, girth) per active segment
    | joint offset per finger base | offset per marker

The first ``n_dynamic`` rows move with the IMU data, the rest only by slow random walks.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, IntArray


class Blocks(NamedTuple):
    """First row of each block of the error state but p (0) and v (3); ``size`` is all rows."""

    theta: int
    bg: int
    phi: int
    ba: int
    scale: int
    joint: int
    marker: int
    size: int


class Drive(NamedTuple):
    """What turns each of the A active segments: its IMU, else its parent and a synergy.

    parent (A,) active row, -1 for the root; imu_of (A,) the IMU on it, -1 for none; source (A,)
    active segment whose flexion drives its own by synergy, -1 for none (always with an IMU); gain
    (A, 2) ratio and offset (rad) of that.
    """

    parent: IntVector
    imu_of: IntVector
    source: IntVector
    gain: Matrix


class ChainSkeleton(NamedTuple):
    """Where the joints of the A active segments stand.

    parent (A,) active row, -1 for the root; origin (A, 3) m joint in the parent's B; base_of (A,)
    number among the joint offsets, -1 for none; lever (3,) m in the root's B, of the point whose
    position is the state.
    """

    parent: IntVector
    origin: Matrix
    base_of: IntVector
    lever: Vector


class MountedImus(NamedTuple):
    """segment (n,) active row of each IMU, position (n, 3) m of I in its B."""

    segment: IntVector
    position: Matrix


class Points(NamedTuple):
    """Points fixed to active segments (n,), m in their B: nominal (n, 3), which grows with the
    segment's scale, and offset (n, 3), which does not."""

    segment: IntVector
    nominal: Matrix
    offset: Matrix


@dataclass(frozen=True, eq=False)
class ChainLayout:
    """Index arrays of one hand with one glove. Rows of segments here are *active* rows."""

    hand: HandModel
    glove: GloveModel

    @cached_property
    def active(self) -> IntArray:
        """(A,) rows of the hand's segments that are estimated, parents first."""
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
        """Hand row to active row."""
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
    def root_lever(self) -> Array:
        """(3,) nominal position in the root's B of the point whose position is the state."""
        j = self.imu_of[0]
        return self.imu_position[j] if j >= 0 else np.zeros(3)

    @cached_property
    def marker_segment(self) -> IntArray:
        """(M,) active row of each marker."""
        rows = [self.row_of[h] for h in self.glove.marker_segment(self.hand)]
        return np.array(rows, np.int64)

    @cached_property
    def base_of(self) -> IntArray:
        """(A,) number of a finger base among the joint offsets, -1 for other segments."""
        out = np.full(len(self.active), -1, np.int64)
        bases = np.flatnonzero(self.parent == 0)
        out[bases] = np.arange(len(bases))
        return out

    @cached_property
    def drive(self) -> Drive:
        """What turns each active segment."""
        hand = self.hand
        source = np.full(len(self.active), -1, np.int64)
        gain = np.zeros((len(self.active), 2))
        child_of = {f"{j.name}_flexion": hand.index[j.child] for j in hand.joints}
        for s in hand.synergies:
            child, of = self.row_of.get(child_of.get(s.angle, -1)), child_of.get(s.of, -1)
            if child is not None and of in self.row_of and self.imu_of[child] < 0:
                source[child], gain[child] = self.row_of[of], (s.ratio, s.offset)
        return Drive(self.parent, self.imu_of, source, gain)

    @cached_property
    def skeleton(self) -> ChainSkeleton:
        """Where the joints of the active segments stand."""
        return ChainSkeleton(self.parent, self.origin, self.base_of, self.root_lever)

    @cached_property
    def imus(self) -> MountedImus:
        """Where the IMUs are mounted."""
        return MountedImus(self.imu_segment, self.imu_position)

    @cached_property
    def tips(self) -> Points:
        """The nominal far ends of the active segments."""
        end = np.zeros((len(self.active), 3))
        end[:, 0] = [self.hand.segments[h].length for h in self.active]
        return Points(np.arange(len(self.active)), end, np.zeros_like(end))

    # Where each block starts.
    p = 0
    v = 3
    theta = 6

    @cached_property
    def n_dynamic(self) -> int:
        return 6 + 3 * len(self.active)

    @cached_property
    def blocks(self) -> Blocks:
        """Where the blocks of the error state start, for kernels."""
        bg = self.n_dynamic
        phi = bg + 3 * len(self.glove.imus)
        ba = phi + 3 * len(self.glove.imus)
        scale = ba + 3 * len(self.glove.imus)
        joint = scale + 2 * len(self.active)
        marker = joint + 3 * int(np.sum(self.base_of >= 0))
        size = marker + 3 * len(self.glove.markers)
        return Blocks(self.theta, bg, phi, ba, scale, joint, marker, size)

    @property
    def bg(self) -> int:
        return self.blocks.bg

    @property
    def phi(self) -> int:
        return self.blocks.phi

    @property
    def ba(self) -> int:
        return self.blocks.ba

    @property
    def scale(self) -> int:
        return self.blocks.scale

    @property
    def joint(self) -> int:
        return self.blocks.joint

    @property
    def marker(self) -> int:
        return self.blocks.marker

    @property
    def size(self) -> int:
        """Number of error states."""
        return self.blocks.size
