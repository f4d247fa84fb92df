"""Meshes of the 3D view's shapes, for a graphics card; uses only NumPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from app.widgets.view3d.shapes import Block, CapsuleShape, Disc, Lines, Shape, turn_x_to
from tracker.messages import Array


@dataclass(frozen=True)
class BodyMesh:
    """A surface of quads, or lines, in the body's own frame, m."""

    points: Array  # (N, 3)
    normals: Array  # (N, 3) outward unit normals; (0, 3) for lines
    cells: npt.NDArray[
        np.intp
    ]  # (M, 4) corners of each face, or (M, 2) ends of each line; indices of points

    @property
    def bounds(self) -> tuple[float, ...]:
        """(x0, x1, y0, y1, z0, z1)."""
        ends = np.stack([self.points.min(axis=0), self.points.max(axis=0)], axis=1)
        return tuple(ends.ravel().tolist())


def mesh_of(shape: Shape) -> BodyMesh:
    """The mesh of a shape in its own frame."""
    if isinstance(shape, CapsuleShape):
        return capsule(shape)
    if isinstance(shape, Disc):
        return disc(shape)
    if isinstance(shape, Block):
        return block(shape)
    return lines(shape)


def capsule(shape: CapsuleShape, sides: int = 24) -> BodyMesh:
    arc = np.linspace(0.0, np.pi / 2, sides // 4 + 2)
    half = np.stack([np.cos(arc), np.sin(arc)], axis=1)  # from the pole to the equator
    normals = np.vstack([half * [-1, 1], half[::-1]])
    profile = shape.radius * normals
    profile[len(arc) :, 0] += shape.length
    return _revolved(profile, normals, sides)


def disc(shape: Disc, sides: int = 16) -> BodyMesh:
    h, radius = shape.height / 2, shape.radius
    profile = np.array([[-h, 0], [-h, radius], [-h, radius], [h, radius], [h, radius], [h, 0]])
    normals = np.array([[-1, 0], [-1, 0], [0, 1], [0, 1], [1, 0], [1, 0]], float)
    mesh = _revolved(profile, normals, sides)
    R = turn_x_to(shape.normal)
    return BodyMesh(mesh.points @ R.T + shape.centre, mesh.normals @ R.T, mesh.cells)


def block(shape: Block, sides: int = 6) -> BodyMesh:
    """The outline follows the edges with ``sides`` steps per corner, from the centre of one flat
    side to that of the other."""
    quarter = np.linspace(0.0, np.pi / 2, sides + 1)
    angle = (quarter + np.pi / 2 * np.arange(4)[:, None]).ravel()
    out = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)  # (A, 3) of the outline
    corners = np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]])
    outline = np.repeat(corners, sides + 1, axis=0) * (shape.half - shape.corner)
    outline = outline + out * (shape.corner - shape.edge)
    up = np.array([0.0, 0.0, 1.0])
    rise = np.concatenate([-quarter[::-1], quarter])[:, None, None]
    normals = np.cos(rise) * out + np.sin(rise) * up
    level = np.sign(rise) * (shape.half[2] - shape.edge) * up
    level[sides] = -level[-1]  # at zero height the lower edge ends and the upper one begins
    level[sides + 1] = level[-1]
    points = outline + level + shape.edge * normals
    flat = np.broadcast_to(up, (1, *outline.shape))
    points = np.concatenate([-shape.half[2] * flat, points, shape.half[2] * flat])
    normals = np.concatenate([-flat, normals, flat])
    return BodyMesh(
        points.reshape(-1, 3) + shape.centre,
        normals.reshape(-1, 3),
        _grid(len(points), len(angle)),
    )


def lines(shape: Lines) -> BodyMesh:
    return BodyMesh(np.asarray(shape.points, float), np.empty((0, 3)), shape.pairs)


def _revolved(profile: Array, normals: Array, sides: int) -> BodyMesh:
    """A surface of revolution: a profile (K, 2) of (along x, distance from x) with its normals."""
    angle = np.linspace(0.0, 2 * np.pi, sides + 1)[:-1]
    spokes = np.stack([np.zeros(sides), np.cos(angle), np.sin(angle)], axis=1)  # (S, 3)

    def turned(rows: Array) -> Array:
        along = rows[:, :1, None] * np.array([1.0, 0.0, 0.0])
        return (along + rows[:, 1:, None] * spokes).reshape(-1, 3)

    return BodyMesh(turned(profile), turned(normals), _grid(len(profile), sides))


def _grid(rows: int, columns: int) -> npt.NDArray[np.intp]:
    """(M, 4) quads of a grid whose columns form a closed ring."""
    at = np.arange(rows * columns).reshape(rows, columns)
    right = np.roll(at, -1, axis=1)
    quads = np.stack([at[:-1], right[:-1], right[1:], at[1:]], axis=-1)
    return quads.reshape(-1, 4)
