"""Where the centre of a patch's image is: a patch around a finger appears nearer to the bone.

A patch covers the angles ±a around the bone, at the distance ρ from its axis. From a direction at
the angle b around the bone, the mean of its projected area is  ρ cos(a) sin(b)  beside the axis, as
of a point at the distance ρ cos(a). From a direction inclined along the bone, it is as of a point
at the distance  ρ (a + sin(a) cos(a)) / (2 sin(a)) . Directions of both kinds occur, so the mean of
both is used. A circle has another a at each position along the bone.
"""

from __future__ import annotations

import numpy as np

from tracker.glove.model import GloveModel, Marker
from tracker.hand.model import HandModel
from tracker.messages import Array

ACROSS = 0.5  # share of a normal along the bone, above which a patch is on a fingertip
STEPS = 32  # slices of a circle along the bone


def seen_centres(glove: GloveModel, hand: HandModel) -> Array:
    """(M, 3) m, in each marker's B: the points that images show as the centres of the patches."""
    root = hand.segments[hand.root].name
    return np.array([_centre(m, m.segment == root) for m in glove.markers]).reshape(-1, 3)


def _centre(marker: Marker, is_flat: bool) -> Array:
    """(3,) m; patches on the hand's back and on fingertips are flat."""
    if is_flat or abs(marker.normal[0]) > ACROSS:
        return marker.position
    radius = float(np.hypot(marker.position[1], marker.position[2]))
    nearer = _nearer(marker, radius)
    return marker.position * np.array([1.0, nearer, nearer])


def _nearer(marker: Marker, radius: float) -> float:
    """Factor on the distance from the bone's axis."""
    half = marker.size / 2
    if marker.shape == "circle":
        along = half * (2 * (np.arange(STEPS) + 0.5) / STEPS - 1)
        a = np.sqrt(half**2 - along**2) / radius
    else:
        a = np.array([half / radius])
    a = np.minimum(a, np.pi / 2)
    around, inclined = np.sin(a) * np.cos(a), (a + np.sin(a) * np.cos(a)) / 2
    return float(np.sum(around + inclined) / (2 * np.sum(np.sin(a))))
