"""Where fingertips are in an object: depth and direction of each, and what is felt of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.applications.hand import TIPS, HandSample
from tracker.geometry.triangles import Triangles, nearest
from tracker.messages import Array


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
    rows = [(n, hand.point(n), hand.rotation(n)) for n in TIPS]
    known = [(n, p, R) for n, p, R in rows if p is not None and R is not None]
    R = np.array([r[2] for r in known]).reshape(-1, 3, 3)
    radius = np.array([hand.radius[hand.names[r[0]]] for r in known])
    tip = np.array([r[1] for r in known]).reshape(-1, 3)
    return Pads([r[0] for r in known], R, tip - radius[:, None] * R[:, :, 0], radius)


class Placed(NamedTuple):
    """A mesh in its own units, which stands in G turned by R (3, 3), ``size`` m large, at p."""

    mesh: Triangles
    R: Array
    size: float
    p: Array


def contacts(fingers: Pads, thing: Placed) -> list[Contact]:
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
