"""The surfaces that the rays of a bundle intersect, nearest first."""

from __future__ import annotations

from app.widgets.view3d.raster.placing import NEAR
from app.widgets.view3d.raster.skin import meet_surface
from app.widgets.view3d.raster.solids import BLOCK, CAPSULE, Rounded, block_depth, disc_depth
from app.widgets.view3d.raster.strokes import stroke_cover, stroke_depth
from app.widgets.view3d.raster.view import (
    ALONE,
    DEEPEST,
    OPACITY,
    STYLE,
    SURFACE,
    WIDTH,
    RayBundle,
    View,
)
from tracker.geometry.solids import capsule_depth
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector

SOLID = 0.999
"""Opacity above which nothing behind is visible."""
MOST_OF_A_LINE = 0.99
"""Lines never end the stack: a line that covers half of a pixel may cover all of it from another
ray."""


@kernel(error_model="numpy")
def gather(
    view: View,
    items: IntVector,
    span: tuple[int, int],
    surfaces: bool,
    rays: int,
    bundle: RayBundle,
) -> None:
    """Fill the layers of the bundle's first ``rays``.

    ``items`` in ``span`` (first, and one past the last): rows of bodies, or of lines after them;
    ``surfaces``: whether there are triangles, too.
    """
    bundle.many[:rays] = 0
    for k in range(span[0], span[1]):
        i = items[k]
        if i >= len(view.kinds):
            m = i - len(view.kinds)
            _meet_line(view, m, rays, bundle)
            _lay(view.owner[m], rays, bundle)
            continue
        bundle.share[:rays] = view.looks[i, OPACITY]
        _meet(view, i, -1.0, rays, bundle)
        _lay(i, rays, bundle)
        if view.looks[i, STYLE] == ALONE:
            _meet(view, i, 1.0, rays, bundle)
            _lay(i, rays, bundle)
    if surfaces:
        meet_surface(view, rays, bundle)
        _lay(SURFACE, rays, bundle)


@kernel(error_model="numpy")
def _meet(view: View, i: int, side: float, rays: int, bundle: RayBundle) -> None:
    """Write the depths at which the rays intersect solid i, see `solids`, into ``found``."""
    xs, ys, found, places, forms = bundle.x, bundle.y, bundle.found, view.places, view.forms
    r0, r1, r2 = places[i, 0], places[i, 1], places[i, 2]  # R_CS row by row
    r3, r4, r5 = places[i, 3], places[i, 4], places[i, 5]
    r6, r7, r8 = places[i, 6], places[i, 7], places[i, 8]
    o = places[i, 9], places[i, 10], places[i, 11]
    f0, f1 = forms[i, 0], forms[i, 1]
    block = Rounded(f0, f1, forms[i, 2], forms[i, 3], forms[i, 4])
    kind = view.kinds[i]
    for k in range(rays):
        x, y = xs[k], ys[k]
        d = r0 * x + r3 * y + r6, r1 * x + r4 * y + r7, r2 * x + r5 * y + r8
        if kind == CAPSULE:
            found[k] = capsule_depth(o, d, f0, f1, side)
        elif kind == BLOCK:
            found[k] = block_depth(o, d, block, side)
        else:
            found[k] = disc_depth(o, d, f0, f1, side)


@kernel(error_model="numpy")
def _lay(i: int, rays: int, bundle: RayBundle) -> None:
    """Insert a layer of body i by depth on each ray that intersects it.

    An opaque layer hides all layers behind it.
    """
    found, counts, depths = bundle.found, bundle.many, bundle.depth
    shares, covers, bodies = bundle.share, bundle.cover, bundle.body
    for k in range(rays):
        depth, count = found[k], counts[k]
        if depth < NEAR:
            continue
        row = count
        while row > 0 and depths[k, row - 1] > depth:
            row -= 1
        if row == DEEPEST or (row > 0 and covers[k, row - 1] >= SOLID):
            continue
        cover = shares[k]
        last = row if cover >= SOLID else min(count, DEEPEST - 1)
        for j in range(last, row, -1):
            depths[k, j] = depths[k, j - 1]
            covers[k, j] = covers[k, j - 1]
            bodies[k, j] = bodies[k, j - 1]
        depths[k, row], covers[k, row], bodies[k, row] = depth, cover, i
        counts[k] = last + 1


@kernel(error_model="numpy")
def _meet_line(view: View, m: int, rays: int, bundle: RayBundle) -> None:
    """Write the depth of line m into ``found`` for rays close to it, and its coverage into
    ``share``.

    Where lines of one body overlap, only the one with the larger coverage is used.
    """
    xs, ys, found, shares, lines = bundle.x, bundle.y, bundle.found, bundle.share, view.lines
    counts, covers, bodies = bundle.many, bundle.cover, bundle.body
    focal, middle_u, middle_v, i = view.focal, view.middle_u, view.middle_v, view.owner[m]
    width_px, opacity = view.looks[i, WIDTH], view.looks[i, OPACITY]
    for k in range(rays):
        found[k] = 0.0
        u, v = middle_u + focal * xs[k], middle_v + focal * ys[k]
        share = opacity * stroke_cover(lines, m, u, v, width_px)
        if share <= 0.0:
            continue
        shares[k], found[k] = min(share, MOST_OF_A_LINE), stroke_depth(lines, m, u, v)
        for j in range(counts[k]):
            if bodies[k, j] == i:
                covers[k, j] = max(covers[k, j], shares[k])
                found[k] = 0.0
