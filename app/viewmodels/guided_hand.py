"""The hand that demonstrates poses, and its movement from one pose to the next.

Uses the wearer's hand file, so that a left hand is shown for a left glove.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array
from tracker.simulation.postures import posture
from tracker.simulation.smooth import minimum_jerk

MOVE = 0.9  # s from one pose to the next
REST = 0.35  # s for which the hand is relaxed before the movement is repeated
AGAIN = 4.0  # s after which the movement is repeated
Degrees = dict[str, float]


class Shown(NamedTuple):
    """Segments R (S, 3, 3), p (S, 3) m of the drawn hand, its centre p_middle (3,) m; ``eye`` (3,)
    the direction from there to the viewer."""

    R: Array
    p: Array
    p_middle: Array
    eye: Array


def _fingers(mcp: float, pip: float, splay: float = 0.0, but: str = "") -> Degrees:
    out: Degrees = {}
    for finger, share in zip(FINGERS, (1.0, 0.15, -0.65, -1.2), strict=True):
        if finger != but:
            out |= {
                f"{finger}_mcp_flexion": mcp,
                f"{finger}_mcp_abduction": share * splay,
                f"{finger}_pip_flexion": pip,
            }
    return out


def _thumb(flexion: float, abduction: float, twist: float, mcp: float) -> Degrees:
    return {
        "thumb_cmc_flexion": flexion,
        "thumb_cmc_abduction": abduction,
        "thumb_cmc_twist": twist,
        "thumb_mcp_flexion": mcp,
    }


def _pinch(finger: str, mcp: float, abduction: float, pip: float) -> Degrees:
    bent = {
        f"{finger}_mcp_flexion": mcp,
        f"{finger}_mcp_abduction": abduction,
        f"{finger}_pip_flexion": pip,
    }
    return _fingers(12, 18, but=finger) | bent


RELAXED = _fingers(20, 25, 4) | _thumb(5, 0, 0, 10)
DRAWN: dict[str, Degrees] = {
    "flat": _fingers(0, 0) | _thumb(-8, 0, 0, 0),
    "spread": _fingers(0, 0, 13) | _thumb(-20, 15, 0, 0),
    "fist": _fingers(80, 95) | _thumb(24, -14, 5, 45),
    "thumb_up": _fingers(80, 95) | _thumb(-35, 15, 0, 0),
    "pinch_index": _pinch("index", 14, -2, 66) | _thumb(33, -25, 23, -10),
    "pinch_middle": _pinch("middle", 11, 0, 75) | _thumb(40, -35, 32, -3),
    "pinch_ring": _pinch("ring", 59, -1, 104) | _thumb(22, -35, -22, 54),
    "pinch_little": _pinch("little", 18, 22, 82) | _thumb(40, -35, -30, 31),
    "grip": _fingers(35, 45) | _thumb(12, -8, 0, 20),
    "turn": _fingers(0, 0) | _thumb(-8, 0, 0, 0),
}
"""Joint angles in degrees of a right hand whose fingertips meet at the nominal size."""
TURNING = 70.0
"""Degrees by which the forearm turns to either side in the continuous pose ``turn``."""
TURN_PERIOD = 3.0  # s

BACK, THUMB_SIDE, PALM = (-0.55, 0.25, 0.8), (0.25, 0.9, 0.25), (0.45, 0.75, -0.35)
"""Viewing directions of a right hand: x along the fingers, y to the thumb, z out of the back."""
EYES = {"flat": BACK, "spread": BACK, "fist": THUMB_SIDE, "thumb_up": THUMB_SIDE}
ROLLED = {"fist": 90.0, "thumb_up": 90.0}
"""Degrees by which a right hand is turned about the forearm, thumb up."""


class DrawnHand:
    """Poses of one hand file."""

    def __init__(self, hand: HandModel) -> None:
        self._hand = hand
        self._relaxed = posture(hand, RELAXED)
        self._angles = {name: posture(hand, degrees) for name, degrees in DRAWN.items()}

    def angles(self, pose: str) -> Array:
        """(J,) rad."""
        return self._angles[pose]

    def shown(self, before: str, pose: str, since: float, again: bool = False) -> Shown:
        """The hand ``since`` s after ``pose`` was requested, moving from ``before`` (empty: from
        rest); ``again``: the movement is repeated."""
        start = self._angles[before] if before else self._relaxed
        eye_before, roll = self._eye(before or pose), self._roll(before or pose)
        if again and since > AGAIN:
            start, since = self._relaxed, (since - AGAIN) % AGAIN - REST
            eye_before, roll = self._eye(pose), self._roll(pose)
        share = float(minimum_jerk(np.array([since / MOVE]))[0])
        angles = start + share * (self._angles[pose] - start)
        roll += share * (self._roll(pose) - roll)
        if pose == "turn":
            roll += np.deg2rad(TURNING) * np.sin(2 * np.pi * max(since - MOVE, 0.0) / TURN_PERIOD)
        R, p = self._hand.forward(angles, so3.rx(roll), np.zeros(3))
        eye = eye_before + share * (self._eye(pose) - eye_before)
        middle = np.array([0.48 * self._hand.length, 0.0, -0.01])
        return Shown(R, p, middle, eye)

    @property
    def _side(self) -> float:
        """Sign of mirrored quantities."""
        return -1.0 if self._hand.side == "left" else 1.0

    def _eye(self, pose: str) -> Array:
        return np.array(EYES.get(pose, PALM)) * [1.0, self._side, 1.0]

    def _roll(self, pose: str) -> float:
        """Roll angle, rad."""
        return float(np.deg2rad(self._side * ROLLED.get(pose, 0.0)))

    def distance(self) -> float:
        """Distance of the viewer at which the hand fills the view, m."""
        return 2.1 * self._hand.length
