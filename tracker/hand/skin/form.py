"""The primitives of a hand's surface: round cones along bones, muscles and the forearm.

All in the frame of the root segment (x to the fingers, y to the thumb of a right hand, z out of the
back), m, in the bind pose. Proportions follow typical anatomy and appearance; lengths and girths
are those of the hand file.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import Array

FABRIC = 0.0015
"""m of cloth on the skin: distance of the glove files' markers from the surface of the bones."""
SPREAD = {"index": 0.6, "ring": -0.55, "little": -0.95}
"""Share of the limit of abduction in the bind pose, so that neighbouring fingers do not touch."""
NARROW = 0.55  # spacing of the metacarpals at the wrist, relative to that of the knuckles
FOREARM = 0.72  # length of the displayed half of the forearm, in hand lengths
TIP = 0.82  # thickness of a fingertip's sphere, relative to its segment's


@dataclass(frozen=True, eq=False)
class Cones:
    """N round cones from a to b (N, 3), with radii (N, 2) at the ends; ``flat`` (N,) is the
    compression along z: 1 is round, 1.4 a flat oval."""

    a: Array
    b: Array
    radius: Array
    flat: Array


@dataclass(frozen=True, eq=False)
class HandForm:
    """Cones by anatomy: fingers by name in the order of `CHAINS`, palm, muscles of the thumb,
    forearm; and their pose: R (S, 3, 3), p (S, 3) of each segment in the root."""

    R: Array
    p: Array
    fingers: dict[str, Cones]
    palm: Cones
    thenar: Cones
    forearm: Cones


def bind_angles(hand: HandModel) -> Array:
    """(J,) rad: flat, with spread fingers, so that they do not merge."""
    angles = np.zeros(len(hand.joint_names))
    side = 1.0 if hand.side == "right" else -1.0
    for finger, share in SPREAD.items():
        column = hand.angle_index.get(f"{finger}_mcp_abduction")
        if column is not None:
            low, high = hand.angle_limits[column]
            angles[column] = share * side * (high if share * side > 0 else -low)
    return angles


def hand_form(hand: HandModel) -> HandForm:
    """The form of a hand in its bind pose."""
    R, p = hand.forward(bind_angles(hand), np.eye(3), np.zeros(3))
    fingers = {
        name: _finger(hand, R, p, [hand.index[s] for s in chain if s in hand.index])
        for name, chain in CHAINS.items()
        if chain[0] in hand.index
    }
    return HandForm(R, p, fingers, _palm(hand, p), _thenar(hand, R, p), _forearm(hand))


def _cones(rows: list[tuple[Array, Array, float, float, float]]) -> Cones:
    a, b, ra, rb, flat = zip(*rows, strict=True) if rows else ((), (), (), (), ())
    return Cones(
        np.array(a, float).reshape(-1, 3),
        np.array(b, float).reshape(-1, 3),
        np.array([ra, rb], float).T.reshape(-1, 2),
        np.array(flat, float),
    )


def _finger(hand: HandModel, R: Array, p: Array, rows: list[int]) -> Cones:
    """One cone per segment: as thick in its middle as the file specifies, tapered between
    joints."""
    radii = [hand.segments[i].radius + FABRIC for i in rows]
    joint = [radii[0], *(0.5 * (x + y) for x, y in itertools.pairwise(radii))]
    out = []
    for k, i in enumerate(rows):
        last = k + 1 == len(rows)
        end = radii[k] * TIP if last else joint[k + 1]
        length = hand.segments[i].length - (end - FABRIC if last else 0.0)
        out.append((p[i], p[i] + R[i, :, 0] * length, joint[k], end, 1.0))
    return _cones(out)


def _palm(hand: HandModel, p: Array) -> Cones:
    """A metacarpal for each finger, and the hypothenar."""
    root = hand.segments[hand.root]
    thick, out = root.radius + FABRIC, []
    knuckles = [p[hand.index[f"{f}_proximal"]] for f in FINGERS if f"{f}_proximal" in hand.index]
    knuckles = knuckles or [np.array([root.length, 0.0, 0.0])]
    for knuckle in knuckles:
        wrist = np.array([0.0, NARROW * knuckle[1], 0.0])
        out.append((wrist, knuckle * [1, 1, 0.5], 0.98 * thick, 0.86 * thick, 1.0))
    outer = knuckles[-1]
    start, end = 0.12 * outer + [0, 0.5 * outer[1], 0], 0.75 * outer
    low = np.array([0.0, 0.0, -0.22 * thick])
    out.append((start + low, end + low, 0.85 * thick, 0.75 * thick, 1.0))
    return _cones(out)


def _thenar(hand: HandModel, R: Array, p: Array) -> Cones:
    """The thenar, and the skin between thumb and index finger."""
    if "thumb_metacarpal" not in hand.index:
        return _cones([])
    i = hand.index["thumb_metacarpal"]
    s = hand.segments[i]
    axis, thick = R[i, :, 0], s.radius + FABRIC
    knuckle = p[hand.index["index_proximal"]] if "index_proximal" in hand.index else axis * s.length
    ball = p[i] + 0.15 * s.length * axis, p[i] + 0.62 * s.length * axis
    inwards = np.array([0.0, -0.25 * np.sign(p[i][1] or 1.0) * thick, -0.1 * thick])
    web = p[i] + 0.55 * s.length * axis
    return _cones(
        [
            (ball[0] + inwards, ball[1] + 0.4 * inwards, 1.08 * thick, 1.0 * thick, 1.0),
            (web, 0.62 * knuckle, 0.62 * thick, 0.62 * thick, 1.0),
        ]
    )


def _forearm(hand: HandModel) -> Cones:
    """From the wrist halfway to the elbow: a widening oval."""
    root = hand.segments[hand.root]
    wide, length = max(root.width, 2.5 * root.radius), FOREARM * hand.length
    wrist, elbow = 0.33 * wide, 0.46 * wide
    return _cones(
        [(np.array([-0.03 * hand.length, 0, 0]), np.array([-length, 0.0, 0.0]), wrist, elbow, 1.35)]
    )
