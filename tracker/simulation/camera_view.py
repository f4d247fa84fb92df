"""Maps a camera's pixels to rays, and solids to pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, IntArray
from tracker.vision.rig import Camera


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


def _raw_bounds(box: Array, camera: Camera) -> Array:
    """Bounds in raw px; a lens bends edges, so corners and midpoints are mapped."""
    if camera.is_rectified or len(box) == 0:
        return box
    u, v = box[:, [0, 2]], box[:, [1, 3]]
    us = np.concatenate([u, u.mean(axis=1, keepdims=True)], axis=1)
    vs = np.concatenate([v, v.mean(axis=1, keepdims=True)], axis=1)
    grid = np.stack([np.repeat(us, 3, axis=1), np.tile(vs, (1, 3))], axis=-1)
    raw = camera.unrectify(grid.reshape(-1, 2)).reshape(len(box), 9, 2)
    return np.concatenate([raw.min(axis=1) - 2, raw.max(axis=1) + 2], axis=1)
