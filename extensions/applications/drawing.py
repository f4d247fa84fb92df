"""What an application has drawn: a few primitives in m in G, whoever draws them.

A primitive's ``name`` is its identity from one drawing to the next: whoever draws keeps what it
made for it. Colours are ``#rrggbb``.
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
    """Triangles ``faces`` (F, 3), counter-clockwise from outside, of ``points`` (V, 3) m in a frame
    of its own, which stands in G turned by R (3, 3), times a size, and at p (3,)."""

    name: str
    points: Array
    faces: IntArray
    colour: str = "#B0B8C0"
    R: Array = field(default_factory=_eye)
    p: Array = field(default_factory=_origin)
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Line:
    """From each of ``points`` (N, 3) to the next; ``width`` in px."""

    name: str
    points: Array
    colour: str = "#56B4E9"
    width: float = 2.0


@dataclass(frozen=True, eq=False)
class Points:
    """Small balls of one ``radius`` (m) at ``points`` (N, 3); N may change."""

    name: str
    points: Array
    radius: float = 0.004
    colour: str = "#E69F00"


@dataclass(frozen=True, eq=False)
class Text:
    """A few words beside a point ``p`` (3,)."""

    name: str
    text: str
    p: Array
    colour: str = ""  # empty: what stands out from the background


Primitive = Mesh | Line | Points | Text
Drawing = tuple[Primitive, ...]
