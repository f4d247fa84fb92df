"""The contents of the 3D view, independent of the renderer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from app.widgets.view3d.shapes import Shape, Surface
from tracker.kernels.arrays import BoolVector
from tracker.messages import Array


class Grid(IntEnum):
    """Whether the grid lines of a body are drawn."""

    NONE = 0
    OVER = 1  # on its surface
    ALONE = 2  # instead of its surface, front and back


@dataclass(frozen=True)
class BodyLook:
    """The look of a body. Values 0..1, ``line_width`` in pixels.

    Of two overlapping transparent bodies in one ``group`` only the nearer is visible, so that they
    look like one; group 0 is none. Only the software renderer supports groups.
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
        """Set the look."""

    def reshape(self, points: Array) -> None:
        """Set other points (N, 3) for the same `Lines`."""

    def move(self, R: Array, p: Array) -> None:
        """Set a rotation (3, 3), multiplied by a size, and a position (3,), both in G."""


class DrawnGroup(Protocol):
    """Several shapes in the scene that are moved together; initially hidden."""

    def place(self, shown: BoolVector, R: Array, p: Array) -> None:
        """Which of the n bodies are drawn (n,); rotations (n, 3, 3), each multiplied by a size, and
        positions (n, 3), in G."""

    def hide(self) -> None: ...


class DrawnSurface(Protocol):
    """A deformable surface in the scene."""

    @property
    def shown(self) -> bool: ...

    def show(self, on: bool) -> None: ...

    def choose(self, faces: BoolVector) -> None:
        """Draw only these faces (F,)."""

    def drape(self, points: Array, normals: Array, dress: Array) -> None:
        """Set points (V, 3) m with normals (V, 3), in G, and looks (V, `DRESS`)."""


@dataclass(frozen=True, eq=False)
class GroundLines:
    """Thin lines in the background: ends (M, 6) m in G, strength (M,) at their centres."""

    ends: Array
    strength: Array


@dataclass(frozen=True, eq=False)
class Label:
    """A short text next to a point (3,) m in G."""

    text: str
    p_G: Array
    colour: str


class BodyScene(Protocol):
    """Bodies and surfaces in front of a plain background."""

    def add(self, shape: Shape, look: BodyLook) -> DrawnBody:
        """Add a body at the origin."""

    def add_group(self, shapes: Sequence[Shape], looks: Sequence[BodyLook]) -> DrawnGroup:
        """Add a body for each shape."""

    def add_surface(self, surface: Surface) -> DrawnSurface:
        """Add a surface, initially hidden."""

    def add_outline(self, surface: Surface) -> DrawnSurface:
        """Add a surface of which only the outline is drawn, over everything; initially hidden."""

    def set_ink(self, colour: str) -> None:
        """Set the colour of outlines and of the ground, ``#rrggbb``."""

    def set_ground(self, ground: GroundLines) -> None: ...

    def clear(self) -> None:
        """Remove all bodies."""

    def set_background(self, colour: str) -> None:
        """Set the background colour, ``#rrggbb``."""


def contrast(background: str) -> str:
    """A colour with high contrast to a background, both ``#rrggbb``."""
    red, green, blue = rgb(background)
    return "#FFFFFF" if 0.299 * red + 0.587 * green + 0.114 * blue < 0.5 else "#101418"


def rgb(colour: str) -> tuple[float, float, float]:
    """``#rrggbb`` as three values 0..1."""
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue
