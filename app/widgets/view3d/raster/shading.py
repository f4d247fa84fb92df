"""Lighting of surfaces by lamps that move with the camera."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.solids import Rotation
from tracker.geometry.solids import Vector3
from tracker.kernels import kernel

DIGITS = 9
"""Decimal places of directions computed here: their last bits depend on the processor, and the
compiled kernels are only valid if all constants agree."""


def _lamp(azimuth_deg: float, elevation_deg: float, strength: float) -> tuple[float, ...]:
    """Direction in C towards a lamp, to the right of the camera and above it, and its strength."""
    a, e = np.deg2rad(azimuth_deg), np.deg2rad(elevation_deg)
    direction = np.sin(a) * np.cos(e), -np.sin(e), -np.cos(a) * np.cos(e)
    x, y, z = (round(float(w), DIGITS) for w in direction)
    return x, y, z, strength


KEY = _lamp(10, 50, 0.75)
FILL = _lamp(0, -75, 0.25)  # for surfaces that the key light does not reach
HEAD = 0.25  # strength of the lamp at the camera
EDGE = _lamp(110, 0, 0.21)  # from behind, on either side, to emphasize the edges
"""As in a photographer's (and VTK's) light kit."""


def _halfway(lamp: tuple[float, ...]) -> tuple[float, ...]:
    """Direction halfway between a lamp and the camera: the normal with the maximum highlight."""
    direction = np.array(lamp[:3]) - [0.0, 0.0, 1.0]
    unit = direction / np.linalg.norm(direction)
    x, y, z = (round(float(u), DIGITS) for u in unit)
    return x, y, z


GLOSS = _halfway(KEY)
GLOSS_TURNS = 4
"""The highlight is the cosine, squared this many times."""


@kernel(error_model="numpy", inline="always")
def lit(R_CS: Rotation, n_S: Vector3, ambient: float, specular: float) -> tuple[float, float]:
    """Factor of a surface's colour, and white to be added; the normal is in S."""
    n = (
        R_CS[0] * n_S[0] + R_CS[1] * n_S[1] + R_CS[2] * n_S[2],
        R_CS[3] * n_S[0] + R_CS[4] * n_S[1] + R_CS[5] * n_S[2],
        R_CS[6] * n_S[0] + R_CS[7] * n_S[1] + R_CS[8] * n_S[2],
    )
    return lit_in_camera(n, ambient, specular)


@kernel(error_model="numpy", inline="always")
def lit_in_camera(n: Vector3, ambient: float, specular: float) -> tuple[float, float]:
    """As `lit`, for a normal in C."""
    bright = ambient
    bright += KEY[3] * max(KEY[0] * n[0] + KEY[1] * n[1] + KEY[2] * n[2], 0.0)
    bright += FILL[3] * max(FILL[1] * n[1] + FILL[2] * n[2], 0.0)
    bright += HEAD * max(-n[2], 0.0)
    bright += EDGE[3] * max(EDGE[0] * abs(n[0]) + EDGE[2] * n[2], 0.0)
    if specular == 0.0:
        return bright, 0.0
    shine = max(GLOSS[0] * n[0] + GLOSS[1] * n[1] + GLOSS[2] * n[2], 0.0)
    for _ in range(GLOSS_TURNS):
        shine *= shine
    return bright, specular * shine
