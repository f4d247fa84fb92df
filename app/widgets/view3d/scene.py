"""What the 3D view shows, whoever draws it: bodies that are moved and dressed."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from app.widgets.view3d.shapes import Shape, Surface
from tracker.kernels.arrays import BoolVector
from tracker.messages import Array


class Grid(IntEnum):
    """Whether a body's grid of lines is drawn."""

    NONE = 0
    OVER = 1  # on its surface
    ALONE = 2  # in place of its surface, front and back


@dataclass(frozen=True)
class BodyLook:
    """How a body is drawn. Shares of one, ``line_width`` in pixels.

    Where two see-through bodies of one ``group`` lie behind each other only the nearer is seen, so
    that they look like one; group 0 is none. Only the painted view knows groups.
    """

    colour: str  # #rrggbb
    opacity: float = 1.0
    ambient: float = 0.0
    specular: float = 0.0
    line_width: float = 1.0
    grid: Grid = Grid.NONE
    group: int = 0


class DrawnBody(Protocol):
    """A shape in the scene."""

    @property
    def shown(self) -> bool: ...

    def show(self, on: bool) -> None: ...

    def wear(self, look: BodyLook) -> None:
        """Look like this from now on."""

    def reshape(self, points: Array) -> None:
        """Other points (N, 3) for the same `Lines`."""

    def move(self, R: Array, p: Array) -> None:
        """To a rotation (3, 3), times a size, and a position (3,), both in G."""


class DrawnSurface(Protocol):
    """A surface in the scene, whose points move one by one."""

    @property
    def shown(self) -> bool: ...

    def show(self, on: bool) -> None: ...

    def choose(self, faces: BoolVector) -> None:
        """Draw only those of its faces (F,) from now on."""

    def drape(self, points: Array, normals: Array, dress: Array) -> None:
        """To points (V, 3) m with normals (V, 3), in G, and looks (V, `DRESS`)."""


@dataclass(frozen=True, eq=False)
class GroundLines:
    """Thin lines behind everything: ends (M, 6) m in G, strength (M,) in their middle."""

    ends: Array
    strength: Array


@dataclass(frozen=True, eq=False)
class Label:
    """A short text beside a point (3,) m in G."""

    text: str
    p_G: Array
    colour: str


class BodyScene(Protocol):
    """A set of bodies and surfaces before a plain background."""

    def add(self, shape: Shape, look: BodyLook) -> DrawnBody:
        """A body at the origin."""

    def add_surface(self, surface: Surface) -> DrawnSurface:
        """Not shown yet."""

    def add_outline(self, surface: Surface) -> DrawnSurface:
        """A surface of which only the outline is drawn, over everything. Not shown yet."""

    def set_ink(self, colour: str) -> None:
        """``#rrggbb`` of outlines and of the ground."""

    def set_ground(self, ground: GroundLines) -> None: ...

    def clear(self) -> None:
        """Without bodies, as in the beginning."""

    def set_background(self, colour: str) -> None:
        """``#rrggbb``."""


def contrast(background: str) -> str:
    """An ink that stands out from a background, both ``#rrggbb``."""
    red, green, blue = rgb(background)
    return "#FFFFFF" if 0.299 * red + 0.587 * green + 0.114 * blue < 0.5 else "#101418"


def rgb(colour: str) -> tuple[float, float, float]:
    """``#rrggbb`` as three shares of one."""
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue
