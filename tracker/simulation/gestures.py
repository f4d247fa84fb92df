"""A wearer who performs scripted gestures: open, fist, grips, pinches and wrist rotations."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, CameraPose
from tracker.simulation.motion import Poses, Still, pose_at
from tracker.simulation.postures import posture
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for
from tracker.simulation.wearer import Wearer

MOVE = 0.8  # s from one gesture to the next
TOUCH = 0.010  # m between the tips of a pinch: the fingers' thickness
APART = 0.015  # m by which other tips must be farther away
CLEAR = 0.030  # m, likewise for an inferred finger, which may be off by a centimetre
TURN = np.deg2rad(60.0)  # of the wrist, to either side
SWAY_ANGLE, SWAY = np.deg2rad(0.8), 0.002  # rad and m, of a hand that holds still

OPEN: dict[str, float] = {
    f"{f}_mcp_abduction": a for f, a in zip(FINGERS, (5, 1, -3, -6), strict=True)
}
FIST: dict[str, float] = {
    **{f"{f}_mcp_flexion": 75.0 for f in FINGERS},
    **{f"{f}_pip_flexion": 95.0 for f in FINGERS},
    "thumb_cmc_flexion": 22.0,
    "thumb_cmc_abduction": -12.0,
    "thumb_mcp_flexion": 40.0,
}
GRIP: dict[str, float] = {
    **{f"{f}_mcp_flexion": 35.0 for f in FINGERS},
    **{f"{f}_pip_flexion": 45.0 for f in FINGERS},
    "thumb_cmc_flexion": 12.0,
    "thumb_cmc_abduction": -8.0,
    "thumb_mcp_flexion": 20.0,
}


class GestureCue(NamedTuple):
    """A gesture that is held for ``hold`` s, starting ``before`` s after the previous one."""

    gesture: str
    before: float
    hold: float


class Gestures:
    """The cues one after another, by a hand in front of a camera.

    A gesture is open, fist, grip, turn or ``pinch_`` and a finger. Fingers without sensors follow
    their synergies. The rotation alternates between both sides.
    """

    follows_synergies = True

    def __init__(
        self,
        hand: HandModel,
        cues: Sequence[GestureCue],
        seed: int,
        camera: CameraPose | None = None,
        wearer: Wearer | None = None,
    ) -> None:
        """``wearer``: whose fingertips meet in a pinch, if not those of the hand file."""
        self._hand, self._wearer, self.cues = hand, wearer, tuple(cues)
        ends = list(accumulate(c.before + c.hold for c in cues))
        self.starts = [end - c.hold for c, end in zip(cues, ends, strict=True)]
        self.duration = ends[-1] + MOVE
        self._angles = np.array([self._posture("open"), *(self._posture(c.gesture) for c in cues)])
        still = RandomPostures(hand, seed, duration=3.0, camera=camera)
        _, self._R, self._p = pose_at(still, 0.0)
        self._sway = SmoothNoise(rng_for(seed, "gestures"), (6,), 0.7)

    def poses(self, t: Array) -> Poses:
        """The hand at t (n,) s."""
        angles = np.tile(self._angles[0], (len(t), 1))
        roll = np.zeros(len(t))
        for k, (cue, start) in enumerate(zip(self.cues, self.starts, strict=True)):
            share = minimum_jerk((t - start) / MOVE + 1)
            angles += share[:, None] * (self._angles[k + 1] - self._angles[k])
            if cue.gesture == "turn":
                roll += TURN * _turning(t - start, cue.hold)
        sway = self._sway(t)
        turned = so3.exp(np.outer(roll, [1.0, 0.0, 0.0]) + SWAY_ANGLE * sway[:, :3])
        centre = np.array([self._hand.length / 2, 0.0, 0.0])
        R = self._R @ turned
        p = self._p + self._R @ centre - R @ centre + SWAY * sway[:, 3:]
        return Poses(angles, R, p)

    def _posture(self, gesture: str) -> Array:
        return self._known[gesture] if gesture in self._known else posture(self._hand, OPEN)

    @cached_property
    def _known(self) -> dict[str, Array]:
        wanted = sorted({c.gesture for c in self.cues})
        return {name: gesture_angles(self._hand, name, self._wearer) for name in wanted}


def gesture_angles(
    hand: HandModel, gesture: str, wearer: Wearer | None = None, alone: bool = False
) -> Array:
    """(J,) rad of a gesture: fist, grip, ``pinch_`` and a finger, else the open hand; ``alone`` as
    for `pinch`."""
    if gesture.startswith("pinch_"):
        return pinch(hand, gesture.removeprefix("pinch_"), wearer, alone)
    return posture(hand, {"fist": FIST, "grip": GRIP}.get(gesture, OPEN))


def _turning(t: Array, hold: float) -> Array:
    """Rotation to one side before t = 0, to the other and back within ``hold`` s, then upright
    again."""
    inside = np.cos(2 * np.pi * np.clip(t / hold, 0, 1))
    return minimum_jerk(t / MOVE + 1) * inside * (1 - minimum_jerk((t - hold) / MOVE))


def pinch(hand: HandModel, finger: str, wearer: Wearer | None = None, alone: bool = False) -> Array:
    """(J,) rad as defined in the hand file: the thumb's tip at the tip of ``finger``, the other
    tips farther away.

    Middle, ring and little finger bend together, by their synergies, unless the finger bends
    ``alone``. The other tips are farther away in the hand of the file, too: unsensed joints are
    inferred from it, so the wearer's pinch must be equally clear.
    """
    from scipy.optimize import minimize  # deferred: slow to load

    moved = [
        n for n in hand.joint_names if n.startswith("thumb_") and n not in _driven_angles(hand)
    ]
    group = (finger,) if alone or finger == "index" else FINGERS[1:]
    others = posture(hand, OPEN if alone else {})
    free = np.array([alone and n.split("_")[1] in ("cmc", "mcp", "pip") for n in hand.joint_names])
    bent = [f"{group[0]}_{joint}_flexion" for joint in ("mcp", "pip")]
    rows = [hand.angle_index[n] for n in (*moved, *bent)]
    limits = hand.angle_limits[rows]
    clear = CLEAR if finger == "little" else APART
    start = np.clip(np.deg2rad([10.0] * len(moved) + [45.0, 45.0]), *limits.T)

    def angles_of(x: Array) -> Array:
        given = dict(zip((*moved, *bent), x, strict=True))
        out, known = others.copy(), free.copy()
        for name, value in given.items():
            for one in (name.replace(group[0], f) for f in group) if name in bent else (name,):
                out[hand.angle_index[one]], known[hand.angle_index[one]] = value, True
        return hand.apply_synergies(out, np.asarray(known | ~_is_synergy(hand), float))[0]

    def cost(x: Array) -> float:
        angles = angles_of(x)
        reach = tip_distances(hand, angles, wearer)
        seen = reach if wearer is None else tip_distances(hand, angles)
        other = _too_near(reach, finger, APART) + _too_near(seen, finger, clear)
        miss = (reach[finger] - TOUCH) ** 2
        return float(1e4 * (miss + other) + 1e-3 * np.sum((x - start) ** 2))

    return angles_of(minimize(cost, start, bounds=limits, options={"maxiter": 40}).x)


def _too_near(reach: dict[str, float], finger: str, apart: float) -> float:
    """m²: squared shortfall of the other tips' distances, which should exceed that of ``finger`` by
    ``apart`` m."""
    others = (d for name, d in reach.items() if name != finger)
    return sum(max(reach[finger] + apart - d, 0.0) ** 2 for d in others)


def tip_distances(hand: HandModel, angles: Array, wearer: Wearer | None = None) -> dict[str, float]:
    """m from the thumb's tip to each finger's, for a wearer or for the hand file."""
    if wearer is None:
        points = hand.keypoints(*hand.forward(angles, np.eye(3), np.zeros(3)))
    else:
        R_GB, p_GB, _ = wearer.segments(Still(angles, np.eye(3), np.zeros(3)), np.zeros(1))
        points = wearer.keypoints(R_GB[0], p_GB[0])
    tip = {f: points[hand.keypoint_names.index(f"{f}_tip")] for f in ("thumb", *FINGERS)}
    return {f: float(np.linalg.norm(tip[f] - tip["thumb"])) for f in FINGERS}


def _driven_angles(hand: HandModel) -> set[str]:
    """The angles that are set directly, without synergies."""
    return {s.angle for s in hand.synergies}


def _is_synergy(hand: HandModel) -> NDArray[np.bool_]:
    """(J,) bool: angles computed by a synergy."""
    return np.array([n in _driven_angles(hand) for n in hand.joint_names])
