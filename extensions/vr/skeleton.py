"""The hand as OpenVR's skeleton of 31 bones, each relative to its parent.

OpenVR's world has OpenXR's axes (x right, y up, -z forward). Bones have those of Valve's hand
models: on the left hand x points to the tip and y out of the palm; the right hand is its mirror
image with all axes reversed. The wrist's z points to the fingers and y to the thumb.
Sources: github.com/ValveSoftware/openvr/wiki/Hand-Skeleton and the reference poses there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from extensions.osc.vmc_pose import quaternions
from tracker.geometry import so3
from tracker.hand.names import CHAINS
from tracker.hand.openxr import JOINTS, WRIST, OpenXrHand
from tracker.messages import Array, IntArray, Validity

ROOT, WRIST_BONE, BONES = 0, 1, 31
DIGITS = {f: [j for j in JOINTS if j.startswith(f"{f}_")] for f in CHAINS}
"""OpenXR's joints of each digit, base first: the bones of the digit, in OpenVR's order."""

_LENGTHS = [len(joints) for joints in DIGITS.values()]
_FIRST = 2 + np.cumsum([0, *_LENGTHS[:-1]])  # the first bone of each digit
PARENT = np.array(
    [
        *(ROOT, ROOT),
        *(WRIST_BONE if k in _FIRST else k - 1 for k in range(2, 2 + sum(_LENGTHS))),
        *[ROOT] * len(DIGITS),
    ]
)
"""For each bone, the one to which it is relative."""
SOURCE = np.array([*range(2 + sum(_LENGTHS)), *(_FIRST + _LENGTHS - 2)])
"""For each bone, the one whose pose it has: an auxiliary one repeats its digit's last joint before
the tip."""

# Columns: a bone's x, y, z in the axes of OpenXR's joint (-z to the tip, y out of the back).
A_BONE = {
    "left": np.array([[0.0, 0, -1], [0, -1, 0], [-1, 0, 0]]),
    "right": np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]),
}
A_WRIST = {
    "left": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]]),
    "right": np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]),
}
MIRROR_X = np.diag([-1.0, 1.0, 1.0])
MIRROR_Z = np.diag([1.0, 1.0, -1.0])


@dataclass(frozen=True, eq=False)
class RigidMotion:
    """A rigid motion: R (3, 3) and p (3,) m."""

    R: Array
    p: Array

    def __matmul__(self, other: RigidMotion) -> RigidMotion:
        return RigidMotion(self.R @ other.R, self.p + self.R @ other.p)

    @property
    def inverse(self) -> RigidMotion:
        return RigidMotion(self.R.T, -(self.R.T @ self.p))


def in_unity(R: Array, p: Array) -> Array:
    """(n, 7) positions and quaternions xyzw in Unity's axes, of poses R (n, 3, 3) and p (n, 3) in
    OpenVR's."""
    return np.column_stack([p @ MIRROR_Z, quaternions(MIRROR_Z @ R @ MIRROR_Z)])


def _held(side: str) -> RigidMotion:
    """The wrist bone in the axes of a Valve Index controller that is held (its reference pose)."""
    w, x, y, z = -0.055147, -0.078608, -0.920279, 0.379296
    R = so3.matrix_from_quat(np.array([x, y, z, w]) / np.linalg.norm([x, y, z, w]))
    p = np.array([-0.034038, 0.036503, 0.164722])
    if side == "left":
        return RigidMotion(R, p)
    return RigidMotion(MIRROR_X @ R @ MIRROR_X, MIRROR_X @ p)


HELD = {side: _held(side) for side in ("left", "right")}


class Bones(NamedTuple):
    """The bones that are known, by number: R (n, 3, 3) and p (n, 3) m, relative to their parents;
    the parent of the root, the wrist and the auxiliary bones is the device."""

    numbers: IntArray
    R: Array
    p: Array


class BoneSkeleton:
    """Bones of one hand. A ``controller`` device stands where an Index controller would be in the
    hand; otherwise it has the pose of the wrist: -z to the fingers, y out of the back."""

    def __init__(self, side: str, controller: bool) -> None:
        self._side, self._controller = side, controller
        self._rows = np.array([JOINTS.index(j) for joints in DIGITS.values() for j in joints])

    def device(self, joints: OpenXrHand) -> RigidMotion | None:
        """Where the device is in OpenVR's world; None where the wrist is lost."""
        if joints.state[WRIST] == Validity.LOST:
            return None
        wrist = RigidMotion(so3.matrix_from_quat(joints.orientation[WRIST]), joints.position[WRIST])
        if not self._controller:
            return wrist
        return self._wrist_bone(wrist) @ HELD[self._side].inverse

    def _wrist_bone(self, wrist: RigidMotion) -> RigidMotion:
        return RigidMotion(wrist.R @ A_WRIST[self._side], wrist.p)

    def bones(self, joints: OpenXrHand, device: RigidMotion) -> Bones:
        """Each bone that is known and whose parent is."""
        R_joints = so3.matrix_from_quat(joints.orientation[[WRIST, *self._rows]])
        wrist = self._wrist_bone(RigidMotion(R_joints[0], joints.position[WRIST]))
        R = np.concatenate([[device.R, wrist.R], R_joints[1:] @ A_BONE[self._side]])
        p = np.concatenate([[device.p, wrist.p], joints.position[self._rows]])
        known = np.concatenate([[True, True], joints.state[self._rows] != Validity.LOST])
        R, p, known = R[SOURCE], p[SOURCE], known[SOURCE]
        found = np.flatnonzero(known & known[PARENT])
        parents = PARENT[found]
        back = np.swapaxes(R[parents], 1, 2)
        relative = np.einsum("nij,nj->ni", back, p[found] - p[parents])
        return Bones(found, back @ R[found], relative)
