"""How sure each fingertip is, as a thin ring around it that faces the eye.

Filled balls would hide what they tell of: of the fingers without a sensor two standard deviations
are centimetres. A ring is as large as it says up to `LIMIT`; where it would be larger, it stays so
large and is broken: "farther than this". So neither colour nor size alone has to be read.
"""

from __future__ import annotations

import numpy as np

from app.viewmodels.hand_scene import HandScene
from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.scene import BodyLook, BodyScene, DrawnBody
from app.widgets.view3d.shapes import Lines
from tracker.messages import Array

LIMIT = 0.015  # m; about half the way to the next fingertip of a spread hand
SEGMENTS = 40
COLOUR = "#2F86BC"  # stands out from the light and the dark background
WHOLE = BodyLook(COLOUR, line_width=1.5)
BROKEN = BodyLook(COLOUR, opacity=0.75, line_width=1.5)


class TipRings:
    """Two rings for each of ``tips`` fingertips, of which one is shown at most."""

    def __init__(self, scene: BodyScene, tips: int) -> None:
        self._whole = [scene.add(ring(broken=False), WHOLE) for _ in range(tips)]
        self._broken = [scene.add(ring(broken=True), BROKEN) for _ in range(tips)]
        for body in (*self._whole, *self._broken):
            body.show(False)  # of unit size until they are placed: they would fill the view

    def update(self, scene: HandScene, wanted: bool, orbit: Orbit) -> None:
        """Around the fingertips of ``scene``, of two standard deviations."""
        for i, (whole, broken) in enumerate(zip(self._whole, self._broken, strict=True)):
            known = bool(np.isfinite(scene.tips[i]).all() and np.isfinite(scene.tip_sd[i]))
            radius = 2 * float(scene.tip_sd[i]) if known else 0.0
            whole.show(wanted and known and radius <= LIMIT)
            broken.show(wanted and known and radius > LIMIT)
            if wanted and known:
                body: DrawnBody = whole if radius <= LIMIT else broken
                body.move(facing(orbit) * min(max(radius, 1e-4), LIMIT), scene.tips[i])


def ring(broken: bool) -> Lines:
    """Of unit radius about z; ``broken``: every other part of it alone."""
    angle = 2 * np.pi * np.arange(SEGMENTS) / SEGMENTS
    points = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    first = np.arange(0, SEGMENTS, 2 if broken else 1)
    return Lines(points, np.stack([first, (first + 1) % SEGMENTS], axis=1))


def facing(orbit: Orbit) -> Array:
    """(3, 3) a rotation that takes z towards the eye."""
    right = np.cross(orbit.up, orbit.direction)
    return np.stack([right, orbit.up, orbit.direction], axis=1)
