"""Capsules of cloth with a texture that is fixed to them, as two cameras see it."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tests.cloth_masks import bits_of, cloth_of, looked_at
from tracker.messages import Array, CameraPose, Cloth
from tracker.vision.rig import StereoRig

CELL = 0.0025  # m, of the texture
WRONG = 0.1  # share of the bits that noise changes
Capsule = tuple[Array, Array, float]
"""Both ends (3,) m in G, and the radius, m."""


def textured(capsules: Sequence[Capsule], rig: StereoRig, pose: CameraPose, right: bool) -> Cloth:
    """All tiles of an image of the capsules; nearer ones are in front."""
    x, y = looked_at(rig.left.height, rig.left.width)
    origin = np.array([rig.baseline * right, 0.0, 0.0])
    ray = np.stack([(x - rig.cx) / rig.fx, (y - rig.cy) / rig.fy, np.ones(x.shape)], axis=-1)
    depth, bright = np.full(x.shape, np.inf), np.zeros(x.shape, bool)
    for number, (start, end, r) in enumerate(capsules):
        a, b = (np.stack([start, end]) - pose.p_GC) @ pose.R_GC
        middle, reach = (a + b) / 2 - origin, np.linalg.norm(b - a) / 2 + r
        u, v = rig.fx * middle[0] / middle[2] + rig.cx, rig.fy * middle[1] / middle[2] + rig.cy
        near = np.hypot(x - u, y - v) <= 1.1 * rig.fx * reach / middle[2]
        z = _distance(ray[near], a - origin, b - origin, r)
        point = ray[near] * z[:, None] + origin  # infinite beside the capsule
        first = z < depth[near]
        at = np.flatnonzero(near)[first]
        on = point[first] @ pose.R_GC.T + pose.p_GC - start
        bright.reshape(-1)[at] = _hashed(on @ _axes(end - start).T, number)
        depth.reshape(-1)[at] = z[first]
    mask = np.isfinite(depth)
    bright ^= np.random.default_rng(int(right)).uniform(size=bright.shape) < WRONG
    found = cloth_of(mask)
    return Cloth(found.columns, found.rows, found.tile, found.bits, bits_of(bright & mask))


def _distance(ray: Array, a: Array, b: Array, r: float) -> Array:
    """(n,) z of the first point of a capsule on each ray (n, 3), infinite without one."""
    length = np.linalg.norm(b - a)
    axis = (b - a) / length if length > 1e-6 else np.array([1.0, 0.0, 0.0])
    out = np.full(len(ray), np.inf)
    for centre, around in ((a, axis), (a, None), (b, None)):
        d = ray - np.outer(ray @ around, around) if around is not None else ray
        w = -centre + (centre @ around) * around if around is not None else -centre
        A, B, C = (d * d).sum(axis=1), d @ w, w @ w - r * r
        root = B * B - A * C
        z = np.where(
            root >= 0.0, (-B - np.sqrt(np.maximum(root, 0.0))) / np.maximum(A, 1e-12), np.inf
        )
        if around is not None:
            along = (ray * np.where(np.isfinite(z), z, 0.0)[:, None] - a) @ axis
            z = np.where((along >= 0.0) & (along <= length), z, np.inf)
        out = np.minimum(out, z)
    return out


def _axes(along: Array) -> Array:
    """(3, 3) rows: a frame whose first axis is ``along``."""
    helper = np.eye(3)[int(np.argmin(np.abs(along)))]
    x = along / max(np.linalg.norm(along), 1e-9) if np.any(along) else np.eye(3)[0]
    y = np.cross(x, helper)
    y /= max(np.linalg.norm(y), 1e-9)
    return np.stack([x, y, np.cross(x, y)])


def _hashed(points: Array, number: int) -> NDArray[np.bool_]:
    """A bit of each cell in which points (n, 3) m are."""
    i, j, k = np.floor(points / CELL).astype(np.int64).T
    mixed = (i * 73856093) ^ (j * 19349663) ^ (k * 83492791) ^ (number * 2654435761)
    mixed = (mixed ^ (mixed >> 13)) * 1274126177
    return np.asarray((mixed >> 17) & 1, bool)
