"""The visible part of each marker: sample points on the curved patch, facing and occlusion."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3, nearest_to_axis, sight_cuts_box
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntVector, Matrix, Stack, Vector, Written
from tracker.messages import Array
from tracker.simulation.solids import SceneInstant, Solids

CIRCLE, SQUARE = 0, 1
_SAMPLES = 16
NO_SEGMENT = -2
"""No solid has this owner: every solid occludes."""
BALL = 1e-12  # m²: a capsule's squared length below which it has no axis


def sample_pattern() -> Array:
    """(2, 16, 2): points of equal area over a circle and a square of unit diameter or side."""
    k = np.arange(_SAMPLES) + 0.5
    radius, turn = 0.5 * np.sqrt(k / _SAMPLES), np.pi * (3 - np.sqrt(5)) * k
    circle = np.column_stack([radius * np.cos(turn), radius * np.sin(turn)])
    circle -= circle.mean(axis=0)  # a spiral of few points is not centred
    edge = (np.arange(4) + 0.5) / 4 - 0.5
    square = np.stack(np.meshgrid(edge, edge), axis=-1).reshape(-1, 2)
    return np.stack([circle, square])


class PatchShapes(NamedTuple):
    """Patches of M markers: outward normal (M, 3) in their segment's B, size (M,) m, `CIRCLE` or
    `SQUARE` (M,), segment (M,), and flat (M,), 1 for a patch on a plane, otherwise wrapped around
    the bone."""

    normal: Matrix
    size: Vector
    shape: IntVector
    segment: IntVector
    flat: IntVector


class _Axes(NamedTuple):
    """For P capsules: unit vector (P, 3) from ``a`` to ``b`` (0 for a ball) and length (P,) m."""

    unit: Matrix
    length: Vector


@kernel
def view_patches(
    eye: Vector, K: Vector, now: SceneInstant, patches: PatchShapes, pattern: Stack
) -> tuple[Matrix, Matrix, Vector, Vector]:
    """The patches of ``now`` from ``eye`` (3,) in C with K = (fx, fy, cx, cy): uv (M, 2) px,
    centroid of the visible area, extent (M, 2) px, facing (M,) mean cosine of the visible part over
    the whole, whole (M,) share of the part facing the camera that is not occluded.

    Each is evaluated at the points of `sample_pattern`.
    """
    position, R_CB, p_CB, solids = now.markers, now.R_CB, now.p_CB, now.solids
    normal, size, shape = patches.normal, patches.size, patches.shape
    segment, flat, axes = patches.segment, patches.flat, _axes_of(solids)
    count, samples = len(position), pattern.shape[1]
    uv, extent = np.full((count, 2), np.nan), np.zeros((count, 2))
    facing, whole = np.zeros(count), np.zeros(count)
    local, n_B = np.empty(3), np.empty(3)
    x, n_C, ray = np.empty(3), np.empty(3), np.empty(3)
    rows = np.empty(len(solids.radius), np.int64)
    for m in range(count):
        own = segment[m]
        _carry(R_CB, p_CB, own, position[m], x)
        near = _near_ray(eye, x, 0.8 * size[m], own, solids, axes, rows)
        seen, turned, su, sv = 0.0, 0.0, 0.0, 0.0
        low_u, high_u, low_v, high_v = 1e9, -1e9, 1e9, -1e9
        for k in range(samples):
            s = pattern[shape[m], k] * size[m]
            _on_surface(position[m], normal[m], s, flat[m] == 1, local, n_B)
            _carry(R_CB, p_CB, own, local, x)
            _rotate(R_CB, own, n_B, n_C)
            distance, along = 0.0, 0.0
            for c in range(3):
                ray[c] = x[c] - eye[c]
                distance += ray[c] * ray[c]
                along += n_C[c] * ray[c]
            cosine = -along / np.sqrt(distance)
            if ray[2] < 0.02 or cosine <= 0.0:
                continue
            turned += cosine
            if _hidden(eye, x, own, rows[:near], solids, axes):
                continue
            u = K[0] * ray[0] / ray[2] + K[2]
            v = K[1] * ray[1] / ray[2] + K[3]
            seen += cosine
            su += cosine * u
            sv += cosine * v
            low_u, high_u = min(low_u, u), max(high_u, u)
            low_v, high_v = min(low_v, v), max(high_v, v)
        if seen > 0.0:
            uv[m, 0], uv[m, 1] = su / seen, sv / seen
            extent[m, 0], extent[m, 1] = high_u - low_u, high_v - low_v
            facing[m] = seen / samples
            whole[m] = seen / turned
    return uv, extent, facing, whole


@kernel
def in_sight(eye: Vector, points: Matrix, solids: Solids) -> BoolVector:
    """(n,) whether points (n, 3) of C are visible from ``eye`` past all solids."""
    axes, out = _axes_of(solids), np.empty(len(points), np.bool_)
    rows = np.empty(len(solids.radius), np.int64)
    for i in range(len(points)):
        near = _near_ray(eye, points[i], 0.0, NO_SEGMENT, solids, axes, rows)
        out[i] = not _hidden(eye, points[i], NO_SEGMENT, rows[:near], solids, axes)
    return out


@kernel
def _axes_of(solids: Solids) -> _Axes:
    unit, length = np.zeros((len(solids.a), 3)), np.zeros(len(solids.a))
    for i in range(len(length)):
        square = 0.0
        for c in range(3):
            unit[i, c] = solids.b[i, c] - solids.a[i, c]
            square += unit[i, c] * unit[i, c]
        if square < BALL:
            unit[i] = 0.0
            continue
        length[i] = np.sqrt(square)
        unit[i] /= length[i]
    return _Axes(unit, length)


@kernel
def _rotate(R: Stack, i: int, v: Vector, out: Written[Vector]) -> None:
    """R[i] v, without a BLAS call for three numbers."""
    for c in range(3):
        out[c] = R[i, c, 0] * v[0] + R[i, c, 1] * v[1] + R[i, c, 2] * v[2]


@kernel
def _carry(R: Stack, p: Matrix, i: int, v: Vector, out: Written[Vector]) -> None:
    """R[i] v + p[i]."""
    _rotate(R, i, v, out)
    for c in range(3):
        out[c] += p[i, c]


@kernel
def _on_surface(
    position: Vector,
    normal: Vector,
    s: Vector,
    flat: bool,
    point: Written[Vector],
    n_out: Written[Vector],
) -> None:
    """The patch's point at ``s`` (along the bone, around it) from its centre, and its normal."""
    if flat or abs(normal[0]) > 0.5:
        _on_plane(position, normal, s, point)
        n_out[:] = normal
        return
    rho = np.sqrt(position[1] ** 2 + position[2] ** 2)
    angle = np.arctan2(position[2], position[1]) + s[1] / rho
    c, d = np.cos(angle), np.sin(angle)
    point[0], point[1], point[2] = position[0] + s[0], rho * c, rho * d
    n_out[0], n_out[1], n_out[2] = 0.0, c, d


@kernel
def _on_plane(position: Vector, n: Vector, s: Vector, point: Written[Vector]) -> None:
    along = np.array([1.0, 0.0, 0.0]) if abs(n[0]) <= 0.9 else np.array([0.0, 0.0, 1.0])
    along -= (along[0] * n[0] + along[1] * n[1] + along[2] * n[2]) * n
    along /= np.sqrt(along[0] ** 2 + along[1] ** 2 + along[2] ** 2)
    across = np.cross(n, along)
    point[:] = position + s[0] * along + s[1] * across


@kernel
def _near_ray(
    eye: Vector,
    x: Vector,
    reach: float,
    own: int,
    solids: Solids,
    axes: _Axes,
    found: Written[IntVector],
) -> int:
    """Number of capsules within ``reach`` of the ray from ``eye`` to x; rows into ``found``."""
    count = 0
    for i in range(len(solids.radius)):
        if solids.owner[i] != own and _is_near(eye, x, solids, axes, i, solids.radius[i] + reach):
            found[count] = i
            count += 1
    return count


@kernel
def _hidden(eye: Vector, x: Vector, own: int, rows: IntVector, solids: Solids, axes: _Axes) -> bool:
    """Whether a capsule of ``rows``, or a box, is between ``eye`` and the point x.

    Solids of the segment ``own`` are excluded: `_near_ray` omits its capsules.
    """
    for i in rows:
        if _is_near(eye, x, solids, axes, i, solids.radius[i]):
            return True
    for i in range(len(solids.half)):
        if solids.box_owner[i] != own and _crosses_box(eye, x, solids, i):
            return True
    return False


@kernel
def _is_near(p: Vector, q: Vector, solids: Solids, axes: _Axes, i: int, reach: float) -> bool:
    """Whether the line pq comes within ``reach`` of capsule i's axis."""
    a, unit = solids.a, axes.unit
    dd, du, dw, uw = 0.0, 0.0, 0.0, 0.0
    for c in range(3):
        d, u, w = q[c] - p[c], unit[i, c], p[c] - a[i, c]
        dd, du, dw, uw = dd + d * d, du + d * u, dw + d * w, uw + u * w
    t, x = nearest_to_axis(dd, du, dw, uw, axes.length[i])
    gap2 = 0.0
    for c in range(3):
        gap = p[c] - a[i, c] + t * (q[c] - p[c]) - x * unit[i, c]
        gap2 += gap * gap
    return gap2 < reach * reach


@kernel
def _crosses_box(p: Vector, q: Vector, solids: Solids, i: int) -> bool:
    """Whether the line pq intersects box i."""
    x, y, z = solids.half[i, 0], solids.half[i, 1], solids.half[i, 2]
    start, end = _in_box(solids, i, p), _in_box(solids, i, q)
    return sight_cuts_box(start, end, (-x, -y, -z), (x, y, z))


@kernel(inline="always")
def _in_box(solids: Solids, i: int, p: Vector) -> Vector3:
    """A point of C along the axes of box i, relative to its centre."""
    R, x, y, z = solids.box_R, p[0], p[1], p[2]
    x, y, z = x - solids.centre[i, 0], y - solids.centre[i, 1], z - solids.centre[i, 2]
    return (
        R[i, 0, 0] * x + R[i, 1, 0] * y + R[i, 2, 0] * z,
        R[i, 0, 1] * x + R[i, 1, 1] * y + R[i, 2, 1] * z,
        R[i, 0, 2] * x + R[i, 1, 2] * y + R[i, 2, 2] * z,
    )
