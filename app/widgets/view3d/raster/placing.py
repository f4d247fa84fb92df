"""Transformation of bodies into the camera frame: their frames S in C, their lines in the image."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.solids import LINES
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntMatrix, IntVector, Matrix, Stack, Vector, Written

NEAR = 0.01
"""Distance in m from the camera within which nothing is drawn."""


class Bodies(NamedTuple):
    """For N bodies: kinds, shown (N,); R_GB (N, 3, 3), a rotation times a size, and p_GB (N, 3) m;
    R_BS, p_BS of the solid in the body; forms (N, 5) m; looks (N, 9) see `view`."""

    kinds: IntVector
    shown: BoolVector
    R_GB: Stack
    p_GB: Matrix
    R_BS: Stack
    p_BS: Matrix
    forms: Matrix
    looks: Matrix


class Strokes(NamedTuple):
    """Lines: points (P, 3) m in B, ends (M, 2) rows of points, owner (M,) body."""

    points: Matrix
    ends: IntMatrix
    owner: IntVector


class Pinhole(NamedTuple):
    """The camera in G; focal length and principal point, px."""

    R_GC: Matrix
    p_GC: Vector
    focal: float
    middle_u: float
    middle_v: float


@kernel(error_model="numpy")
def place(bodies: Bodies, i: int, camera: Pinhole) -> Vector:
    """(13,) of solid i: R_CS (9), the camera in S (3), its size; size 0 if it has no pose.

    Coordinates in B and S have to be multiplied by the size.
    """
    R_GB, p_GB, R_BS, p_BS = bodies.R_GB[i], bodies.p_GB[i], bodies.R_BS[i], bodies.p_BS[i]
    R_GC, p_GC = camera.R_GC, camera.p_GC
    out = np.zeros(13)
    size = np.sqrt(R_GB[0, 0] ** 2 + R_GB[1, 0] ** 2 + R_GB[2, 0] ** 2)
    if not (np.isfinite(R_GB).all() and np.isfinite(p_GB).all() and size > 0.0):
        return out
    for i in range(3):
        for j in range(3):
            for k in range(3):
                for m in range(3):
                    out[3 * i + j] += R_GC[k, i] * R_GB[k, m] * R_BS[m, j] / size
    for k in range(3):
        away = p_GC[k] - p_GB[k]
        for m in range(3):
            away -= R_GB[k, m] * p_BS[m]
        for j in range(3):
            column = R_GB[k, 0] * R_BS[0, j] + R_GB[k, 1] * R_BS[1, j] + R_GB[k, 2] * R_BS[2, j]
            out[9 + j] += column / size * away
    out[12] = size
    return out


@kernel(error_model="numpy")
def project_line(a_G: Vector, b_G: Vector, camera: Pinhole, out: Written[Vector]) -> None:
    """Write the projected ends of a line into ``out`` (6,): u, v px and 1/z of each; NaN if all of
    it is behind the camera."""
    R_GC, p_GC, focal = camera.R_GC, camera.p_GC, camera.focal
    cx, cy = camera.middle_u, camera.middle_v
    out[:] = np.nan
    a, b = np.zeros(3), np.zeros(3)
    for j in range(3):
        for k in range(3):
            a[j] += R_GC[k, j] * (a_G[k] - p_GC[k])
            b[j] += R_GC[k, j] * (b_G[k] - p_GC[k])
    if not (np.isfinite(a).all() and np.isfinite(b).all()) or max(a[2], b[2]) <= NEAR:
        return
    if a[2] < NEAR:
        a += (b - a) * (NEAR - a[2]) / (b[2] - a[2])
    elif b[2] < NEAR:
        b += (a - b) * (NEAR - b[2]) / (a[2] - b[2])
    out[0], out[1], out[2] = cx + focal * a[0] / a[2], cy + focal * a[1] / a[2], 1 / a[2]
    out[3], out[4], out[5] = cx + focal * b[0] / b[2], cy + focal * b[1] / b[2], 1 / b[2]


@kernel(error_model="numpy")
def place_solids(bodies: Bodies, camera: Pinhole) -> tuple[Matrix, Matrix]:
    """(N, 13) of `place`, size 0 for hidden ones; (N, 5) forms in m."""
    places, sized = np.zeros((len(bodies.kinds), 13)), np.zeros(bodies.forms.shape)
    for i in range(len(bodies.kinds)):
        if bodies.shown[i] and bodies.kinds[i] != LINES:
            places[i] = place(bodies, i, camera)
            sized[i] = bodies.forms[i] * places[i, 12]
    return places, sized


@kernel(error_model="numpy")
def project_lines(bodies: Bodies, strokes: Strokes, camera: Pinhole) -> Matrix:
    """(M, 6) of `project_line`; NaN for hidden ones."""
    R_GB, p_GB, points, ends = bodies.R_GB, bodies.p_GB, strokes.points, strokes.ends
    lines = np.full((len(ends), 6), np.nan)
    a, b = np.empty(3), np.empty(3)
    for m in range(len(ends)):
        i = strokes.owner[m]
        if bodies.shown[i]:
            for k in range(3):
                a[k] = b[k] = p_GB[i, k]
                for j in range(3):
                    a[k] += R_GB[i, k, j] * points[ends[m, 0], j]
                    b[k] += R_GB[i, k, j] * points[ends[m, 1], j]
            project_line(a, b, camera, lines[m])
    return lines
