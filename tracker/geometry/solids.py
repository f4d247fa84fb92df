"""Intersection of lines with capsules and boxes, shared by occlusion, images and drawings.

Two problems: whether a line of sight (from a to b) is blocked, and at which depths a ray (o + t d)
enters and leaves. All kernels take numbers and tuples of them only: numba's reference counting of
passed arrays takes longer than all the arithmetic here. Lengths in m.
"""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel

Vector3 = tuple[float, float, float]

PARALLEL = 1e-12  # m, or of a ray's direction, along an axis: below it a line is parallel to a side
SAME_WAY = 1e-15  # m², of the cross product per length: parallel lines


# --- a line of sight


@kernel(inline="always", nogil=False)
def nearest_to_axis(
    dd: float, du: float, dw: float, uw: float, length: float
) -> tuple[float, float]:
    """Closest points of a line of sight a + t d, t in 0..1, and an axis x u, x in 0..length: t, x.

    From products of d, of the unit vector u and of w, the vector from the start of the axis to a.
    Ericson, Real-Time Collision Detection (2005), section 5.1.9.
    """
    cross = dd - du * du  # of the two directions, squared, over length squared
    t = 0.0
    if cross > SAME_WAY:
        t = min(max((du * uw - dw) / cross, 0.0), 1.0)
    x = min(max(uw + t * du, 0.0), length)  # point of the axis nearest to that of the line
    t = min(max((x * du - dw) / dd, 0.0), 1.0)
    return t, min(max(uw + t * du, 0.0), length)


@kernel(inline="always")
def sight_cuts_capsule(a: Vector3, b: Vector3, length: float, radius: float) -> bool:
    """Whether the line a-b is within ``radius`` of the axis (0, 0, 0)-(length, 0, 0)."""
    d0, d1, d2 = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    dd = d0 * d0 + d1 * d1 + d2 * d2
    da = d0 * a[0] + d1 * a[1] + d2 * a[2]
    t, x = nearest_to_axis(dd, d0, da, a[0], length)
    u, v, w = a[0] + t * d0 - x, a[1] + t * d1, a[2] + t * d2
    return bool(u * u + v * v + w * w < radius * radius)


@kernel(inline="always")
def sight_cuts_box(a: Vector3, b: Vector3, lower: Vector3, upper: Vector3) -> bool:
    """Whether the line a-b intersects the box between two corners (slab method)."""
    low, high = 0.0, 1.0
    for i in range(3):
        d = b[i] - a[i]
        if abs(d) < PARALLEL:
            if a[i] < lower[i] or a[i] > upper[i]:
                return False
            continue
        t0, t1 = (lower[i] - a[i]) / d, (upper[i] - a[i]) / d
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low < high


# --- a ray


@kernel(error_model="numpy", inline="always")
def capsule_depth(o: Vector3, d: Vector3, length: float, radius: float, side: float) -> float:
    """Depth at which o + t d enters (``side`` -1) or leaves (1) a capsule along x from 0 to
    ``length``.

    0 where the ray misses.
    """
    a, b = d[1] * d[1] + d[2] * d[2], o[1] * d[1] + o[2] * d[2]
    c = o[1] * o[1] + o[2] * o[2] - radius * radius
    h = b * b - a * c
    if h < 0.0:  # misses the infinite cylinder, which contains the spheres
        return 0.0
    end = length if side * d[0] > 0.0 else 0.0  # for a ray along the axis
    if length > 0.0 and a > PARALLEL * d[0] * d[0]:
        t = (-b + side * np.sqrt(h)) / a
        x = o[0] + t * d[0]
        if 0.0 <= x <= length:
            return t
        end = 0.0 if x < 0.0 else length
    a += d[0] * d[0]
    b += (o[0] - end) * d[0]
    h = b * b - a * (c + (o[0] - end) * (o[0] - end))
    if h < 0.0:
        return 0.0
    return (-b + side * np.sqrt(h)) / a


@kernel(error_model="numpy", inline="always")
def box_span(o: Vector3, d: Vector3, half: Vector3) -> tuple[float, float]:
    """Depths at which o + t d enters and leaves a box around the origin; the first is larger where
    it misses."""
    low, high = -np.inf, np.inf
    for i in range(3):
        step = 1.0 / (d[i] if abs(d[i]) > PARALLEL else PARALLEL)
        t0, t1 = (-half[i] - o[i]) * step, (half[i] - o[i]) * step
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low, high
