"""A wearer who performs the guided poses before moving freely, with human inaccuracy.

Poses with contact are solved by inverse kinematics on the wearer's own hand: bone lengths, axes and
synergies determine how two pads can touch.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.guided.events import began, ended
from tracker.geometry import so3
from tracker.geometry.solids import nearest_to_axis
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.hand.poses import BETWEEN, EARLY, HELD, LATE, POSES, GuidedPose
from tracker.messages import Array, Event
from tracker.simulation.motion import Poses, SimulatedMotion, Still
from tracker.simulation.postures import posture
from tracker.simulation.scenario import Message
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for
from tracker.simulation.wearer import Wearer

FIRST = 2.0  # s flat and in view before the first pose
SOLVED = 8  # steps of an iteration whose error shrinks in each
ALL_TRIED = 3  # initial values that are tried for every pinch, before those for unusual joints
GOOD_TOUCH = 20.0  # half the sum of a pinch's squared misfits
PAD = 0.006  # m from a fingertip to the centre of its pad


@dataclass(frozen=True)
class HoldParams:
    """How accurately poses are held: standard deviations unless stated otherwise."""

    flexion_deg: float = 4.0  # of a joint that should be straight or bent
    gap: float = 0.0015  # m, between pads that should touch
    pad: float = 0.003  # m, where on the pads, along and across
    height: float = 0.0015  # m, of a fingertip above the table
    sway_deg: float = 0.8
    off_deg: float = 0.0  # common error of all joints, of either sign
    apart: float = 0.0  # m, gap between the pads
    wrong: bool = False  # one of the poses is replaced by another


HELD_BADLY = HoldParams(off_deg=10.0, apart=0.005, wrong=True)


class HeldPose(NamedTuple):
    """A pose requested from ``begin`` to ``end`` s; held from ``reached`` to ``left`` with
    ``angles`` (J,) rad."""

    name: str
    begin: float
    end: float
    reached: float
    left: float
    angles: Array


class GuidedPoses:
    """All poses one after the other, then another motion: a `SimulatedMotion`, and its ``events``.

    ``wearer`` is the wearer who holds the poses.
    """

    def __init__(
        self, wearer: Wearer, then: SimulatedMotion, seed: int, params: HoldParams | None = None
    ) -> None:
        self._params, self._then = params or HoldParams(), then
        self._rng = rng_for(seed, "guided poses")
        self._hand = HeldHand(wearer, self._params, self._rng)
        self._held = self._lead()
        self.free_from = self._held[-1].end + BETWEEN
        self.duration = self.free_from + then.duration
        self.follows_synergies = then.follows_synergies
        self._sway = SmoothNoise(self._rng, (len(wearer.hand.joint_names) + 3,), 0.8)
        first = then.poses(np.zeros(1))
        self._still = Still(first.angles[0], first.R_GB[0], first.p_GB[0])

    def _lead(self) -> list[HeldPose]:
        """The poses, with the times when each is requested, reached and released."""
        names, rng, out = list(POSES), self._rng, []
        odd = int(rng.integers(len(names))) if self._params.wrong else -1
        for k, name in enumerate(names):
            begin = FIRST + k * (HELD + BETWEEN)
            end = begin + HELD
            reached, left = begin + LATE * rng.uniform(), end - EARLY * rng.uniform()
            done = names[(k + 3) % len(names)] if k == odd else name
            angles = self._hand.angles(done, (reached + left) / 2)
            out.append(HeldPose(name, begin, end, reached, left, angles))
        return out

    @property
    def held(self) -> list[HeldPose]:
        """The poses that are held, in order of time."""
        return list(self._held)

    @property
    def events(self) -> list[Event]:
        """The instructions to the wearer as events, in order of time."""
        out = []
        for p in self._held:
            out += [began(p.name, p.begin), ended(p.name, p.end, held=True)]
        return out

    def poses(self, t: Array) -> Poses:
        t = np.asarray(t, float)
        later = self._then.poses(np.maximum(t - self.free_from, 0.0))
        still = self._still.poses(t)
        angles, before = still.angles.copy(), self._still.angles
        leaving = FIRST - BETWEEN / 2
        for p in self._held:
            share = minimum_jerk((t - leaving) / (p.reached - leaving))[:, None]
            angles = angles + share * (p.angles - before)
            before, leaving = p.angles, p.left
        share = minimum_jerk((t - leaving) / (self.free_from - leaving))[:, None]
        angles = angles + share * (self._still.angles - before)
        turn = np.deg2rad(self._params.sway_deg) * self._sway(t)
        led = t < self.free_from
        # the free motion has its own sway from its beginning, so this one fades out before
        fade = 1 - minimum_jerk((t - self.free_from + 0.5) / 0.5)[:, None]
        angles = np.where(led[:, None], angles + fade * turn[:, :-3], later.angles)
        R = np.where(led[:, None, None], still.R_GB @ so3.exp(fade * turn[:, -3:]), later.R_GB)
        return Poses(angles, R, np.where(led[:, None], still.p_GB, later.p_GB))


class _Touch(NamedTuple):
    """``gap`` m between two surfaces, negative if they overlap; from_tip (2,) m from each fingertip
    to the point of contact; off_pad (2,) 1 minus the cosine between palmar side and contact."""

    gap: float
    from_tip: Array
    off_pad: Array


class HeldHand:
    """Joint angles of one wearer in each pose."""

    def __init__(self, wearer: Wearer, params: HoldParams, rng: np.random.Generator) -> None:
        self._wearer, self._params, self._rng = wearer, params, rng

    @property
    def hand(self) -> HandModel:
        return self._wearer.hand

    def angles(self, name: str, t: float) -> Array:
        """(J,) rad, about the wearer's own axes, with distal joints as in a motion: the wearer's
        synergy errors are added by `Wearer.segments`. Held at about ``t`` (s)."""
        pose = POSES[name]
        if pose.touches:
            return self._pinch(pose.touches, t)
        angles = posture(self.hand, _BESIDE[name])
        for f in pose.flexions:
            if not f.by_will and f"{f.joint}_flexion" in self.hand.angle_index:
                angles[self.hand.angle_index[f"{f.joint}_flexion"]] = f.value + self._off()
        forced = self._forced(pose)
        angles = self._with_forced(self._inferred(angles), forced, t)
        return self._laid_flat(angles, forced, t) if pose.on_table else angles

    def _forced(self, pose: GuidedPose) -> dict[int, float]:
        """Column and angle (rad) of the end joints that are held independent of their synergies, by
        a table, by other fingers or actively."""
        out, off = {}, np.deg2rad(self._params.off_deg)
        for f in pose.flexions:
            column = self.hand.angle_index.get(f"{f.joint}_flexion", -1)
            if f.by_will and column >= 0:
                way = self._rng.choice([-1.0, 1.0])
                out[column] = f.value + self._rng.normal(0, f.sd) + way * off
        return out

    def _with_forced(self, angles: Array, forced: dict[int, float], t: float) -> Array:
        """The angles (J,) rad to which the wearer's deviations add up to ``forced``."""
        out, columns = angles.copy(), list(forced)
        wanted = np.array(list(forced.values()))
        for _ in range(SOLVED):  # a deviation depends on its own angle near the limits only
            out[columns] = wanted - self._wearer.beyond_synergies(out, t)[columns]
        return out

    def _off(self) -> float:
        p = self._params
        way = self._rng.choice([-1.0, 1.0])
        return float(np.deg2rad(self._rng.normal(0, p.flexion_deg) + way * p.off_deg))

    def _inferred(self, angles: Array) -> Array:
        """Distal joints by the hand file's synergies, the rest unchanged."""
        distal = [s.angle for s in self.hand.synergies if s.angle.split("_")[1] in ("dip", "ip")]
        known = np.array([n not in distal for n in self.hand.joint_names])
        return self.hand.apply_synergies(angles, known)[0]

    def _laid_flat(self, angles: Array, forced: dict[int, float], t: float) -> Array:
        """MCP joints bend until the fingertips are in the plane of the palm."""
        from scipy.optimize import least_squares  # deferred: slow to load

        names = [f"{f}_mcp_flexion" for f in FINGERS if f"{f}_mcp_flexion" in self.hand.angle_index]
        columns = [self.hand.angle_index[n] for n in names]
        rows = [self.hand.index[CHAINS[n.split("_")[0]][-1]] for n in names]
        height = self._rng.normal(0, self._params.height, len(rows))
        palm = -self.hand.segments[self.hand.root].radius * self._wearer.scale[self.hand.root, 2]
        off = np.deg2rad(self._params.off_deg) * self._rng.choice([-1.0, 1.0])

        def lying(bent: Array) -> Array:
            trial = angles.copy()
            trial[columns] = bent
            return self._with_forced(trial, forced, t)

        def misfit(bent: Array) -> Array:
            pads = self._pads(lying(bent), t, rows)
            return np.asarray((pads[:, 2] - palm - height) / 1e-3)

        return lying(least_squares(misfit, angles[columns]).x + off)

    def _pinch(self, finger: str, t: float) -> Array:
        """Thumb and finger bend until their pads meet, as close to a typical pinch as possible."""
        from scipy.optimize import least_squares  # deferred: slow to load

        columns = [
            self.hand.angle_index[n]
            for n in (*_THUMB, *(f"{finger}_{axis}" for axis in _FINGER))
            if n in self.hand.angle_index
        ]
        rows = [self.hand.index[CHAINS[d][-1]] for d in ("thumb", finger)]
        p, rng = self._params, self._rng
        asked = abs(rng.normal(0, p.gap)) + p.apart, PAD + rng.normal(0, p.pad, 2)
        low, high = self.hand.angle_limits[columns].T
        best, least = posture(self.hand, {}), np.inf
        for tried, (mcp, pip) in enumerate(_STARTS):
            if tried >= ALL_TRIED and least < GOOD_TOUCH:
                break
            start = posture(self.hand, _pinching(finger, mcp, pip))

            def misfit(bent: Array, start: Array = start) -> Array:
                touch = self._touch(self._with(start, columns, bent), t, rows)
                return np.r_[
                    (touch.gap - asked[0]) / 2e-4,
                    (touch.from_tip - asked[1]) / 1e-3,
                    touch.off_pad / 0.3,
                    (bent - start[columns]) / np.deg2rad(35),
                ]

            inside = np.clip(start[columns], low + 1e-3, high - 1e-3)
            found = least_squares(misfit, inside, bounds=(low, high))
            if found.cost < least:
                best, least = self._with(start, columns, found.x), found.cost
        return best

    def _with(self, angles: Array, columns: list[int], values: Array) -> Array:
        """(J,) rad with other values, distal joints by their synergies."""
        out = angles.copy()
        out[columns] = values
        return self._inferred(out)

    def _posed(self, angles: Array, t: float) -> tuple[Array, Array]:
        """R (S, 3, 3), p (S, 3) in the dorsum's frame, with the wearer's synergies at ``t``."""
        still = Still(angles, np.eye(3), np.zeros(3))
        R, p, _ = self._wearer.segments(still, np.array([t]))
        return R[0], p[0]

    def _touch(self, angles: Array, t: float, rows: list[int]) -> _Touch:
        """The contact geometry of two distal segments."""
        R, p = self._posed(angles, t)
        scale = self._wearer.scale[rows]
        length = scale[:, 0] * [self.hand.segments[r].length for r in rows]
        radius = scale[:, 2] * [self.hand.segments[r].radius for r in rows]
        x = R[rows][:, :, 0]
        d, w = length[0] * x[0], p[rows[0]] - p[rows[1]]
        share, along = nearest_to_axis(
            float(d @ d), float(d @ x[1]), float(d @ w), float(x[1] @ w), float(length[1])
        )
        between = w + share * d - along * x[1]
        apart = float(np.linalg.norm(between))
        way = between / max(apart, 1e-6)  # from the finger's axis to the thumb's
        off = np.array([1 - way @ R[rows[0], :, 2], 1 + way @ R[rows[1], :, 2]])
        return _Touch(apart - radius.sum(), length - [share * length[0], along], off)

    def _pads(self, angles: Array, t: float, rows: list[int]) -> Array:
        """(n, 3) m in the dorsum's frame: the centres of the pads of distal segments."""
        R, p = self._posed(angles, t)
        out = []
        for row in rows:
            s, scale = self.hand.segments[row], self._wearer.scale[row]
            x = np.array([s.length * scale[0] - PAD, 0.0, -s.radius * scale[2]])
            out.append(p[row] + R[row] @ x)
        return np.array(out)


def _pinching(finger: str, mcp: float, pip: float) -> dict[str, float]:
    """Angles in degrees before the pads meet; the other fingers are extended."""
    out: dict[str, float] = {
        "thumb_cmc_flexion": 15,
        "thumb_cmc_abduction": -12,
        "thumb_cmc_twist": 8,
        "thumb_mcp_flexion": 20,
    }
    for other in FINGERS:
        bent = other == finger
        out |= {
            f"{other}_mcp_flexion": mcp if bent else 15,
            f"{other}_pip_flexion": pip if bent else 20,
        }
    return out


_THUMB = ("thumb_cmc_flexion", "thumb_cmc_abduction", "thumb_cmc_twist", "thumb_mcp_flexion")
_FINGER = ("mcp_flexion", "mcp_abduction", "pip_flexion")
"""Axes that may be adjusted to make two pads meet."""

_STARTS = ((48.0, 45.0), (62.0, 30.0), (35.0, 65.0), (75.0, 10.0), (20.0, 80.0), (60.0, 60.0))
"""MCP and PIP flexion (degrees) from which a pinch is solved."""

_BESIDE: dict[str, dict[str, float]] = {
    "flat": {"thumb_cmc_flexion": -5.0},
    "spread": {
        "index_mcp_abduction": 12.0,
        "middle_mcp_abduction": 2.0,
        "ring_mcp_abduction": -8.0,
        "little_mcp_abduction": -15.0,
        "thumb_cmc_abduction": 15.0,
        "thumb_cmc_flexion": -15.0,
    },
    "fist": {"thumb_cmc_flexion": 22.0, "thumb_cmc_abduction": -12.0, "thumb_mcp_flexion": 40.0},
    "thumb_up": {"thumb_cmc_flexion": -15.0, "thumb_cmc_abduction": 10.0},
}
"""Angles in degrees for joints that a pose does not specify."""


def with_events(feed: Iterator[Message], events: Iterable[Event]) -> Iterator[Message | Event]:
    """A feed of messages with events inserted at their times."""
    waiting = list(events)
    for message in feed:
        while waiting and waiting[0].t <= message.t_arrival:
            yield waiting.pop(0)
        yield message
    yield from waiting
