"""Random whole-hand postures: open, fist, pinch, point, grip and free ones."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array

Angles = dict[str, float]
Generator = np.random.Generator

APART_DEG = {
    ("ring", "mcp"): 17.0,
    ("ring", "pip"): 5.0,
    ("little", "mcp"): 9.0,
    ("little", "pip"): 7.0,
}
"""Standard deviation from the neighbour towards the thumb, besides that of the kind of posture.
With it, ring and little finger differ from their neighbours as in recordings of people who handle
objects (extensions/evaluation/docs/evaluation.md)."""
STRAIGHT_OR_CLOSED = 0.4  # of these deviations remain if all fingers are straight or closed


def random_posture(hand: HandModel, rng: Generator, holding: bool = False) -> Array:
    """Angles (J,) rad within limits; synergies are exact for thumb IP and the DIP joints.

    ``holding``: only postures around an object.
    """
    own = rng.spawn(1)[0]
    if holding:
        return posture(hand, _apart(own, _grip(rng), 1.0))
    kinds = [_free, _open, _fist, _pinch, _point, _grip]
    kind: Callable[[Generator], Angles] = kinds[rng.choice(6, p=[0.4, 0.15, 0.1, 0.12, 0.1, 0.13])]
    share = STRAIGHT_OR_CLOSED if kind in (_open, _fist, _point) else 1.0
    return posture(hand, _apart(own, kind(rng), share))


def posture(hand: HandModel, degrees: Angles) -> Array:
    """Angles (J,) rad from some angles in degrees of a right hand; the rest are zero or synergy."""
    out = np.zeros(len(hand.joint_names))
    known = np.zeros(len(out), bool)
    for name, value in degrees.items():
        if name in hand.angle_index:
            i = hand.angle_index[name]
            out[i], known[i] = np.deg2rad(_side(hand, name) * value), True
    out, _ = hand.apply_synergies(out, known)
    return np.clip(out, hand.angle_limits[:, 0], hand.angle_limits[:, 1])


def _side(hand: HandModel, name: str) -> float:
    """Abduction and twist of a left hand have the opposite sign."""
    return -1.0 if hand.side == "left" and not name.endswith("flexion") else 1.0


def _fingers(rng: Generator, mcp: float, pip: float, spread: float, own: float) -> Angles:
    """All four fingers around one flexion, each with a deviation of ``own`` degrees; neighbours are
    correlated."""
    angles: Angles = {}
    wander = np.cumsum(rng.normal(0, own, (4, 2)), axis=0)
    for i, finger in enumerate(FINGERS):
        splay = np.array([1.0, 0.15, -0.6, -1.1])[i] * spread
        angles[f"{finger}_mcp_flexion"] = mcp + wander[i, 0]
        angles[f"{finger}_mcp_abduction"] = splay + rng.normal(0, 2.5)
        angles[f"{finger}_pip_flexion"] = max(pip + wander[i, 1], 0.0)
    return angles


def _thumb(rng: Generator, flexion: float, abduction: float, mcp: float) -> Angles:
    return {
        "thumb_cmc_flexion": flexion + rng.normal(0, 6),
        "thumb_cmc_abduction": abduction + rng.normal(0, 6),
        "thumb_cmc_twist": 0.3 * flexion + rng.normal(0, 5),
        "thumb_mcp_flexion": max(mcp + rng.normal(0, 8), -5.0),
        "thumb_mcp_abduction": rng.normal(0, 4),
    }


def _apart(rng: Generator, angles: Angles, share: float) -> Angles:
    """The angles with ring and little finger bent independently of the others: the little finger as
    far as the ring finger, plus its own deviation."""
    out, carried = dict(angles), {"mcp": 0.0, "pip": 0.0}
    for (finger, joint), sd in APART_DEG.items():
        carried[joint] += share * rng.normal(0, sd)
        name = f"{finger}_{joint}_flexion"
        if name in out:
            out[name] += carried[joint]
    return out


def _free(rng: Generator) -> Angles:
    mcp = rng.uniform(-10, 70)
    pip = float(np.clip(0.6 * mcp + rng.normal(20, 25), 0, 95))
    fingers = _fingers(rng, mcp, pip, rng.uniform(0, 12) * (1 - mcp / 100), 14)
    return fingers | _thumb(rng, rng.uniform(-20, 30), rng.uniform(-20, 20), rng.uniform(0, 45))


def _open(rng: Generator) -> Angles:
    return _fingers(rng, rng.uniform(-8, 8), 4, rng.uniform(2, 14), 3) | _thumb(rng, -5, 5, 3)


def _fist(rng: Generator) -> Angles:
    return _fingers(rng, rng.uniform(60, 80), rng.uniform(80, 98), 0, 4) | _thumb(rng, 22, -12, 40)


def _pinch(rng: Generator) -> Angles:
    fingers = _fingers(rng, rng.uniform(10, 60), rng.uniform(10, 60), 4, 6)
    index = {"index_mcp_flexion": rng.uniform(40, 58), "index_pip_flexion": rng.uniform(35, 55)}
    return fingers | index | _thumb(rng, 12, -10, 25)


def _point(rng: Generator) -> Angles:
    fist = _fist(rng)
    index = {"index_mcp_flexion": rng.uniform(-5, 20), "index_pip_flexion": rng.uniform(0, 15)}
    if rng.random() < 0.4:
        index |= {k.replace("index", "middle"): v + rng.normal(0, 4) for k, v in index.items()}
    return fist | index


def _grip(rng: Generator) -> Angles:
    close = rng.uniform(0, 1)
    fingers = _fingers(rng, 15 + 35 * close, 25 + 35 * close, 8 * (1 - close), 5)
    return fingers | _thumb(rng, 5 + 15 * close, -8, 10 + 20 * close)
