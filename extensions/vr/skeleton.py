"""The hand as OpenVR's skeleton of 31 bones, each relative to its parent.

OpenVR's world has OpenXR's axes (x right, y up, -z forward). Bones have those of Valve's hand
models: on the left hand x points to the tip and y out of the palm; the right hand is its mirror
image with all axes reversed. The wrist's z points to the fingers and y to the thumb.
Sources: github.com/ValveSoftware/openvr/wiki/Hand-Skeleton and the reference poses there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from extensions.osc.vmc_pose import quaternions
from tracker.geometry import so3
from tracker.hand.names import CHAINS
from tracker.hand.openxr import JOINTS, WRIST, OpenXrHand
from tracker.messages import Array, Validity

ROOT, WRIST_BONE, BONES = 0, 1, 31
DIGITS = {f: [j for j in JOINTS if j.startswith(f"{f}_")] for f in CHAINS}
"""OpenXR's joints of each digit, base first: the bones of the digit, in OpenVR's order."""

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

    def in_unity(self) -> tuple[Array, Array]:
        """Position and quaternion (4,) xyzw in Unity's axes, of a pose in OpenVR's."""
        (row,) = in_unity([self])
        return row[:3], row[3:]


def in_unity(poses: Sequence[RigidMotion]) -> Array:
    """(n, 7) positions and quaternions xyzw in Unity's axes, of poses in OpenVR's."""
    R = np.array([pose.R for pose in poses])
    p = np.array([pose.p for pose in poses])
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


class BoneSkeleton:
    """Bones of one hand. A ``controller`` device stands where an Index controller would be in the
    hand; otherwise it has the pose of the wrist: -z to the fingers, y out of the back."""

    def __init__(self, side: str, controller: bool) -> None:
        self._side, self._controller = side, controller
        self._order = [j for joints in DIGITS.values() for j in joints]
        self._rows = np.array([JOINTS.index(j) for j in self._order])

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

    def bones(self, joints: OpenXrHand, device: RigidMotion) -> dict[int, RigidMotion]:
        """Each bone that is known, relative to its parent; the root is the ``device``."""
        R = so3.matrix_from_quat(joints.orientation[self._rows]) @ A_BONE[self._side]
        p, known = joints.position[self._rows], joints.state[self._rows] != Validity.LOST
        wrist = self._wrist_bone(
            RigidMotion(so3.matrix_from_quat(joints.orientation[WRIST]), joints.position[WRIST])
        )
        out = {ROOT: RigidMotion(np.eye(3), np.zeros(3)), WRIST_BONE: device.inverse @ wrist}
        row = 0
        for digit, listed in enumerate(DIGITS.values()):
            parent: RigidMotion | None = wrist
            for _ in listed:
                bone = RigidMotion(R[row], p[row]) if known[row] else None
                if bone is not None and parent is not None:
                    out[2 + row] = parent.inverse @ bone
                parent, row = bone, row + 1
            last = row - 2  # the last joint before the tip, which an auxiliary bone repeats
            if known[last]:
                out[26 + digit] = device.inverse @ RigidMotion(R[last], p[last])
        return out
