"""A skin in the pose of its segments.

Dual quaternions (L. Kavan et al., "Geometric skinning with approximate dual quaternion blending",
2008): a blend of rotations about one joint is a rotation about it, so that a bent finger keeps its
thickness, while a blend of matrices would make it thinner.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.kernels import quat3
from tracker.hand.model import HandModel
from tracker.hand.skin.form import bind_angles
from tracker.hand.skin.mesh import Skin
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, Matrix, Stack, Written
from tracker.messages import Array


class RestingSkin(NamedTuple):
    """A skin at the wearer's size: points, normals (V, 3) and bones, shares (V, 4) as in `Skin`; R
    (S, 3, 3), p (S, 3) of its segments in the root."""

    points: Matrix
    normals: Matrix
    bones: IntMatrix
    shares: Matrix
    R: Stack
    p: Matrix


def rest_of(skin: Skin, hand: HandModel, scale: Array | None = None) -> RestingSkin:
    """The skin of a wearer whose segments are ``scale`` (S, 3) times the file's along each B."""
    contiguous = np.ascontiguousarray
    bound = RestingSkin(
        contiguous(skin.points), contiguous(skin.normals), contiguous(skin.bones),
        contiguous(skin.shares), contiguous(skin.bind_R), contiguous(skin.bind_p),
    )  # fmt: skip
    if scale is None:
        return bound
    R, p = map(contiguous, hand.forward(bind_angles(hand), np.eye(3), np.zeros(3), scale))
    points = np.empty_like(bound.points)
    scale_skin(bound, contiguous(scale, float), R, p, points)
    return bound._replace(points=points, R=R, p=p)


@kernel(error_model="numpy")
def scale_skin(
    bound: RestingSkin, scale: Matrix, R: Stack, p: Matrix, points: Written[Matrix]
) -> None:
    """Fill points (V, 3): those of ``bound``, transformed by the blend of the segments scaled by
    ``scale`` (S, 3), at R, p in the root and still in the bind pose."""
    local = np.empty(3)
    for v in range(len(points)):
        points[v] = 0.0
        for k in range(bound.bones.shape[1]):
            share, i = bound.shares[v, k], bound.bones[v, k]
            if share == 0.0:
                continue
            for a in range(3):
                local[a] = 0.0
                for b in range(3):
                    local[a] += bound.R[i, b, a] * (bound.points[v, b] - bound.p[i, b])
                local[a] *= scale[i, a]
            for a in range(3):
                moved = p[i, a]
                for b in range(3):
                    moved += R[i, a, b] * local[b]
                points[v, a] += share * moved


def posed(rest: RestingSkin, R_GB: Array, p_GB: Array) -> tuple[Array, Array]:
    """Points (V, 3) m and normals (V, 3) in G, of segments at R_GB (S, 3, 3), p_GB (S, 3) m."""
    points, normals = np.empty_like(rest.points), np.empty_like(rest.normals)
    R, p = np.ascontiguousarray(R_GB, float), np.ascontiguousarray(p_GB, float)
    pose_skin(rest, R, p, points, normals)
    return points, normals


@kernel(error_model="numpy")
def pose_skin(
    rest: RestingSkin, R_GB: Stack, p_GB: Matrix, points: Written[Matrix], normals: Written[Matrix]
) -> None:
    """Fill points and normals (V, 3), in G."""
    real, dual = _dual_quaternions(rest, R_GB, p_GB)
    r, d = np.empty(4), np.empty(4)
    for v in range(len(rest.points)):
        r[:] = 0.0
        d[:] = 0.0
        first = rest.bones[v, 0]
        for k in range(rest.bones.shape[1]):
            share, i = rest.shares[v, k], rest.bones[v, k]
            if share == 0.0:
                continue
            dot = 0.0
            for j in range(4):
                dot += real[first, j] * real[i, j]
            if dot < 0.0:  # the same rotation has two quaternions; use the nearer
                share = -share
            for j in range(4):
                r[j] += share * real[i, j]
                d[j] += share * dual[i, j]
        norm = np.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3])
        x, y, z, w = r[0] / norm, r[1] / norm, r[2] / norm, r[3] / norm
        dx, dy, dz, dw = d[0] / norm, d[1] / norm, d[2] / norm, d[3] / norm
        # the translation 2 d r*
        points[v, 0] = 2 * (-dw * x + dx * w - dy * z + dz * y)
        points[v, 1] = 2 * (-dw * y + dx * z + dy * w - dz * x)
        points[v, 2] = 2 * (-dw * z - dx * y + dy * x + dz * w)
        _turn(x, y, z, w, rest.points, v, points, True)
        _turn(x, y, z, w, rest.normals, v, normals, False)


@kernel(error_model="numpy", inline="always")
def _turn(
    x: float, y: float, z: float, w: float,
    vectors: Matrix, v: int, out: Written[Matrix], add: bool,
) -> None:  # fmt: skip
    """Rotates row v of ``vectors`` by a unit quaternion into (or added to) row v of ``out``."""
    a, b, c = vectors[v, 0], vectors[v, 1], vectors[v, 2]
    s, t, u = 2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)
    a, b, c = a + w * s + y * u - z * t, b + w * t + z * s - x * u, c + w * u + x * t - y * s
    if add:
        a, b, c = a + out[v, 0], b + out[v, 1], c + out[v, 2]
    out[v, 0], out[v, 1], out[v, 2] = a, b, c


@kernel(error_model="numpy")
def _dual_quaternions(rest: RestingSkin, R_GB: Stack, p_GB: Matrix) -> tuple[Matrix, Matrix]:
    """(S, 4) xyzw, real and dual part, of the transformation of each segment from rest to its
    pose."""
    many = len(R_GB)
    real, dual = np.empty((many, 4)), np.empty((many, 4))
    R, t = np.empty((3, 3)), np.empty(3)
    for i in range(many):
        for a in range(3):
            for b in range(3):
                R[a, b] = 0.0
                for c in range(3):
                    R[a, b] += R_GB[i, a, c] * rest.R[i, b, c]
        for a in range(3):
            t[a] = p_GB[i, a]
            for b in range(3):
                t[a] -= R[a, b] * rest.p[i, b]
        real[i] = quat3(R)
        x, y, z, w = real[i, 0], real[i, 1], real[i, 2], real[i, 3]
        dual[i, 0] = 0.5 * (t[0] * w + t[1] * z - t[2] * y)
        dual[i, 1] = 0.5 * (-t[0] * z + t[1] * w + t[2] * x)
        dual[i, 2] = 0.5 * (t[0] * y - t[1] * x + t[2] * w)
        dual[i, 3] = -0.5 * (t[0] * x + t[1] * y + t[2] * z)
    return real, dual
