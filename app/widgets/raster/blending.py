"""The colour that comes of what a ray meets."""

from __future__ import annotations

from app.widgets.raster.grid import grid_cover
from app.widgets.raster.layers import SOLID
from app.widgets.raster.shading import lit
from app.widgets.raster.solids import (
    BLOCK,
    CAPSULE,
    Vector,
    block_normal,
    capsule_normal,
    disc_normal,
)
from app.widgets.raster.view import (
    AMBIENT,
    BLUE,
    GREEN,
    GROUP,
    LINES,
    OVER,
    RED,
    SPECULAR,
    STYLE,
    Bundle,
    View,
)
from tracker.kernels import kernel

GRID_DARKNESS = 0.55
"""Of the lines on a surface."""
ALONE_FILL = 0.25
"""Share of its cover that a surface keeps between the lines of a grid that stands for it."""


@kernel(error_model="numpy")
def blend(view: View, rays: int, bundle: Bundle) -> None:
    """Colour of the bundle's first ``rays``: their layers before the background; and a number that
    differs between rays which meet different bodies, 0 for no body."""
    kinds, forms, places, looks = view.kinds, view.forms, view.places, view.looks
    xs, ys, colours, numbers = bundle.x, bundle.y, bundle.colour, bundle.number
    counts, depths, covers, bodies = bundle.many, bundle.depth, bundle.cover, bundle.body
    focal, back = view.focal, (view.background[0], view.background[1], view.background[2])
    for k in range(rays):
        red, green, blue = 0.0, 0.0, 0.0
        through, groups, number = 1.0, 0, 0
        for j in range(counts[k]):
            i, cover = bodies[k, j], covers[k, j]
            colour = looks[i, RED], looks[i, GREEN], looks[i, BLUE]
            if kinds[i] != LINES:
                group = 1 << int(looks[i, GROUP])
                if group > 1 and cover < SOLID:
                    if groups & group:
                        continue  # behind another one of its group
                    groups |= group
                number = (number * 31 + i + 1) & 0x3FFFFFFF
                form = forms[i, 0], forms[i, 1], forms[i, 2], forms[i, 3], forms[i, 4]
                o = places[i, 9], places[i, 10], places[i, 11]
                R_CS = (
                    places[i, 0], places[i, 1], places[i, 2], places[i, 3], places[i, 4],
                    places[i, 5], places[i, 6], places[i, 7], places[i, 8],
                )  # fmt: skip
                d = (
                    R_CS[0] * xs[k] + R_CS[3] * ys[k] + R_CS[6],
                    R_CS[1] * xs[k] + R_CS[4] * ys[k] + R_CS[7],
                    R_CS[2] * xs[k] + R_CS[5] * ys[k] + R_CS[8],
                )
                depth = depths[k, j]
                p = o[0] + depth * d[0], o[1] + depth * d[1], o[2] + depth * d[2]
                n = _normal(kinds[i], form, p)
                style, dark = looks[i, STYLE], 0.0
                if style != 0.0:
                    grid = grid_cover(kinds[i], form[0], form[1], p, n, d, focal / depth)
                    dark = GRID_DARKNESS * grid if style == OVER else 0.0
                    cover = (
                        max(cover, dark)
                        if style == OVER
                        else cover * (ALONE_FILL + (1.0 - ALONE_FILL) * grid)
                    )
                bright, shine = lit(R_CS, n, looks[i, AMBIENT], looks[i, SPECULAR])
                colour = (
                    min(colour[0] * bright + shine, 1.0) * (1.0 - dark),
                    min(colour[1] * bright + shine, 1.0) * (1.0 - dark),
                    min(colour[2] * bright + shine, 1.0) * (1.0 - dark),
                )
            share = through * cover
            red, green = red + share * colour[0], green + share * colour[1]
            blue += share * colour[2]
            through -= share
        colours[k, 0] = red + through * back[0]
        colours[k, 1] = green + through * back[1]
        colours[k, 2] = blue + through * back[2]
        numbers[k] = number


@kernel(error_model="numpy")
def _normal(kind: int, form: tuple[float, float, float, float, float], p: Vector) -> Vector:
    """In S, at a point of the surface."""
    if kind == CAPSULE:
        return capsule_normal(p[0], p[1], p[2], form[0], form[1])
    if kind == BLOCK:
        return block_normal(p[0], p[1], p[2], form[0], form[1], form[2], form[3], form[4])
    return disc_normal(p[0], p[1], p[2], form[0], form[1])
