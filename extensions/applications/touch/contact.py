"""Where fingertips are in an object: depth and direction of each, and what is felt of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from extensions.applications.hand import TIPS, HandSample
from tracker.geometry import so3
from tracker.geometry.triangles import Triangles, nearest
from tracker.messages import Array, Validity

LOST = int(Validity.LOST)


class Contact(NamedTuple):
    """A fingertip's pad, a ball of ``radius`` (m) around ``centre`` (3,), against an object.

    depth m, negative where it does not touch; point (3,) on the surface and normal (3,) there,
    outwards; all in G. push (3,): the normal in the distal segment's frame B.
    """

    tip: str
    depth: float
    point: Array
    normal: Array
    push: Array


class Pads(NamedTuple):
    """Of the fingertips that are known: names, R_GB (n, 3, 3), centres (n, 3), radius (n,)."""

    tips: list[str]
    R_GB: Array
    centre: Array
    radius: Array


def pads(hand: HandSample) -> Pads:
    """The last bone's end, as far inside its tip as it is thick."""
    names = [n for n in TIPS if n in hand.names]
    rows = np.array([hand.names[n] for n in names], np.int64)
    there = hand.state[rows] != LOST
    there &= np.isfinite(hand.p[rows]).all(axis=1) & np.isfinite(hand.q[rows]).all(axis=1)
    known = rows[there]
    R, radius = so3.matrix_from_quat(hand.q[known]), hand.radius[known]
    tips = [n for n, seen in zip(names, there.tolist(), strict=True) if seen]
    return Pads(tips, R, hand.p[known] - radius[:, None] * R[:, :, 0], radius)


class PlacedMesh(NamedTuple):
    """A mesh in its own units, which stands in G turned by R (3, 3), ``size`` m large, at p."""

    mesh: Triangles
    R: Array
    size: float
    p: Array


def contacts(fingers: Pads, thing: PlacedMesh) -> list[Contact]:
    """Of each pad."""
    local = (fingers.centre - thing.p) @ thing.R / thing.size
    found = nearest(thing.mesh, local)
    point = thing.size * found.point @ thing.R.T + thing.p
    normal = found.normal @ thing.R.T
    depth = fingers.radius - thing.size * found.distance
    push = np.einsum("nji,nj->ni", fingers.R_GB, normal)
    return [
        Contact(tip, float(depth[i]), point[i], normal[i], push[i])
        for i, tip in enumerate(fingers.tips)
    ]
