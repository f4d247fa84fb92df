"""Maps a camera's pixels to rays, and solids to pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector
from tracker.messages import Array, IntArray
from tracker.vision.rig import Camera

PLUMB_BOB = 5  # coefficients of a lens that `_bent` knows; longer lists only with zeros
LENS_PX = 2  # by which an edge that a lens bends exceeds its corners and its middle


def ray_map(camera: Camera) -> NDArray[np.float32]:
    """(h, w, 2): x/z and y/z in the rectified camera of each pixel as recorded."""
    u, v = np.meshgrid(np.arange(camera.width, dtype=float), np.arange(camera.height, dtype=float))
    uv = camera.rectify(np.column_stack([u.ravel(), v.ravel()]))
    P = camera.P
    rays = (uv - P[:2, 2]) / np.array([P[0, 0], P[1, 1]])
    return np.ascontiguousarray(rays.reshape(camera.height, camera.width, 2), np.float32)


def pitch_of(rays: NDArray[np.float32]) -> float:
    """The maximum difference between a pixel's ray of `ray_map` and those next to it or below
    it."""
    across, down = np.abs(np.diff(rays, axis=1)), np.abs(np.diff(rays, axis=0))
    return float(max(across.max(), down.max()))


def pixels_of(box: Array, camera: Camera) -> IntArray:
    """Solids' bounds (n, 4) in rectified px as whole pixels of the image, empty where unseen."""
    out = np.zeros((len(box), 4), np.int64)
    seen = np.isfinite(box).all(axis=1)
    raw = _raw_bounds(box[seen], camera)
    size = [camera.width, camera.height]
    out[seen, :2] = np.clip(np.floor(raw[:, :2]) - 1, 0, size)
    out[seen, 2:] = np.clip(np.ceil(raw[:, 2:]) + 2, 0, size)
    empty = (out[:, 0] >= out[:, 2]) | (out[:, 1] >= out[:, 3])
    out[empty] = 0
    return out


def within_rows(pixels: IntArray, first: int, end: int) -> IntArray:
    """Bounds (n, 4) px of what is in the rows from ``first`` to before ``end``, empty where nothing
    is."""
    out = pixels.copy()
    out[:, [1, 3]] = np.clip(out[:, [1, 3]], first, end)
    out[out[:, 1] >= out[:, 3]] = 0
    return out


def _raw_bounds(box: Array, camera: Camera) -> Array:
    """Bounds in raw px; a lens bends edges, so corners and midpoints are mapped."""
    if camera.is_rectified or len(box) == 0:
        return box
    if not camera.fisheye and not np.any(camera.D[PLUMB_BOB:]):
        D = np.zeros(PLUMB_BOB)
        D[: len(camera.D)] = camera.D[:PLUMB_BOB]
        return _bent(np.ascontiguousarray(box, float), camera.pixel_to_ray, camera.K, D)
    u, v = box[:, [0, 2]], box[:, [1, 3]]
    us = np.concatenate([u, u.mean(axis=1, keepdims=True)], axis=1)
    vs = np.concatenate([v, v.mean(axis=1, keepdims=True)], axis=1)
    grid = np.stack([np.repeat(us, 3, axis=1), np.tile(vs, (1, 3))], axis=-1)
    raw = camera.unrectify(grid.reshape(-1, 2)).reshape(len(box), 9, 2)
    return np.concatenate([raw.min(axis=1) - LENS_PX, raw.max(axis=1) + LENS_PX], axis=1)


@kernel(nogil=False)
def _bent(box: Matrix, to_ray: Matrix, K: Matrix, D: Vector) -> Matrix:
    """(n, 4) raw px of rectified bounds (n, 4), by the lens D (5,); ``to_ray`` (3, 3) from
    rectified pixels to directions in the camera."""
    out = np.empty((len(box), 4))
    for k in range(len(box)):
        out[k, :2], out[k, 2:] = np.inf, -np.inf
        for i in range(9):
            u = box[k, 0] + (box[k, 2] - box[k, 0]) * (i % 3) / 2
            v = box[k, 1] + (box[k, 3] - box[k, 1]) * (i // 3) / 2
            z = to_ray[2, 0] * u + to_ray[2, 1] * v + to_ray[2, 2]
            x = (to_ray[0, 0] * u + to_ray[0, 1] * v + to_ray[0, 2]) / z
            y = (to_ray[1, 0] * u + to_ray[1, 1] * v + to_ray[1, 2]) / z
            r2 = x * x + y * y
            gain = 1 + r2 * (D[0] + r2 * (D[1] + r2 * D[4]))
            a = x * gain + 2 * D[2] * x * y + D[3] * (r2 + 2 * x * x)
            b = y * gain + D[2] * (r2 + 2 * y * y) + 2 * D[3] * x * y
            a, b = K[0, 0] * a + K[0, 1] * b + K[0, 2], K[1, 1] * b + K[1, 2]
            out[k, 0], out[k, 1] = min(out[k, 0], a), min(out[k, 1], b)
            out[k, 2], out[k, 3] = max(out[k, 2], a), max(out[k, 3], b)
        out[k, :2] -= LENS_PX
        out[k, 2:] += LENS_PX
    return out
