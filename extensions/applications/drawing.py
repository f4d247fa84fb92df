"""Drawings of applications: primitives in m in G, independent of the renderer.

A primitive's ``name`` identifies it across drawings, so that a renderer can reuse its objects.
Colours are ``#rrggbb``.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.messages import Array, IntArray


def _eye() -> Array:
    return np.eye(3)


def _origin() -> Array:
    return np.zeros(3)


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles ``faces`` (F, 3), counter-clockwise from outside, of ``points`` (V, 3) m in the
    mesh's frame, whose pose in G is R (3, 3), times a scale, and p (3,)."""

    name: str
    points: Array
    faces: IntArray
    colour: str = "#B0B8C0"
    R: Array = field(default_factory=_eye)
    p: Array = field(default_factory=_origin)
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Line:
    """A polyline through ``points`` (N, 3); ``width`` in px."""

    name: str
    points: Array
    colour: str = "#56B4E9"
    width: float = 2.0


@dataclass(frozen=True, eq=False)
class Points:
    """Balls of one ``radius`` (m) at ``points`` (N, 3); N may change."""

    name: str
    points: Array
    radius: float = 0.004
    colour: str = "#E69F00"


@dataclass(frozen=True, eq=False)
class Text:
    """A text next to the point ``p`` (3,)."""

    name: str
    text: str
    p: Array
    colour: str = ""  # empty: contrasts with the background


Primitive = Mesh | Line | Points | Text
Drawing = tuple[Primitive, ...]
