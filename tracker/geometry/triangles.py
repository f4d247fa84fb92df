"""The surface of a closed triangle mesh: nearest point and signed distance.

Triangles are in small groups with a bounding box each, so that only few of a large mesh are tested.
Inside or outside is determined by the angle-weighted normal of the nearest face, edge or corner
(Bærentzen & Aanæs 2005, doi:10.1109/TVCG.2005.49). Lengths in m.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tracker.base.arrays import Array, IntArray
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector, Written

GROUP = 12  # triangles
FACE = 0  # rows of `Triangles.normals`; edges 1 to 3 and corners 4 to 6 follow
SMALLEST = 1e-30  # m⁴, below which a triangle has no area


class Triangles(NamedTuple):
    """F triangles in groups: corners (F, 3, 3); normals (F, 7, 3) of the face, of the edges
    a-b, b-c, c-a and of the corners a, b, c; boxes low, high (G, 3); first (G + 1,) of each."""

    corners: Stack
    normals: Stack
    low: Matrix
    high: Matrix
    first: IntVector


class Nearest(NamedTuple):
    """For n points: nearest (n, 3) on the surface, normal (n, 3) there, outward of length 1, and
    distance (n,), negative inside."""

    point: Matrix
    normal: Matrix
    distance: Vector


def triangles_of(points: Array, faces: IntArray) -> Triangles:
    """From points (V, 3) and faces (F, 3), counter-clockwise from outside; degenerate ones are
    omitted."""
    corners = points[faces]
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    whole = (flat * flat).sum(axis=1) > SMALLEST
    faces, corners, flat = faces[whole], corners[whole], flat[whole]
    normals = _normals(faces, corners, flat / np.linalg.norm(flat, axis=1, keepdims=True))
    order = _grouped(corners.mean(axis=1))
    corners, normals = corners[order], normals[order]
    first = np.arange(0, len(corners) + GROUP, GROUP).clip(max=len(corners))
    rows = [corners[a:b].reshape(-1, 3) for a, b in pairwise(first)]
    return Triangles(
        np.ascontiguousarray(corners),
        np.ascontiguousarray(normals),
        np.array([r.min(axis=0) for r in rows]),
        np.array([r.max(axis=0) for r in rows]),
        first.astype(np.int64),
    )


def _normals(faces: IntArray, corners: Array, face: Array) -> Array:
    """(F, 7, 3), see `Triangles`."""
    out = np.empty((len(faces), 7, 3))
    out[:, FACE] = face
    by_edge: dict[tuple[int, int], Array] = {}
    for row, n in zip(faces.tolist(), face, strict=True):
        for k in range(3):
            edge = (min(row[k], row[k - 2]), max(row[k], row[k - 2]))
            by_edge[edge] = by_edge.get(edge, np.zeros(3)) + n
    by_corner = np.zeros((int(faces.max()) + 1, 3))
    for k in range(3):
        u = corners[:, k - 2] - corners[:, k]
        v = corners[:, k - 1] - corners[:, k]
        cosine = (u * v).sum(1) / (np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1))
        np.add.at(by_corner, faces[:, k], np.arccos(np.clip(cosine, -1, 1))[:, None] * face)
    for k in range(3):
        edges = [(min(r[k], r[k - 2]), max(r[k], r[k - 2])) for r in faces.tolist()]
        out[:, 1 + k] = np.array([by_edge[e] for e in edges])
        out[:, 4 + k] = by_corner[faces[:, k]]
    return np.asarray(out / np.maximum(np.linalg.norm(out, axis=2, keepdims=True), 1e-12))


def _grouped(middle: Array) -> IntArray:
    """(F,) an order in which `GROUP` successive triangles are near each other."""
    out: list[IntArray] = []
    waiting = [np.arange(len(middle))]
    while waiting:
        rows = waiting.pop()
        if len(rows) <= GROUP:
            out.append(rows)
            continue
        axis = int(np.ptp(middle[rows], axis=0).argmax())
        rows = rows[np.argsort(middle[rows, axis], kind="stable")]
        half = GROUP * ((len(rows) // 2 + GROUP - 1) // GROUP)
        waiting += [rows[half:], rows[:half]]
    return np.concatenate(out)


def nearest(mesh: Triangles, points: Array) -> Nearest:
    """The nearest surface points of points (n, 3)."""
    n = len(points)
    out = Nearest(np.empty((n, 3)), np.empty((n, 3)), np.empty(n))
    _nearest(mesh, np.ascontiguousarray(points, float), out)
    return out


@kernel(nogil=False)
def _nearest(mesh: Triangles, points: Matrix, out: Written[Nearest]) -> None:
    for i in range(len(points)):
        p = (points[i, 0], points[i, 1], points[i, 2])
        best, which, feature, at = np.inf, 0, 0, (0.0, 0.0, 0.0)
        for g in range(len(mesh.low)):
            if _box_distance(mesh.low, mesh.high, g, p) >= best:
                continue
            for k in range(mesh.first[g], mesh.first[g + 1]):
                q, f = on_triangle(mesh.corners, k, p)
                d = (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2
                if d < best:
                    best, which, feature, at = d, k, f, q
        side = 0.0
        for j in range(3):
            out.point[i, j] = at[j]
            side += (p[j] - at[j]) * mesh.normals[which, feature, j]
        length = np.sqrt(best)
        out.distance[i] = length if side >= 0 else -length
        for j in range(3):
            if length > 1e-9:
                out.normal[i, j] = (p[j] - at[j]) / out.distance[i]
            else:
                out.normal[i, j] = mesh.normals[which, feature, j]


@kernel(inline="always")
def _box_distance(low: Matrix, high: Matrix, g: int, p: tuple[float, float, float]) -> float:
    """m², from a point to a box."""
    total = 0.0
    for j in range(3):
        d = max(low[g, j] - p[j], 0.0, p[j] - high[g, j])
        total += d * d
    return total


@kernel(inline="always")
def on_triangle(
    corners: Stack, k: int, p: tuple[float, float, float]
) -> tuple[tuple[float, float, float], int]:
    """The point of a triangle nearest to p, and the applicable row of `Triangles.normals`.

    Ericson, Real-Time Collision Detection (2005), section 5.1.5.
    """
    a = (corners[k, 0, 0], corners[k, 0, 1], corners[k, 0, 2])
    b = (corners[k, 1, 0], corners[k, 1, 1], corners[k, 1, 2])
    c = (corners[k, 2, 0], corners[k, 2, 1], corners[k, 2, 2])
    ab = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    ac = (c[0] - a[0], c[1] - a[1], c[2] - a[2])
    ap = (p[0] - a[0], p[1] - a[1], p[2] - a[2])
    d1 = ab[0] * ap[0] + ab[1] * ap[1] + ab[2] * ap[2]
    d2 = ac[0] * ap[0] + ac[1] * ap[1] + ac[2] * ap[2]
    if d1 <= 0 and d2 <= 0:
        return a, 4
    bp = (p[0] - b[0], p[1] - b[1], p[2] - b[2])
    d3 = ab[0] * bp[0] + ab[1] * bp[1] + ab[2] * bp[2]
    d4 = ac[0] * bp[0] + ac[1] * bp[1] + ac[2] * bp[2]
    if d3 >= 0 and d4 <= d3:
        return b, 5
    vc = d1 * d4 - d3 * d2
    if vc <= 0 and d1 >= 0 and d3 <= 0:
        v = d1 / (d1 - d3)
        return (a[0] + v * ab[0], a[1] + v * ab[1], a[2] + v * ab[2]), 1
    cp = (p[0] - c[0], p[1] - c[1], p[2] - c[2])
    d5 = ab[0] * cp[0] + ab[1] * cp[1] + ab[2] * cp[2]
    d6 = ac[0] * cp[0] + ac[1] * cp[1] + ac[2] * cp[2]
    if d6 >= 0 and d5 <= d6:
        return c, 6
    vb = d5 * d2 - d1 * d6
    if vb <= 0 and d2 >= 0 and d6 <= 0:
        w = d2 / (d2 - d6)
        return (a[0] + w * ac[0], a[1] + w * ac[1], a[2] + w * ac[2]), 3
    va = d3 * d6 - d5 * d4
    if va <= 0 and d4 - d3 >= 0 and d5 - d6 >= 0:
        w = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        return (
            b[0] + w * (c[0] - b[0]), b[1] + w * (c[1] - b[1]), b[2] + w * (c[2] - b[2])
        ), 2  # fmt: skip
    v, w = vb / (va + vb + vc), vc / (va + vb + vc)
    return (
        a[0] + v * ab[0] + w * ac[0], a[1] + v * ab[1] + w * ac[1], a[2] + v * ab[2] + w * ac[2]
    ), 0  # fmt: skip
