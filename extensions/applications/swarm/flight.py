"""Flight of the drones: each to its slot, away from neighbours, fingers and walls.

All lengths are in m of the model in front of the hand; a drone is a point mass.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Stack, Vector, Written
from tracker.messages import Array

GOLDEN = np.pi * (3.0 - np.sqrt(5.0))
DENSITY = 0.74  # of the densest packing of balls


class FlightParams(NamedTuple):
    """stiffness 1/s², damping 1/s, fastest m/s; apart m between drones, clear m from walls; push
    m/s away from a finger that is nearer than ``reach`` m."""

    stiffness: float = 60.0
    damping: float = 14.0
    fastest: float = 0.8
    apart: float = 0.012
    clear: float = 0.006
    reach: float = 0.025
    push: float = 0.6


class Drones(NamedTuple):
    """p (N, 3) m in G, v (N, 3) m/s."""

    p: Matrix
    v: Matrix


def ball(count: int, spacing: float) -> Array:
    """Slots (N, 3) m about the origin, approximately ``spacing`` apart, on shells of a ball."""
    i = np.arange(count) + 0.5
    radius = spacing * np.cbrt(3 * i / (4 * np.pi * DENSITY))
    z = 1 - 2 * np.mod(i * 0.7548776662466927, 1.0)  # of the plastic number: evenly spread
    around = GOLDEN * i
    flat = np.sqrt(1 - z * z)
    return np.asarray(
        radius[:, None] * np.stack([flat * np.cos(around), flat * np.sin(around), z], axis=1)
    )


def fly(
    drones: Drones, slots: Array, fingers: Array, walls: Array, dt: float, params: FlightParams
) -> tuple[Drones, Array]:
    """The drones ``dt`` s later, and the displacement (N, 3) m of each by ``fingers`` (F, 3).

    slots (N, 3) m; walls (W, 3, 3) m are triangles that no drone crosses.
    """
    after = Drones(drones.p.copy(), drones.v.copy())
    pushed = np.zeros_like(after.p)
    _steer(drones, slots, fingers, params, dt, after, pushed)
    _hold(drones.p, walls, params.clear, after)
    return after, pushed


@kernel
def _steer(
    drones: Drones,
    slots: Matrix,
    fingers: Matrix,
    params: FlightParams,
    dt: float,
    after: Written[Drones],
    pushed: Written[Matrix],
) -> None:
    """Accelerate the drones, ignoring walls."""
    n = len(slots)
    force = np.zeros(3)
    for i in range(n):
        for k in range(3):
            away = slots[i, k] - drones.p[i, k]
            force[k] = params.stiffness * away - params.damping * drones.v[i, k]
        for j in range(n):
            dx = drones.p[i, 0] - drones.p[j, 0]
            dy = drones.p[i, 1] - drones.p[j, 1]
            dz = drones.p[i, 2] - drones.p[j, 2]
            near = dx * dx + dy * dy + dz * dz
            if j != i and near < params.apart * params.apart:
                d = max(np.sqrt(near), 1e-6)
                strength = params.stiffness * (params.apart - d) / d
                force[0] += strength * dx
                force[1] += strength * dy
                force[2] += strength * dz
        speed = 0.0
        for k in range(3):
            after.v[i, k] = drones.v[i, k] + dt * force[k]
            speed += after.v[i, k] ** 2
        slow = min(1.0, params.fastest / max(np.sqrt(speed), 1e-9))
        for k in range(3):
            after.v[i, k] *= slow
        for f in range(len(fingers)):
            d = 0.0
            for k in range(3):
                d += (drones.p[i, k] - fingers[f, k]) ** 2
            d = np.sqrt(d)
            if d < params.reach:
                for k in range(3):
                    out = (drones.p[i, k] - fingers[f, k]) / max(d, 1e-6)
                    pushed[i, k] += dt * params.push * (1 - d / params.reach) * out
        for k in range(3):
            after.p[i, k] = drones.p[i, k] + dt * after.v[i, k] + pushed[i, k]


@kernel
def _hold(before: Matrix, walls: Stack, clear: float, after: Written[Drones]) -> None:
    """Deflect steps that cross a wall or come within ``clear`` of it along the wall, or cancel
    them."""
    step, wall = np.zeros(3), np.zeros(3)
    for i in range(len(before)):
        for attempt in range(3):
            length = 0.0
            for k in range(3):
                step[k] = after.p[i, k] - before[i, k]
                length += step[k] ** 2
            length = np.sqrt(length)
            if length < 1e-12 or not meets(before, i, step, 1.0 + clear / length, walls, wall):
                break
            into = step[0] * wall[0] + step[1] * wall[1] + step[2] * wall[2]
            fast = after.v[i, 0] * wall[0] + after.v[i, 1] * wall[1] + after.v[i, 2] * wall[2]
            for k in range(3):
                stays = attempt == 2
                after.p[i, k] = before[i, k] + (0.0 if stays else step[k] - into * wall[k])
                after.v[i, k] = 0.0 if stays else after.v[i, k] - fast * wall[k]


@kernel
def meets(
    before: Matrix, i: int, step: Vector, reach: float, walls: Stack, wall: Written[Vector]
) -> bool:
    """Whether the segment from row ``i`` of ``before``, ``reach`` times ``step``, intersects a
    triangle; ``wall`` (3,) receives the normal of the nearest one.

    Möller & Trumbore (1997), doi:10.1080/10867651.1997.10487468.
    """
    nearest = reach
    found = False
    for w in range(len(walls)):
        e1x = walls[w, 1, 0] - walls[w, 0, 0]
        e1y = walls[w, 1, 1] - walls[w, 0, 1]
        e1z = walls[w, 1, 2] - walls[w, 0, 2]
        e2x = walls[w, 2, 0] - walls[w, 0, 0]
        e2y = walls[w, 2, 1] - walls[w, 0, 1]
        e2z = walls[w, 2, 2] - walls[w, 0, 2]
        hx = step[1] * e2z - step[2] * e2y
        hy = step[2] * e2x - step[0] * e2z
        hz = step[0] * e2y - step[1] * e2x
        a = e1x * hx + e1y * hy + e1z * hz
        if abs(a) < 1e-18:
            continue
        sx = before[i, 0] - walls[w, 0, 0]
        sy = before[i, 1] - walls[w, 0, 1]
        sz = before[i, 2] - walls[w, 0, 2]
        u = (sx * hx + sy * hy + sz * hz) / a
        if u < -1e-9 or u > 1 + 1e-9:
            continue
        qx = sy * e1z - sz * e1y
        qy = sz * e1x - sx * e1z
        qz = sx * e1y - sy * e1x
        v = (step[0] * qx + step[1] * qy + step[2] * qz) / a
        if v < -1e-9 or u + v > 1 + 1e-9:
            continue
        t = (e2x * qx + e2y * qy + e2z * qz) / a
        if 0 <= t < nearest:
            nearest, found = t, True
            nx, ny, nz = e1y * e2z - e1z * e2y, e1z * e2x - e1x * e2z, e1x * e2y - e1y * e2x
            size = np.sqrt(nx * nx + ny * ny + nz * nz)
            wall[0], wall[1], wall[2] = nx / size, ny / size, nz / size
    return found
