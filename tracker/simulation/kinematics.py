"""Forward kinematics of a true hand, vectorised over time."""

from __future__ import annotations

import numpy as np

from tracker.geometry import so3
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Stack4, Vector, Written
from tracker.messages import Array, IntArray


@kernel
def forward_many(
    parent: IntVector,
    origin: Matrix,
    R_rest: Stack,
    column: IntMatrix,
    twist_per_flexion: Vector,
    angles: Matrix,
    R_root: Stack,
    p_root: Matrix,
) -> tuple[Stack4, Stack]:
    """Poses of all segments: R_GB (n, S, 3, 3), p_GB (n, S, 3).

    parent (S,), -1 for the root; origin (S, 3) m in the parent's B; R_rest (S, 3, 3); column (S, 3)
    of abduction, flexion, twist among angles (n, J), -1 where fixed; twist_per_flexion (S,).
    """
    n, count = len(angles), len(parent)
    R = np.empty((n, count, 3, 3))
    p = np.empty((n, count, 3))
    joint = np.empty((3, 3))
    for k in range(n):
        for s in range(count):
            a = parent[s]
            if a < 0:
                R[k, s] = R_root[k]
                p[k, s] = p_root[k]
                continue
            _joint_rotation(column[s], twist_per_flexion[s], angles[k], joint)
            R[k, s] = R[k, a] @ (R_rest[s] @ joint)
            p[k, s] = p[k, a] + R[k, a] @ origin[s]
    return R, p


@kernel
def _joint_rotation(
    column: IntVector, twist_per_flexion: float, angles: Vector, out: Written[Matrix]
) -> None:
    """Rz(abduction) Ry(flexion) Rx(twist), the twist including the part coupled to flexion."""
    a = angles[column[0]] if column[0] >= 0 else 0.0
    f = angles[column[1]] if column[1] >= 0 else 0.0
    w = twist_per_flexion * f + (angles[column[2]] if column[2] >= 0 else 0.0)
    ca, sa, cf, sf, cw, sw = np.cos(a), np.sin(a), np.cos(f), np.sin(f), np.cos(w), np.sin(w)
    out[0, 0], out[0, 1], out[0, 2] = ca * cf, ca * sf * sw - sa * cw, ca * sf * cw + sa * sw
    out[1, 0], out[1, 1], out[1, 2] = sa * cf, sa * sf * sw + ca * cw, sa * sf * cw - ca * sw
    out[2, 0], out[2, 1], out[2, 2] = -sf, cf * sw, cf * cw


def angles_from_many(
    parent: IntArray, R_rest: Array, column: IntArray, R_GB: Array, count: int
) -> Array:
    """Angles (n, count) rad as defined in the hand file, from orientations R_GB (n, S, 3, 3)."""
    out = np.zeros((len(R_GB), count))
    moved = np.flatnonzero(np.asarray(parent) >= 0)
    before = np.swapaxes(R_GB[:, np.asarray(parent)[moved]], 2, 3)
    R = np.swapaxes(R_rest[moved], 1, 2) @ before @ R_GB[:, moved]
    has = column[moved] >= 0
    for axes in np.unique(has[:, ::2], axis=0):
        alike = np.flatnonzero((has[:, ::2] == axes).all(axis=1))
        values = so3.joint_angles(R[:, alike], *map(bool, axes))
        for i in range(3):
            there = has[alike, i]
            out[:, column[moved[alike[there]], i]] = values[:, there, i]
    return out
