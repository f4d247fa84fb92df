"""Objects of the virtual place: a gate tower with a wall, its plan, and labels; our own shapes.

Lemak et al. 2020 show a reconstruction of a town, labels that lead to its objects, and a historical
source that is overlaid on an object and faded (section 1.1, Fig. 1 to 3).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from extensions.applications.solids import Solid, box, cylinder
from tracker.messages import Array

MAP = 0.32  # m, the side of the map


class Thing(NamedTuple):
    """A reconstructed object: its solids relative to the centre of its base, and the position (3,)
    m of its label relative to the map's centre."""

    name: str
    solids: tuple[tuple[Solid, str], ...]
    label: Array


def _block(centre: tuple[float, float, float], half: tuple[float, float, float]) -> Solid:
    solid = box(np.array(half))
    return Solid(solid.points + np.array(centre), solid.faces)


def _column(centre: tuple[float, float, float], radius: float, half: float) -> Solid:
    solid = cylinder(radius, half)
    return Solid(solid.points + np.array(centre), solid.faces)


def _roof(centre: tuple[float, float, float], half: float, height: float) -> Solid:
    """A pyramid."""
    foot = np.array([[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0.0]])
    top = np.array([0.0, 0.0, height])
    sides = [np.array([foot[k], foot[(k + 1) % 4], top]) for k in range(4)]
    points = np.concatenate([*sides, foot[::-1]]) + np.array(centre)
    faces = np.concatenate([np.arange(12).reshape(-1, 3), [[12, 13, 14], [12, 14, 15]]])
    return Solid(points, faces.astype(np.int64))


STONE, BRICK, SLATE = "#C8BBA6", "#B5694B", "#5A6B7B"
THINGS = (
    Thing(
        "Gate tower",
        (
            (_block((0, 0.022, 0.03), (0.02, 0.008, 0.03)), STONE),
            (_block((0, -0.022, 0.03), (0.02, 0.008, 0.03)), STONE),
            (_block((0, 0, 0.055), (0.02, 0.03, 0.012)), STONE),
            (_roof((0, 0, 0.067), 0.026, 0.03), SLATE),
        ),
        np.array([0.08, 0.07, 0.0]),
    ),
    Thing(
        "Church",
        (
            (_block((0, 0, 0.02), (0.035, 0.018, 0.02)), BRICK),
            (_column((-0.02, 0, 0.04), 0.013, 0.04), BRICK),
            (_roof((-0.02, 0, 0.08), 0.012, 0.025), SLATE),
            (_roof((0.015, 0, 0.04), 0.018, 0.018), SLATE),
        ),
        np.array([0.08, -0.07, 0.0]),
    ),
    Thing(
        "Round tower",
        (
            (_column((0, 0, 0.03), 0.022, 0.03), STONE),
            (_column((0, 0, 0.064), 0.026, 0.006), STONE),
        ),
        np.array([-0.06, 0.0, 0.0]),
    ),
)


def plan_of(thing: Thing) -> list[Array]:
    """The source overlaid on the object: a drawing of its edges like in an old plan, as polylines
    (n, 3) m: the outlines of each solid's base and top."""
    out = []
    for solid, _ in thing.solids:
        low, high = solid.points.min(axis=0), solid.points.max(axis=0)
        for z in (low[2], high[2]):
            x0, y0, x1, y1 = low[0], low[1], high[0], high[1]
            out.append(np.array([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z], [x0, y0, z]]))
    return out
