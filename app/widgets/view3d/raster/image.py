"""The image: a ray through the middle of each pixel, three more where surfaces meet."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.blending import blend, blend_surfaces
from app.widgets.view3d.raster.ground import Ground, rule
from app.widgets.view3d.raster.layers import gather
from app.widgets.view3d.raster.placing import (
    Bodies,
    Pinhole,
    Strokes,
    place_solids,
    project_line,
    project_lines,
)
from app.widgets.view3d.raster.skin import meet_surface
from app.widgets.view3d.raster.surfaces import (
    MORE,
    Samples,
    Surfaces,
    fill_samples,
    project_surfaces,
)
from app.widgets.view3d.raster.tiles import TILE, line_pairs, solid_pairs, sort_pairs
from app.widgets.view3d.raster.view import WIDTH, RayBundle, View, new_bundle
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    BoolVector,
    Int32Matrix,
    IntMatrix,
    IntVector,
    Matrix,
    UInt32Matrix,
    Written,
)

FIRST_PAIRS = 4096
MOST_RAYS = TILE * TILE * len(MORE)
FAINT = 16
"""Steps of 255 by which colours may differ without anybody seeing stairs."""


class Canvas(NamedTuple):
    """What is drawn on, of H by W pixels: image and backdrop 0xFFRRGGBB, numbers for what the
    pixels show, samples of the surfaces."""

    image: Written[UInt32Matrix]
    backdrop: Written[UInt32Matrix]
    numbers: Written[Int32Matrix]
    samples: Samples


@kernel(error_model="numpy")
def draw(
    bodies: Bodies,
    strokes: Strokes,
    surfaces: Surfaces,
    ground: Ground,
    camera: Pinhole,
    canvas: Canvas,
) -> None:
    """Fill the canvas with what the camera sees."""
    image, numbers = canvas.image, canvas.numbers
    height, width = image.shape
    # 1. everything before the camera, and which tiles of the image it may touch
    places, sized = place_solids(bodies, camera)
    seen = project_surfaces(surfaces, camera)
    view = View(
        bodies.kinds, sized, places, bodies.looks, project_lines(bodies, strokes, camera),
        strokes.owner, camera.focal, camera.middle_u, camera.middle_v, canvas.backdrop, surfaces,
        seen, canvas.samples,
    )  # fmt: skip
    items, starts = _sort(view, (height, width))
    touched = np.zeros(len(starts) - 1, np.bool_)
    if len(surfaces.faces):
        fill_samples(surfaces, seen, canvas.samples, touched)
    rule(_ground_lines(ground, camera), ground, canvas.backdrop)
    image[:] = canvas.backdrop
    numbers[:] = 0
    bundle = new_bundle(MOST_RAYS)
    # 2. a ray through each pixel's middle; 3. more where neighbours show something else
    _first_rays(view, items, starts, touched, bundle, canvas)
    _more_rays(view, items, starts, touched, bundle, canvas)


@kernel(error_model="numpy")
def _first_rays(
    view: View, items: IntVector, starts: IntVector, touched: BoolVector, bundle: RayBundle,
    canvas: Canvas,
) -> None:  # fmt: skip
    """A ray through the middle of each pixel of the tiles that show anything."""
    image, numbers = canvas.image, canvas.numbers
    columns = (image.shape[1] + TILE - 1) // TILE
    for tile in range(len(touched)):
        span = starts[tile], starts[tile + 1]
        if span[0] < span[1] or touched[tile]:
            top, left = tile // columns * TILE, tile % columns * TILE
            rays = _middle_rays(view, image, top, left, bundle)
            _colour(view, items, span, touched[tile], rays, bundle)
            _paint(rays, bundle.at, bundle.colour, bundle.number, image, numbers)


@kernel(error_model="numpy")
def _more_rays(
    view: View, items: IntVector, starts: IntVector, touched: BoolVector, bundle: RayBundle,
    canvas: Canvas,
) -> None:  # fmt: skip
    """`MORE` rays through each pixel whose neighbour shows something else."""
    image, numbers = canvas.image, canvas.numbers
    columns = (image.shape[1] + TILE - 1) // TILE
    for tile in range(len(touched)):
        span = starts[tile], starts[tile + 1]
        if span[0] < span[1] or touched[tile]:
            top, left = tile // columns * TILE, tile % columns * TILE
            rays = _edge_rays(view, image, numbers, top, left, bundle)
            _colour(view, items, span, touched[tile], rays, bundle)
            _mix(rays, bundle.at, bundle.colour, image)


@kernel(error_model="numpy")
def _colour(
    view: View,
    items: IntVector,
    span: tuple[int, int],
    surfaces: bool,
    rays: int,
    bundle: RayBundle,
) -> None:
    """The colours of a tile's rays; its bodies are ``items`` in ``span``."""
    if span[0] < span[1]:
        gather(view, items, span, surfaces, rays, bundle)
        blend(view, rays, bundle)
    else:
        meet_surface(view, rays, bundle)
        blend_surfaces(view, rays, bundle)


@kernel(error_model="numpy")
def _ground_lines(ground: Ground, camera: Pinhole) -> Matrix:
    """(M, 6) as `project_line` has them."""
    lines = np.empty((len(ground.ends), 6))
    for m in range(len(lines)):
        project_line(ground.ends[m, :3], ground.ends[m, 3:], camera, lines[m])
    return lines


@kernel(error_model="numpy")
def _middle_rays(view: View, image: UInt32Matrix, top: int, left: int, bundle: RayBundle) -> int:
    """A ray through the middle of each pixel of a tile, and which pixel; how many."""
    rays, (height, width) = 0, image.shape
    xs, ys, focal, middle_u, middle_v = bundle.x, bundle.y, view.focal, view.middle_u, view.middle_v
    for v in range(top, min(top + TILE, height)):
        for u in range(left, min(left + TILE, width)):
            xs[rays] = (u + 0.5 - middle_u) / focal
            ys[rays] = (v + 0.5 - middle_v) / focal
            bundle.at[rays, 0], bundle.at[rays, 1], bundle.at[rays, 2] = v, u, 0
            rays += 1
    return rays


@kernel(error_model="numpy")
def _edge_rays(
    view: View, image: UInt32Matrix, numbers: Int32Matrix, top: int, left: int, bundle: RayBundle
) -> int:
    """`MORE` rays one after another through each pixel of a tile whose neighbour shows
    something else."""
    rays, (height, width) = 0, image.shape
    xs, ys, focal, middle_u, middle_v = bundle.x, bundle.y, view.focal, view.middle_u, view.middle_v
    for v in range(top, min(top + TILE, height)):
        above, below = max(v - 1, 0), min(v + 1, height - 1)
        for u in range(left, min(left + TILE, width)):
            before, after = max(u - 1, 0), min(u + 1, width - 1)
            mine, colour = numbers[v, u], image[v, u]
            if not (
                (numbers[v, before] != mine and _differ(image[v, before], colour))
                or (numbers[v, after] != mine and _differ(image[v, after], colour))
                or (numbers[above, u] != mine and _differ(image[above, u], colour))
                or (numbers[below, u] != mine and _differ(image[below, u], colour))
            ):
                continue
            for m in range(len(MORE)):
                du, dv = MORE[m]
                xs[rays] = (u + 0.5 + du - middle_u) / focal
                ys[rays] = (v + 0.5 + dv - middle_v) / focal
                bundle.at[rays, 0], bundle.at[rays, 1], bundle.at[rays, 2] = v, u, m + 1
                rays += 1
    return rays


@kernel(error_model="numpy")
def _paint(
    rays: int,
    at: IntMatrix,
    colour: Matrix,
    number: IntVector,
    image: Written[UInt32Matrix],
    numbers: Written[Int32Matrix],
) -> None:
    """Each ray's colour to its pixel."""
    for k in range(rays):
        image[at[k, 0], at[k, 1]] = packed((colour[k, 0], colour[k, 1], colour[k, 2]))
        numbers[at[k, 0], at[k, 1]] = number[k]


@kernel(error_model="numpy")
def _mix(rays: int, at: IntMatrix, colour: Matrix, image: Written[UInt32Matrix]) -> None:
    """The mean of `MORE` rays and the first one to their pixel."""
    share = 1.0 / (len(MORE) + 1)
    for k in range(0, rays, len(MORE)):
        v, u = at[k, 0], at[k, 1]
        before = image[v, u]
        red, green, blue = (
            (before >> 16 & 255) / 255,
            (before >> 8 & 255) / 255,
            (before & 255) / 255,
        )
        for j in range(k, k + len(MORE)):
            red, green, blue = red + colour[j, 0], green + colour[j, 1], blue + colour[j, 2]
        image[v, u] = packed((share * red, share * green, share * blue))


@kernel(error_model="numpy", inline="always")
def _differ(a: int, b: int) -> bool:
    """Whether two colours 0xFFRRGGBB differ by more than `FAINT` in one part."""
    red = abs(np.int64(a >> 16 & 255) - np.int64(b >> 16 & 255))
    green = abs(np.int64(a >> 8 & 255) - np.int64(b >> 8 & 255))
    blue = abs(np.int64(a & 255) - np.int64(b & 255))
    return bool(max(red, green, blue) > FAINT)


@kernel(error_model="numpy", inline="always")
def packed(colour: tuple[float, float, float]) -> np.uint32:
    """Red, green and blue, shares of one, as 0xFFRRGGBB."""
    red = np.uint32(min(max(colour[0], 0.0), 1.0) * 255.0 + 0.5)
    green = np.uint32(min(max(colour[1], 0.0), 1.0) * 255.0 + 0.5)
    blue = np.uint32(min(max(colour[2], 0.0), 1.0) * 255.0 + 0.5)
    return np.uint32(0xFF000000) | red << np.uint32(16) | green << np.uint32(8) | blue


@kernel(error_model="numpy")
def _sort(view: View, size: tuple[int, int]) -> tuple[IntVector, IntVector]:
    """Items of each tile, as `tiles.sort_pairs`: a body's row, or N and more for a line."""
    bodies, pairs = len(view.kinds), np.empty((FIRST_PAIRS, 2), np.int64)
    tiles = ((size[0] + TILE - 1) // TILE) * ((size[1] + TILE - 1) // TILE)
    while True:
        found = 0
        for i in range(bodies):
            if view.places[i, 12] > 0.0:
                form, at = view.forms[i], view.places[i]
                found = solid_pairs(i, view.kinds[i], form, at, view.focal, size, pairs, found)
        for m in range(len(view.lines)):
            if view.lines[m, 2] > 0.0:
                width_px = view.looks[view.owner[m], WIDTH]
                found = line_pairs(bodies + m, view.lines, m, width_px, size, pairs, found)
        if found <= len(pairs):
            return sort_pairs(pairs, found, tiles)
        pairs = np.empty((found, 2), np.int64)
