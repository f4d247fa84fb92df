"""The way of a fingertip as a ribbon that faces the eye and tapers to its oldest end."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array, IntArray

WIDEST = 0.0024  # m, at the fingertip
SMOOTH = np.array([1.0, 2.0, 3.0, 2.0, 1.0]) / 9.0


def ribbon_faces(points: int) -> IntArray:
    """(F, 3) triangles between the sides of a ribbon of so many points, seen from either side."""
    i = 2 * np.arange(points - 1)
    one = np.concatenate([np.stack([i, i + 1, i + 2], 1), np.stack([i + 2, i + 1, i + 3], 1)])
    return np.concatenate([one, one[:, ::-1]])


def ribbon(trail: Array, eye: Array, colour: tuple[float, ...]) -> tuple[Array, Array, Array]:
    """Points (2N, 3) m, normals (2N, 3) and looks (2N, 7) along a trail (N, 3), oldest first."""
    padded = np.concatenate([trail[[0, 0]], trail, trail[[-1, -1]]])
    way = sum(w * padded[k : k + len(trail)] for k, w in enumerate(SMOOTH))
    way[-1] = trail[-1]
    forward = np.gradient(way, axis=0)
    to_eye = eye - way
    side = np.cross(forward, to_eye)
    length = np.linalg.norm(side, axis=1, keepdims=True)
    side = np.where(length > 1e-9, side / np.maximum(length, 1e-9), 0.0)
    age = np.linspace(0.0, 1.0, len(trail))[:, None]
    half = 0.5 * WIDEST * (0.25 + 0.75 * age) * side
    points = np.stack([way - half, way + half], axis=1).reshape(-1, 3)
    normals = np.repeat(to_eye / np.linalg.norm(to_eye, axis=1, keepdims=True), 2, axis=0)
    looks = np.tile([*colour, 1.0, 0.6, 0.0, 0.0], (len(points), 1))
    looks[:, 3] = np.repeat(age[:, 0], 2)
    return points, normals, looks
