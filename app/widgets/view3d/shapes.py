"""Analytic shapes of the 3D view, each in its own frame."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from tracker.messages import Array


def _origin() -> Array:
    return np.zeros(3)


@dataclass(frozen=True, eq=False)
class CapsuleShape:
    """A capsule along x from the origin to ``length`` (m)."""

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
    """A rounded slab around ``centre`` (3,) with half sides ``half`` (3,), m, thinnest along z.

    Along z it appears as a rectangle with round corners; its edges are round, too.
    """

    half: Array
    centre: Array = field(default_factory=_origin)

    CORNER = 0.45  # radius of the corners relative to the shorter half side
    EDGE = 0.75  # radius of the edges relative to the half thickness

    @property
    def corner(self) -> float:
        """Radius of the corners in the xy plane, m."""
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
"""Values per point of a `Surface`: red, green, blue, opacity, ambient, hatch, dots, 0..1."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles ``faces`` (F, 3) between V moving points, counter-clockwise from outside.

    part (F,): parts with smooth edges in front of each other; along (V,) m: coordinate of the
    hatching.
    """

    faces: npt.NDArray[np.int64]
    part: npt.NDArray[np.int64]
    along: Array


Shape = CapsuleShape | Disc | Block | Lines


def ball(radius: float) -> CapsuleShape:
    """Around the origin."""
    return CapsuleShape(0.0, radius)


def polyline(points: Array) -> Lines:
    """Lines that connect consecutive ``points`` (N, 3)."""
    first = np.arange(len(points) - 1)
    return Lines(np.asarray(points, float), np.stack([first, first + 1], axis=1))


def turn_x_to(direction: Array) -> Array:
    """(3, 3) rotation that maps x to ``direction`` (3,) of length 1."""
    other = np.eye(3)[np.abs(direction).argmin()]
    y = np.cross(direction, other)
    y /= np.linalg.norm(y)
    return np.stack([direction, y, np.cross(direction, y)], axis=1)
