"""Colour of each pixel: cloth, marker patches wrapped on it, light from one side."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    ByteVector,
    Float32Stack,
    Float32Vector,
    Int32Vector,
    IntVector,
    Matrix,
    Vector,
    Written,
)
from tracker.simulation.raster import Buffer, PixelRays
from tracker.simulation.sewn import PixelRun, Place, SeenPatches, find_patches
from tracker.simulation.solids import Solids


class SolidColours(NamedTuple):
    """For all solids, capsules first: owner (n,) and colour (n, 3) BGR."""

    owner: IntVector
    colour: Matrix


class Light(NamedTuple):
    """A unit vector (3,) in C towards the light, and the share of ambient light."""

    direction: Vector
    ambient: float


class LitCapsule(NamedTuple):
    """Its axis over the axis' square (e), and its product with the vector from its end to the eye;
    the direction of the lamp over its radius (l), and its products with the same vector and the
    axis; and the share of ambient light."""

    e0: np.float32
    e1: np.float32
    e2: np.float32
    ew: np.float32
    l0: np.float32
    l1: np.float32
    l2: np.float32
    wl: np.float32
    el: np.float32
    ambient: np.float32


@kernel(fastmath=True, error_model="numpy", wide=True)
def shade(
    rays: PixelRays,
    buffer: Buffer,
    solids: Solids,
    cloth: SolidColours,
    patches: SeenPatches,
    lamp: Light,
    ground: ByteStack,
    total: Written[Float32Stack],
) -> None:
    """Add one exposure to ``total`` (h, w, 3) BGR; ``ground`` (h, w, 3) is visible elsewhere.

    Processes runs of pixels that show one solid: common terms are computed once, and the pixels are
    lit without a branch and in single precision, so that the loop is vectorised.
    """
    depth, ident, corner, capsules = buffer.depth, buffer.solid, rays.corner, len(solids.radius)
    slope, image, wall = rays.slope.reshape(-1), total.reshape(-1), ground.reshape(-1)
    jx, jy = np.float32(rays.jitter[0]), np.float32(rays.jitter[1])
    rows, columns = depth.shape
    bright, patch = np.empty(columns, np.float32), np.empty(columns, np.int32)
    for row in range(rows):
        before = 2 * ((row + corner[0]) * rays.slope.shape[1] + corner[1])
        end = 0
        while end < columns:
            begin, i = end, ident[row, end]
            while end < columns and ident[row, end] == i:
                end += 1
            first = 3 * (row * columns + begin)
            into = image[first : first + 3 * (end - begin)]
            if i < 0:
                _add_ground(wall[first : first + 3 * (end - begin)], into)
                continue
            run = PixelRun(
                slope[before + 2 * begin : before + 2 * end],
                depth[row, begin:end],
                jx,
                jy,
                rays.eye,
            )
            lit = bright[: end - begin]
            if i < capsules:
                _light_capsule(run, _lit_capsule(rays.eye, solids, i, lamp), lit)
            else:
                _light_box(run, solids, i - capsules, lamp, lit)
            at = Place(row + corner[0], begin + corner[1], cloth.owner[i])
            covered = patch[: end - begin]
            if find_patches(run, at, patches, covered):
                _add_patched(lit, covered, cloth.colour, patches.fabric, i, into)
            else:
                _add_plain(lit, cloth.colour, i, into)


@kernel(inline="always")
def _add_ground(wall: ByteVector, into: Written[Float32Vector]) -> None:
    for k in range(len(into)):
        into[k] += wall[k]


@kernel(fastmath=True, inline="always")
def _add_plain(lit: Float32Vector, colour: Matrix, i: int, into: Written[Float32Vector]) -> None:
    """Cloth of one colour."""
    blue, green, red = np.float32(colour[i, 0]), np.float32(colour[i, 1]), np.float32(colour[i, 2])
    for k in range(len(lit)):
        into[3 * k] += blue * lit[k]
        into[3 * k + 1] += green * lit[k]
        into[3 * k + 2] += red * lit[k]


@kernel(fastmath=True, inline="always")
def _add_patched(
    lit: Float32Vector,
    covered: Int32Vector,
    colour: Matrix,
    fabric: Matrix,
    i: int,
    into: Written[Float32Vector],
) -> None:
    """Cloth partly covered by patches."""
    for k in range(len(lit)):
        for c in range(3):
            base = fabric[covered[k], c] if covered[k] >= 0 else colour[i, c]
            into[3 * k + c] += np.float32(base) * lit[k]


@kernel(fastmath=True, error_model="numpy", inline="always")
def _lit_capsule(eye: Vector, solids: Solids, i: int, lamp: Light) -> LitCapsule:
    """Capsule i for `_light_capsule`."""
    a, b, r, light = solids.a, solids.b, solids.radius[i], lamp.direction
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = eye[0] - a[i, 0], eye[1] - a[i, 1], eye[2] - a[i, 2]
    per = 1.0 / max(e0 * e0 + e1 * e1 + e2 * e2, 1e-12)
    scale = (1 - lamp.ambient) / r
    el = scale * (e0 * light[0] + e1 * light[1] + e2 * light[2])
    wl = scale * (w0 * light[0] + w1 * light[1] + w2 * light[2])
    return LitCapsule(
        np.float32(per * e0), np.float32(per * e1), np.float32(per * e2),
        np.float32(per * (e0 * w0 + e1 * w1 + e2 * w2)),
        np.float32(scale * light[0]), np.float32(scale * light[1]), np.float32(scale * light[2]),
        np.float32(wl), np.float32(el), np.float32(lamp.ambient),
    )  # fmt: skip


@kernel(fastmath=True, inline="always")
def _light_capsule(run: PixelRun, capsule: LitCapsule, lit: Written[Float32Vector]) -> None:
    """Irradiance (n,) of each pixel of a run: at the point q = w + z (x, y, 1) from the capsule's
    end, the normal is q minus its part along the axis, over the radius."""
    slope, depth, jx, jy = run.slope, run.depth, run.jx, run.jy
    e0, e1, e2, ew, l0, l1, l2, wl, el, ambient = capsule
    zero, one = np.float32(0.0), np.float32(1.0)
    for k in range(len(lit)):
        x, y, z = slope[2 * k] + jx, slope[2 * k + 1] + jy, depth[k]
        share = min(max(ew + z * (e0 * x + e1 * y + e2), zero), one)
        lit[k] = ambient + max(wl + z * (l0 * x + l1 * y + l2) - share * el, zero)


@kernel(fastmath=True, inline="always")
def _light_box(
    run: PixelRun, solids: Solids, i: int, lamp: Light, lit: Written[Float32Vector]
) -> None:
    """As `_light_capsule`, for box i: a point is on the face that it is closest to."""
    R, centre, half, light, eye = solids.box_R, solids.centre, solids.half, lamp.direction, run.eye
    for k in range(len(lit)):
        z = run.depth[k]
        d0 = eye[0] + z * (run.slope[2 * k] + run.jx) - centre[i, 0]
        d1 = eye[1] + z * (run.slope[2 * k + 1] + run.jy) - centre[i, 1]
        d2 = eye[2] + z - centre[i, 2]
        best, cosine = -1e9, 0.0
        for c in range(3):
            x = R[i, 0, c] * d0 + R[i, 1, c] * d1 + R[i, 2, c] * d2
            if abs(x) - half[i, c] > best:
                best = abs(x) - half[i, c]
                cosine = R[i, 0, c] * light[0] + R[i, 1, c] * light[1] + R[i, 2, c] * light[2]
                cosine = cosine if x > 0 else -cosine
        lit[k] = lamp.ambient + (1 - lamp.ambient) * max(cosine, 0.0)


@kernel(wide=True)
def develop(
    total: Float32Stack,
    exposures: int,
    gain: Float32Vector,
    noise: Float32Stack,
    shift: IntVector,
    corner: IntVector,
    out: Written[ByteStack],
) -> None:
    """Mean of the exposures, each row times its ``gain`` (H,), plus sensor noise, rounded, written
    to the part of ``out`` (H, W, 3) uint8 that starts at the corner (v0, u0).

    noise (n, m, 3) is a scaled tile; shift (2,) is the origin in it.
    """
    rows, columns, width = noise.shape[0], noise.shape[1], total.shape[1]
    light, grain, image = total.reshape(-1), noise.reshape(-1), out.reshape(-1)
    share = np.float32(1.0 / exposures)
    for v in range(total.shape[0]):
        tile = 3 * ((v + shift[0]) % rows) * columns
        own = share * gain[v + corner[0]]
        to = 3 * ((v + corner[0]) * out.shape[1] + corner[1])
        begin = 0
        while begin < width:
            column = (begin + shift[1]) % columns
            n = 3 * min(columns - column, width - begin)
            row, at = 3 * (v * width + begin), to + 3 * begin
            _round(
                light[row : row + n],
                own,
                grain[tile + 3 * column : tile + 3 * column + n],
                image[at : at + n],
            )
            begin += columns - column


@kernel(inline="always")
def _round(
    light: Float32Vector, share: np.float32, grain: Float32Vector, out: Written[ByteVector]
) -> None:
    """For a part of a row, with interleaved channels."""
    for k in range(len(out)):
        value = light[k] * share + grain[k] + np.float32(0.5)
        out[k] = np.uint8(np.int32(min(max(value, np.float32(0.0)), np.float32(255.0))))
