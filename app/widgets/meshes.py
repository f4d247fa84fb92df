"""Bodies of the 3D view as points, normals and faces; no more than NumPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from tracker.messages import Array


@dataclass(frozen=True)
class Mesh:
    """A surface of quads, or lines. In the body's own frame, m."""

    points: Array  # (N, 3)
    normals: Array  # (N, 3) outwards, of length 1; (0, 3) for lines
    cells: npt.NDArray[
        np.intp
    ]  # (M, 4) corners of each face, or (M, 2) ends of each line; indices of points

    @property
    def bounds(self) -> tuple[float, ...]:
        """(x0, x1, y0, y1, z0, z1)."""
        ends = np.stack([self.points.min(axis=0), self.points.max(axis=0)], axis=1)
        return tuple(ends.ravel().tolist())


def ball(radius: float, sides: int = 12) -> Mesh:
    """Around the origin."""
    return capsule(0.0, radius, sides)


def capsule(length: float, radius: float, sides: int = 10) -> Mesh:
    """Along x from the origin to ``length``, with half a ball on either end."""
    arc = np.linspace(0.0, np.pi / 2, sides // 4 + 2)
    half = np.stack([np.cos(arc), np.sin(arc)], axis=1)  # from the pole to the equator
    normals = np.vstack([half * [-1, 1], half[::-1]])
    profile = radius * normals
    profile[len(arc) :, 0] += length
    return _revolved(profile, normals, sides)


def disc(radius: float, height: float, direction: Array, sides: int = 12) -> Mesh:
    """A flat cylinder around the origin whose axis is ``direction`` (3,) of length 1."""
    h = height / 2
    profile = np.array([[-h, 0], [-h, radius], [-h, radius], [h, radius], [h, radius], [h, 0]])
    normals = np.array([[-1, 0], [-1, 0], [0, 1], [0, 1], [1, 0], [1, 0]], float)
    mesh = _revolved(profile, normals, sides)
    R = _turn_x_to(direction)
    return Mesh(mesh.points @ R.T, mesh.normals @ R.T, mesh.cells)


def rounded_block(half: Array, roundness: float = 0.4, sides: int = 24) -> Mesh:
    """A superquadric around the origin; ``half`` (3,) is its size along each axis."""
    around = np.linspace(-np.pi, np.pi, sides + 1)[:-1]
    up = np.linspace(-np.pi / 2, np.pi / 2, sides // 2 + 1)[:, None]
    points = _superquadric(up, around, roundness)
    normals = _superquadric(up, around, 2 - roundness) / half
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return Mesh((points * half).reshape(-1, 3), normals.reshape(-1, 3), _grid(len(up), sides))


def lines(points: Array, pairs: list[tuple[int, int]]) -> Mesh:
    """Lines between ``points`` (N, 3)."""
    return Mesh(np.asarray(points, float), np.empty((0, 3)), np.array(pairs, int))


def _superquadric(up: Array, around: Array, exponent: float) -> Array:
    """(U, A, 3) on the unit superquadric; with 2 - exponent its normals before scaling."""

    def power(x: Array) -> Array:
        return np.sign(x) * np.abs(x) ** exponent

    flat = power(np.cos(up))
    x, y = flat * power(np.cos(around)), flat * power(np.sin(around))
    return np.stack([x, y, np.broadcast_to(power(np.sin(up)), x.shape)], axis=-1)


def _revolved(profile: Array, normals: Array, sides: int) -> Mesh:
    """A profile (K, 2) of (along x, away from x), with its normals, turned around x."""
    angle = np.linspace(0.0, 2 * np.pi, sides + 1)[:-1]
    spokes = np.stack([np.zeros(sides), np.cos(angle), np.sin(angle)], axis=1)  # (S, 3)

    def turned(rows: Array) -> Array:
        along = rows[:, :1, None] * np.array([1.0, 0.0, 0.0])
        return (along + rows[:, 1:, None] * spokes).reshape(-1, 3)

    return Mesh(turned(profile), turned(normals), _grid(len(profile), sides))


def _grid(rows: int, columns: int) -> npt.NDArray[np.intp]:
    """(M, 4) quads between neighbours of a grid whose columns close to a ring."""
    at = np.arange(rows * columns).reshape(rows, columns)
    right = np.roll(at, -1, axis=1)
    quads = np.stack([at[:-1], right[:-1], right[1:], at[1:]], axis=-1)
    return quads.reshape(-1, 4)


def _turn_x_to(direction: Array) -> Array:
    """(3, 3) a rotation that takes x to ``direction``."""
    other = np.eye(3)[np.abs(direction).argmin()]
    y = np.cross(direction, other)
    y /= np.linalg.norm(y)
    return np.stack([direction, y, np.cross(direction, y)], axis=1)
