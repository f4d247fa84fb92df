"""Where a ray meets a solid, in the solid's own frame S.

Each ``..._depth`` gets the camera o and the ray d in S, and ``side``: -1 for where the ray enters,
1 for where it leaves. It returns the depth in m, 0 where the ray misses. Each ``..._normal`` gets a
point of the surface and returns the outward normal. They take numbers alone: numba counts the
references to each array that it hands on, which takes longer than all the arithmetic here.
"""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel

CAPSULE, DISC, BLOCK = 0, 1, 2
Vector = tuple[float, float, float]
Rotation = tuple[float, float, float, float, float, float, float, float, float]
"""Row by row."""

TOLERANCE = 2e-5  # m, of a block's surface
STEPS = 24


@kernel(error_model="numpy", inline="always")
def capsule_depth(
    ox: float, oy: float, oz: float, dx: float, dy: float, dz: float,
    length: float, radius: float, side: float,
) -> float:  # fmt: skip
    """Around x from 0 to ``length``."""
    a, b = dy * dy + dz * dz, oy * dy + oz * dz
    c = oy * oy + oz * oz - radius * radius
    h = b * b - a * c
    if h < 0.0:  # past the endless cylinder, which the balls lie in
        return 0.0
    end = length if side * dx > 0.0 else 0.0  # of a ray along the axis
    if length > 0.0 and a > 1e-12 * dx * dx:
        t = (-b + side * np.sqrt(h)) / a
        x = ox + t * dx
        if 0.0 <= x <= length:
            return t
        end = 0.0 if x < 0.0 else length
    a += dx * dx
    b += (ox - end) * dx
    h = b * b - a * (c + (ox - end) * (ox - end))
    if h < 0.0:
        return 0.0
    return (-b + side * np.sqrt(h)) / a


@kernel(error_model="numpy", inline="always")
def capsule_normal(x: float, y: float, z: float, length: float, radius: float) -> Vector:
    """Away from the axis."""
    return (x - min(max(x, 0.0), length)) / radius, y / radius, z / radius


@kernel(error_model="numpy", inline="always")
def disc_depth(
    ox: float, oy: float, oz: float, dx: float, dy: float, dz: float,
    half: float, radius: float, side: float,
) -> float:  # fmt: skip
    """Around x from -``half`` to ``half``."""
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
def disc_normal(x: float, y: float, z: float, half: float, radius: float) -> Vector:
    """Along x on the flat sides."""
    if abs(x) > 0.999 * half:
        return np.copysign(1.0, x), 0.0, 0.0
    return 0.0, y / radius, z / radius


@kernel(error_model="numpy", inline="always")
def box_span(
    ox: float, oy: float, oz: float, dx: float, dy: float, dz: float,
    hx: float, hy: float, hz: float,
) -> tuple[float, float]:  # fmt: skip
    """Depths at which the ray enters and leaves a box around the origin; the first is larger
    where it misses."""
    low, high = -np.inf, np.inf
    for o, d, h in ((ox, dx, hx), (oy, dy, hy), (oz, dz, hz)):
        step = 1.0 / (d if abs(d) > 1e-12 else 1e-12)
        t0, t1 = (-h - o) * step, (h - o) * step
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low, high


@kernel(error_model="numpy", inline="always")
def block_surface(
    x: float, y: float, z: float, hx: float, hy: float, hz: float, corner: float, edge: float
) -> tuple[float, float, float, float]:
    """How far (m) a point is from a block's surface, less than 0 inside; and in which direction
    that grows most: the normal."""
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
def block_depth(
    ox: float, oy: float, oz: float, dx: float, dy: float, dz: float,
    hx: float, hy: float, hz: float, corner: float, edge: float, side: float,
) -> float:  # fmt: skip
    """By Newton's steps from the box that holds the block.

    The distance to a convex body is convex along a ray, so that no step goes too far, and a ray
    that no longer comes nearer misses.
    """
    enters, leaves = box_span(ox, oy, oz, dx, dy, dz, hx, hy, hz)
    if enters > leaves:
        return 0.0
    t = enters if side < 0.0 else leaves
    for _ in range(STEPS):
        x, y, z = ox + t * dx, oy + t * dy, oz + t * dz
        away, nx, ny, nz = block_surface(x, y, z, hx, hy, hz, corner, edge)
        if away < TOLERANCE:
            return t
        slope = nx * dx + ny * dy + nz * dz
        if side * slope <= 0.0:
            break
        t -= away / slope
    return 0.0
