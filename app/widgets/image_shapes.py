"""Shapes drawn over an image: plain data in image pixels, drawn by `ImageView`."""

from __future__ import annotations

from typing import NamedTuple


class Ring(NamedTuple):
    """A circle around a point, ``radius`` in image pixels; ``filled`` see-through."""

    u: float
    v: float
    radius: float
    colour: str
    width: float = 1.5
    dashed: bool = False
    opacity: float = 1.0
    filled: bool = False


class Cross(NamedTuple):
    """An upright or (``diagonal``) diagonal cross of fixed size on the screen."""

    u: float
    v: float
    colour: str
    diagonal: bool = False
    opacity: float = 1.0


class Ellipse(NamedTuple):
    """Half axes ``a``, ``b`` in image pixels; ``angle`` rad of the first against u."""

    u: float
    v: float
    a: float
    b: float
    angle: float
    colour: str
    opacity: float = 1.0


class ImageLine(NamedTuple):
    u0: float
    v0: float
    u1: float
    v1: float
    colour: str
    width: float = 1.5
    dashed: bool = False
    opacity: float = 1.0


class ImageLabel(NamedTuple):
    """Text next to a point, of constant size; hidden below ``least_zoom`` screen pixels per image
    pixel, where texts would overlap."""

    u: float
    v: float
    text: str
    colour: str
    opacity: float = 1.0
    least_zoom: float = 0.0


Shape = Ring | Cross | Ellipse | ImageLine | ImageLabel
