"""Assignment of bodies to image tiles; conservative, with few false positives."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.placing import NEAR
from app.widgets.view3d.raster.solids import BLOCK, CAPSULE
from app.widgets.view3d.raster.strokes import distance_px
from tracker.geometry.solids import box_span, capsule_depth
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Vector, Written

TILE = 12
"""px along a tile's side."""
HALF_DIAGONAL = 0.7072 * TILE


@kernel(error_model="numpy")
def bounding_ball(kind: int, form: Vector, place: Vector) -> tuple[float, float, float, float]:
    """Centre in C (3), m, and radius of a bounding sphere of a solid."""
    along, radius = 0.0, 0.0
    if kind == CAPSULE:
        along, radius = form[0] / 2, form[0] / 2 + form[1]
    elif kind == BLOCK:
        radius = np.sqrt(form[0] ** 2 + form[1] ** 2 + form[2] ** 2)
    else:
        radius = np.sqrt(form[0] ** 2 + form[1] ** 2)
    x, y, z = along - place[9], -place[10], -place[11]  # from the camera, in S
    return (
        place[0] * x + place[1] * y + place[2] * z,
        place[3] * x + place[4] * y + place[5] * z,
        place[6] * x + place[7] * y + place[8] * z,
        radius,
    )


@kernel(error_model="numpy")
def solid_span(
    ball: tuple[float, float, float, float], focal: float, cx: float, cy: float
) -> Vector:
    """(4,) px: left, top, right and bottom of the bounding box of a sphere; NaN if it is behind the
    camera."""
    x, y, z, radius = ball
    out = np.full(4, np.nan)
    if z + radius <= NEAR:
        return out
    near = z - radius
    if near <= NEAR:  # around the camera: may be anywhere in the image
        out[0] = out[1] = -np.inf
        out[2] = out[3] = np.inf
        return out
    u, v = x / z, y / z
    # the offset from the optical axis grows the box: 1 + |x/z| bounds the ellipse of a sphere
    reach_u, reach_v = radius / near * (1 + abs(u)), radius / near * (1 + abs(v))
    out[0], out[2] = cx + focal * (u - reach_u), cx + focal * (u + reach_u)
    out[1], out[3] = cy + focal * (v - reach_v), cy + focal * (v + reach_v)
    return out


@kernel(error_model="numpy")
def may_show(kind: int, form: Vector, place: Vector, x: float, y: float, grown: float) -> bool:
    """Whether the ray (x, y, 1) meets a solid enlarged by ``grown`` m, the maximum distance of a
    tile's rays from its centre ray at the solid's depth."""
    d = (
        place[0] * x + place[3] * y + place[6],
        place[1] * x + place[4] * y + place[7],
        place[2] * x + place[5] * y + place[8],
    )
    o = place[9], place[10], place[11]
    if kind == BLOCK:
        enters, leaves = box_span(o, d, (form[0] + grown, form[1] + grown, form[2] + grown))
        return enters <= leaves
    length = form[0] if kind == CAPSULE else 0.0
    radius = form[1] if kind == CAPSULE else np.sqrt(form[0] ** 2 + form[1] ** 2)
    return capsule_depth(o, d, length, radius + grown, 1.0) != 0.0


@kernel(error_model="numpy")
def line_span(line: Vector, width_px: float) -> Vector:
    """(4,) px: left, top, right and bottom of a line's bounding box; NaN if it is behind the
    camera."""
    reach = 0.5 * width_px + 1.0
    out = np.empty(4)
    out[0], out[2] = min(line[0], line[3]) - reach, max(line[0], line[3]) + reach
    out[1], out[3] = min(line[1], line[4]) - reach, max(line[1], line[4]) + reach
    return out


@kernel(error_model="numpy")
def tile_range(low: float, high: float, count: int) -> tuple[int, int]:
    """First tile and one past the last, of ``count``, that px ``low`` to ``high`` touch."""
    if not (high >= 0.0 and low <= count * TILE):
        return 0, 0
    return int(max(low, 0.0)) // TILE, min(int(min(high, count * TILE - 1.0)) // TILE + 1, count)


@kernel(error_model="numpy")
def solid_pairs(
    item: int, kind: int, form: Vector, place: Vector, focal: float, size: tuple[int, int],
    pairs: Written[IntMatrix], found: int,
) -> int:  # fmt: skip
    """Append (tile, ``item``) for each tile that may show a solid; returns the new number of pairs.

    Pairs beyond the size of ``pairs`` are only counted. ``size``: height and width, px.
    """
    height, width = size
    rows, columns = (height + TILE - 1) // TILE, (width + TILE - 1) // TILE
    ball = bounding_ball(kind, form, place)
    span = solid_span(ball, focal, width / 2, height / 2)
    grown = (ball[2] + ball[3]) * HALF_DIAGONAL / focal
    left, right = tile_range(span[0], span[2], columns)
    top, bottom = tile_range(span[1], span[3], rows)
    for row in range(top, bottom):
        for column in range(left, right):
            x = ((column + 0.5) * TILE - width / 2) / focal
            y = ((row + 0.5) * TILE - height / 2) / focal
            if may_show(kind, form, place, x, y, grown):
                if found < len(pairs):
                    pairs[found, 0], pairs[found, 1] = row * columns + column, item
                found += 1
    return found


@kernel(error_model="numpy")
def line_pairs(
    item: int,
    lines: Matrix,
    m: int,
    width_px: float,
    size: tuple[int, int],
    pairs: Written[IntMatrix],
    found: int,
) -> int:
    """As `solid_pairs`, for a line."""
    rows, columns = (size[0] + TILE - 1) // TILE, (size[1] + TILE - 1) // TILE
    span = line_span(lines[m], width_px)
    left, right = tile_range(span[0], span[2], columns)
    top, bottom = tile_range(span[1], span[3], rows)
    reach = HALF_DIAGONAL + 0.5 * width_px + 1.0
    for row in range(top, bottom):
        for column in range(left, right):
            if distance_px(lines, m, (column + 0.5) * TILE, (row + 0.5) * TILE) <= reach:
                if found < len(pairs):
                    pairs[found, 0], pairs[found, 1] = row * columns + column, item
                found += 1
    return found


@kernel(error_model="numpy")
def sort_pairs(pairs: IntMatrix, found: int, tiles: int) -> tuple[IntVector, IntVector]:
    """Items of all tiles, contiguous, and the start of each tile (T + 1,)."""
    starts = np.zeros(tiles + 1, np.int64)
    for i in range(found):
        starts[pairs[i, 0] + 1] += 1
    for i in range(tiles):
        starts[i + 1] += starts[i]
    items, filled = np.empty(found, np.int64), starts[:tiles].copy()
    for i in range(found):
        tile = pairs[i, 0]
        items[filled[tile]] = pairs[i, 1]
        filled[tile] += 1
    return items, starts
