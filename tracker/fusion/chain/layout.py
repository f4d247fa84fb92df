"""The positions of the chain filter's error states in the covariance.

Equation numbers here and in the neighbouring modules are those of docs/chain.md (this is eq. 2).

Which segments are estimated is defined in `tracker.fusion.segments`. Error state, in this order
(blocks of 3 unless noted):

    p, v | theta per active segment | bg, phi, ba per IMU | scale (length, girth) per active segment
    | joint offset per finger base | offset per marker | value of each fixed axis' row (1)

The first ``n_dynamic`` rows are propagated with the IMU data, the rest only by slow random walks.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.joint_axes import FixedAxis, fixed_axes
from tracker.fusion.segments import EstimatedSegments
from tracker.glove.model import GloveModel, Marker
from tracker.hand.model import HandModel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, IntArray

P, V, THETA = 0, 3, 6  # first rows of position, velocity and rotations


class Blocks(NamedTuple):
    """First row of each block of the error state except p (0) and v (3); ``size``: number of
    rows."""

    theta: int
    bg: int
    phi: int
    ba: int
    scale: int
    joint: int
    marker: int
    axis: int
    size: int


class Drive(NamedTuple):
    """The source of rotation of each of the A active segments: its IMU, else its parent and a
    synergy.

    parent (A,) active row, -1 for the root; imu_of (A,) the IMU on it, -1 for none; source (A,)
    active segment whose flexion drives its own by synergy, -1 for none (always with an IMU); gain
    (A, 2) ratio and offset (rad) of that.
    """

    parent: IntVector
    imu_of: IntVector
    source: IntVector
    gain: Matrix


class ChainSkeleton(NamedTuple):
    """Joint positions of the A active segments.

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
    """Points fixed to active segments (n,), m in their B: nominal (n, 3), which is scaled with the
    segment, and offset (n, 3), which is not."""

    segment: IntVector
    nominal: Matrix
    offset: Matrix


@dataclass(frozen=True, eq=False)
class ChainLayout(EstimatedSegments):
    """Layout of the error state of one hand with one glove, and the tables for its kernels."""

    @cached_property
    def root_lever(self) -> Array:
        """(3,) nominal position in the root's B of the point whose position is the state."""
        j = self.imu_of[0]
        return self.imu_position[j] if j >= 0 else np.zeros(3)

    @cached_property
    def base_of(self) -> IntArray:
        """(A,) number of a finger base among the joint offsets, -1 for other segments."""
        out = np.full(len(self.active), -1, np.int64)
        bases = np.flatnonzero(self.parent == 0)
        out[bases] = np.arange(len(bases))
        return out

    @cached_property
    def drive(self) -> Drive:
        """The source of rotation of each active segment."""
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
        """The joint positions of the active segments."""
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

    @cached_property
    def marker_position(self) -> Array:
        """(M, 3) m, in each marker's B: the points that images show as the patches' centres."""
        return seen_centres(self.glove, self.hand)

    @cached_property
    def fixed_axes(self) -> tuple[FixedAxis, ...]:
        """The axes about which joints do not rotate."""
        return fixed_axes(self.hand, self.names, self.parent)

    @cached_property
    def n_dynamic(self) -> int:
        """Number of rows propagated with the IMU data: p, v and theta."""
        return THETA + 3 * len(self.active)

    @cached_property
    def blocks(self) -> Blocks:
        """The first rows of the blocks of the error state."""
        bg = self.n_dynamic
        phi = bg + 3 * len(self.glove.imus)
        ba = phi + 3 * len(self.glove.imus)
        scale = ba + 3 * len(self.glove.imus)
        joint = scale + 2 * len(self.active)
        marker = joint + 3 * int(np.sum(self.base_of >= 0))
        axis = marker + 3 * len(self.glove.markers)
        size = axis + len(self.fixed_axes)
        return Blocks(THETA, bg, phi, ba, scale, joint, marker, axis, size)


def digit_of(layout: ChainLayout) -> IntArray:
    """(A,) number of the digit that each active segment belongs to, -1 for the root."""
    out = np.full(len(layout.active), -1, np.int64)
    digits = 0
    for a, parent in enumerate(layout.parent):
        if parent == 0:
            out[a], digits = digits, digits + 1
        elif parent > 0:
            out[a] = out[parent]
    return out


# ---- where the centre of a patch's image is: a patch around a finger appears nearer to the bone
#
# A patch covers the angles ±a around the bone, at the distance ρ from its axis. From a direction
# at the angle b around the bone, the mean of its projected area is ρ cos(a) sin(b) beside the
# axis, as of a point at the distance ρ cos(a). From a direction inclined along the bone, it is as
# of a point at the distance ρ (a + sin(a) cos(a)) / (2 sin(a)) . Directions of both kinds occur,
# so the mean of both is used. A circle has another a at each position along the bone.

ACROSS = 0.5  # share of a normal along the bone, above which a patch is on a fingertip
STEPS = 32  # slices of a circle along the bone


def seen_centres(glove: GloveModel, hand: HandModel) -> Array:
    """(M, 3) m, in each marker's B: the points that images show as the centres of the patches."""
    root = hand.segments[hand.root].name
    return np.array([_centre(m, m.segment == root) for m in glove.markers]).reshape(-1, 3)


def _centre(marker: Marker, is_flat: bool) -> Array:
    """(3,) m; patches on the hand's back and on fingertips are flat."""
    if is_flat or abs(marker.normal[0]) > ACROSS:
        return marker.position
    radius = float(np.hypot(marker.position[1], marker.position[2]))
    nearer = _nearer(marker, radius)
    return marker.position * np.array([1.0, nearer, nearer])


def _nearer(marker: Marker, radius: float) -> float:
    """Factor on the distance from the bone's axis."""
    half = marker.size / 2
    if marker.shape == "circle":
        along = half * (2 * (np.arange(STEPS) + 0.5) / STEPS - 1)
        a = np.sqrt(half**2 - along**2) / radius
    else:
        a = np.array([half / radius])
    a = np.minimum(a, np.pi / 2)
    around, inclined = np.sin(a) * np.cos(a), (a + np.sin(a) * np.cos(a)) / 2
    return float(np.sum(around + inclined) / (2 * np.sum(np.sin(a))))
