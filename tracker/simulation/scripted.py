"""A hand that does what it is told: from key to key, each a place, a turn and a gesture."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tracker.errors import ConfigError
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array
from tracker.simulation.gestures import FIST, OPEN, pinch
from tracker.simulation.motion import Poses
from tracker.simulation.postures import posture
from tracker.simulation.smooth import minimum_jerk
from tracker.simulation.wearer import Wearer

PAUSE = 1.5  # s from the end of a show to its beginning
PALM = 0.625  # of the way from the wrist to the knuckles: the palm's middle
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


WORD = "show:"
"""Before the name of an application, in place of a file of recorded motion."""


class Key(NamedTuple):
    """At ``t`` s the hand shows ``gesture`` with its palm's middle at ``palm`` m in G, turned from
    palm down, fingers along x, by the rotation vector ``turn`` in degrees about G's axes."""

    t: float
    gesture: str
    palm: tuple[float, float, float]
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)


class ScriptedHand:
    """Minimum-jerk moves (Flash & Hogan 1985) from each key to the next; two equal keys hold."""

    follows_synergies = True

    def __init__(self, hand: HandModel, keys: Sequence[Key], wearer: Wearer | None = None) -> None:
        """``wearer``: whose fingers meet in a pinch, where that is not the hand of the file."""
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
    """A wearer who uses an application: `WORD` and its name; again and again for ``least`` s.

    Raises ConfigError for no such one.
    """
    keys, once = [], show_keys(name)
    again = once[-1].t + PAUSE
    for k in range(max(1, math.ceil(least / again))):
        keys += [key._replace(t=key.t + k * again) for key in once]
    return ScriptedHand(hand, keys, wearer)


def show_keys(name: str) -> list[Key]:
    """The keys of a `show`."""
    known = name.removeprefix(WORD)
    if known not in SHOWS:
        raise ConfigError(f"There is no show {name!r}; there are {', '.join(SHOWS)}.")
    keys, t = [], 0.0
    for seconds, gesture, palm, turn in SHOWS[known]:
        t += seconds
        keys.append(Key(t, gesture, palm, turn))
    return keys


_FLAT, _EDGE, _TURNED = (0.0, 0.0, 0.0), (90.0, 0.0, 0.0), (0.0, 0.0, 35.0)
_HOME = (0.15, 0.0, 0.12)
SHOWS: dict[
    str, list[tuple[float, str, tuple[float, float, float], tuple[float, float, float]]]
] = {
    "touch": [
        (0.0, "open_palm", _HOME, _FLAT),
        (1.5, "open_palm", _HOME, _FLAT),
        (1.5, "open_palm", (0.15, 0.0, 0.07), _FLAT),
        (0.8, "open_palm", (0.17, 0.03, 0.07), _FLAT),
        (0.8, "open_palm", (0.17, -0.03, 0.07), _FLAT),
        (1.0, "point", (0.15, 0.0, 0.12), _FLAT),
        (1.0, "point", (0.18, 0.0, 0.08), _FLAT),
        (1.0, "open_palm", _HOME, _FLAT),
    ],
    "arm": [
        (0.0, "relaxed", _HOME, _FLAT),
        (1.5, "relaxed", _HOME, _FLAT),
        (0.6, "grasp", _HOME, _FLAT),
        (1.5, "grasp", (0.18, 0.0, -0.01), _FLAT),
        (0.4, "grasp", (0.18, 0.0, -0.01), _FLAT),
        (0.4, "pinch_index", (0.18, 0.0, -0.01), _FLAT),
        (0.8, "pinch_index", (0.18, 0.0, -0.01), _FLAT),
        (1.2, "pinch_index", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "open_palm", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "open_palm", (0.16, 0.03, 0.09), _FLAT),
        (0.6, "thumb_up", (0.16, 0.03, 0.09), _FLAT),
        (0.8, "thumb_up", (0.16, 0.03, 0.09), _FLAT),
    ],
    "swarm": [
        (0.0, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (1.5, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (0.8, "point", (0.10, 0.0, 0.12), _FLAT),
        (1.0, "point", (0.15, 0.0, 0.12), _FLAT),
        (0.8, "relaxed", (0.22, 0.0, 0.20), _FLAT),
        (0.5, "pinch_index", (0.22, -0.02, 0.20), _FLAT),
        (1.0, "pinch_index", (0.18, 0.06, 0.18), _FLAT),
        (0.6, "relaxed", (0.12, 0.0, 0.22), _FLAT),
        (0.6, "open_palm", (0.20, 0.03, 0.24), _EDGE),
        (1.2, "open_palm", (0.20, 0.03, 0.02), _EDGE),
        (0.6, "relaxed", (0.12, 0.0, 0.12), _FLAT),
        (0.8, "thumb_up", (0.12, 0.0, 0.12), _FLAT),
        (0.6, "fist", (0.12, 0.0, 0.12), _FLAT),
        (0.6, "fist", (0.12, 0.0, 0.12), _FLAT),
    ],
    "place": [
        (0.0, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (1.5, "relaxed", (0.10, 0.0, 0.12), _FLAT),
        (0.6, "point", (0.08, -0.0935, 0.16), _FLAT),
        (1.5, "point", (0.08, -0.0935, 0.16), _FLAT),
        (0.8, "relaxed", (0.24, -0.03, 0.14), _FLAT),
        (0.5, "grasp", (0.24, -0.03, 0.14), _FLAT),
        (1.2, "grasp", (0.20, 0.02, 0.14), _TURNED),
        (0.5, "relaxed", (0.20, 0.02, 0.14), _TURNED),
        (0.5, "pinch_index", (0.20, 0.02, 0.14), _FLAT),
        (1.0, "pinch_index", (0.20, -0.04, 0.14), _FLAT),
        (0.6, "open_palm", (0.12, 0.0, 0.14), _FLAT),
        (1.2, "open_palm", (0.12, 0.0, 0.14), _FLAT),
    ],
}
"""Seconds since the key before, gesture, palm and turn of each key, by application."""
