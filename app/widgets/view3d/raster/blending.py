"""The colour of a ray from the surfaces that it intersects."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.grid import grid_cover
from app.widgets.view3d.raster.layers import SOLID
from app.widgets.view3d.raster.shading import lit
from app.widgets.view3d.raster.solids import (
    BLOCK,
    CAPSULE,
    LINES,
    Rotation,
    Rounded,
    block_surface,
    capsule_normal,
    disc_normal,
)
from app.widgets.view3d.raster.view import (
    ALONE,
    AMBIENT,
    BLUE,
    GREEN,
    GROUP,
    OVER,
    RED,
    SPECULAR,
    STYLE,
    SURFACE,
    RayBundle,
    View,
)
from tracker.geometry.solids import Vector3
from tracker.kernels import kernel

GRID_DARKNESS = 0.55
"""Darkness of the lines on a surface."""
ALONE_FILL = 0.25
"""Opacity factor of a surface between the lines of a grid drawn instead of it."""
RIM = 0.5
"""Share of the transmitted light that a transparent body absorbs when it is viewed edge-on."""
NUMBERS = 0x3FFFFFFF


@kernel(error_model="numpy")
def blend(view: View, rays: int, bundle: RayBundle) -> None:
    """Colour of the bundle's first ``rays``: their layers in front of the background; and a number
    that identifies the combination of surfaces, 0 for none."""
    kinds, forms, places, looks = view.kinds, view.forms, view.places, view.looks
    xs, ys, colours, numbers = bundle.x, bundle.y, bundle.colour, bundle.number
    counts, depths, covers, bodies = bundle.many, bundle.depth, bundle.cover, bundle.body
    at, skin, parts = bundle.at, bundle.skin, bundle.part
    backdrop, focal = view.backdrop, view.focal
    for k in range(rays):
        red, green, blue = 0.0, 0.0, 0.0
        through, groups, number = 1.0, 0, 0
        for j in range(counts[k]):
            i, depth, cover = bodies[k, j], depths[k, j], covers[k, j]
            if i == SURFACE:
                colour = skin[k, 0], skin[k, 1], skin[k, 2]
                number = (number * 31 + len(kinds) + parts[k] + 1) & NUMBERS
                red, green = red + through * cover * colour[0], green + through * cover * colour[1]
                blue += through * cover * colour[2]
                through -= through * cover
                continue
            colour = looks[i, RED], looks[i, GREEN], looks[i, BLUE]
            if kinds[i] != LINES:
                style, group = looks[i, STYLE], 1 << int(looks[i, GROUP])
                if group > 1 and cover < SOLID:
                    if groups & group:
                        continue  # hidden by another one of its group
                    groups |= group
                if style != ALONE:
                    number = (number * 31 + i + 1) & NUMBERS
                form = Rounded(forms[i, 0], forms[i, 1], forms[i, 2], forms[i, 3], forms[i, 4])
                R_CS = (
                    places[i, 0], places[i, 1], places[i, 2],
                    places[i, 3], places[i, 4], places[i, 5],
                    places[i, 6], places[i, 7], places[i, 8],
                )  # fmt: skip
                o = places[i, 9], places[i, 10], places[i, 11]
                d = _into(R_CS, xs[k], ys[k])
                p = o[0] + depth * d[0], o[1] + depth * d[1], o[2] + depth * d[2]
                n = _normal(kinds[i], form, p)
                dark = 0.0
                if style != 0.0:
                    grid = grid_cover(kinds[i], forms[i, 0], forms[i, 1], p, n, d, focal / depth)
                    cover, dark = _with_grid(style, cover, grid)
                elif cover < SOLID:
                    cover = _with_rim(cover, n, d)
                bright, shine = lit(R_CS, n, looks[i, AMBIENT], looks[i, SPECULAR])
                colour = _coloured(colour, bright, shine, 1.0 - dark)
            share = through * cover
            red, green = red + share * colour[0], green + share * colour[1]
            blue += share * colour[2]
            through -= share
        back = backdrop[at[k, 0], at[k, 1]]
        colours[k, 0] = red + through * (back >> 16 & 255) / 255
        colours[k, 1] = green + through * (back >> 8 & 255) / 255
        colours[k, 2] = blue + through * (back & 255) / 255
        numbers[k] = number


@kernel(error_model="numpy", inline="always")
def _into(R_CS: Rotation, x: float, y: float) -> Vector3:
    """The ray (x, y, 1) in S."""
    return (
        R_CS[0] * x + R_CS[3] * y + R_CS[6],
        R_CS[1] * x + R_CS[4] * y + R_CS[7],
        R_CS[2] * x + R_CS[5] * y + R_CS[8],
    )


@kernel(error_model="numpy", inline="always")
def _normal(kind: int, form: Rounded, p: Vector3) -> Vector3:
    """Outward normal in S at a point of the surface. A form starts with length and radius of a
    capsule, or half height and radius of a disc."""
    if kind == CAPSULE:
        return capsule_normal(p, form[0], form[1])
    if kind == BLOCK:
        _, nx, ny, nz = block_surface(p, form)
        return nx, ny, nz
    return disc_normal(p, form[0], form[1])


@kernel(error_model="numpy", inline="always")
def _with_grid(style: float, cover: float, grid: float) -> tuple[float, float]:
    """Opacity of a surface of which ``grid`` is covered by grid lines, and how much they darken
    it."""
    if style == OVER:
        dark = GRID_DARKNESS * grid
        return max(cover, dark), dark
    return cover * (ALONE_FILL + (1.0 - ALONE_FILL) * grid), 0.0


@kernel(error_model="numpy", inline="always")
def _with_rim(cover: float, n: Vector3, d: Vector3) -> float:
    """A transparent body is more opaque where the ray passes through more of its surface."""
    length = np.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    edge = 1.0 - abs(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) / length
    return cover + (1.0 - cover) * RIM * edge * edge * edge


@kernel(error_model="numpy", inline="always")
def _coloured(colour: Vector3, bright: float, shine: float, left: float) -> Vector3:
    """Lit colour; ``left`` is the share that dark lines leave visible."""
    return (
        min(colour[0] * bright + shine, 1.0) * left,
        min(colour[1] * bright + shine, 1.0) * left,
        min(colour[2] * bright + shine, 1.0) * left,
    )
