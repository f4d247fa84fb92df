"""Poses in the axes of other systems as poses in G (z up, right-handed)."""

from __future__ import annotations

import numpy as np

from extensions.osc.vmc_pose import M_WORLD
from tracker.geometry import so3
from tracker.messages import Array

UPRIGHT = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
"""Rows: x, y, z of G; columns: x, y, z of right-handed axes with y up: forward is z, left is x."""
UP_AXES = ("y", "z")


def from_unity(p: Array, q: Array) -> tuple[Array, Array]:
    """Pose in G of a position (3,) m and a quaternion (4,) xyzw in Unity's left-handed axes; the
    inverse of `extensions.osc.vmc_pose.unity_pose`."""
    R = M_WORLD.T @ so3.matrix_from_quat(q) @ M_WORLD
    return M_WORLD.T @ p, so3.quat_from_matrix(R)


def from_upright(p: Array, q: Array, up: str) -> tuple[Array, Array]:
    """Pose in G of one in right-handed axes with ``up`` (y or z) upwards. The tracker's own axes
    stay unchanged: the alignment includes them."""
    if up == "z":
        return p, q
    if not np.isfinite(q).all():
        return UPRIGHT @ p, q
    return UPRIGHT @ p, so3.quat_from_matrix(UPRIGHT @ so3.matrix_from_quat(q))


def from_unity_euler(degrees: Array) -> Array:
    """Quaternion (4,) xyzw in Unity's axes of its angles (3,) in degrees: about z, then x, then
    y."""
    x, y, z = np.deg2rad(degrees)
    # written with right-handed matrices: a left-handed turn has the same matrix in its own axes
    return so3.quat_from_matrix(so3.ry(y) @ so3.rx(x) @ so3.rz(z))
