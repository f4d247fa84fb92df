"""A scripted hand that moves between keys, each with a position, an orientation and a gesture."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array
from tracker.simulation.gestures import FIST, OPEN, pinch
from tracker.simulation.motion import Poses
from tracker.simulation.postures import posture
from tracker.simulation.shows import Key, show_keys
from tracker.simulation.smooth import minimum_jerk
from tracker.simulation.wearer import Wearer

PAUSE = 1.5  # s from the end of a show to its restart
PALM = 0.625  # of the distance from the wrist to the knuckles: the centre of the palm
RELAXED = {f"{f}_{joint}_flexion": 32.0 for f in FINGERS for joint in ("mcp", "pip")}
THUMB_UP = {
    **{f"{f}_mcp_flexion": 80.0 for f in FINGERS},
    **{f"{f}_pip_flexion": 95.0 for f in FINGERS},
    "thumb_cmc_flexion": -15.0,
    "thumb_cmc_abduction": 10.0,
}
POINT = {
    **{name: angle for name, angle in FIST.items() if not name.startswith("index")},
    "index_mcp_flexion": 5.0,
    "index_pip_flexion": 5.0,
}
GRASP = {
    **{f"{f}_mcp_flexion": 35.0 for f in FINGERS},
    **{f"{f}_pip_flexion": 45.0 for f in FINGERS},
    "thumb_mcp_flexion": 10.0,
}
POSTURES = {
    "relaxed": RELAXED,
    "open_palm": OPEN,
    "fist": FIST,
    "grasp": GRASP,
    "thumb_up": THUMB_UP,
    "point": POINT,
}


class ScriptedHand:
    """Minimum-jerk moves (Flash & Hogan 1985) between successive keys; two equal keys hold."""

    follows_synergies = True

    def __init__(self, hand: HandModel, keys: Sequence[Key], wearer: Wearer | None = None) -> None:
        """``wearer``: whose fingertips meet in a pinch, if not those of the hand file."""
        self.duration = keys[-1].t + 0.5
        self._t = np.array([k.t for k in keys])
        shapes = {k.gesture for k in keys}
        known = {name: _angles(hand, name, wearer) for name in shapes}
        self._angles = np.array([known[k.gesture] for k in keys])
        self._R = so3.exp(np.deg2rad([k.turn for k in keys]))
        self._palm = np.array([k.palm for k in keys], float)
        self._middle = np.array([PALM * hand.segments[hand.root].length, 0.0, 0.0])
        self._turn = so3.log(np.swapaxes(self._R[:-1], 1, 2) @ self._R[1:]).reshape(-1, 3)

    def poses(self, t: Array) -> Poses:
        t = np.clip(np.asarray(t, float), self._t[0], self._t[-1])
        k = np.clip(np.searchsorted(self._t, t, side="right") - 1, 0, len(self._t) - 2)
        length = self._t[k + 1] - self._t[k]
        share = minimum_jerk((t - self._t[k]) / length)[:, None]
        angles = self._angles[k] + share * (self._angles[k + 1] - self._angles[k])
        R = self._R[k] @ so3.exp(share * self._turn[k])
        palm = self._palm[k] + share * (self._palm[k + 1] - self._palm[k])
        return Poses(angles, R, palm - R @ self._middle)


def _angles(hand: HandModel, gesture: str, wearer: Wearer | None) -> Array:
    if gesture.startswith("pinch_"):
        return pinch(hand, gesture.removeprefix("pinch_"), wearer)
    return posture(hand, POSTURES[gesture])


def show(
    name: str, hand: HandModel, wearer: Wearer | None = None, least: float = 0.0
) -> ScriptedHand:
    """A wearer who uses an application, by `show_keys`; repeated for ``least`` s.

    Raises ConfigError for an unknown name.
    """
    keys, once = [], show_keys(name)
    again = once[-1].t + PAUSE
    for k in range(max(1, math.ceil(least / again))):
        keys += [key._replace(t=key.t + k * again) for key in once]
    return ScriptedHand(hand, keys, wearer)
