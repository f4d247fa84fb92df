"""The gloved hand in linear light: textured cloth, irregular patches, a lamp and its shadow."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    Float32Matrix,
    Float32Stack,
    IntVector,
    Matrix,
    Stack,
    Vector,
    Written,
)
from tracker.simulation.desk.shadow import CastShadow, lit_share
from tracker.simulation.raster import Buffer, PixelRays
from tracker.simulation.sewn import SewnPatches, patch_at
from tracker.simulation.solids import SceneInstant

GRAIN_TEXEL = 0.0004  # m
FELT = 0.4  # grain of felt, relative to the knitted cloth's
OTHERS = 0.35  # likewise for sleeves, skin and held objects


class Knit(NamedTuple):
    """For all solids, capsules first: owner (n,) and colour (n, 3) linear BGR. Tiles (n, n), n a
    power of two: brightness of the cloth about 1, and displacement (m) of patches' edges."""

    owner: IntVector
    colour: Matrix
    grain: Float32Matrix
    ragged: Float32Matrix


class RoomLights(NamedTuple):
    """A lamp at a position (3,) in C, m, with colour (3,) linear BGR at the working volume, reach2
    (m²) its squared distance from there, softness as in `lights.RoomLight`; a second lamp; ambient
    light, mostly from ``up`` (3,); vignetting, and the leak into red."""

    place: Vector
    colour: Vector
    reach2: float
    softness: float
    second_place: Vector
    second: Vector
    second_reach2: float
    sky: Vector
    up: Vector
    vignetting: float
    leak: float


class Surroundings(NamedTuple):
    """The light on the hand, and base (h, w, 3) linear BGR of the region behind it."""

    lights: RoomLights
    shadow: CastShadow
    base: Float32Stack


@kernel(fastmath=True)
def shade_knit(
    rays: PixelRays,
    buffer: Buffer,
    now: SceneInstant,
    knit: Knit,
    patches: SewnPatches,
    around: Surroundings,
    total: Written[Float32Stack],
) -> None:
    """Add one exposure to ``total`` (h, w, 3) linear BGR."""
    slope, jitter, eye, corner = rays.slope, rays.jitter, rays.eye, rays.corner
    light, shadow, base = around.lights, around.shadow, around.base
    depth, solid, R, p = buffer.depth, buffer.solid, now.R_CB, now.p_CB
    a, b, radius, capsules = now.solids.a, now.solids.b, now.solids.radius, len(now.solids.radius)
    box_R, centre, half = now.solids.box_R, now.solids.centre, now.solids.half
    owner, colour, fabric = knit.owner, knit.colour, patches.fabric
    tile, ragged = knit.grain, knit.ragged
    height, origin, axes = shadow.height, shadow.origin, shadow.axes
    place, second_place, up = light.place, light.second_place, light.up
    main_bgr, second_bgr, sky_bgr = light.colour, light.second, light.sky
    soft, vignetting, leak = light.softness, light.vignetting, light.leak
    reach2, second_reach2 = light.reach2, light.second_reach2
    jx, jy = jitter[0], jitter[1]
    for row in range(depth.shape[0]):
        for column in range(depth.shape[1]):
            i = solid[row, column]
            if i < 0:
                for c in range(3):
                    total[row, column, c] += base[row, column, c]
                continue
            z = depth[row, column]
            v, u = row + corner[0], column + corner[1]
            sx, sy = slope[v, u, 0] + jx, slope[v, u, 1] + jy
            q = (eye[0] + z * sx, eye[1] + z * sy, eye[2] + z)
            if i < capsules:
                n = _capsule_normal(q, a, b, radius, i)
            else:
                n = _box_normal(q, box_R, centre, half, i - capsules)
            s, m = owner[i], -1
            grain, wander = _texel(_on_cloth(q, R, p, max(s, 0)), tile, ragged)
            share = OTHERS
            if s >= 0:
                there = (
                    q[0] + wander * (R[s, 0, 0] + R[s, 0, 1]),
                    q[1] + wander * (R[s, 1, 0] + R[s, 1, 1]),
                    q[2] + wander * (R[s, 2, 0] + R[s, 2, 1]),
                )
                m = patch_at(there, R, p, s, patches)
                share = FELT if m >= 0 else 1.0
            bright = (1.0 + share * (grain - 1.0)) / (1.0 + vignetting * (sx * sx + sy * sy))
            main = bright * reach2 * lit_share(q, origin, axes, height)
            main *= _irradiance(q, n, place, soft)
            second = bright * second_reach2 * _irradiance(q, n, second_place, 0.0)
            sky = bright * (0.6 + 0.4 * (n[0] * up[0] + n[1] * up[1] + n[2] * up[2]))
            blue = main * main_bgr[0] + second * second_bgr[0] + sky * sky_bgr[0]
            green = main * main_bgr[1] + second * second_bgr[1] + sky * sky_bgr[1]
            red = main * main_bgr[2] + second * second_bgr[2] + sky * sky_bgr[2]
            if m >= 0:
                blue, green, red = blue * fabric[m, 0], green * fabric[m, 1], red * fabric[m, 2]
            else:
                blue, green, red = blue * colour[i, 0], green * colour[i, 1], red * colour[i, 2]
            total[row, column, 0] += np.float32(blue)
            total[row, column, 1] += np.float32(green)
            total[row, column, 2] += np.float32(red + leak * (blue + green))


@kernel(fastmath=True, inline="always")
def _capsule_normal(q: Vector3, a: Matrix, b: Matrix, radius: Vector, i: int) -> Vector3:
    """Outward normal at the point q of capsule i."""
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = q[0] - a[i, 0], q[1] - a[i, 1], q[2] - a[i, 2]
    ee = max(e0 * e0 + e1 * e1 + e2 * e2, 1e-12)
    share, r = min(max((e0 * w0 + e1 * w1 + e2 * w2) / ee, 0.0), 1.0), radius[i]
    return (w0 - share * e0) / r, (w1 - share * e1) / r, (w2 - share * e2) / r


@kernel(fastmath=True, inline="always")
def _box_normal(q: Vector3, R: Stack, centre: Matrix, half: Matrix, i: int) -> Vector3:
    """Outward normal of the face of box i that contains the point q."""
    best, face, sign = -1e9, 0, 1.0
    d0, d1, d2 = q[0] - centre[i, 0], q[1] - centre[i, 1], q[2] - centre[i, 2]
    for k in range(3):
        x = R[i, 0, k] * d0 + R[i, 1, k] * d1 + R[i, 2, k] * d2
        if abs(x) - half[i, k] > best:
            best, face, sign = abs(x) - half[i, k], k, (1.0 if x > 0 else -1.0)
    return sign * R[i, 0, face], sign * R[i, 1, face], sign * R[i, 2, face]


@kernel(fastmath=True, inline="always")
def _irradiance(q: Vector3, n: Vector3, place: Vector, soft: float) -> float:
    """Irradiance by a lamp of a surface with normal n at the point q."""
    d0, d1, d2 = place[0] - q[0], place[1] - q[1], place[2] - q[2]
    r2 = d0 * d0 + d1 * d1 + d2 * d2
    cosine = (d0 * n[0] + d1 * n[1] + d2 * n[2]) / np.sqrt(r2)
    return max((cosine + soft) / (1 + soft), 0.0) / r2


@kernel(fastmath=True, inline="always")
def _on_cloth(q: Vector3, R: Stack, p: Matrix, i: int) -> tuple[float, float]:
    """The point q of C in coordinates along segment i, and across it."""
    d0, d1, d2 = q[0] - p[i, 0], q[1] - p[i, 1], q[2] - p[i, 2]
    along = R[i, 0, 0] * d0 + R[i, 1, 0] * d1 + R[i, 2, 0] * d2
    y = R[i, 0, 1] * d0 + R[i, 1, 1] * d1 + R[i, 2, 1] * d2
    return along, y + 0.8 * (R[i, 0, 2] * d0 + R[i, 1, 2] * d1 + R[i, 2, 2] * d2)


@kernel(fastmath=True, inline="always")
def _texel(
    x: tuple[float, float], grain: Float32Matrix, ragged: Float32Matrix
) -> tuple[float, float]:
    """Brightness and edge displacement at a point of a segment's cloth, m."""
    last = grain.shape[0] - 1
    i = int(np.floor(x[0] / GRAIN_TEXEL)) & last
    j = int(np.floor(x[1] / GRAIN_TEXEL)) & last
    return grain[i, j], ragged[i, j]
