"""Triangle meshes of boxes, cylinders, capsules and balls, for drawings. Lengths in m."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.messages import Array, IntArray

SIDES = 20
CORNERS = np.array(
    [[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)]
)  # fmt: skip
SQUARES = np.array(
    [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
)


class Solid(NamedTuple):
    """points (V, 3) and faces (F, 3), counter-clockwise from outside."""

    points: Array
    faces: IntArray


def box(half: Array) -> Solid:
    """A box about the origin; sides do not share corners, so that edges are sharp."""
    points = (CORNERS * half)[SQUARES.ravel()]
    first = 4 * np.arange(6)[:, None]
    faces = np.concatenate([first + [0, 1, 2], first + [0, 2, 3]])
    return Solid(points, faces)


def capsule(radius: float, half: float) -> Solid:
    """A capsule along z whose cylinder is from -half to half; ``half`` 0: a ball."""
    rise = np.linspace(-np.pi / 2, np.pi / 2, 10)
    profile = np.stack([radius * np.cos(rise), radius * np.sin(rise)], axis=1)
    profile[:, 1] += np.where(rise < 0, -half, half)
    return _turned(profile)


def cylinder(radius: float, half: float) -> Solid:
    """A cylinder along z from -half to half."""
    profile = [
        [0, -half],
        [radius, -half],
        [radius, -half],
        [radius, half],
        [radius, half],
        [0, half],
    ]
    return _turned(np.array(profile, float))


def _turned(profile: Array) -> Solid:
    """Surface of revolution of a profile (K, 2) of distance from z and height, from bottom to
    top."""
    angle = 2 * np.pi * np.arange(SIDES) / SIDES
    around = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rings = [np.column_stack([r * around, np.full(SIDES, z)]) for r, z in profile]
    here = np.arange(SIDES)
    after = (here + 1) % SIDES
    faces = []
    for k in range(len(profile) - 1):
        low, high = k * SIDES, (k + 1) * SIDES
        faces.append(np.stack([low + here, low + after, high + after], axis=1))
        faces.append(np.stack([low + here, high + after, high + here], axis=1))
    return Solid(np.concatenate(rings), np.concatenate(faces))
