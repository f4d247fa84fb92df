"""Things held and worn in the paper's second and third experiments, as solids that hide markers."""

from __future__ import annotations

import numpy as np

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import NOBODY, Solids, boxes, capsules, together

GREY_BGR = np.array([120.0, 120.0, 118.0])

# Eight things of daily life, m: ("box", half edges) or ("capsule", length, radius).
OBJECTS: tuple[tuple[str, tuple[float, ...]], ...] = (
    ("capsule", (0.10, 0.033)),  # can
    ("capsule", (0.18, 0.032)),  # bottle
    ("box", (0.075, 0.036, 0.004)),  # telephone
    ("capsule", (0.02, 0.037)),  # apple
    ("box", (0.11, 0.075, 0.012)),  # book
    ("capsule", (0.13, 0.005)),  # pen
    ("box", (0.055, 0.030, 0.020)),  # computer mouse
    ("capsule", (0.08, 0.040)),  # cup
)
EACH_HELD = 40.0  # s: three objects in a trial of two minutes
TIPS = ("thumb_distal", "index_distal", "middle_distal")


class HeldObject:
    """One of eight things in the palm, three in a trial, each turned at random in the grip."""

    def __init__(self, hand: HandModel, seed: int) -> None:
        rng = rng_for(seed, "held object")
        self._choice = rng.choice(len(OBJECTS), 3, replace=False)
        self._turn = so3.exp(rng.normal(0, 0.35, (3, 3)))
        self._root = hand.index["dorsum"]
        self._reach = 0.85 * hand.segments[self._root].length

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """The thing in hand at ``t``, below the palm and across the fingers' roots."""
        k = int(t // EACH_HELD) % len(self._choice)
        kind, size = OBJECTS[self._choice[k]]
        thick = size[2] if kind == "box" else size[1]
        centre_B = np.array([self._reach, 0.0, -0.016 - thick])
        R = R_GB[self._root] @ self._turn[k]
        centre = p_GB[self._root] + R_GB[self._root] @ centre_B
        if kind == "box":
            return boxes(R[None], centre[None], np.array([size]), np.array([NOBODY]), GREY_BGR)
        half = R[:, 1] * size[0] / 2  # the axis lies across the palm
        return capsules(
            (centre - half)[None],
            (centre + half)[None],
            np.array([size[1]]),
            np.array([NOBODY]),
            GREY_BGR,
        )

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        """Nothing of a marker's hue."""
        return np.zeros((0, 3)), np.zeros(0), ()


class Device:
    """A cutaneous haptic device on three fingertips: a box around each distal phalanx."""

    def __init__(self, hand: HandModel) -> None:
        self._rows = [hand.index[s] for s in TIPS if s in hand.index]
        self._length = np.array([hand.segments[i].length for i in self._rows])

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """Boxes with the motors above the nail."""
        half = np.column_stack(
            [0.5 * self._length, np.full(len(self._rows), 0.013), np.full(len(self._rows), 0.016)]
        )
        middle_B = np.column_stack(
            [0.55 * self._length, 0 * self._length, 0 * self._length + 0.004]
        )
        R = R_GB[self._rows]
        centre = p_GB[self._rows] + np.einsum("nij,nj->ni", R, middle_B)
        return together([boxes(R, centre, half, np.full(len(self._rows), NOBODY), GREY_BGR)])

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        """Nothing of a marker's hue."""
        return np.zeros((0, 3)), np.zeros(0), ()
