"""Finger rotations as avatars take them: parent-local, left-handed, zero in the T-pose.

VMC carries Unity's axes (left-handed; x right, y up, z forward) and a VRM avatar's bones, which are
all parallel to these axes in the T-pose. There the arms point sideways with the palms down, so a
hand segment's B (x to the tip, y = z × x, z dorsal) lies along

    right hand: x → +X, y → +Z, z → +Y          left hand: x → -X, y → -Z, z → +Y

The T-pose of a hand is its hand file's rest: all joint angles zero.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.geometry import so3
from tracker.geometry.kernels import quats
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate

# Rows: X, Y, Z of Unity; columns: x, y, z of B (or of G). Determinant -1: they change handedness.
M_AVATAR = {
    "right": np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "left": np.array([[-1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),
}
M_WORLD = np.array([[0.0, -1, 0], [0, 0, 1], [1, 0, 0]])  # of G with x forward


class AvatarHand:
    """A hand's bones in an avatar's axes.

    With N_i = R_i Rest_i^T the rotation of a bone from the T-pose, the local one is N_parent^T N_i.
    In an estimate a bone may also turn about axes that its joint has no angle for. Where the poses
    of segments are not known, the local rotation is Rest_i J_i Rest_i^T, J_i the joint's rotation
    by its angles.
    """

    def __init__(self, hand: HandModel) -> None:
        self._columns = np.array(hand.axis_columns)  # (S, 3), -1 for none
        self._parent = np.array(hand.parent)
        M = M_AVATAR[hand.side]
        rest, _ = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
        self._axes = M @ rest  # (S, 3, 3): B's axes in Unity's, in the T-pose
        self.offsets = np.zeros((len(hand.segments), 3))
        """(S, 3) m: every bone's origin in its parent bone's axes."""
        for i, segment in enumerate(hand.segments):
            if hand.parent[i] >= 0:
                self.offsets[i] = self._axes[hand.parent[i]] @ segment.origin

    def poses(self, bones: Sequence[int], estimate: Estimate) -> Array:
        """Local poses (n, 7) of the segments ``bones``: position (m), quaternion xyzw, w ≥ 0."""
        i = np.asarray(bones)
        a = self._parent[i]
        R, p = estimate.segment_R, estimate.segment_p
        from_G = self._axes[a] @ R[a].transpose(0, 2, 1)
        out = np.empty((len(i), 7))
        out[:, :3] = (from_G @ (p[i] - p[a])[:, :, None])[:, :, 0]
        out[:, 3:] = quats(from_G @ R[i] @ self._axes[i].transpose(0, 2, 1))
        unknown = np.flatnonzero(~np.isfinite(out).all(axis=1))
        if len(unknown):
            rows = i[unknown]
            out[unknown, :3] = self.offsets[rows]
            out[unknown, 3:] = self.rotations(rows.tolist(), estimate.angles)
        return out

    def rotations(self, bones: Sequence[int], angles: Array) -> Array:
        """Local rotations (n, 4) xyzw, w ≥ 0, of the segments ``bones`` from angles (J,) rad.

        A J A^T turns about the axis of J in Unity's axes, the other way since A changes handedness.
        """
        rows = list(bones)
        half = np.append(angles, 0.0)[self._columns[rows]] / 2  # a missing joint does not turn
        q = _zyx(np.sin(half), np.cos(half))
        q[:, :3] = -np.einsum("nij,nj->ni", self._axes[rows], q[:, :3])
        return np.where(q[:, 3:] < 0, -q, q)


def _zyx(s: Array, c: Array) -> Array:
    """(n, 4) quaternions xyzw of Rz Ry Rx from sines and cosines (n, 3) of half their angles."""
    (sz, sy, sx), (cz, cy, cx) = s.T, c.T
    return np.column_stack(
        [
            cz * cy * sx - sz * sy * cx,
            cz * sy * cx + sz * cy * sx,
            sz * cy * cx - cz * sy * sx,
            cz * cy * cx + sz * sy * sx,
        ]
    )


def quaternions(R: Array) -> Array:
    """(n, 4) xyzw with w ≥ 0 of rotation matrices (n, 3, 3), quicker for many at once than
    `tracker.geometry.so3`."""
    q = Rotation.from_matrix(R).as_quat(canonical=True)
    return np.asarray(q)


def unity_pose(p_G: Array, q_GB: Array) -> tuple[Array, Array]:
    """Position (3,) m and quaternion (4,) xyzw in Unity's world of a pose in G.

    A flat hand, palm down, pointing along G's x has no rotation: Z to the fingers, Y dorsal.
    """
    R = M_WORLD @ so3.matrix_from_quat(q_GB) @ M_WORLD.T
    return M_WORLD @ p_G, so3.quat_from_matrix(R)


def unity_velocity(linear: Array, angular: Array) -> tuple[Array, Array]:
    """Velocity and angular velocity (..., 3) in Unity's world of those in G. Unity turns about an
    axis by the left hand, so its angular velocity has the other sign."""
    return linear @ M_WORLD.T, -angular @ M_WORLD.T
