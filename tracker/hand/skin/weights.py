"""Which segments a point of the surface follows, and by how much."""

from __future__ import annotations

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.hand.skin.field import finger_distances, palm_distance
from tracker.hand.skin.form import FABRIC, HandForm
from tracker.messages import Array, IntArray

MOST = 4
"""Segments that one point follows."""
BEND = 0.85  # radii on either side of a joint over which the surface bends
BEND_THUMB = 1.3  # the same of the thumb's root, which lies deep in the palm
BETWEEN = 0.0025  # m of difference in distance over which two fingers share what lies between
BESIDE = 0.006  # the same between thumb and palm


def bone_weights(hand: HandModel, form: HandForm, x: Array) -> tuple[IntArray, Array]:
    """Segments (P, `MOST`) and their shares (P, `MOST`), which sum to 1, of points x (P, 3)."""
    dense = _dense(hand, form, x)
    bones = np.argsort(-dense, axis=1, kind="stable")[:, :MOST]
    share = np.take_along_axis(dense, bones, axis=1)
    share[share < 1e-3] = 0.0
    return bones, share / share.sum(axis=1, keepdims=True)


def _dense(hand: HandModel, form: HandForm, x: Array) -> Array:
    """(P, S) share of each segment."""
    out = np.zeros((len(x), len(hand.segments)))
    palm, near = palm_distance(form, x), finger_distances(form, x)
    if near:
        belongs = _shares(np.array(list(near.values())))
        for name, share in zip(near, belongs, strict=True):
            if name == "thumb":
                share = share * _step((palm - near[name]) / BESIDE)
            _hand_out(hand, form, name, share, x, out)
    out[:, hand.root] += np.maximum(1.0 - out.sum(axis=1), 0.0)
    return out


def _shares(distances: Array) -> Array:
    """(F, P) how much of each point belongs to each finger, by distances (F, P) m."""
    nearer = np.clip(1.0 - (distances - distances.min(axis=0)) / BETWEEN, 0.0, 1.0) ** 2
    return np.asarray(nearer / nearer.sum(axis=0))


def _hand_out(
    hand: HandModel, form: HandForm, finger: str, left: Array, x: Array, out: Array
) -> None:
    """Add a finger's share (P,) of each point to its segments, from the palm to the tip."""
    chain = [hand.index[s] for s in CHAINS[finger] if s in hand.index]
    for k, i in enumerate(chain):
        radius = hand.segments[i].radius + FABRIC
        width = radius * (BEND_THUMB if finger == "thumb" and k == 0 else BEND)
        beyond = left * _step((x - form.p[i]) @ form.R[i, :, 0] / width)
        if k > 0:
            out[:, chain[k - 1]] += left - beyond
        left = beyond
    out[:, chain[-1]] += left


def _step(x: Array) -> Array:
    """From 0 at -1 to 1 at 1, level at both ends."""
    t = np.clip(0.5 + 0.5 * x, 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))
