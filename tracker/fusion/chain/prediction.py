"""Prediction of the markers in the two images, with Jacobians and covariances.

Equation numbers are those of docs/chain.md.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.kinematics import (
    OriginJacobians,
    origin_jacobians,
    points_of,
    put_own,
    rotated,
    segment_origins,
)
from tracker.fusion.chain.layout import Blocks, ChainSkeleton, Points
from tracker.fusion.chain.params import PixelNoise
from tracker.fusion.chain.state import Body
from tracker.geometry.kernels import rotate, rotate_back
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Stack4, Vector, Written
from tracker.messages import CameraPose
from tracker.vision.rig import NEAREST, StereoIntrinsics, StereoRig, projected

MIN_PRIOR = 0.01  # of visibility, below which a marker is ignored


@record(
    "chain.prediction",
    shapes={
        "rows": "int n",
        "uv": "2 M 2",
        "prior": "2 M",
        "A": "2 M 2 3",
        "H": "n 3 N",
        "HP": "n 3 N",
        "cov": "n 3 3",
        "S": "2 n 2 2",
    },
)
class Prediction(NamedTuple):
    """Predicted markers; n of them may be seen.

    rows (n,) marker ids; uv (2, M, 2) rectified; prior (2, M); A (2, M, 2, 3) = d uv / d p_G; and
    for the n rows H, HP (n, 3, N), cov (n, 3, 3) m² in G including the placement's, and the
    innovation covariance S (2, n, 2, 2) px².
    """

    rows: IntVector
    uv: Stack
    prior: Matrix
    H: Stack
    HP: Stack
    cov: Stack
    A: Stack4
    S: Stack4


class PosedRig(NamedTuple):
    """A stereo camera with its pose: R_GC (3, 3), p_GC (3,) m of the left one."""

    R_GC: Matrix
    p_GC: Vector
    camera: StereoIntrinsics

    @staticmethod
    def of(rig: StereoRig, pose: CameraPose) -> PosedRig:
        return PosedRig(pose.R_GC.copy(), pose.p_GC.copy(), rig.intrinsics)


@kernel(nogil=False)
def viewed(
    skeleton: ChainSkeleton, body: Body, p: Vector, markers: Points, normal: Matrix, view: PosedRig
) -> tuple[Matrix, Matrix, Matrix, Matrix, Stack]:
    """p_GB (A, 3) of the active segments; of the markers p_G, normal_G, p_C (M, 3) and their
    rectified pixels uv (2, M, 2)."""
    p_GB = segment_origins(skeleton, body, p)
    p_G = points_of(p_GB, body, markers)
    p_C, uv = np.empty_like(p_G), np.empty((2, len(p_G), 2))
    for k in range(len(p_G)):
        p_C[k] = rotate_back(view.R_GC, p_G[k] - view.p_GC)
    camera = view.camera
    for c in range(2):
        shift = camera.baseline if c else 0.0
        # eq. 20
        uv[c] = projected(p_C, shift, camera.fx, camera.fy, camera.cx, camera.cy)
    return p_GB, p_G, rotated(body.R_GB, markers.segment, normal), p_C, uv


@kernel(nogil=False)
def pixel_jacobians(p_C: Matrix, view: PosedRig) -> Stack4:
    """(2, n, 2, 3) d uv / d p_G of both cameras, of points p_C (n, 3) (eq. 21)."""
    n, R_GC, camera = len(p_C), view.R_GC, view.camera
    out = np.empty((2, n, 2, 3))
    for c in range(2):
        shift = camera.baseline if c else 0.0
        for k in range(n):
            z = max(p_C[k, 2], NEAREST)
            u_z = -camera.fx * (p_C[k, 0] - shift) / z**2
            v_z = -camera.fy * p_C[k, 1] / z**2
            for i in range(3):
                out[c, k, 0, i] = camera.fx / z * R_GC[i, 0] + u_z * R_GC[i, 2]
                out[c, k, 1, i] = camera.fy / z * R_GC[i, 1] + v_z * R_GC[i, 2]
    return out


@kernel(nogil=False)
def expected(
    skeleton: ChainSkeleton,
    at: Blocks,
    body: Body,
    markers: Points,
    P: Matrix,
    prior: Matrix,
    A: Stack4,
    noise: PixelNoise,
) -> tuple[IntVector, Stack, Stack, Stack, Stack4]:
    """The markers that may be seen: rows, H, H P, cov and S of a `Prediction`.

    They are those whose ``prior`` (2, M) exceeds `MIN_PRIOR` in a camera. The product H P of a
    segment's origin, which its markers share, is computed once.
    """
    # 1. which markers, and the origins of their segments (eq. 6)
    rows = np.flatnonzero(np.maximum(prior[0], prior[1]) > MIN_PRIOR)
    origins = origin_jacobians(skeleton, at, body)
    of_origin = origin_products(skeleton.parent, origins, P)
    n, size = len(rows), len(P)
    H, HP, cov = np.zeros((n, 3, size)), np.empty((n, 3, size)), np.empty((n, 3, 3))
    S = np.empty((2, n, 2, 2))
    for i in range(n):
        m = rows[i]
        a = markers.segment[m]
        # 2. H of the marker: its origin's columns, then its own
        k, h, column = origins.used[a], origins.value[a], origins.column[a]
        end = k + put_own(h[:, k:], column[k:], skeleton, at, body, markers, m, at.marker + 3 * m)
        # 3. H P
        HP[i] = of_origin[a]
        add_product(HP[i], h[:, k:end], column[k:end], P)
        # 4. H P Hᵀ and the placement's noise; H expanded
        for r in range(3):
            for c in range(end):
                H[i, r, column[c]] = h[r, c]
            for s in range(3):
                cov[i, r, s] = noise.marker**2 if r == s else 0.0
                for c in range(end):
                    cov[i, r, s] += HP[i, r, column[c]] * h[s, c]
        # 5. the same in each camera's pixels (eq. 22)
        for c in range(2):
            S[c, i] = seen_covariance(A[c, m], cov[i], noise.pixel_px)
    return rows, H, HP, cov, S


@kernel
def seen_covariance(J: Matrix, cov: Matrix, sd_pixel: float) -> Matrix:
    """J cov J^T + I sd_pixel² (e, e) px² of J (e, 3) and cov (3, 3) m²."""
    n = len(J)
    out = np.empty((n, n))
    for a in range(n):
        x = rotate(cov, J[a])
        for b in range(n):
            out[a, b] = x[0] * J[b, 0] + x[1] * J[b, 1] + x[2] * J[b, 2]
        out[a, a] += sd_pixel**2
    return out


@kernel
def origin_products(parent: IntVector, origins: OriginJacobians, P: Matrix) -> Stack:
    """(A, 3, N) H P of the segments' origins: reuses the parents' products."""
    used, column, value = origins
    out = np.zeros((len(parent), 3, len(P)))
    for c in range(len(parent)):
        a = parent[c]
        begin = used[a] if a >= 0 else 0
        if a >= 0:
            out[c] = out[a]
        end = used[c]
        add_product(out[c], value[c, :, begin:end], column[c, begin:end], P)
    return out


@kernel
def add_product(out: Written[Matrix], value: Matrix, column: IntVector, P: Matrix) -> None:
    """out (3, N) += H P of an H with the entries value (3, k) in the columns (k,)."""
    x, y, z = out[0], out[1], out[2]
    for c in range(len(column)):
        row = P[column[c]]
        a, b, d = value[0, c], value[1, c], value[2, c]
        for i in range(len(row)):
            x[i] += a * row[i]
            y[i] += b * row[i]
            z[i] += d * row[i]
