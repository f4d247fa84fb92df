"""Rendering of the image: one ray through the centre of each pixel, three more at the edges of
surfaces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.widgets.view3d.raster.blending import NUMBERS, blend
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
from app.widgets.view3d.raster.skin import light, surface_colour
from app.widgets.view3d.raster.surfaces import (
    MORE,
    RaySamples,
    Surfaces,
    fill_middle,
    fill_more,
    project_surfaces,
)
from app.widgets.view3d.raster.tiles import TILE, line_pairs, solid_pairs, sort_pairs
from app.widgets.view3d.raster.view import WIDTH, RayBundle, View, new_bundle
from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import (
    BoolMatrix,
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
"""Difference of colours in steps of 255 that is not visible as aliasing."""


class Canvas(NamedTuple):
    """The render target of H by W pixels: image and backdrop 0xFFRRGGBB, numbers that identify the
    visible surfaces, samples of the surfaces."""

    image: Written[UInt32Matrix]
    backdrop: Written[UInt32Matrix]
    numbers: Written[Int32Matrix]
    samples: RaySamples


class Tiles(NamedTuple):
    """Possible content of each of T tiles: bodies and lines are ``items`` from its ``starts`` (T +
    1,) to the next, see `_sort`; surfaces where it is touched (T,)."""

    items: IntVector
    starts: IntVector
    touched: BoolVector


@kernel(error_model="numpy", wide=True)
def draw(
    bodies: Bodies,
    strokes: Strokes,
    surfaces: Surfaces,
    ground: Ground,
    camera: Pinhole,
    canvas: Canvas,
) -> None:
    """Render everything into the canvas."""
    image, numbers = canvas.image, canvas.numbers
    # 1. transform everything into the camera frame and sort it into tiles
    places, sized = place_solids(bodies, camera)
    seen = project_surfaces(surfaces, camera)
    light(surfaces, camera, seen)
    view = View(
        bodies.kinds, sized, places, bodies.looks, project_lines(bodies, strokes, camera),
        strokes.owner, camera.focal, camera.middle_u, camera.middle_v, canvas.backdrop, surfaces,
        seen, canvas.samples,
    )  # fmt: skip
    items, starts = _sort(view, image.shape)
    touched = np.zeros(len(starts) - 1, np.bool_)
    boxes = np.zeros((0, 4), np.int64)
    if len(surfaces.faces):
        boxes = fill_middle(surfaces, seen, canvas.samples, touched)
    tiles = Tiles(items, starts, touched)
    rule(_ground_lines(ground, camera), ground, canvas.backdrop)
    image[:] = canvas.backdrop
    numbers[:] = 0
    bundle = new_bundle(MOST_RAYS)
    # 2. a ray through the centre of each pixel; 3. more rays at edges
    _first_rays(view, tiles, bundle, canvas)
    wanted, edged = np.empty(image.shape, np.bool_), np.zeros(len(touched), np.bool_)
    _mark_edges(tiles, canvas, wanted, edged)
    if len(surfaces.faces):
        fill_more(surfaces, seen, boxes, wanted, edged, canvas.samples)
    _more_rays(view, tiles, wanted, edged, bundle, canvas)


@kernel(error_model="numpy")
def _first_rays(view: View, tiles: Tiles, bundle: RayBundle, canvas: Canvas) -> None:
    """A ray through the centre of each pixel of the tiles that are not empty."""
    image, numbers = canvas.image, canvas.numbers
    columns = (image.shape[1] + TILE - 1) // TILE
    for tile in range(len(tiles.touched)):
        span, surfaces = (tiles.starts[tile], tiles.starts[tile + 1]), tiles.touched[tile]
        top, left = tile // columns * TILE, tile % columns * TILE
        if span[0] < span[1]:
            rays = _middle_rays(view, image, top, left, bundle)
            gather(view, tiles.items, span, surfaces, rays, bundle)
            blend(view, rays, bundle)
            _paint(rays, bundle.at, bundle.colour, bundle.number, image, numbers)
        elif surfaces:
            _paint_surfaces(view, top, left, image, numbers)


@kernel(error_model="numpy")
def _more_rays(
    view: View, tiles: Tiles, wanted: BoolMatrix, edged: BoolVector, bundle: RayBundle,
    canvas: Canvas,
) -> None:  # fmt: skip
    """`MORE` rays through each pixel of ``wanted`` (H, W), all in tiles ``edged`` (T,)."""
    image = canvas.image
    columns = (image.shape[1] + TILE - 1) // TILE
    for tile in range(len(edged)):
        if not edged[tile]:
            continue
        span, surfaces = (tiles.starts[tile], tiles.starts[tile + 1]), tiles.touched[tile]
        top, left = tile // columns * TILE, tile % columns * TILE
        if span[0] < span[1]:
            rays = _edge_rays(view, wanted, top, left, bundle)
            gather(view, tiles.items, span, surfaces, rays, bundle)
            blend(view, rays, bundle)
            _mix(rays, bundle.at, bundle.colour, image)
        else:
            _mix_surfaces(view, wanted, top, left, image)


@kernel(error_model="numpy")
def _paint_surfaces(
    view: View, top: int, left: int, image: Written[UInt32Matrix], numbers: Written[Int32Matrix]
) -> None:
    """Render a tile that contains only surfaces, as most tiles of a hand do, without bundles of
    rays, which would be written and read unnecessarily."""
    inverse, face, part = view.samples.inverse, view.samples.face, view.surfaces.part
    height, width = image.shape
    for v in range(top, min(top + TILE, height)):
        for u in range(left, min(left + TILE, width)):
            if inverse[0, v, u] > 0.0:
                f = face[0, v, u]
                colour, cover = surface_colour(view, f, u + 0.5, v + 0.5)
                image[v, u] = packed(_over(view.backdrop[v, u], colour, cover))
                numbers[v, u] = (len(view.kinds) + part[f] + 1) & NUMBERS


@kernel(error_model="numpy")
def _mix_surfaces(
    view: View, wanted: BoolMatrix, top: int, left: int, image: Written[UInt32Matrix]
) -> None:
    """The mean of `MORE` rays and the first one in the pixels ``wanted`` of such a tile."""
    inverse, face = view.samples.inverse, view.samples.face
    height, width = image.shape
    share = 1.0 / (len(MORE) + 1)
    for v in range(top, min(top + TILE, height)):
        for u in range(left, min(left + TILE, width)):
            if not wanted[v, u]:
                continue
            back = view.backdrop[v, u]
            red, green, blue = _parts(image[v, u])
            for m in range(len(MORE)):
                colour, cover = (0.0, 0.0, 0.0), 0.0
                if inverse[m + 1, v, u] > 0.0:
                    x, y = u + 0.5 + MORE[m][0], v + 0.5 + MORE[m][1]
                    colour, cover = surface_colour(view, face[m + 1, v, u], x, y)
                mixed = _over(back, colour, cover)
                red, green, blue = red + mixed[0], green + mixed[1], blue + mixed[2]
            image[v, u] = packed((share * red, share * green, share * blue))


@kernel(error_model="numpy", inline="always")
def _over(below: int, colour: Vector3, cover: float) -> Vector3:
    """Blend a colour over 0xFFRRGGBB."""
    if cover >= 1.0:
        return colour
    red, green, blue = _parts(below)
    return (
        cover * colour[0] + (1.0 - cover) * red,
        cover * colour[1] + (1.0 - cover) * green,
        cover * colour[2] + (1.0 - cover) * blue,
    )


@kernel(error_model="numpy", inline="always")
def _parts(colour: int) -> Vector3:
    """Red, green and blue of 0xFFRRGGBB, 0..1."""
    return (colour >> 16 & 255) / 255, (colour >> 8 & 255) / 255, (colour & 255) / 255


@kernel(error_model="numpy")
def _ground_lines(ground: Ground, camera: Pinhole) -> Matrix:
    """(M, 6) projected lines, see `project_line`."""
    lines = np.empty((len(ground.ends), 6))
    for m in range(len(lines)):
        project_line(ground.ends[m, :3], ground.ends[m, 3:], camera, lines[m])
    return lines


@kernel(error_model="numpy")
def _middle_rays(view: View, image: UInt32Matrix, top: int, left: int, bundle: RayBundle) -> int:
    """Rays through the centres of the pixels of a tile, with their pixels; returns their number."""
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
def _mark_edges(
    tiles: Tiles, canvas: Canvas, wanted: Written[BoolMatrix], edged: Written[BoolVector]
) -> None:
    """Mark the pixels of non-empty tiles whose neighbours show other surfaces, and the tiles that
    contain any; ``wanted`` (H, W) is not changed in other tiles."""
    image, numbers = canvas.image, canvas.numbers
    height, width = image.shape
    columns = (width + TILE - 1) // TILE
    for tile in range(len(edged)):
        if tiles.starts[tile] == tiles.starts[tile + 1] and not tiles.touched[tile]:
            continue
        top, left = tile // columns * TILE, tile % columns * TILE
        for v in range(top, min(top + TILE, height)):
            above, below = max(v - 1, 0), min(v + 1, height - 1)
            for u in range(left, min(left + TILE, width)):
                before, after = max(u - 1, 0), min(u + 1, width - 1)
                mine, colour = numbers[v, u], image[v, u]
                wanted[v, u] = (
                    (numbers[v, before] != mine and _differ(image[v, before], colour))
                    or (numbers[v, after] != mine and _differ(image[v, after], colour))
                    or (numbers[above, u] != mine and _differ(image[above, u], colour))
                    or (numbers[below, u] != mine and _differ(image[below, u], colour))
                )
                if wanted[v, u]:
                    edged[tile] = True


@kernel(error_model="numpy")
def _edge_rays(view: View, wanted: BoolMatrix, top: int, left: int, bundle: RayBundle) -> int:
    """`MORE` rays through each pixel ``wanted`` of a tile; returns their number."""
    rays, (height, width) = 0, wanted.shape
    xs, ys, focal, middle_u, middle_v = bundle.x, bundle.y, view.focal, view.middle_u, view.middle_v
    for v in range(top, min(top + TILE, height)):
        for u in range(left, min(left + TILE, width)):
            if not wanted[v, u]:
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
    """Write the colour of each ray to its pixel."""
    for k in range(rays):
        image[at[k, 0], at[k, 1]] = packed((colour[k, 0], colour[k, 1], colour[k, 2]))
        numbers[at[k, 0], at[k, 1]] = number[k]


@kernel(error_model="numpy")
def _mix(rays: int, at: IntMatrix, colour: Matrix, image: Written[UInt32Matrix]) -> None:
    """Write the mean of `MORE` rays and the first one to their pixel."""
    share = 1.0 / (len(MORE) + 1)
    for k in range(0, rays, len(MORE)):
        v, u = at[k, 0], at[k, 1]
        red, green, blue = _parts(image[v, u])
        for j in range(k, k + len(MORE)):
            red, green, blue = red + colour[j, 0], green + colour[j, 1], blue + colour[j, 2]
        image[v, u] = packed((share * red, share * green, share * blue))


@kernel(error_model="numpy", inline="always")
def _differ(a: int, b: int) -> bool:
    """Whether two colours 0xFFRRGGBB differ by more than `FAINT` in one component."""
    red = abs(np.int64(a >> 16 & 255) - np.int64(b >> 16 & 255))
    green = abs(np.int64(a >> 8 & 255) - np.int64(b >> 8 & 255))
    blue = abs(np.int64(a & 255) - np.int64(b & 255))
    return bool(max(red, green, blue) > FAINT)


@kernel(error_model="numpy", inline="always")
def packed(colour: tuple[float, float, float]) -> np.uint32:
    """Red, green and blue, 0..1, as 0xFFRRGGBB."""
    red = np.uint32(min(max(colour[0], 0.0), 1.0) * 255.0 + 0.5)
    green = np.uint32(min(max(colour[1], 0.0), 1.0) * 255.0 + 0.5)
    blue = np.uint32(min(max(colour[2], 0.0), 1.0) * 255.0 + 0.5)
    return np.uint32(0xFF000000) | red << np.uint32(16) | green << np.uint32(8) | blue


@kernel(error_model="numpy")
def _sort(view: View, size: tuple[int, int]) -> tuple[IntVector, IntVector]:
    """Items of each tile, see `tiles.sort_pairs`: a body's row, or N and more for a line."""
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
