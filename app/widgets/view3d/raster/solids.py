"""Intersection of rays with solids, in the solid's own frame S.

Complements `tracker.geometry.solids` with discs, rounded blocks and normals. Each ``..._depth``
gets the camera o and the ray d in S, and ``side``: -1 for the entry, 1 for the exit of the ray. It
returns the depth in m, 0 if the ray misses. Each ``..._normal`` returns the outward normal at a
point of the surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3, box_span
from tracker.kernels import kernel

CAPSULE, DISC, BLOCK, LINES = 0, 1, 2, 3
"""Kinds of bodies; the last one has no surface."""
Rotation = tuple[float, float, float, float, float, float, float, float, float]
"""Row by row."""


class Rounded(NamedTuple):
    """A block: half sides, radii of the corners in plan and of the edges, m."""

    hx: float
    hy: float
    hz: float
    corner: float
    edge: float


TOLERANCE = 2e-5  # m, of a block's surface
STEPS = 24


@kernel(error_model="numpy", inline="always")
def capsule_normal(p: Vector3, length: float, radius: float) -> Vector3:
    """Pointing away from the axis."""
    return (p[0] - min(max(p[0], 0.0), length)) / radius, p[1] / radius, p[2] / radius


@kernel(error_model="numpy", inline="always")
def disc_depth(o: Vector3, d: Vector3, half: float, radius: float, side: float) -> float:
    """Extends along x from -``half`` to ``half``."""
    ox, oy, oz = o
    dx, dy, dz = d
    a, b = dy * dy + dz * dz, oy * dy + oz * dz
    h = b * b - a * (oy * oy + oz * oz - radius * radius)
    if h < 0.0:
        return 0.0
    if dx != 0.0:
        t = ((half if side * dx > 0.0 else -half) - ox) / dx
        y, z = oy + t * dy, oz + t * dz
        if y * y + z * z <= radius * radius:
            return t
    if a == 0.0:
        return 0.0
    t = (-b + side * np.sqrt(h)) / a
    return t if abs(ox + t * dx) <= half else 0.0


@kernel(error_model="numpy", inline="always")
def disc_normal(p: Vector3, half: float, radius: float) -> Vector3:
    """Along x on the flat sides."""
    if abs(p[0]) > 0.999 * half:
        return np.copysign(1.0, p[0]), 0.0, 0.0
    return 0.0, p[1] / radius, p[2] / radius


@kernel(error_model="numpy", inline="always")
def block_surface(p: Vector3, block: Rounded) -> tuple[float, float, float, float]:
    """Signed distance (m) of a point from a block's surface, negative inside; and its gradient, the
    normal."""
    x, y, z = p
    hx, hy, hz, corner, edge = block.hx, block.hy, block.hz, block.corner, block.edge
    qx, qy = abs(x) - hx + corner, abs(y) - hy + corner
    plan, gx = max(qx, qy), 1.0 if qx > qy else 0.0
    gy = 1.0 - gx
    if qx > 0.0 and qy > 0.0:
        plan = np.sqrt(qx * qx + qy * qy)
        gx, gy = qx / plan, qy / plan
    a, b = plan - corner + edge, abs(z) - hz + edge
    away, ga = max(a, b), 1.0 if a > b else 0.0
    gb = 1.0 - ga
    if a > 0.0 and b > 0.0:
        away = np.sqrt(a * a + b * b)
        ga, gb = a / away, b / away
    nx, ny, nz = np.copysign(ga * gx, x), np.copysign(ga * gy, y), np.copysign(gb, z)
    return away - edge, nx, ny, nz


@kernel(error_model="numpy", inline="always")
def block_depth(o: Vector3, d: Vector3, block: Rounded, side: float) -> float:
    """By Newton's method from the block's bounding box.

    The distance to a convex body is convex along a ray, so that no step overshoots, and a ray whose
    distance no longer decreases misses.
    """
    enters, leaves = box_span(o, d, (block.hx, block.hy, block.hz))
    if enters > leaves:
        return 0.0
    t = enters if side < 0.0 else leaves
    for _ in range(STEPS):
        p = o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]
        away, nx, ny, nz = block_surface(p, block)
        if away < TOLERANCE:
            return t
        slope = nx * d[0] + ny * d[1] + nz * d[2]
        if side * slope <= 0.0:
            break
        t -= away / slope
    return 0.0
