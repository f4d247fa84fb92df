"""The appearance of a triangle at a ray: lit colour, hatching, dots.

Vertices are lit and their colours are interpolated. The triangles of a hand mesh are a few pixels
large, so that the difference to lighting each pixel, which takes four times as long, is not
visible.
"""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.placing import Pinhole
from app.widgets.view3d.raster.shading import lit_in_camera
from app.widgets.view3d.raster.surfaces import Surfaces
from app.widgets.view3d.raster.view import RayBundle, View
from tracker.geometry.solids import Vector3
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Written

RING = 0.0042  # m between the lines of the hatching, along the surface
LINE_PX = 1.5  # of the hatching
LEAST_PX = 4.0  # lines closer than this fade
HATCH_DARKNESS = 0.62
DOT_PX, DOT_RADIUS = 5.0, 1.55  # px, distance and radius of dots
BETWEEN_DOTS = 0.22  # opacity between the dots
GLOSS = 0.16


@kernel(error_model="numpy")
def light(surfaces: Surfaces, camera: Pinhole, seen: Written[Matrix]) -> None:
    """Fill in each point of ``seen`` (V, `SEEN`), after its position: the lit colour (3),
    highlight, opacity, hatch and dots."""
    R, normals, dress = camera.R_GC, surfaces.normals, surfaces.dress
    for i in range(len(seen)):
        a, b, c = normals[i, 0], normals[i, 1], normals[i, 2]
        x = R[0, 0] * a + R[1, 0] * b + R[2, 0] * c
        y = R[0, 1] * a + R[1, 1] * b + R[2, 1] * c
        z = R[0, 2] * a + R[1, 2] * b + R[2, 2] * c
        length = np.sqrt(x * x + y * y + z * z) + 1e-12
        ambient = dress[i, 4]
        normal = x / length, y / length, z / length
        bright, shine = lit_in_camera(normal, ambient, GLOSS * (1.0 - ambient))
        for k in range(3):
            seen[i, 3 + k] = dress[i, k] * bright
        seen[i, 6], seen[i, 7] = shine, dress[i, 3]
        seen[i, 8], seen[i, 9] = dress[i, 5], dress[i, 6]


@kernel(error_model="numpy", inline="always")
def surface_colour(view: View, f: int, x: float, y: float) -> tuple[Vector3, float]:
    """Colour and opacity of triangle f at the ray through (x, y) px."""
    seen, faces, along = view.seen, view.surfaces.faces, view.surfaces.along
    i, j, k = faces[f, 0], faces[f, 1], faces[f, 2]
    u, v = x - seen[k, 0], y - seen[k, 1]
    ui, vi = seen[i, 0] - seen[k, 0], seen[i, 1] - seen[k, 1]
    uj, vj = seen[j, 0] - seen[k, 0], seen[j, 1] - seen[k, 1]
    double = ui * vj - uj * vi
    si, sj = (u * vj - uj * v) / double, (ui * v - u * vi) / double
    sk = 1.0 - si - sj
    shine = si * seen[i, 6] + sj * seen[j, 6] + sk * seen[k, 6]
    cover = si * seen[i, 7] + sj * seen[j, 7] + sk * seen[k, 7]
    left = 1.0
    if si * seen[i, 8] + sj * seen[j, 8] + sk * seen[k, 8] > 0.5:
        p, q, r = along[i], along[j], along[k]
        gu, gv = (p - r) * vj - (q - r) * vi, (q - r) * ui - (p - r) * uj
        dark = _ring(si * p + sj * q + sk * r, np.sqrt(gu * gu + gv * gv) / abs(double))
        left, shine = 1.0 - HATCH_DARKNESS * dark, shine * (1.0 - dark)
    if si * seen[i, 9] + sj * seen[j, 9] + sk * seen[k, 9] > 0.5:
        cover *= BETWEEN_DOTS + (1.0 - BETWEEN_DOTS) * _dot(x, y)
    colour = (
        min((si * seen[i, 3] + sj * seen[j, 3] + sk * seen[k, 3]) * left + shine, 1.0),
        min((si * seen[i, 4] + sj * seen[j, 4] + sk * seen[k, 4]) * left + shine, 1.0),
        min((si * seen[i, 5] + sj * seen[j, 5] + sk * seen[k, 5]) * left + shine, 1.0),
    )
    return colour, cover


@kernel(error_model="numpy")
def meet_surface(view: View, rays: int, bundle: RayBundle) -> None:
    """Write the depth of the surface that each ray meets into ``found``, its opacity into
    ``share``, its colour into ``skin``."""
    face, inverse, part = view.samples.face, view.samples.inverse, view.surfaces.part
    xs, ys, at = bundle.x, bundle.y, bundle.at
    for ray in range(rays):
        row, column, m = at[ray, 0], at[ray, 1], at[ray, 2]
        bundle.found[ray] = 0.0
        if not inverse[m, row, column] > 0.0:
            continue
        f = face[m, row, column]
        x, y = view.middle_u + view.focal * xs[ray], view.middle_v + view.focal * ys[ray]
        colour, cover = surface_colour(view, f, x, y)
        bundle.skin[ray, 0], bundle.skin[ray, 1], bundle.skin[ray, 2] = colour
        bundle.part[ray], bundle.share[ray] = part[f], cover
        bundle.found[ray] = 1.0 / np.float64(inverse[m, row, column])


@kernel(error_model="numpy", inline="always")
def _ring(along: float, per_px: float) -> float:
    """Coverage of the pixel by the nearest line; ``per_px`` m of ``along`` per pixel."""
    off = abs(along - RING * np.round(along / RING)) / max(per_px, 1e-9)
    cover = min(max(0.5 * LINE_PX + 0.5 - off, 0.0), 1.0)
    return cover * min(1.0, max(0.0, RING / max(per_px, 1e-9) / LEAST_PX - 0.5))


@kernel(error_model="numpy", inline="always")
def _dot(u: float, v: float) -> float:
    """Coverage of the pixel by a dot of a lattice."""
    a, b = (u + v) * 0.7071, (u - v) * 0.7071
    a, b = a - DOT_PX * np.round(a / DOT_PX), b - DOT_PX * np.round(b / DOT_PX)
    return min(max(DOT_RADIUS + 0.5 - np.sqrt(a * a + b * b), 0.0), 1.0)
