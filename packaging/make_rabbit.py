"""Makes resources/meshes/rabbit.obj: the surface of a smooth union of ellipsoids, by VTK's contour
filter.

.venv/bin/python packaging/make_rabbit.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyvista

OUT = Path(__file__).parents[1] / "resources" / "meshes" / "rabbit.obj"
CELLS = 36  # along each side of the grid
SOFT = 0.07  # smoothing of the seams, in units of the body's half height
PARTS = (  # centre, half axes, tilt about y in degrees
    ((0.00, 0.00, 0.00), (0.52, 0.40, 0.46), 0.0),  # body
    ((0.42, 0.00, 0.44), (0.28, 0.25, 0.25), 20.0),  # head
    ((0.66, 0.00, 0.38), (0.12, 0.13, 0.10), 20.0),  # muzzle
    ((0.22, 0.13, 0.92), (0.08, 0.05, 0.36), -18.0),  # ears
    ((0.22, -0.13, 0.92), (0.08, 0.05, 0.36), -18.0),
    ((0.34, 0.20, -0.34), (0.24, 0.11, 0.11), 0.0),  # paws
    ((0.34, -0.20, -0.34), (0.24, 0.11, 0.11), 0.0),
    ((-0.10, 0.30, -0.26), (0.34, 0.15, 0.22), 0.0),  # hind legs
    ((-0.10, -0.30, -0.26), (0.34, 0.15, 0.22), 0.0),
    ((-0.56, 0.00, -0.10), (0.15, 0.15, 0.15), 0.0),  # tail
)


def distance(points: np.ndarray) -> np.ndarray:
    """The approximate signed distance of points (n, 3) from the union."""
    out = np.full(len(points), np.inf)
    for centre, axes, tilt in PARTS:
        a = np.deg2rad(tilt)
        R = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
        local = (points - centre) @ R / np.array(axes)
        length = np.linalg.norm(local, axis=1)
        part = (length - 1) * min(axes)
        h = np.clip(0.5 + 0.5 * (out - part) / SOFT, 0, 1)
        both = np.where(np.isfinite(out), out, 10.0)
        out = both * (1 - h) + part * h - SOFT * h * (1 - h)
    return out


def main() -> None:
    n = CELLS
    grid = pyvista.ImageData(
        dimensions=(n, n, n), spacing=(2.4 / n,) * 3, origin=(-1.103, -1.207, -0.801)
    )
    grid["d"] = distance(np.asarray(grid.points))
    surface = grid.contour([0.0], scalars="d").triangulate().clean(tolerance=0.0)
    surface = surface.smooth_taubin(n_iter=30, pass_band=0.15)
    points = np.asarray(surface.points)
    points = (points - (points.min(0) + points.max(0)) / 2) / np.ptp(points, axis=0).max()
    faces = (
        np.asarray(surface.faces).reshape(-1, 4)[:, [1, 3, 2]] + 1
    )  # outside is where the distance is greater
    lines = ["# Glovetrack's rabbit, 1 unit high; made by packaging/make_rabbit.py, Apache-2.0"]
    lines += [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in points]
    lines += [f"f {a} {b} {c}" for a, b, c in faces]
    OUT.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
