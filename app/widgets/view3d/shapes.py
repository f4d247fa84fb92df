"""Bodies of the 3D view as pure forms, each in a frame of its own; whoever draws them knows how."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from tracker.messages import Array


def _origin() -> Array:
    return np.zeros(3)


@dataclass(frozen=True, eq=False)
class CapsuleShape:
    """Along x from the origin to ``length`` (m), with half a ball on either end."""

    length: float
    radius: float


@dataclass(frozen=True, eq=False)
class Disc:
    """A flat cylinder around ``centre`` (3,), m, whose axis is ``normal`` (3,) of length 1."""

    radius: float
    height: float
    normal: Array
    centre: Array = field(default_factory=_origin)


@dataclass(frozen=True, eq=False)
class Block:
    """A slab around ``centre`` (3,), ``half`` (3,) as large along each axis, m, thinnest along z.

    Seen along z it is a rectangle with round corners; its edges are round too.
    """

    half: Array
    centre: Array = field(default_factory=_origin)

    CORNER = 0.45  # radius of the corners seen along z, of the shorter half side
    EDGE = 0.75  # radius of the edges, of the half thickness

    @property
    def corner(self) -> float:
        """Radius of the corners seen along z, m."""
        return float(max(self.CORNER * self.half[:2].min(), self.edge))

    @property
    def edge(self) -> float:
        """Radius of the edges, m."""
        return float(self.EDGE * self.half[2])


@dataclass(frozen=True, eq=False)
class Lines:
    """Straight lines between ``points`` (N, 3), m; ``pairs`` (M, 2) are the ends of each."""

    points: Array
    pairs: npt.NDArray[np.intp]


DRESS = 7
"""Numbers that say how a point of a `Surface` looks: red, green, blue, cover, ambient, hatch, dots;
shares of one."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles ``faces`` (F, 3) between V points that move, counter-clockwise seen from outside.

    part (F,) tells parts apart whose edges are to be smooth before one another; along (V,) m is
    what lines of hatching follow.
    """

    faces: npt.NDArray[np.int64]
    part: npt.NDArray[np.int64]
    along: Array


Shape = CapsuleShape | Disc | Block | Lines


def ball(radius: float) -> CapsuleShape:
    """Around the origin."""
    return CapsuleShape(0.0, radius)


def polyline(points: Array) -> Lines:
    """From each of ``points`` (N, 3) to the next."""
    first = np.arange(len(points) - 1)
    return Lines(np.asarray(points, float), np.stack([first, first + 1], axis=1))


def turn_x_to(direction: Array) -> Array:
    """(3, 3) a rotation that takes x to ``direction`` (3,) of length 1."""
    other = np.eye(3)[np.abs(direction).argmin()]
    y = np.cross(direction, other)
    y /= np.linalg.norm(y)
    return np.stack([direction, y, np.cross(direction, y)], axis=1)
