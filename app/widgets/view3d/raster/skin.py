"""What a ray sees of a triangle: colour under light, hatching, dots."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.shading import lit_in_camera
from app.widgets.view3d.raster.view import RayBundle, View
from tracker.kernels import kernel

RING = 0.0042  # m from one line of the hatching to the next, along the surface
LINE_PX = 1.5  # of the hatching
LEAST_PX = 4.0  # lines nearer to each other than this fade
HATCH_DARKNESS = 0.62
DOT_PX, DOT_RADIUS = 5.0, 1.55  # px from dot to dot and of each, where a surface is dotted
BETWEEN_DOTS = 0.22  # cover of a dotted surface between its dots
GLOSS = 0.16


@kernel(error_model="numpy")
def meet_surface(view: View, rays: int, bundle: RayBundle) -> None:
    """The depth of the surface that each ray meets into ``found``, its cover into ``share``, its
    colour into ``skin``. One long loop: an array that is handed on costs more than its numbers."""
    face, inverse, seen = view.samples.face, view.samples.inverse, view.seen
    faces, dress, along, part = (
        view.surfaces.faces, view.surfaces.dress, view.surfaces.along, view.surfaces.part
    )  # fmt: skip
    xs, ys, at, found, shares = bundle.x, bundle.y, bundle.at, bundle.found, bundle.share
    skin, parts, focal = bundle.skin, bundle.part, view.focal
    middle_u, middle_v = view.middle_u, view.middle_v
    for ray in range(rays):
        row, column, m = at[ray, 0], at[ray, 1], at[ray, 2]
        f = face[row, column, m]
        found[ray] = 0.0
        if not inverse[row, column, m] > 0.0:
            continue
        i, j, k = faces[f, 0], faces[f, 1], faces[f, 2]
        depth = 1.0 / np.float64(inverse[row, column, m])
        # shares of the corners in the image, then on the triangle
        u, v = middle_u + focal * xs[ray] - seen[k, 0], middle_v + focal * ys[ray] - seen[k, 1]
        ui, vi = seen[i, 0] - seen[k, 0], seen[i, 1] - seen[k, 1]
        uj, vj = seen[j, 0] - seen[k, 0], seen[j, 1] - seen[k, 1]
        double = ui * vj - uj * vi
        si = (u * vj - uj * v) / double * seen[i, 2] * depth
        sj = (ui * v - u * vi) / double * seen[j, 2] * depth
        sk = 1.0 - si - sj
        nx = si * seen[i, 3] + sj * seen[j, 3] + sk * seen[k, 3]
        ny = si * seen[i, 4] + sj * seen[j, 4] + sk * seen[k, 4]
        nz = si * seen[i, 5] + sj * seen[j, 5] + sk * seen[k, 5]
        length = np.sqrt(nx * nx + ny * ny + nz * nz) + 1e-12
        ambient = si * dress[i, 4] + sj * dress[j, 4] + sk * dress[k, 4]
        normal = nx / length, ny / length, nz / length
        bright, shine = lit_in_camera(normal, ambient, GLOSS * (1.0 - ambient))
        cover = si * dress[i, 3] + sj * dress[j, 3] + sk * dress[k, 3]
        if si * dress[i, 5] + sj * dress[j, 5] + sk * dress[k, 5] > 0.5:
            x, y, z = along[i], along[j], along[k]
            gu, gv = (x - z) * vj - (y - z) * vi, (y - z) * ui - (x - z) * uj
            per_px = np.sqrt(gu * gu + gv * gv) / abs(double)
            dark = _ring(si * x + sj * y + sk * z, per_px)
            bright, shine = bright * (1.0 - HATCH_DARKNESS * dark), shine * (1.0 - dark)
        if si * dress[i, 6] + sj * dress[j, 6] + sk * dress[k, 6] > 0.5:
            dot = _dot(middle_u + focal * xs[ray], middle_v + focal * ys[ray])
            cover *= BETWEEN_DOTS + (1.0 - BETWEEN_DOTS) * dot
        for c in range(3):
            colour = si * dress[i, c] + sj * dress[j, c] + sk * dress[k, c]
            skin[ray, c] = min(colour * bright + shine, 1.0)
        parts[ray], found[ray], shares[ray] = part[f], depth, cover


@kernel(error_model="numpy", inline="always")
def _ring(along: float, per_px: float) -> float:
    """How much of the pixel the nearest line covers; ``per_px`` m of ``along`` that it is wide."""
    off = abs(along - RING * np.round(along / RING)) / max(per_px, 1e-9)
    cover = min(max(0.5 * LINE_PX + 0.5 - off, 0.0), 1.0)
    return cover * min(1.0, max(0.0, RING / max(per_px, 1e-9) / LEAST_PX - 0.5))


@kernel(error_model="numpy", inline="always")
def _dot(u: float, v: float) -> float:
    """How much of the pixel a dot of a lattice on its corner covers."""
    a, b = (u + v) * 0.7071, (u - v) * 0.7071
    a, b = a - DOT_PX * np.round(a / DOT_PX), b - DOT_PX * np.round(b / DOT_PX)
    return min(max(DOT_RADIUS + 0.5 - np.sqrt(a * a + b * b), 0.0), 1.0)
