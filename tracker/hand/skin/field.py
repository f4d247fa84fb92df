"""Signed distance to a hand's surface, negative inside.

The distance to a round cone is exact; cones are blended by the quadratic smooth minimum (I. Quilez,
"Smooth minimum", 2013), which has no effect beyond the width of the blend.
"""

from __future__ import annotations

import numpy as np

from tracker.hand.skin.form import Cones, HandForm
from tracker.messages import Array

BLEND_PALM, BLEND_MUSCLE, BLEND_WRIST, BLEND_KNUCKLE, BLEND_WEB = 0.012, 0.012, 0.03, 0.008, 0.004
"""m, width of the blend."""
REACH = 0.008  # m around a control point that deforms the surface
STEP = 1e-4  # m, step of the difference quotient for the gradient


def cone_distance(cones: Cones, x: Array) -> Array:
    """(N, P) m from each of the points x (P, 3) to each cone."""
    stretch = np.stack([np.ones_like(cones.flat)] * 2 + [cones.flat], axis=1)
    a, b = cones.a * stretch, cones.b * stretch
    along = b - a
    square = np.maximum((along**2).sum(axis=1), 1e-12)[:, None]
    y = x[None] * stretch[:, None] - a[:, None]
    drop = (cones.radius[:, :1] - cones.radius[:, 1:]) / np.sqrt(square)
    drop = np.clip(drop, -0.95, 0.95)
    along_axis = np.einsum("npk,nk->np", y, along) / np.sqrt(square)
    away = np.sqrt(np.maximum((y**2).sum(axis=2) - along_axis**2, 0.0))
    # the nearest point of the axis is perpendicular to the cone's side, not to its axis
    foot = along_axis + away * drop / np.sqrt(1 - drop**2)
    share = np.clip(foot / np.sqrt(square), 0.0, 1.0)
    radius = cones.radius[:, :1] * (1 - share) + cones.radius[:, 1:] * share
    centre = along_axis - share * np.sqrt(square)
    return np.asarray(np.sqrt(centre**2 + away**2) - radius)


def smooth_minimum(a: Array, b: Array, width: float) -> Array:
    """The smaller of two distances, blended where they differ by less than ``width`` m."""
    h = np.maximum(width - np.abs(a - b), 0.0) / width
    return np.asarray(np.minimum(a, b) - 0.25 * width * h * h)


def _blended(rows: Array, width: float) -> Array:
    out = rows[0]
    for row in rows[1:]:
        out = smooth_minimum(out, row, width)
    return np.asarray(out)


def palm_distance(form: HandForm, x: Array) -> Array:
    """(P,) m to palm, wrist and forearm."""
    palm = _blended(cone_distance(form.palm, x), BLEND_PALM)
    arm = cone_distance(form.forearm, x)[0]
    end = form.forearm.b[0, 0] - x[:, 0]  # cut off, with a rounded edge
    arm = -smooth_minimum(-arm, -end, 0.01)
    return smooth_minimum(palm, arm, BLEND_WRIST)


def finger_distances(form: HandForm, x: Array) -> dict[str, Array]:
    """(P,) m to each finger."""
    return {name: cone_distance(cones, x).min(axis=0) for name, cones in form.fingers.items()}


def distance(form: HandForm, x: Array) -> Array:
    """(P,) m from points x (P, 3) to the blended surface."""
    palm, fingers = palm_distance(form, x), finger_distances(form, x)
    thumb = fingers.pop("thumb", None)
    if thumb is not None:
        muscles = [*cone_distance(form.thenar, x)]
        for part in (*muscles, thumb):
            palm = smooth_minimum(palm, part, BLEND_MUSCLE)
    if not fingers:
        return palm
    return smooth_minimum(
        palm, _blended(np.array(list(fingers.values())), BLEND_WEB), BLEND_KNUCKLE
    )


class BlendedSurface:
    """The blended surface, deformed so that it passes through ``points`` (M, 3)."""

    def __init__(self, form: HandForm, points: Array) -> None:
        self._form, self._points = form, points
        self._pull: Array = np.zeros(len(points))
        if len(points):
            pulls = _bumps(points, points) + 1e-3 * np.eye(len(points))
            self._pull = np.asarray(np.linalg.solve(pulls, distance(form, points)), float)

    def distance(self, x: Array) -> Array:
        """(P,) m."""
        out = distance(self._form, x)
        near = _near(x, self._points)
        if near.any():
            out = out.copy()
            out[near] -= _bumps(x[near], self._points) @ self._pull
        return out

    def gradient(self, x: Array) -> Array:
        """(P, 3) by central differences: outward, with length 1 except in blends."""
        steps = STEP * np.eye(3)
        ahead = [self.distance(x + d) - self.distance(x - d) for d in steps]
        return np.stack(ahead, axis=1) / (2 * STEP)

    def project(self, x: Array, turns: int = 2) -> Array:
        """(P, 3) the points x (P, 3) projected to the surface along its gradient."""
        out = np.array(x, float)
        for _ in range(turns):
            g = self.gradient(out)
            square = np.maximum((g**2).sum(axis=1, keepdims=True), 0.05)
            out -= np.clip(self.distance(out)[:, None] / square, -0.003, 0.003) * g
        return out


def _bumps(x: Array, points: Array) -> Array:
    """(P, M) weight of each control point at each point."""
    square = ((x[:, None] - points[None]) ** 2).sum(axis=2)
    return np.asarray(np.exp(-0.5 * square / REACH**2))


def _near(x: Array, points: Array) -> Array:
    """(P,) whether any control point may have an effect."""
    if not len(points):
        return np.zeros(len(x), bool)
    low, high = points.min(axis=0) - 4 * REACH, points.max(axis=0) + 4 * REACH
    return np.asarray(((x >= low) & (x <= high)).all(axis=1))
