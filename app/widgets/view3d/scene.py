"""What the 3D view shows, whoever draws it: bodies that are moved and dressed."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from app.widgets.view3d.shapes import Shape
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


class BodyScene(Protocol):
    """A set of bodies before a plain background."""

    def add(self, shape: Shape, look: BodyLook) -> DrawnBody:
        """A body at the origin."""

    def clear(self) -> None:
        """Without bodies, as in the beginning."""

    def set_background(self, colour: str) -> None:
        """``#rrggbb``."""


def rgb(colour: str) -> tuple[float, float, float]:
    """``#rrggbb`` as three shares of one."""
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue
