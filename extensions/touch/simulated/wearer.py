"""A wearer who carries out the cues: the pulp of the finger rests on the cross that was asked for.

The contact is where the round end of the finger meets the paper, so it rolls with the finger's
inclination; each person's pulp differs, gives way, and misses the middle of the cross.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from extensions.touch.protocol import FINGERS, Cued, TouchCue, began, ended
from extensions.touch.sheet import BY_NAME
from extensions.touch.simulated.images import SheetPlace
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, Event
from tracker.simulation.motion import Poses, SimulatedMotion
from tracker.simulation.postures import posture
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for
from tracker.simulation.solids import UNOWNED, Solids, capsules
from tracker.simulation.wearer import Wearer

HOVER = np.array([0.0, 0.0, 0.045])  # m in G above a target, between touches
OUT = np.array([-0.45, 0.0, 0.05])  # m in G, out of view
REST, MARGIN = 0.55, 0.2  # s of a touch; from the end of a touch to that of its cue
APPROACH = {"slow": 0.7, "fast": 0.35}  # s from above the cross to contact
TRANSIT = 0.65  # s from one cross to above the next
AWAY = 5.0  # s out of view
TURN_DEG = {"turned_left": 35.0, "turned_right": -35.0}
COVER_RADIUS, COVER_ABOVE = 0.013, 0.045  # m, a finger of the other hand over the dorsum


@dataclass(frozen=True)
class PulpParams:
    """Standard deviations over people or touches, m, unless another word is used."""

    place: float = 0.0004  # of the contact in the finger, each axis, over people
    flattened: float = 0.0007  # mean by which the pulp gives way
    flattened_sd: float = 0.0003
    aim: float = 0.0006  # of the contact from the cross, along and across, over touches
    pitch_deg: float = 7.0  # of the inclination of the last segment, over touches
    roll_deg: float = 6.0
    tremor: float = 0.00015


@dataclass(frozen=True, eq=False)
class _Key:
    """One touch; times s."""

    cue: TouchCue
    on: Touching
    leave: float  # the previous cross
    above: float
    down: float
    up: float


@dataclass(frozen=True, eq=False)
class _Given:
    """Poses at instants that are known already: a `SimulatedMotion` for one call of a wearer."""

    given: Poses
    duration: float = 0.0
    follows_synergies: bool = True

    def poses(self, t: Array) -> Poses:
        return self.given


@dataclass(frozen=True, eq=False)
class Touching:
    """The hand on a cross: posture (J,) rad, R_GB, and the contact (3,) m in G."""

    angles: Array
    R_GB: Array
    contact: Array


class Touches:
    """How one wearer touches: own pulps, and an inclination and a miss that are drawn for each
    touch. ``rng`` is used for all of it."""

    def __init__(
        self, wearer: Wearer, sheet: SheetPlace, rng: np.random.Generator, params: PulpParams
    ) -> None:
        self.wearer, self.sheet, self.params, self._rng = wearer, sheet, params, rng
        self._draw_pulps()

    def _draw_pulps(self) -> None:
        p, w, rng = self.params, self.wearer, self._rng
        rows = [w.hand.index[f"{f}_distal"] for f in FINGERS]
        self._row = dict(zip(FINGERS, rows, strict=True))
        self._centre: dict[str, Array] = {}
        self._radius: dict[str, float] = {}
        for finger, row in self._row.items():
            radius = w.hand.segments[row].radius * w.scale[row, 2]
            length = w.hand.segments[row].length * w.scale[row, 0]
            own = rng.normal(0, p.place, 3)
            self._centre[finger] = np.array([length - radius, 0.0, 0.0]) + own
            self._radius[finger] = radius - abs(rng.normal(p.flattened, p.flattened_sd))

    def touch(self, cue: TouchCue) -> Touching:
        """A touch of the cross that ``cue`` asks for."""
        miss = np.append(self._rng.normal(0, self.params.aim, 2), 0.0)
        contact = self.sheet.target(BY_NAME[cue.target].p_S) + self.sheet.R_GS @ miss
        angles, R_GB = self._reach(cue)
        return Touching(angles, R_GB, contact)

    def root(self, finger: str, t: Array, angles: Array, R: Array, contact: Array) -> Array:
        """(n, 3) m: where the dorsum is while the pulp's lowest point is at ``contact`` (n, 3)."""
        return contact - self._contact(finger, t, angles, R, np.zeros((len(t), 3)))

    def _reach(self, cue: TouchCue) -> tuple[Array, Array]:
        """Posture (J,) and R_GB of the hand that has the pulp of the finger on the paper."""
        rng, p, hand = self._rng, self.params, self.wearer.hand
        angles = posture(hand, _POSTURE[cue.finger])
        R_0 = hand.forward(angles, np.eye(3), np.zeros(3))[0][self._row[cue.finger]]
        pitch_deg, yaw_deg, roll_deg = _INCLINED[cue.finger]
        side = -1.0 if hand.side == "left" else 1.0
        pitch_deg += rng.normal(0, p.pitch_deg)
        yaw_deg = side * yaw_deg + TURN_DEG.get(cue.how, 0.0) + rng.normal(0, 5.0)
        roll_deg = side * roll_deg + rng.normal(0, p.roll_deg)
        yaw, pitch, roll = np.deg2rad([yaw_deg, pitch_deg, roll_deg])
        R_GD = so3.rz(yaw) @ so3.ry(pitch) @ so3.rx(roll)
        return angles, R_GD @ R_0.T

    def _contact(self, finger: str, t: Array, angles: Array, R: Array, p: Array) -> Array:
        """(n, 3) m in G of the lowest point of the pulp."""
        given = _Given(Poses(angles, np.broadcast_to(R, (len(t), 3, 3)), p))
        R_GB, p_GB, _ = self.wearer.segments(given, t)
        row = self._row[finger]
        centre = p_GB[:, row] + R_GB[:, row] @ self._centre[finger]
        return centre + self._radius[finger] * self.sheet.R_GS[:, 2]


class TouchMotion:
    """Moves freely for ``lead`` s as ``before``, then carries out the touches."""

    follows_synergies = True

    def __init__(
        self,
        wearer: Wearer,
        sheet: SheetPlace,
        cues: Sequence[TouchCue],
        before: SimulatedMotion,
        seed: int,
        params: PulpParams | None = None,
    ) -> None:
        self.params = params or PulpParams()
        self._before, self._lead = before, before.duration
        self._rng = rng_for(seed, "touches")
        hand = wearer.hand
        self._sway = SmoothNoise(self._rng, (len(hand.joint_names) + 6,), 0.7)
        self._touches = Touches(wearer, sheet, self._rng, self.params)
        self.cued: list[Cued] = []
        self._keys: list[_Key] = []
        t = self._lead + 0.5
        for cue in cues:
            t = self._add(cue, t)
        self.duration = t + 1.0

    @property
    def events(self) -> list[Event]:
        """The cues as the window records them, in order of time."""
        out: list[Event] = []
        for c in self.cued:
            out += [began(c.cue, c.begin), ended(c.cue, c.end)]
        return out

    def _add(self, cue: TouchCue, t: float) -> float:
        """Append the touch of ``cue``, asked for at ``t``; returns its end."""
        leave = t + self._rng.uniform(0.15, 0.4)
        gone = AWAY + 1.6 if cue.how == "away" else 0.0
        above = leave + TRANSIT + gone
        down = above + APPROACH["fast" if cue.how == "fast" else "slow"]
        up = down + REST
        on = self._touches.touch(cue)
        self._keys.append(_Key(cue, on, leave, above, down, up))
        self.cued.append(Cued(cue, t, up + MARGIN))
        return up + MARGIN

    def poses(self, t: Array) -> Poses:
        """For each instant: between two touches the hand goes from one posture to the next."""
        t = np.asarray(t, float)
        k = np.clip(np.searchsorted([q.leave for q in self._keys], t, side="right") - 1, 0, None)
        before = self._before.poses(np.minimum(t, self._lead))
        angles, R, p = before.angles.copy(), before.R_GB.copy(), before.p_GB.copy()
        for n in np.unique(k):
            now = (k == n) & (t >= self._keys[0].leave)
            if np.any(now):
                angles[now], R[now], p[now] = self._near(int(n), t[now], now, before)
        return Poses(angles, R, p)

    def _near(self, n: int, t: Array, now: Array, before: Poses) -> Poses:
        """From leaving the touch before number ``n`` until leaving number ``n``."""
        key = self._keys[n]
        last = self._keys[n - 1] if n else None
        share = minimum_jerk((t - key.leave) / (key.above - key.leave))[:, None]
        if last is None:
            angles_0, R_0 = before.angles[now], before.R_GB[now]
        else:
            angles_0, R_0 = last.on.angles[None], last.on.R_GB[None]
        sway = self._sway(t)
        angles = angles_0 + share * (key.on.angles - angles_0) + np.deg2rad(0.6) * sway[:, :-6]
        turn = so3.log(np.swapaxes(R_0, 1, 2) @ key.on.R_GB)
        R = R_0 @ so3.exp(share * turn + np.deg2rad(0.5) * sway[:, -6:-3])
        p = self._root(key, t, angles, R, sway[:, -3:])
        if last is None:
            fade = minimum_jerk((t - key.leave) / 0.3)[:, None]
            angles = angles_0 + fade * (angles - angles_0)
            p_0 = before.p_GB[now]
        else:
            p_0 = self._root(last, t, angles, R, sway[:, -3:])
        p = p_0 + share * (p - p_0)
        if key.cue.how == "away":
            p = p + self._out(key, t) * OUT
        return Poses(angles, R, p)

    def _out(self, key: _Key, t: Array) -> Array:
        """(n, 1) share of the way out of view."""
        going = minimum_jerk((t - key.leave - 0.2) / 0.8)
        coming = minimum_jerk((t - key.above + 0.8) / 0.8)
        return (going * (1 - coming))[:, None]

    def _root(self, key: _Key, t: Array, angles: Array, R: Array, tremor: Array) -> Array:
        """(n, 3) m: where the dorsum is when the contact of ``key`` follows its path."""
        low = minimum_jerk((t - key.above) / (key.down - key.above))
        high = minimum_jerk((t - key.up) / 0.35)
        path = key.on.contact + (1 - low * (1 - high))[:, None] * HOVER
        path = path + self.params.tremor * tremor
        return self._touches.root(key.cue.finger, t, angles, R, path)


class OtherHandFinger:
    """A finger of the other hand, an `Extra`: hides markers of the dorsum during some touches."""

    def __init__(self, hand: HandModel, cued: Sequence[Cued]) -> None:
        self._root = hand.root
        self._spans = [(c.begin, c.end) for c in cued if c.cue.how == "covered"]

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        if not any(begin <= t <= end for begin, end in self._spans):
            none = np.zeros((0, 3))
            return capsules(none, none, np.zeros(0), np.zeros(0, np.int64), np.zeros(3))
        R, p = R_GB[self._root], p_GB[self._root]
        ends = [p + R @ np.array([0.05, y, COVER_ABOVE]) for y in (-0.08, 0.015)]
        owner, radius = np.array([UNOWNED]), np.array([COVER_RADIUS])
        return capsules(ends[0][None], ends[1][None], radius, owner, np.array([120.0, 150, 200]))

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return np.zeros((0, 3)), np.zeros(0), ()


_CURLED = {
    f"{f}_{joint}_flexion": value
    for f in ("index", "middle", "ring", "little")
    for joint, value in (("mcp", 50.0), ("pip", 100.0))
}
_POSTURE = {
    "thumb": {
        **{name: -8.0 if "mcp" in name else 8.0 for name in _CURLED},
        "thumb_cmc_flexion": 30.0,
        "thumb_cmc_abduction": -20.0,
        "thumb_mcp_flexion": 30.0,
    },
    "index": {**_CURLED, "index_mcp_flexion": 8.0, "index_pip_flexion": 12.0},
    "middle": {**_CURLED, "middle_mcp_flexion": 8.0, "middle_pip_flexion": 12.0},
}
"""Degrees of a right hand while a finger touches."""
_INCLINED = {"thumb": (40.0, -25.0, -35.0), "index": (50.0, 0.0, 0.0), "middle": (50.0, 0.0, 0.0)}
"""Degrees of the last segment's pitch, yaw and roll in G during a touch."""
