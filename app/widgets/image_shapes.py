"""Shapes drawn over an image: plain data in image pixels, drawn by `ImageView`.

Many shapes of one kind are one object with arrays: live images have a hundred, sixty times a
second.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


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


class Rings(NamedTuple):
    """n of `Ring`: uv (n, 2), radius (n,), a colour for each."""

    uv: Array
    radius: Array
    colours: Sequence[str]
    width: float
    dashed: Flags
    filled: Flags
    opacity: float = 1.0


class Crosses(NamedTuple):
    """n of `Cross`: uv (n, 2), a colour for each."""

    uv: Array
    colours: Sequence[str]
    diagonal: bool = False
    opacity: float = 1.0


class Ellipses(NamedTuple):
    """n of `Ellipse`: uv (n, 2), half axes (n, 2), angle (n,)."""

    uv: Array
    axes: Array
    angle: Array
    colour: str
    opacity: float = 1.0


class ImageLines(NamedTuple):
    """n of `ImageLine`: ends (n, 4), u0, v0, u1, v1, a colour for each."""

    ends: Array
    colours: Sequence[str]
    width: float
    dashed: Flags
    opacity: float = 1.0


class ImageLabels(NamedTuple):
    """n of `ImageLabel`: uv (n, 2), a text for each."""

    uv: Array
    texts: Sequence[str]
    colour: str
    opacity: float = 1.0
    least_zoom: float = 0.0


Shape = Ring | Cross | Ellipse | ImageLine | ImageLabel
Shapes = Rings | Crosses | Ellipses | ImageLines | ImageLabels
Drawn = Shape | Shapes
